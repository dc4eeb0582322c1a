"""How tightly operators bind, in the numbers of the ROM (Level II facts, Expressions)."""

from __future__ import annotations

from typing import Final

from trs80arm.basic import tokens

RELATION: Final = 0x64
UNARY_MINUS: Final = 0x7D
NOT: Final = 0x5A
BINARY: Final = {
    tokens.PLUS: 0x79,
    tokens.MINUS: 0x79,
    tokens.TIMES: 0x7C,
    tokens.DIVIDE: 0x7C,
    tokens.POWER: 0x7F,
    tokens.AND: 0x50,
    tokens.OR: 0x46,
}
"""Token of an operator between two operands to what it binds with; relations apart."""
