"""The room between the variables and the Z-80's stack, and what needs how much of it.

The ROM looks before it opens a loop or a subroutine, before it makes a variable, and each time it
evaluates an expression, so a program that fills memory fails with ?OM in a certain statement. The
numbers were measured on the ROM by leaving ever less memory free.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from trs80arm.basic.errors import BasicError, Code

if TYPE_CHECKING:
    from trs80arm.basic.control import Control
    from trs80arm.basic.string_space import StringSpace
    from trs80arm.basic.variables import Variables

STACK_AT_REST: Final = 2
"""Bytes of the stack in use between two statements."""
MEM_DEPTH: Final = 12
"""What MEM finds in use besides, in a PRINT list."""
EXPRESSION: Final = 70
"""Free bytes that an expression needs, besides what its nesting takes."""
PARENTHESIS: Final = 6
"""What a level of parentheses, a minus sign or a NOT takes."""
FUNCTION: Final = 10
"""What a function takes, its parentheses included."""
OPERATOR: Final = 8
"""What an operator takes while its right side is evaluated, besides its left operand."""
LET: Final = 4
GOSUB: Final = 70
FOR: Final = 78
LIMIT: Final = 4
STEP: Final = 6
"""What FOR takes while its limit and its step are evaluated."""
SUBSCRIPT: Final = 18
CONDITION: Final = 2
"""What IF and ON take."""
VARIABLE: Final = 76
"""Free bytes that must remain when a simple variable was made."""
ARRAY: Final = 68
"""Free bytes that must remain when an array was made."""
CLEAR: Final = 40
"""Bytes that CLEAR n must leave above the program."""
LINE: Final = 62
"""Free bytes that must remain when a line was stored."""
FEW: Final = 50
_PLENTY: Final = 2000
TIGHT: Final = 400
"""With less than this the compiled statements look for room in every expression."""


class Room:
    """The free memory of one interpreter.

    Attributes:
        tight: whether memory has been so short that expressions must look for room.
        plenty: whether `FEW` loops and subroutines are sure to fit.
    """

    # Also in machines that are made as copies attributes are then found at once.
    __slots__ = ("_control", "_strings", "_variables", "plenty", "tight")

    def __init__(self, strings: StringSpace, variables: Variables, control: Control) -> None:
        self._strings = strings
        self._variables = variables
        self._control = control
        self.tight = False
        self.plenty = False

    def free(self) -> int:
        """Bytes between the variables and the stack."""
        used = self._control.stack_bytes() + STACK_AT_REST
        return self._strings.bottom - self._variables.end - used

    def need(self, size: int) -> None:
        """OM unless so many bytes are free."""
        free = self.free()
        self._look(size)
        if free - size < TIGHT:
            self.tight = True
        if free < size:
            raise BasicError(Code.OM)

    def relax(self) -> None:
        """Everything was cleared: look again."""
        self._look(0)
        self.tight = self.free() < TIGHT

    def _look(self, size: int) -> None:
        self.plenty = self._strings.bottom - self._variables.end - size >= _PLENTY
