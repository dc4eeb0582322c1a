"""The Level II interpreter: it switches the machine on and turns the wheel.

The rig builds it on a `Host` and calls `advance`; everything else happens in the activities on the
stack of its `State`. The command level is at the bottom, a running program or direct line is an
`Execution`, and INPUT, EDIT, a listing or a motion of the arm lie above.
"""

from __future__ import annotations

from collections.abc import Iterable

from trs80arm.basic import addresses, aside, editing, execution, system_area
from trs80arm.basic.activity import Waiting
from trs80arm.basic.code import CompiledCode
from trs80arm.basic.control import DIRECT
from trs80arm.basic.dialogue import machine_code
from trs80arm.basic.dialogue.boot import MemorySize
from trs80arm.basic.dialogue.command import CommandLevel
from trs80arm.basic.errors import BasicError
from trs80arm.basic.execution import Execution
from trs80arm.basic.host import Host
from trs80arm.basic.outcome import Outcome
from trs80arm.basic.program import Program
from trs80arm.basic.state import ColdStart, Listener, State, Stops
from trs80arm.basic.system_area import SystemArea, Workspace


class Interpreter:
    """Level II BASIC on one machine.

    Attributes:
        state: the machine's state, which the activities work on.
    """

    def __init__(
        self, host: Host, armbasic: bool = True, blocks: bool = True, native: bool = True
    ) -> None:
        state = self.state = State(
            host, CompiledCode, armbasic=armbasic, blocks=blocks, native=native
        )
        state.memory.attach(*SystemArea.RANGE, SystemArea(state))
        state.memory.attach(addresses.PROGRAM, state.memory.top, Workspace(state))
        self._switch_on()

    def _switch_on(self) -> None:
        state = self.state
        system_area.power_on(state.memory.ram)
        state.clear_program()
        state.stack[:] = [CommandLevel(), MemorySize()]

    # -- what a rig looks at ------------------------------------------------------------------

    @property
    def program(self) -> Program:
        """The lines in memory."""
        return self.state.program

    @property
    def outcome(self) -> Outcome | None:
        """How the last program ended; None while one runs."""
        return self.state.outcome

    @property
    def listeners(self) -> list[Listener]:
        """Watchers of statements; they are not part of a snapshot."""
        return self.state.listeners

    @listeners.setter
    def listeners(self, listeners: list[Listener]) -> None:
        self.state.listeners = listeners

    @property
    def stops(self) -> Stops:
        """Who may stop a program before a statement; they are not part of a snapshot."""
        return self.state.stops

    @stops.setter
    def stops(self, stops: Stops) -> None:
        self.state.stops = stops

    @property
    def waiting(self) -> Waiting:
        """What the machine waits for."""
        return self.state.stack[-1].waiting

    @property
    def running(self) -> bool:
        """Whether a program or a direct line is under way."""
        return execution.under_way(self.state) is not None

    @property
    def next_address(self) -> int | None:
        """The separator in front of the statement that is executed next, or is under way now.

        None when neither program nor direct line runs.
        """
        running = execution.under_way(self.state)
        if running is None:
            return None
        return running.next if self.state.stack[-1] is running else running.statement

    @property
    def line(self) -> int | None:
        """The number of the line that is being executed; None when no program runs."""
        running = execution.under_way(self.state)
        line = DIRECT if running is None else running.line(self.state)
        return None if line == DIRECT else line

    @property
    def next_line(self) -> int | None:
        """The number of the line that is executed next; None when no program runs."""
        running = execution.under_way(self.state)
        line = DIRECT if running is None else running.next_line(self.state)
        return None if line == DIRECT else line

    # -- the wheel ----------------------------------------------------------------------------

    def advance(self, until_waiting: bool = False) -> None:
        """Work until the clock reaches its limit.

        Args:
            until_waiting: return as soon as the machine waits for something.
        """
        state = self.state
        clock = state.clock
        while clock.now < clock.limit:
            if until_waiting and state.stack[-1].waiting is not Waiting.NOTHING:
                return
            try:
                state.stack[-1].advance(state)
            except BasicError as error:
                execution.failed(state, error)
            except ColdStart:
                self._switch_on()

    def step_statement(self) -> None:
        """Execute one statement of the running program, for a debugger's single step.

        Whatever else the machine is doing, as a motion of the arm, goes on to the clock's limit or
        to its own end.
        """
        state = self.state
        top = state.stack[-1]
        try:
            if isinstance(top, Execution):
                top.step(state)
            else:
                top.advance(state)
        except BasicError as error:
            execution.failed(state, error)
        except ColdStart:
            self._switch_on()

    def aside(self, crunched: bytes) -> None:
        """Do an assignment or a POKE beside what the machine is doing, in no time.

        Raises:
            BasicError: what the machine says to it.
            ValueError: it is another statement, or not one alone.
        """
        aside.do(self.state, crunched)

    def push_reset(self) -> None:
        """The reset button: from machine code to READY; BASIC itself has BREAK."""
        machine_code.push_reset(self.state)

    # -- instead of the keyboard --------------------------------------------------------------

    def execute_direct(self, crunched: bytes) -> None:
        """Run a direct line."""
        execution.execute_direct(self.state, crunched)

    def store_line(self, number: int, text: bytes) -> None:
        """Store a line as it is typed (not crunched) under a number.

        Raises:
            BasicError: OM when it does not fit.
        """
        editing.store_line(self.state, number, text)

    def load_lines(self, lines: Iterable[tuple[int, bytes]]) -> None:
        """Replace the program by crunched lines; what does not fit is left out with ?OM."""
        editing.load_lines(self.state, lines)
