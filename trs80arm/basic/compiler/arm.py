"""The five ARMBASIC statements: `@` and the word STEP, CLOSE, SET, RESET or READ.

The text between them is parsed like Level II's own statements; the motions themselves are the
driver's (the article, Table 1; Level II facts, The at sign).
"""

from __future__ import annotations

from trs80arm.basic import tokens
from trs80arm.basic.compiler.output import OutputCompiler
from trs80arm.basic.errors import Code
from trs80arm.basic.variables import STRING

JOINTS = 6


class ArmCompiler(OutputCompiler):
    """The `@` statements.

    Attributes:
        armbasic: whether ARMBASIC is loaded; without it `@` is ?SN.
    """

    armbasic: bool

    def arm(self) -> bool:
        """The statement behind an `@`."""
        reader, out = self.reader, self.out
        word = reader.advance() if self.armbasic else 0
        if word not in (tokens.STEP, tokens.CLOSE, tokens.SET, tokens.RESET, tokens.READ):
            raise self.mistake(Code.SN)
        reader.advance()
        if word == tokens.READ:
            self._read()
        elif word == tokens.RESET:
            if not reader.at_end:
                raise self.mistake(Code.SN)
            out.charge()
            out.emit("arm_reset()")
        elif word == tokens.STEP:
            self._step()
        else:
            delay = "None"
            if not reader.at_end:
                delay = out.keep(f"subscript({self.number().text})")
                self._end()
            out.charge()
            name = "arm_close" if word == tokens.CLOSE else "arm_set"
            out.emit(f"{name}({delay}, {reader.address})")
        return True

    def _end(self) -> None:
        """Nothing but the end of the statement may stand here."""
        if not self.reader.at_end:
            raise self.mistake(Code.SN)

    def _step(self) -> None:
        """`@STEP D[,J1[,..J6]]`; joints left out do not move."""
        delay = self.out.keep(f"subscript({self.number().text})")
        joints: list[str] = []
        while self.reader.code == 0x2C:
            if len(joints) == JOINTS:
                raise self.mistake(Code.SN)
            self.reader.advance()
            joints.append(self.out.keep(self.integer()))
        self._end()
        joints += ["0"] * (JOINTS - len(joints))
        self.out.charge()
        self.out.emit(f"arm_step({delay}, ({', '.join(joints)}), {self.reader.address})")

    def _read(self) -> None:
        """`@READ V1[,..V6]`: the position registers into numeric variables."""
        self.out.charge()
        self.out.emit("registers = arm_read()")
        for joint in range(JOINTS):
            target = self.target()
            if target.kind == STRING:
                raise self.mistake(Code.TM)
            self.out.emit(f"{target.text} = as_kind({target.kind!r}, registers[{joint}])")
            if self.reader.code != 0x2C:
                return
            self.reader.advance()
        raise self.mistake(Code.SN)
