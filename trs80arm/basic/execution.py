"""Executing a program or a direct line: the statement loop.

Its state is the address of the separator in front of the next statement. While nobody presses a key
the engine calls one statement after the other; with a key down, TRON, a watcher or somebody who may
stop it the loop looks around before each of them, as the ROM does at 1D1EH.
"""

from __future__ import annotations

from typing import Any, Final, Protocol

from trs80arm.basic import addresses, costs, endings, keyboard
from trs80arm.basic.control import DIRECT
from trs80arm.basic.errors import BasicError, Code, LineError
from trs80arm.basic.outcome import Ending
from trs80arm.basic.pause import Pause
from trs80arm.basic.program import LINE_HEAD
from trs80arm.basic.state import Activity, Listener, State

_LONGEST_DIRECT: Final = addresses.PROGRAM - addresses.INPUT_BUFFER - 5
"""What fits between the buffer's start and the program."""
DIRECT_LINE: Final = addresses.INPUT_BUFFER
"""Where a direct line stands while it is executed."""


class Leave(Exception):  # noqa: N818 - a way of leaving, not a failure
    """The statement is done, but the loop must look around before it goes on.

    Attributes:
        address: where it goes on.
    """

    def __init__(self, address: int) -> None:
        super().__init__(address)
        self.address = address


class CodeCall(Leave):
    """The statement calls machine code: it is executed again when that is done."""

    def __init__(self) -> None:
        super().__init__(0)


class Answered(Protocol):
    """The variables of an INPUT that is under way."""

    def finish(self) -> int:
        """Where the program goes on when they have their values."""


class Execution(Activity):
    """A running program or direct line.

    Attributes:
        next: the separator in front of the next statement.
        statement: the separator in front of the last one executed.
        forced_line: the line number of 40A2H where it is not that of `statement`.
        noted: what 40E6H holds while the first statement of an error trap is executed: that of
            the error, since the jump to the trap notes none.
        targets: the variables of the INPUT that it waits for.
    """

    next: int
    statement: int
    forced_line: int | None
    noted: int | None
    targets: Answered | None

    def __init__(self, address: int) -> None:
        self.next = address
        self.statement = address
        self.forced_line = None
        self.noted = None
        self.targets = None

    def line(self, state: State) -> int:
        """The number of the line being executed, 65535 in direct mode (40A2H)."""
        if self.forced_line is not None:
            return self.forced_line
        return self._line_of(state, self.statement)

    def next_line(self, state: State) -> int:
        """The number of the line of the statement that is next, 65535 in direct mode."""
        return self._line_of(state, self.next)

    def _line_of(self, state: State, address: int) -> int:
        program = state.program
        ram = state.memory.ram
        if not program.start - 1 <= address < state.memory.top - LINE_HEAD - 1:
            return DIRECT
        if ram[address] == 0 and (ram[address + 1] or ram[address + 2]):
            return program.number_at(address + 1)
        link = program.line_at(address)
        return DIRECT if link is None else program.number_at(link)

    def advance(self, state: State) -> None:
        """Execute statements until the clock's limit, or until another activity is on top."""
        clock = state.clock
        while clock.now < clock.limit:
            if state.stack[-1] is not self:
                return
            try:
                if self._must_look(state):
                    self._slowly(state)
                else:
                    self.forced_line = None
                    state.engine.run(self)
            except Leave as leave:
                self._left(state, leave)

    def _must_look(self, state: State) -> bool:
        """Whether there is something to do or to know before or behind the next statement."""
        return (
            bool(state.control.trace)
            or bool(state.listeners)
            or bool(state.stops)
            or not state.host.console.quiet
            or self.noted is not None
        )

    def step(self, state: State) -> None:
        """Execute one statement, whatever the clock's limit."""
        try:
            self._one(state)
        except Leave as leave:
            self._left(state, leave)

    def _slowly(self, state: State) -> None:
        clock = state.clock
        while clock.now < clock.limit and state.stack[-1] is self:
            again = state.code_calls.again
            if state.stops and not again and state.stops.before(self.next):
                # Whoever turns the wheel finds that there is no more time.
                clock.limit = clock.now
                return
            self._one(state)
            if not self._must_look(state):
                return

    def _one(self, state: State) -> None:
        """One turn of the statement loop with everything that the ROM does in it."""
        again = state.code_calls.again
        if self.noted is None and not again and self._key(state):
            return
        address = self.next
        ram = state.memory.ram
        if not again:
            for listener in state.listeners:
                self._tell(state, listener, address)
        self.statement = address
        self.forced_line = None
        if (
            state.control.trace
            and not again
            and not ram[address]
            and (ram[address + 1] or ram[address + 2])
        ):
            number = state.program.number_at(address + 1)
            if address >= state.program.start - 1:
                state.output.show(b"<%d>" % number)
        self.next = state.engine.step(address)
        self.noted = None

    def _tell(self, state: State, listener: Listener, address: int) -> None:
        before = self.statement, self.forced_line
        self.statement, self.forced_line = address, None
        line = self.line(state)
        self.statement, self.forced_line = before
        listener.statement(line, address)

    def _key(self, state: State) -> bool:
        """The look at the keyboard before a statement; whether something else comes first."""
        console = state.host.console
        if console.quiet:
            return False
        key = console.scan()
        if not key:
            return False
        if key == keyboard.BREAK:
            if state.memory.ram[addresses.BREAK_VECTOR] == addresses.BREAK_ON:
                self._hold_line(state)
                self.statement = self.next
                break_(state)
                return True
            return False
        if key == keyboard.SHIFT_AT:
            state.begin(Pause())
            self._hold_line(state)
            self.statement = self.next
            return True
        state.clock.now += costs.KEY_LATCHED
        state.memory.ram[addresses.KEY_LATCH] = key
        return False

    def _hold_line(self, state: State) -> None:
        self.forced_line = self.line(state)

    def _left(self, state: State, leave: Leave) -> None:
        state.engine.stale = False
        self.next = leave.address
        if isinstance(leave, CodeCall):
            return
        self.noted = None

    # -- errors -------------------------------------------------------------------------------

    def fail(self, state: State, error: BasicError) -> None:
        """An error in the statement under way: to the program's trap, or a message."""
        control = state.control
        line = error.line if isinstance(error, LineError) else self.line(state)
        state.strings.temporaries.clear()
        control.error = (min(int(error.code), 255) - 1) * 2
        control.error_line = line
        control.dot = line
        noted = self.statement if self.noted is None else self.noted
        self.noted = None
        control.error_address = noted
        if line != DIRECT:
            control.resume_line = line
            control.resume_address = noted
        if control.trap and not control.handling:
            control.handling = True
            self.noted = noted
            self.next = control.trap - 1
            return
        state.clock.now += costs.ERROR_RAISED
        self._raise_again(state, error.code)

    def _raise_again(self, state: State, code: Code) -> None:
        """The message for an error, with the line where it happened, and to command level."""
        control = state.control
        control.handling = False
        line = control.error_line
        endings.report(state, code, None if line == DIRECT else line)

    def resumed(self, state: State, result: Any) -> None:
        """The activity that a statement began has ended."""
        if isinstance(result, int):
            if result == keyboard.BREAK:
                break_(state)
        elif self.targets is not None:
            targets, self.targets = self.targets, None
            self.next = targets.finish()


def under_way(state: State) -> Execution | None:
    """The program or direct line under way, whatever lies above it."""
    for activity in reversed(state.stack):
        if isinstance(activity, Execution):
            return activity
    return None


def execute_direct(state: State, crunched: bytes) -> None:
    """Run a direct line."""
    ram = state.memory.ram
    crunched = crunched[:_LONGEST_DIRECT]
    end = DIRECT_LINE + 1 + len(crunched)
    ram[DIRECT_LINE : end + 3] = b":" + crunched + b"\0\0\0"
    state.engine.forget_direct()
    state.strings.temporaries.clear()
    state.outcome = None
    state.begin(Execution(DIRECT_LINE))


def break_(state: State) -> None:
    """`Break in n` and to command level; CONT repeats the statement under way."""
    execution = under_way(state)
    if execution is None:
        endings.stop(state, DIRECT, 0, Ending.BREAK)
    else:
        endings.stop(state, execution.line(state), execution.statement, Ending.BREAK)


def failed(state: State, error: BasicError) -> None:
    """An error of the activity on top: the running statement's, or the command level's."""
    execution = under_way(state)
    if execution is None:
        execution = Execution(DIRECT_LINE)
        del state.stack[1:]
        state.begin(execution)
    while state.stack[-1] is not execution:
        state.stack.pop()
    execution.fail(state, error)
