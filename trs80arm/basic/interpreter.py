"""The Level II interpreter: one program in memory, one stack of things that the machine is doing.

The rig builds it on a `Host` and calls `advance`; everything else happens in the activities on the
stack. The command level is at the bottom, a running program or direct line is an `Execution`, and
INPUT, EDIT, a listing or a motion of the arm lie above.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from enum import Enum
from typing import Any, Protocol

from trs80arm.basic import costs, cruncher, room, system_area
from trs80arm.basic.activity import Activity, Waiting
from trs80arm.basic.code import CompiledCode
from trs80arm.basic.control import DIRECT, Control
from trs80arm.basic.dialogue.boot import MemorySize
from trs80arm.basic.dialogue.command import CommandLevel
from trs80arm.basic.dialogue.home import return_to_command
from trs80arm.basic.errors import BasicError, Code
from trs80arm.basic.execution import Execution
from trs80arm.basic.host import Host
from trs80arm.basic.program import START, Program
from trs80arm.basic.room import Room
from trs80arm.basic.runtime.environment import Runtime
from trs80arm.basic.string_space import StringSpace
from trs80arm.basic.system_area import SystemArea, Workspace
from trs80arm.basic.variables import Variables

STRING_SPACE = 50
"""Bytes for strings unless CLEAR says otherwise (facts, thing 11)."""
_LONGEST_DIRECT = START - system_area.INPUT_BUFFER - 5
"""What fits between the buffer's start and the program."""
DIRECT_LINE = system_area.INPUT_BUFFER
"""Where a direct line stands while it is executed."""


class Kind(Enum):
    """How a program ended."""

    END = "end"
    STOP = "stop"
    BREAK = "break"
    ERROR = "error"


@dataclass(frozen=True)
class Outcome:
    """How the last program run, or direct line, ended.

    Attributes:
        code: the error, if it was one.
        line: where; None in direct mode.
    """

    kind: Kind
    code: Code | None = None
    line: int | None = None


class Listener(Protocol):
    """Somebody who watches statements being executed."""

    def statement(self, line: int, address: int) -> None:
        """A statement begins: its line (65535 in direct mode) and its separator's address."""


class Interpreter:
    """Level II BASIC on one machine.

    Attributes:
        host: the machine.
        program: the lines in memory.
        variables: simple variables and arrays.
        strings: string space and temporaries.
        room: the free memory.
        control: loops, subroutines, error trap, DATA pointer.
        stack: what the machine is doing, the topmost last.
        armbasic: whether the `@` statements are there.
        blocks: whether runs of statements are compiled into one function.
        outcome: how the last program ended; None while one runs.
        listeners: watchers of statements; they are not part of a snapshot.
    """

    def __init__(self, host: Host, armbasic: bool = True, blocks: bool = True) -> None:
        self.host = host
        self.clock = host.clock
        self.memory = host.memory
        self.armbasic = armbasic
        self.blocks = blocks
        self.program = Program(host.memory)
        self.variables = Variables()
        self.strings = StringSpace(host.memory, host.clock, self.variables)
        self.control = Control()
        self.room = Room(self.strings, self.variables, self.control)
        self.seed = 0
        self.outcome: Outcome | None = None
        self.listeners: list[Listener] = []
        self.stack: list[Activity] = []
        self.runtime = Runtime(self)
        self._code: CompiledCode | None = None
        self.memory.attach(*SystemArea.RANGE, SystemArea(self))
        self.memory.attach(START, self.memory.top, Workspace(self))
        system_area.power_on(self)
        self.program.clear()
        self.clear_all()
        self.stack = [CommandLevel(), MemorySize()]

    def __getstate__(self) -> dict[str, Any]:
        return {**self.__dict__, "listeners": [], "_code": None}

    @property
    def code(self) -> CompiledCode:
        """The compiled statements; not part of a snapshot."""
        if self._code is None:
            self._code = CompiledCode(self)
        return self._code

    # -- the stack ----------------------------------------------------------------------------

    @property
    def waiting(self) -> Waiting:
        """What the machine waits for."""
        return self.stack[-1].waiting

    def advance(self, until_waiting: bool = False) -> None:
        """Work until the clock reaches its limit.

        Args:
            until_waiting: return as soon as the machine waits for something.
        """
        clock = self.clock
        while clock.now < clock.limit:
            if until_waiting and self.stack[-1].waiting is not Waiting.NOTHING:
                return
            try:
                self.stack[-1].advance(self)
            except BasicError as error:
                self.failed(error)

    def begin(self, activity: Activity) -> None:
        """Put an activity on top."""
        self.stack.append(activity)

    def end(self, result: Any = None) -> None:
        """The topmost activity has ended; the one below hears its result."""
        self.stack.pop()
        try:
            self.stack[-1].resumed(self, result)
        except BasicError as error:
            self.failed(error)

    def step_statement(self) -> None:
        """Execute one statement of the running program, for a debugger's single step.

        Whatever else the machine is doing, as a motion of the arm, goes on to the clock's limit or
        to its own end.
        """
        top = self.stack[-1]
        try:
            if isinstance(top, Execution):
                top.step(self)
            else:
                top.advance(self)
        except BasicError as error:
            self.failed(error)

    # -- lines --------------------------------------------------------------------------------

    def enter_line(self, text: bytes) -> bool:
        """What was typed at the command level.

        Returns:
            Whether it was a direct line (then READY comes after it), not a program line.

        Raises:
            BasicError: SN for a line number above 65529.
        """
        number, rest = cruncher.split_line(text)
        if number is None:
            crunched = cruncher.crunch(rest)
            self.clock.now += costs.crunching(crunched, rest)
            self.execute_direct(crunched)
            return True
        if rest:
            self.clock.now += costs.NUMBERED_LINE
        self.store_line(number, rest)
        return False

    def store_line(self, number: int, text: bytes) -> None:
        """Store a typed line (not crunched yet) under a number; one of blanks or nothing deletes.

        All variables, CONT and the error trap go, as in the ROM (facts, thing 12).

        Raises:
            BasicError: OM when it does not fit.
        """
        crunched = cruncher.crunch(text) if text.strip(b" \t\n") else b""
        program = self.program
        behind = program.end - (program.address_from(number) or program.end)
        self.clock.now += costs.crunching(crunched, text) + costs.storing(
            behind, len(program), program.end - program.start
        )
        self.control.dot = number
        if crunched and program.find(number) is None:
            # The variables are about to go, but the stack is still there.
            freed = self.variables.end - program.end
            self.room.need(len(crunched) + 5 + room.LINE - freed)
        program.delete(number)
        frames = list(self.control.frames)
        self.program_changed()
        if crunched:
            # The room is looked at before the stack is emptied, and the old line is gone by then.
            self.control.frames[:] = frames
            try:
                self.room.need(len(crunched) + 5 + room.LINE)
            finally:
                self.control.frames[1:] = []
            program.store(number, crunched)
            self.program_changed()

    def program_changed(self) -> None:
        """The program's text is another one: variables, stack and trap go."""
        self.clear_all()

    def load_lines(self, lines: Iterable[tuple[int, bytes]]) -> None:
        """Replace the program by crunched lines, sorted by number, as a tape would.

        Lines that do not fit into memory are left out, and ?OM is reported.
        """
        wanted = sorted(dict(lines).items())
        free = self.strings.bottom - self.program.start - room.LINE
        fits = []
        for number, text in wanted:
            free -= len(text) + 5
            if free < 0:
                break
            fits.append((number, text))
        self.program.load(fits)
        self.program_changed()
        if len(fits) < len(wanted):
            self.report(Code.OM, None)

    def execute_direct(self, crunched: bytes) -> None:
        """Run a direct line."""
        ram = self.memory.ram
        crunched = crunched[:_LONGEST_DIRECT]
        end = DIRECT_LINE + 1 + len(crunched)
        ram[DIRECT_LINE : end + 3] = b":" + crunched + b"\0\0\0"
        self.code.forget_direct()
        self.strings.temporaries.clear()
        self.outcome = None
        self.begin(Execution(DIRECT_LINE))

    # -- ends ---------------------------------------------------------------------------------

    def execution(self) -> Execution | None:
        """The program or direct line under way, whatever lies above it."""
        for activity in reversed(self.stack):
            if isinstance(activity, Execution):
                return activity
        return None

    @property
    def next_line(self) -> int | None:
        """The number of the line that is executed next; None when no program runs."""
        execution = self.execution()
        line = DIRECT if execution is None else execution.next_line(self)
        return None if line == DIRECT else line

    def failed(self, error: BasicError) -> None:
        """An error of the activity on top: the running statement's, or the command level's."""
        execution = self.execution()
        if execution is None:
            execution = Execution(DIRECT_LINE)
            del self.stack[1:]
            self.begin(execution)
        while self.stack[-1] is not execution:
            self.stack.pop()
        execution.fail(self, error)

    def report(self, code: Code, line: int | None) -> None:
        """Print an error message and go to command level; ?SN in a line goes on to EDIT."""
        self.outcome = Outcome(Kind.ERROR, code, line)
        self.strings.temporaries.clear()
        self.runtime.printing.leave_printer()
        self.newline_if_needed()
        where = b"" if line is None else b" in %d" % line
        self.print_text(b"?" + code.letters.encode("ascii") + b" Error" + where + b"\r")
        return_to_command(self)

    def break_(self) -> None:
        """`Break in n` and to command level; CONT repeats the statement under way."""
        execution = self.execution()
        if execution is None:
            self._say_break(None, Kind.BREAK)
        else:
            self.stop(execution, execution.statement, Kind.BREAK)

    def stop(self, execution: Execution, resume: int, kind: Kind) -> None:
        """The program stops (BREAK, STOP, END); CONT would go on at `resume`."""
        line = execution.line(self)
        number = None if line == DIRECT else line
        if number is not None:
            self.control.resume_line = line
            self.control.resume_address = resume
        self.strings.temporaries.clear()
        if kind is Kind.END:
            self.outcome = Outcome(kind, None, number)
            self.runtime.printing.leave_printer()
            return_to_command(self)
        else:
            self._say_break(number, kind)

    def _say_break(self, line: int | None, kind: Kind) -> None:
        self.outcome = Outcome(kind, None, line)
        self.runtime.printing.leave_printer()
        self.newline_if_needed()
        self.print_text(b"Break" + (b"" if line is None else b" in %d" % line) + b"\r")
        return_to_command(self)

    # -- output -------------------------------------------------------------------------------

    def print_text(self, text: bytes) -> None:
        """Send characters to the display."""
        put = self.host.console.put
        for code in text:
            self.clock.now += costs.PRINT_CHARACTER
            put(code)

    def newline_if_needed(self) -> None:
        """A newline unless the cursor is at the start of a line (20F9H)."""
        if self.host.console.column:
            self.host.console.put(13)

    # -- memory -------------------------------------------------------------------------------

    def cold_start(self, top: int) -> None:
        """Begin with `top` as BASIC's last address (the answer to MEMORY SIZE?)."""
        self.strings.top = top
        self.strings.bottom = top - STRING_SPACE
        self.program.clear()
        self.clear_all()

    def clear_all(self, string_space: int | None = None) -> None:
        """Forget variables, loops, error trap, types of names; READ starts again (1B5DH)."""
        self.variables.clear(self.program.end)
        self.strings.reset(string_space)
        self.control.forget(self.program.start - 1)
        system_area.reset_types(self.memory.ram)
        self.room.relax()
        self.code.cleared()

    def new(self) -> None:
        """NEW: no program."""
        self.host.console.put(0x1C)
        self.host.console.put(0x1F)
        self.control.traced = False
        self.program.clear()
        self.clear_all()
        return_to_command(self)
