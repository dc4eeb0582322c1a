"""Executing a program or a direct line: the statement loop.

Its state is the address of the separator in front of the next statement. While nobody presses a key
the loop does nothing but call one compiled statement after the other; with a key down, TRON or a
watcher it looks around before each of them, as the ROM does at 1D1EH.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from trs80arm.basic import costs, system_area
from trs80arm.basic.activity import Activity
from trs80arm.basic.code import MARGIN
from trs80arm.basic.control import DIRECT
from trs80arm.basic.dialogue.pause import Pause
from trs80arm.basic.errors import BasicError, Code

if TYPE_CHECKING:
    from trs80arm.basic.interpreter import Interpreter

_BREAK_KEY = 1
_PAUSE_KEY = 96
_LINE_HEAD = 5
"""A line's final zero, link and number."""


class Leave(Exception):  # noqa: N818 - a way of leaving, not a failure
    """The statement is done, but the loop must look around before it goes on.

    Attributes:
        address: where it goes on.
    """

    def __init__(self, address: int) -> None:
        super().__init__(address)
        self.address = address


class LineError(BasicError):
    """An error that belongs to another line than the one being executed (a wrong DATA item)."""

    def __init__(self, code: Code, line: int) -> None:
        super().__init__(code)
        self.line = line


class Execution(Activity):
    """A running program or direct line.

    Attributes:
        next: the separator in front of the next statement.
        statement: the separator in front of the last one executed.
        forced_line: the line number of 40A2H where it is not that of `statement`.
        noted: what 40E6H holds while the first statement of an error trap is executed: that of
            the error, since the jump to the trap notes none.
    """

    def __init__(self, address: int) -> None:
        self.next = address
        self.statement = address
        self.forced_line: int | None = None
        self.noted: int | None = None
        self.targets: Any = None

    def line(self, basic: Interpreter) -> int:
        """The number of the line being executed, 65535 in direct mode (40A2H)."""
        if self.forced_line is not None:
            return self.forced_line
        return self._line_of(basic, self.statement)

    def next_line(self, basic: Interpreter) -> int:
        """The number of the line of the statement that is next, 65535 in direct mode."""
        return self._line_of(basic, self.next)

    def _line_of(self, basic: Interpreter, address: int) -> int:
        program = basic.program
        ram = basic.memory.ram
        if not program.start - 1 <= address < basic.memory.top - _LINE_HEAD:
            return DIRECT
        if ram[address] == 0 and (ram[address + 1] or ram[address + 2]):
            return ram[address + 3] | ram[address + 4] << 8
        link = program.line_at(address)
        return DIRECT if link is None else program.number_at(link)

    def advance(self, basic: Interpreter) -> None:
        """Execute statements until the clock's limit, or until another activity is on top."""
        clock = basic.clock
        while clock.now < clock.limit:
            if basic.stack[-1] is not self:
                return
            try:
                if self._must_look(basic):
                    self._slowly(basic)
                else:
                    self._quickly(basic)
            except Leave as leave:
                self._left(basic, leave)

    def _must_look(self, basic: Interpreter) -> bool:
        """Whether there is something to do or to know before or behind the next statement."""
        return (
            basic.control.traced
            or bool(basic.listeners)
            or not basic.host.console.quiet
            or self.noted is not None
        )

    def step(self, basic: Interpreter) -> None:
        """Execute one statement, whatever the clock's limit."""
        try:
            self._one(basic)
        except Leave as leave:
            self._left(basic, leave)

    def _quickly(self, basic: Interpreter) -> None:
        clock = basic.clock
        code = basic.code
        pace = code.pace
        address = self.next
        self.forced_line = None
        table = code.blocks
        try:
            if basic.blocks:
                pace.soft = clock.limit - MARGIN
                while clock.now < pace.soft:
                    self.statement = address
                    address = table[address]()
            table = code.statements
            while clock.now < clock.limit:
                self.statement = address
                address = table[address]()
        except (BasicError, Leave) as error:
            self.statement, cost = table.failed(address, error)
            clock.now += cost
            raise
        self.next = address

    def _slowly(self, basic: Interpreter) -> None:
        clock = basic.clock
        while clock.now < clock.limit and basic.stack[-1] is self:
            self._one(basic)
            if not self._must_look(basic):
                return

    def _one(self, basic: Interpreter) -> None:
        """One turn of the statement loop with everything that the ROM does in it."""
        if self.noted is None and self._key(basic):
            return
        address = self.next
        ram = basic.memory.ram
        clock = basic.clock
        for listener in basic.listeners:
            self._tell(basic, listener, address)
        self.statement = address
        self.forced_line = None
        if basic.control.traced and not ram[address] and (ram[address + 1] or ram[address + 2]):
            number = ram[address + 3] | ram[address + 4] << 8
            if address >= basic.program.start - 1:
                basic.print_text(b"<%d>" % number)
        table = basic.code.statements
        try:
            self.next = table[address]()
        except (BasicError, Leave) as error:
            clock.now += table.failed(address, error).cost
            raise
        self.noted = None

    def _tell(self, basic: Interpreter, listener: Any, address: int) -> None:
        before = self.statement, self.forced_line
        self.statement, self.forced_line = address, None
        line = self.line(basic)
        self.statement, self.forced_line = before
        listener.statement(line, address)

    def _key(self, basic: Interpreter) -> bool:
        """The look at the keyboard before a statement; whether something else comes first."""
        console = basic.host.console
        if console.quiet:
            return False
        key = console.scan()
        if not key:
            return False
        if key == _BREAK_KEY:
            if basic.memory.ram[system_area.BREAK_VECTOR] == system_area.BREAK_ON:
                self._hold_line(basic)
                self.statement = self.next
                basic.break_()
                return True
            return False
        if key == _PAUSE_KEY:
            basic.begin(Pause())
            self._hold_line(basic)
            self.statement = self.next
            return True
        basic.clock.now += costs.KEY_LATCHED
        basic.memory.ram[system_area.KEY_LATCH] = key
        return False

    def _hold_line(self, basic: Interpreter) -> None:
        self.forced_line = self.line(basic)

    def _left(self, basic: Interpreter, leave: Leave) -> None:
        basic.code.stale = False
        self.noted = None
        self.next = leave.address

    # -- errors -------------------------------------------------------------------------------

    def fail(self, basic: Interpreter, error: BasicError) -> None:
        """An error in the statement under way: to the program's trap, or a message."""
        control = basic.control
        line = error.line if isinstance(error, LineError) else self.line(basic)
        basic.strings.temporaries.clear()
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
        basic.clock.now += costs.ERROR_RAISED
        self.raise_again(basic, error.code)

    def raise_again(self, basic: Interpreter, code: Code) -> None:
        """The message for an error, with the line where it happened, and to command level."""
        control = basic.control
        control.handling = False
        line = control.error_line
        basic.report(code, None if line == DIRECT else line)

    def resumed(self, basic: Interpreter, result: Any) -> None:
        """The activity that a statement began has ended."""
        if isinstance(result, int):
            if result == _BREAK_KEY:
                basic.break_()
        elif self.targets is not None:
            targets, self.targets = self.targets, None
            self.next = targets.finish()
