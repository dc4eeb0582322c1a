"""Statements and functions that reach the machine: memory, ports, graphics, tape, the arm."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from trs80arm.basic import addresses
from trs80arm.basic.code_calls import USR
from trs80arm.basic.dialogue import machine_code
from trs80arm.basic.dialogue.arm_motion import ArmMotion
from trs80arm.basic.dialogue.system import SystemCommand
from trs80arm.basic.dialogue.tape_statements import Cload, Csave, PrintTape
from trs80arm.basic.errors import BasicError, Code
from trs80arm.basic.execution import CodeCall, Leave
from trs80arm.basic.numbers import rnd
from trs80arm.basic.numbers.convert import Number
from trs80arm.basic.runtime.part import Part
from trs80arm.basic.state import Activity

_REFRESH_STEP = 7
"""T-states in which the Z-80's refresh register counts up by one, on average."""


class Hardware(Part):
    """The machine's side of the language."""

    def peek(self, address: int) -> int:
        """PEEK."""
        return self._memory.peek(address & 0xFFFF)

    def poke(self, address: int, value: int, following: int) -> None:
        """POKE; the statement loop looks around when the program itself was changed."""
        self._memory.poke(address & 0xFFFF, value)
        if self._state.engine.stale:
            raise Leave(following)

    def read_port(self, port: int) -> int:
        """INP."""
        return self._state.host.ports.read(port)

    def write_port(self, port: int, value: int) -> None:
        """OUT."""
        self._state.host.ports.write(port, value)

    def point(self, x: int, y: int) -> int:
        """POINT."""
        return -1 if self._console.point(x, y) else 0

    def plot(self, x: int, y: int, lit: bool) -> None:
        """SET and RESET."""
        self._console.plot(x, y, lit)

    def rnd(self, number: int) -> float:
        """RND."""
        self._state.seed, value = rnd.rnd(self._state.seed, number)
        return value

    def randomize(self) -> None:
        """RANDOM: the refresh register into the middle byte of the seed."""
        refresh = self._clock.now // _REFRESH_STEP & 0x7F
        self._state.seed = self._state.seed & 0xFF00FF | refresh << 8

    def user_routine(self, argument: Any) -> Number:
        """USR where a number is wanted; TM for a string that it gives."""
        value = self.user_value(argument)
        if isinstance(value, list):
            self._strings.free(value)
            raise BasicError(Code.TM)
        number: Number = value
        return number

    def user_value(self, argument: Any) -> Any:
        """USR: machine code with an argument; the statement is executed again when it is done."""
        calls = self._state.code_calls
        if calls.active and calls.replays(USR):
            if isinstance(argument, list):
                self._strings.free(argument)
            value = calls.next()
            # It was charged to here before the code was called.
            self._clock.now = calls.resumed - calls.pending
            return self._strings.new(value) if isinstance(value, bytes) else value
        if not calls.active:
            # A subscript in INPUT's list, which is no statement of its own.
            raise BasicError(Code.FC)
        machine_code.call(self._state, argument)
        self._strings.temporaries.clear()
        raise CodeCall

    # -- tape ---------------------------------------------------------------------------------

    def tape_unit(self, number: int) -> int:
        """The recorder of `#-1` and `#-2`; FC for another number."""
        if number not in (-1, -2):
            raise BasicError(Code.FC)
        return -number

    def _do(self, activity: Activity, following: int) -> None:
        self._state.begin(activity)
        raise Leave(following)

    def begin_csave(self, name: bytes | BasicError, following: int) -> None:
        """CSAVE."""
        self._do(Csave(name), following)

    def begin_cload(self, name: bytes | BasicError | None, verify: bool, following: int) -> None:
        """CLOAD and CLOAD?."""
        self._do(Cload(name, verify=verify), following)

    def begin_tape_print(self, data: bytes | BasicError, following: int) -> None:
        """PRINT#-1."""
        self._do(PrintTape(data), following)

    def begin_system(self) -> None:
        """SYSTEM."""
        self._do(SystemCommand(), addresses.INPUT_BUFFER)

    # -- the arm ------------------------------------------------------------------------------

    def arm_step(self, delay: int, steps: Sequence[int], following: int) -> None:
        """`@STEP`."""
        arm = self._state.host.arm
        if arm is not None:
            arm.step(delay, steps)
            self._do(ArmMotion(), following)

    def arm_close(self, delay: int | None, following: int) -> None:
        """`@CLOSE`."""
        arm = self._state.host.arm
        if arm is not None:
            arm.close(delay)
            self._do(ArmMotion(), following)

    def arm_set(self, delay: int | None, following: int) -> None:
        """`@SET`."""
        arm = self._state.host.arm
        if arm is not None:
            arm.set(delay)
            self._do(ArmMotion(manual=True), following)

    def arm_reset(self) -> None:
        """`@RESET`."""
        arm = self._state.host.arm
        if arm is not None:
            arm.reset()

    def arm_read(self) -> tuple[int, ...]:
        """`@READ`: the six position registers."""
        arm = self._state.host.arm
        return (0,) * 6 if arm is None else arm.read()
