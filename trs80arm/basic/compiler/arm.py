"""The five ARMBASIC statements: `@` and the word STEP, CLOSE, SET, RESET or READ.

The text between them is parsed like Level II's own statements; the motions themselves are the
driver's (the article, Table 1; Level II facts, The at sign).
"""

from __future__ import annotations

from trs80arm.basic import tokens
from trs80arm.basic.characters import COMMA
from trs80arm.basic.compiler.assignments import AssignmentCompiler
from trs80arm.basic.compiler.draft import Draft, Mistake
from trs80arm.basic.compiler.expressions import ExpressionCompiler
from trs80arm.basic.errors import Code
from trs80arm.basic.kinds import STRING

JOINTS = 6


class ArmCompiler:
    """The `@` statements.

    Args:
        draft: the statement.
        expressions: who reads delays and steps.
        assignments: who reads the variables of `@READ`.
    """

    def __init__(
        self, draft: Draft, expressions: ExpressionCompiler, assignments: AssignmentCompiler
    ) -> None:
        self._draft = draft
        self._reader = draft.reader
        self._out = draft.out
        self._expressions = expressions
        self._assignments = assignments
        self._commands = {
            tokens.STEP: self._step,
            tokens.CLOSE: self._close,
            tokens.SET: self._set,
            tokens.RESET: self._reset,
            tokens.READ: self._read,
        }

    def statement(self) -> None:
        """The statement behind an `@`; SN for anything but the five words."""
        command = self._commands.get(self._reader.advance())
        if command is None:
            raise Mistake(Code.SN)
        self._reader.advance()
        command()

    def _end(self) -> None:
        """Nothing but the end of the statement may stand here."""
        if not self._reader.at_end:
            raise Mistake(Code.SN)

    def _step(self) -> None:
        """`@STEP D[,J1[,..J6]]`; joints left out do not move."""
        delay = self._out.keep(self._expressions.whole().text)
        joints: list[str] = []
        while self._reader.code == COMMA:
            if len(joints) == JOINTS:
                raise Mistake(Code.SN)
            self._reader.advance()
            joints.append(self._out.keep(self._expressions.integer().text))
        self._end()
        joints += ["0"] * (JOINTS - len(joints))
        self._out.charge()
        self._out.emit(
            f"arm_step({delay}, ({', '.join(joints)}), {self._out.address(self._reader.address)})"
        )

    def _close(self) -> None:
        """`@CLOSE [D]`."""
        delay = self._delay()
        self._out.emit(f"arm_close({delay}, {self._out.address(self._reader.address)})")

    def _set(self) -> None:
        """`@SET [D]`."""
        delay = self._delay()
        self._out.emit(f"arm_set({delay}, {self._out.address(self._reader.address)})")

    def _delay(self) -> str:
        delay = "None"
        if not self._reader.at_end:
            delay = self._out.keep(self._expressions.whole().text)
            self._end()
        self._out.charge()
        return delay

    def _reset(self) -> None:
        """`@RESET`."""
        self._end()
        self._out.charge()
        self._out.emit("arm_reset()")

    def _read(self) -> None:
        """`@READ V1[,..V6]`: the position registers into numeric variables."""
        out = self._out
        out.charge()
        out.emit("registers = arm_read()")
        for joint in range(JOINTS):
            target = self._assignments.target()
            if target.kind == STRING:
                raise Mistake(Code.TM)
            kind = out.constant(target.kind)
            out.emit(f"{target.text} = to_kind({kind}, registers[{joint}])")
            if self._reader.code != COMMA:
                return
            self._reader.advance()
        raise Mistake(Code.SN)
