"""The machine's state: what it has in memory, and the stack of what it is doing.

Activities, the runtime and the engine are given a `State`; `Interpreter`, above all of them, makes
one and turns the wheel. Nothing in the language blocks: waiting for a line, for a key in EDIT,
listing a program, running one, or watching a motion of the arm are all activities, small picklable
objects whose `advance` works until the clock's limit and returns. When one ends it leaves the stack
and the one below is told.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Final, Protocol

from trs80arm.basic import addresses
from trs80arm.basic.activity import Waiting
from trs80arm.basic.code_calls import CodeCalls
from trs80arm.basic.control import Control
from trs80arm.basic.engine import Engine
from trs80arm.basic.host import Host
from trs80arm.basic.kinds import SINGLE, SIZES
from trs80arm.basic.outcome import Outcome
from trs80arm.basic.output import Output
from trs80arm.basic.program import Program
from trs80arm.basic.room import Room
from trs80arm.basic.string_space import StringSpace
from trs80arm.basic.variables import Variables

STRING_SPACE: Final = 50
"""Bytes for strings unless CLEAR says otherwise (facts, thing 11)."""


class Listener(Protocol):
    """Somebody who watches statements being executed."""

    def statement(self, line: int, address: int) -> None:
        """A statement begins: its line (65535 in direct mode) and its separator's address."""


class Stops:
    """Who may stop a program before a statement: a debugger.

    They are heeded only where time can stand still and go on later, which the rig says.

    Attributes:
        conditions: each is asked before every statement, with the address of its separator,
            whether the machine is to stop there.
        heeded: whether they are asked now.
        reached: whether one has stopped the machine since this was last set to False.
    """

    __slots__ = ("conditions", "heeded", "reached")

    def __init__(self) -> None:
        self.conditions: list[Callable[[int], bool]] = []
        self.heeded = False
        self.reached = False

    def __bool__(self) -> bool:
        return self.heeded and bool(self.conditions)

    def before(self, address: int) -> bool:
        """Whether the machine is to stop before a statement; everybody is asked."""
        stopped = [condition(address) for condition in list(self.conditions)]
        self.reached = self.reached or any(stopped)
        return any(stopped)


class ColdStart(Exception):  # noqa: N818 - not a failure of ours
    """Machine code went to the address 0: the machine begins as if it was switched on."""


class Activity:
    """One thing that the machine is doing."""

    @property
    def waiting(self) -> Waiting:
        """What this activity waits for; NOTHING while it works."""
        return Waiting.NOTHING

    def advance(self, state: State) -> None:
        """Work until the clock reaches its limit, or until another activity is on top.

        An activity that waits for a key moves `Clock.now` straight on to the limit when
        `Console.quiet`. It must make progress: either time passes or the stack changes.
        """
        raise TypeError(f"{type(self).__name__} does not say how it advances")

    def resumed(self, state: State, result: Any) -> None:
        """The activity above has ended, with its result."""


class Home(Activity):
    """The bottom of the stack: what it does next can be set from outside."""

    _ready: bool

    def __init__(self) -> None:
        self._ready = True

    def come_back(self, ready: bool) -> None:
        """Begin again, with READY or with a prompt alone."""
        self._ready = ready


class State:
    """Level II BASIC's state on one machine.

    Attributes:
        host: the machine.
        clock: its time.
        memory: its memory map.
        output: its display and printer.
        program: the lines in memory.
        variables: simple variables and arrays.
        strings: string space and temporaries.
        room: the free memory.
        control: loops, subroutines, error trap, DATA pointer.
        code_calls: what a statement found out that calls machine code.
        seed: of RND, 24 bits.
        stack: what the machine is doing, the topmost last; the bottom is a `Home`.
        outcome: how the last program ended; None while one runs.
        listeners: watchers of statements; they are not part of a snapshot.
        stops: who may stop a program before a statement; not part of a snapshot either.
        armbasic: whether the `@` statements are there.
        blocks: whether runs of statements are compiled into one function.
        native: whether hot loops of numbers are made native code, where that is installed.
    """

    def __init__(
        self,
        host: Host,
        make_engine: Callable[[State], Engine],
        *,
        armbasic: bool = True,
        blocks: bool = True,
        native: bool = True,
    ) -> None:
        self.host = host
        self.clock = host.clock
        self.memory = host.memory
        self.output = Output(host)
        self.program = Program(host.memory)
        self.variables = Variables()
        self.strings = StringSpace(host.memory, host.clock, self.variables)
        self.control = Control()
        self.room = Room(self.strings, self.variables, self.control)
        self.code_calls = CodeCalls()
        self.seed = 0
        self.stack: list[Activity] = []
        self.outcome: Outcome | None = None
        self.listeners: list[Listener] = []
        self.stops = Stops()
        self.armbasic = armbasic
        self.blocks = blocks
        self.native = native
        self._make_engine = make_engine
        self._engine: Engine | None = None

    def __getstate__(self) -> dict[str, Any]:
        kept = {name: value for name, value in self.__dict__.items() if name != "stops"}
        return {**kept, "listeners": [], "_engine": None}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)
        self.stops = Stops()

    @property
    def engine(self) -> Engine:
        """What executes statements; not part of a snapshot."""
        if self._engine is None:
            self._engine = self._make_engine(self)
        return self._engine

    # -- the stack ----------------------------------------------------------------------------

    def begin(self, activity: Activity) -> None:
        """Put an activity on top."""
        self.stack.append(activity)

    def end(self, result: Any = None) -> None:
        """The topmost activity has ended; the one below hears its result."""
        self.stack.pop()
        self.stack[-1].resumed(self, result)

    def return_to_command(self, *, ready: bool = True) -> None:
        """End everything under way: READY and `>`.

        Args:
            ready: whether READY is printed; after a stored line there is `>` alone.
        """
        bottom = self.stack[0]
        assert isinstance(bottom, Home)
        del self.stack[1:]
        bottom.come_back(ready)

    # -- memory -------------------------------------------------------------------------------

    def cold_start(self, top: int) -> None:
        """Begin with `top` as BASIC's last address (the answer to MEMORY SIZE?)."""
        self.strings.top = top
        self.strings.bottom = top - STRING_SPACE
        self.clear_program()

    def clear_program(self) -> None:
        """No program, and nothing of what one leaves behind."""
        self.program.clear()
        self.clear_all()

    def clear_all(self, string_space: int | None = None) -> None:
        """Forget variables, loops, error trap, types of names; READ starts again (1B5DH)."""
        self.variables.clear(self.program.end)
        self.strings.reset(string_space)
        self.control.forget(self.program.start - 1)
        start, stop = addresses.TYPE_TABLE, addresses.TYPE_TABLE + addresses.LETTERS
        self.memory.ram[start:stop] = bytes((SIZES[SINGLE],)) * addresses.LETTERS
        self.room.relax()
        self.engine.cleared()

    def need_room(self, size: int) -> None:
        """OM unless so many bytes are free; when it gets tight, statements are compiled anew."""
        tight = self.room.tight
        self.room.need(size)
        if self.room.tight and not tight:
            self.engine.look_around()
