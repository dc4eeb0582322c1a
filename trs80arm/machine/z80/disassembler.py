"""Z-80 instructions as text, one at a time, from tables: the documented ones and the others.

An opcode is taken apart into its two highest bits, the three in the middle and the three lowest;
what these mean together is what the tables say. Prefixes CBH and EDH choose another table, DDH and
FDH put IX or IY in the place of HL. What is no instruction is shown as the bytes that it is.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

_REGISTERS: Final = ("B", "C", "D", "E", "H", "L", "(HL)", "A")
_PAIRS: Final = ("BC", "DE", "HL", "SP")
_PAIRS_ON_STACK: Final = ("BC", "DE", "HL", "AF")
_CONDITIONS: Final = ("NZ", "Z", "NC", "C", "PO", "PE", "P", "M")
_ARITHMETIC: Final = ("ADD A,", "ADC A,", "SUB ", "SBC A,", "AND ", "XOR ", "OR ", "CP ")
_ROTATIONS: Final = ("RLC", "RRC", "RL", "RR", "SLA", "SRA", "SLL", "SRL")
_ACCUMULATOR: Final = ("RLCA", "RRCA", "RLA", "RRA", "DAA", "CPL", "SCF", "CCF")
_MODES: Final = ("0", "0", "1", "2", "0", "0", "1", "2")
_ED_LAST: Final = ("LD I,A", "LD R,A", "LD A,I", "LD A,R", "RRD", "RLD")
_BLOCKS: Final = (
    ("LDI", "CPI", "INI", "OUTI"),
    ("LDD", "CPD", "IND", "OUTD"),
    ("LDIR", "CPIR", "INIR", "OTIR"),
    ("LDDR", "CPDR", "INDR", "OTDR"),
)
_CB, _DD, _ED, _FD = 0xCB, 0xDD, 0xED, 0xFD
MOST_BYTES: Final = 4
"""Bytes of the longest instruction."""


@dataclass(frozen=True)
class Instruction:
    """One instruction.

    Attributes:
        address: where it stands.
        code: its bytes.
        text: as an assembler would have it; numbers in hex, `0A5H`.
    """

    address: int
    code: bytes
    text: str

    @property
    def next(self) -> int:
        """The address behind it."""
        return self.address + len(self.code) & 0xFFFF

    @property
    def is_call(self) -> bool:
        """Whether it comes back behind itself: a CALL, an RST, or what repeats itself."""
        word = self.text.partition(" ")[0]
        return word in ("CALL", "RST", "HALT", "DJNZ") or self.text in _REPEATING


_REPEATING: Final = frozenset((*_BLOCKS[2], *_BLOCKS[3]))


def disassemble(peek: Callable[[int], int], address: int) -> Instruction:
    """The instruction at an address.

    Args:
        peek: gives the byte at an address, 0 to 65535.
        address: of its first byte; behind 65535 comes 0.
    """
    reader = _Reader(peek, address)
    text = reader.instruction()
    return Instruction(address & 0xFFFF, bytes(reader.read), text)


def listing(peek: Callable[[int], int], address: int, count: int) -> list[Instruction]:
    """So many instructions from an address on."""
    found = []
    for _ in range(count):
        found.append(disassemble(peek, address))
        address = found[-1].next
    return found


def number(value: int, digits: int) -> str:
    """A number in hex as assemblers have it: a letter in front gets a zero."""
    text = f"{value:0{digits}X}H"
    return text if text[0].isdigit() else f"0{text}"


class _Reader:
    def __init__(self, peek: Callable[[int], int], address: int) -> None:
        self._peek = peek
        self._address = address
        self.read = bytearray()
        self._index = ""

    def _byte(self) -> int:
        value = self._peek(self._address + len(self.read) & 0xFFFF)
        self.read.append(value)
        return value

    def _n(self) -> str:
        return number(self._byte(), 2)

    def _nn(self) -> str:
        low = self._byte()
        return number(low | self._byte() << 8, 4)

    def _relative(self) -> str:
        offset = self._byte()
        target = self._address + len(self.read) + (offset ^ 0x80) - 0x80
        return number(target & 0xFFFF, 4)

    def _displaced(self, offset: int) -> str:
        sign, size = ("-", 0x100 - offset) if offset & 0x80 else ("+", offset)
        return f"({self._index}{sign}{number(size, 2)})"

    def _pair(self, names: tuple[str, ...], place: int) -> str:
        name = names[place]
        return self._index or name if name == "HL" else name

    def _register(self, place: int, *, plain: bool = False) -> str:
        """A register; with an index its halves, or the byte that it points beside."""
        name = _REGISTERS[place]
        if not self._index:
            return name
        if name == "(HL)":
            return self._displaced(self._byte())
        return self._index + name if name in ("H", "L") and not plain else name

    def instruction(self) -> str:
        opcode = self._byte()
        if opcode == _CB:
            return self._bits(self._byte(), "")
        if opcode == _ED:
            return self._extended(self._byte())
        if opcode in (_DD, _FD):
            self._index = "IX" if opcode == _DD else "IY"
            following = self._peek(self._address + 1 & 0xFFFF)
            if following in (_DD, _ED, _FD):
                return self._no_instruction()
            self._byte()
            if following == _CB:
                offset = self._byte()
                return self._bits(self._byte(), self._displaced(offset))
            if not _has_hl(following):
                del self.read[1:]
                return self._no_instruction()
            return self._main(following)
        return self._main(opcode)

    def _no_instruction(self) -> str:
        return "DEFB " + ",".join(number(value, 2) for value in self.read)

    def _main(self, opcode: int) -> str:
        high, middle, low = opcode >> 6, opcode >> 3 & 7, opcode & 7
        if high == 0:
            return self._loads_and_jumps(middle, low)
        if high == 1:
            if opcode == 0x76:
                return "HALT"
            # Beside a byte that an index points to, H and L are themselves.
            memory = 6 in (middle, low)
            target = self._register(middle, plain=memory)
            return f"LD {target},{self._register(low, plain=memory)}"
        if high == 2:
            return _ARITHMETIC[middle] + self._register(low)
        return self._calls_and_the_rest(middle, low)

    def _loads_and_jumps(self, middle: int, low: int) -> str:
        pair, second = middle >> 1, middle & 1
        if low == 0:
            return self._jumps(middle)
        if low == 1:
            if second:
                return f"ADD {self._index or 'HL'},{self._pair(_PAIRS, pair)}"
            return f"LD {self._pair(_PAIRS, pair)},{self._nn()}"
        if low == 2:
            if pair < 2:
                where = f"({_PAIRS[pair]})"
                return f"LD A,{where}" if second else f"LD {where},A"
            where = f"({self._nn()})"
            name = "A" if pair == 3 else self._index or "HL"
            return f"LD {name},{where}" if second else f"LD {where},{name}"
        if low == 3:
            return f"{'DEC' if second else 'INC'} {self._pair(_PAIRS, pair)}"
        if low < 6:
            return f"{'INC' if low == 4 else 'DEC'} {self._register(middle)}"
        if low == 6:
            target = self._register(middle)
            return f"LD {target},{self._n()}"
        return _ACCUMULATOR[middle]

    def _jumps(self, middle: int) -> str:
        if middle == 0:
            return "NOP"
        if middle == 1:
            return "EX AF,AF'"
        if middle == 2:
            return f"DJNZ {self._relative()}"
        if middle == 3:
            return f"JR {self._relative()}"
        return f"JR {_CONDITIONS[middle - 4]},{self._relative()}"

    def _calls_and_the_rest(self, middle: int, low: int) -> str:
        pair, second = middle >> 1, middle & 1
        hl = self._index or "HL"
        if low == 0:
            return f"RET {_CONDITIONS[middle]}"
        if low == 1:
            if not second:
                return f"POP {self._pair(_PAIRS_ON_STACK, pair)}"
            return ("RET", "EXX", f"JP ({hl})", f"LD SP,{hl}")[pair]
        if low == 2:
            return f"JP {_CONDITIONS[middle]},{self._nn()}"
        if low == 3:
            if middle == 0:
                return f"JP {self._nn()}"
            if middle == 2:
                return f"OUT ({self._n()}),A"
            if middle == 3:
                return f"IN A,({self._n()})"
            return ("", "", "", "", f"EX (SP),{hl}", "EX DE,HL", "DI", "EI")[middle]
        if low == 4:
            return f"CALL {_CONDITIONS[middle]},{self._nn()}"
        if low == 5:
            return f"CALL {self._nn()}" if second else f"PUSH {self._pair(_PAIRS_ON_STACK, pair)}"
        if low == 6:
            return _ARITHMETIC[middle] + self._n()
        return f"RST {number(middle * 8, 2)}"

    def _bits(self, opcode: int, memory: str) -> str:
        """Behind CBH; with an index the byte beside it, which may go into a register as well."""
        high, middle, low = opcode >> 6, opcode >> 3 & 7, opcode & 7
        what = memory or _REGISTERS[low]
        # BIT leaves nothing to keep.
        also = f",{_REGISTERS[low]}" if memory and low != 6 and high != 1 else ""
        if high == 0:
            return f"{_ROTATIONS[middle]} {what}{also}"
        return f"{('', 'BIT', 'RES', 'SET')[high]} {middle},{what}{also}"

    def _extended(self, opcode: int) -> str:
        high, middle, low = opcode >> 6, opcode >> 3 & 7, opcode & 7
        pair, second = middle >> 1, middle & 1
        if high == 2 and low < 4 and middle > 3:
            return _BLOCKS[middle - 4][low]
        if high != 1:
            return self._no_instruction()
        if low == 0:
            return "IN F,(C)" if middle == 6 else f"IN {_REGISTERS[middle]},(C)"
        if low == 1:
            return f"OUT (C),{'0' if middle == 6 else _REGISTERS[middle]}"
        if low == 2:
            return f"{'ADC' if second else 'SBC'} HL,{_PAIRS[pair]}"
        if low == 3:
            where = f"({self._nn()})"
            return f"LD {_PAIRS[pair]},{where}" if second else f"LD {where},{_PAIRS[pair]}"
        if low == 4:
            return "NEG"
        if low == 5:
            return "RETI" if middle == 1 else "RETN"
        if low == 6:
            return f"IM {_MODES[middle]}"
        return _ED_LAST[middle] if middle < 6 else self._no_instruction()


def _has_hl(opcode: int) -> bool:
    """Whether an index prefix changes anything: whether HL, H, L or (HL) is in it."""
    high, middle, low = opcode >> 6, opcode >> 3 & 7, opcode & 7
    if high == 0:
        if low in (1, 3):
            return (low == 1 and middle & 1 == 1) or middle >> 1 == 2
        return (low == 2 and middle >> 1 == 2) or (low in (4, 5, 6) and middle in (4, 5, 6))
    if high == 1:
        return opcode != 0x76 and (middle in (4, 5, 6) or low in (4, 5, 6))
    if high == 2:
        return low in (4, 5, 6)
    return opcode in (0xE1, 0xE3, 0xE5, 0xE9, 0xF9)
