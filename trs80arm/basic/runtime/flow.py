"""Loops, subroutines, error traps and the ends of programs."""

from __future__ import annotations

from typing import NoReturn

from trs80arm.basic import costs, endings, room, words
from trs80arm.basic.control import TRACE_ON, ForFrame, GosubFrame
from trs80arm.basic.dialogue import auto, edit, lister
from trs80arm.basic.errors import BasicError, Code, LineError
from trs80arm.basic.execution import Execution, Leave, under_way
from trs80arm.basic.kinds import INTEGER
from trs80arm.basic.numbers import integer, single
from trs80arm.basic.outcome import Ending
from trs80arm.basic.program import LINE_HEAD
from trs80arm.basic.runtime.part import Part
from trs80arm.basic.variables import Scalar

_NEXT = words.word("NEXT")
_LAST = 0xFFF0
"""No statement begins behind this address."""


class Flow(Part):
    """Control flow at run time."""

    def _execution(self) -> Execution:
        execution = under_way(self._state)
        if execution is None:
            raise LookupError("no program is running")
        return execution

    # -- the stack of loops and subroutines ---------------------------------------------------

    def room(self, size: int) -> None:
        """OM unless an expression finds its room on the stack."""
        self._state.need_room(size)

    def open_subroutine(self, back: int, line: int) -> None:
        """GOSUB."""
        self._state.need_room(room.GOSUB)
        self._control.frames.append(GosubFrame(back, line))

    def close_subroutine(self) -> int:
        """RETURN: the address behind the GOSUB; RG without one."""
        frames = self._control.frames
        while len(frames) > 1:
            frame = frames.pop()
            if isinstance(frame, GosubFrame):
                return frame.back
        # The ROM takes the byte behind the last frame, which is no GOSUB's, from the stack.
        self._control.slip += 1
        raise BasicError(Code.RG)

    def drop_loop(self, scalar: Scalar) -> None:
        """An open loop of the same variable goes, with all inside it."""
        frames = self._control.frames
        place = len(frames) - 1
        while (looping := frames[place].scalar) is not None:
            if looping is scalar:
                del frames[place:]
                return
            place -= 1

    def _find_loop(self, scalar: Scalar | None) -> int | None:
        """The innermost loop, or that of a variable; a subroutine hides what is outside it."""
        frames = self._control.frames
        place = len(frames) - 1
        while isinstance(frames[place], ForFrame):
            if scalar is None or frames[place].scalar is scalar:
                return place
            place -= 1
        return None

    def open_loop(
        self, scalar: Scalar, limit: float, step: float, body: int, line: int
    ) -> ForFrame:
        """FOR; the frame that it opens. OM when the stack comes too near to the variables.

        With few frames and much memory there is nothing to look at.
        """
        frames = self._control.frames
        if len(frames) >= room.FEW or not self._state.room.plenty:
            self._state.need_room(room.FOR)
        frame = ForFrame(scalar, limit, step, body, line)
        frames.append(frame)
        return frame

    @staticmethod
    def goes_on(value: float, frame: ForFrame) -> bool:
        """Whether a loop goes on whose step is not positive."""
        if frame.up:
            return value >= frame.limit if frame.up < 0 else value <= frame.limit
        return value != frame.limit

    def step_loop(self, scalar: Scalar | None) -> int:
        """NEXT: the address of the body, 0 when the loop is done; NF without a loop."""
        frames = self._control.frames
        place = self._find_loop(scalar)
        if place is None:
            raise BasicError(Code.NF)
        del frames[place + 1 :]
        frame = frames[place]
        assert isinstance(frame, ForFrame)
        cell = frame.scalar.cell
        if frame.scalar.kind == INTEGER:
            value: float = integer.step(cell.cell_contents, int(frame.step))
        else:
            value = single.add(cell.cell_contents, frame.step)
        cell.cell_contents = value
        if self.goes_on(value, frame):
            return frame.body
        frames.pop()
        return 0

    def other_step(self, charged: int) -> int:
        """T-states that NEXT without a name takes beside those for the loop that was expected."""
        frame = self._control.frames[-1]
        integer = frame.scalar is not None and frame.scalar.kind == INTEGER
        return (costs.NEXT_INTEGER if integer else _NEXT.work) - charged

    # -- errors -------------------------------------------------------------------------------

    def set_trap(self, address: int) -> None:
        """ON ERROR GOTO; 0 in a handler raises the error again."""
        control = self._control
        control.trap = address
        if not address and control.handling:
            raise LineError(Code(min(control.error // 2 + 1, 23)), control.error_line)

    def raise_error(self, code: int) -> NoReturn:
        """ERROR n; FC for 0."""
        if not code:
            raise BasicError(Code.FC)
        error = BasicError(Code(code) if code <= Code.L3 else Code.UE)
        raise error

    def error_code(self) -> int:
        """ERR."""
        return self._control.error

    def error_line(self) -> float:
        """ERL, a single."""
        return float(self._control.error_line)

    def end_handling(self) -> None:
        """RESUME begins: RW unless an error is being handled."""
        if not self._control.handling:
            raise BasicError(Code.RW)
        self._control.handling = False
        self._control.error = 0

    def resume_again(self) -> int:
        """RESUME: the failing statement again."""
        return self._control.error_address

    def resume_next(self) -> int:
        """RESUME NEXT: the separator behind the failing statement."""
        # POKEd astray, the address may leave too little memory behind it.
        address = min(self._control.error_address, _LAST)
        text = address + 1 if self._ram[address] else address + 1 + LINE_HEAD
        return self._state.program.statement_end(text)

    # -- ends ---------------------------------------------------------------------------------

    def end_of_text(self, address: int) -> NoReturn:
        """The program's, or the direct line's, end; NR inside an error handler."""
        execution = self._execution()
        control = self._control
        if address >= self._state.program.start - 1 and control.handling and control.trap:
            raise BasicError(Code.NR)
        self._stop(execution, address, Ending.END)

    def _stop(self, execution: Execution, address: int, ending: Ending) -> NoReturn:
        endings.stop(self._state, execution.line(self._state), address, ending)
        raise Leave(address)

    def end_program(self, address: int) -> NoReturn:
        """END."""
        self._stop(self._execution(), address, Ending.END)

    def stop_program(self, address: int) -> NoReturn:
        """STOP."""
        self._stop(self._execution(), address, Ending.STOP)

    def new_program(self) -> NoReturn:
        """NEW."""
        self._output.clear_screen()
        self._control.trace = 0
        self._state.clear_program()
        self._state.return_to_command()
        raise Leave(0)

    def start_program(self) -> None:
        """RUN: forget everything that a run leaves behind."""
        self._state.clear_all()
        self._state.outcome = None

    def continue_program(self) -> int:
        """CONT; CN when there is nothing to go on with."""
        address = self._control.resume_address
        if not address:
            raise BasicError(Code.CN)
        return address

    def now_at(self, address: int) -> None:
        """A statement inside a block that looks at the machine begins."""
        self._execution().statement = address

    def leave(self, address: int) -> NoReturn:
        """Have the statement loop look around."""
        raise Leave(address)

    def trace(self, on: bool) -> None:
        """TRON and TROFF."""
        self._control.trace = TRACE_ON if on else 0

    # -- commands -----------------------------------------------------------------------------

    def list_lines(self, text: bytes) -> NoReturn:
        """LIST, to the device that 409CH names."""
        if self._output.on_printer:
            self._output.to_screen()
            self.list_printer(text)
        lister.list_lines(self._state, text)
        raise Leave(0)

    def list_printer(self, text: bytes) -> NoReturn:
        """LLIST."""
        lister.llist(self._state, text)
        raise Leave(0)

    def delete_lines(self, text: bytes) -> NoReturn:
        """DELETE."""
        lister.delete(self._state, text)
        raise Leave(0)

    def edit_line(self, text: bytes) -> NoReturn:
        """EDIT."""
        edit.edit(self._state, text)
        raise Leave(0)

    def auto_lines(self, text: bytes) -> NoReturn:
        """AUTO."""
        auto.auto(self._state, text)
        raise Leave(0)
