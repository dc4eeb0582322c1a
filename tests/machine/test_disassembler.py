"""Z-80 instructions as text."""

from __future__ import annotations

from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from trs80arm.machine.z80.disassembler import MOST_BYTES, disassemble, listing


def text(code: str, address: int = 0x7000) -> tuple[str, int]:
    data = bytes.fromhex(code)
    found = disassemble(lambda at: (data + bytes(8))[at - address & 0xFFFF], address)
    return found.text, len(found.code)


@pytest.mark.parametrize(
    ("code", "told"),
    [
        ("00", "NOP"),
        ("08", "EX AF,AF'"),
        ("10FE", "DJNZ 7000H"),
        ("20FE", "JR NZ,7000H"),
        ("187F", "JR 7081H"),
        ("01A0C3", "LD BC,0C3A0H"),
        ("220040", "LD (4000H),HL"),
        ("3A0040", "LD A,(4000H)"),
        ("12", "LD (DE),A"),
        ("34", "INC (HL)"),
        ("3605", "LD (HL),05H"),
        ("27", "DAA"),
        ("76", "HALT"),
        ("7E", "LD A,(HL)"),
        ("96", "SUB (HL)"),
        ("CE0F", "ADC A,0FH"),
        ("C0", "RET NZ"),
        ("F5", "PUSH AF"),
        ("E3", "EX (SP),HL"),
        ("EB", "EX DE,HL"),
        ("E9", "JP (HL)"),
        ("D3FF", "OUT (0FFH),A"),
        ("DB98", "IN A,(98H)"),
        ("FC0050", "CALL M,5000H"),
        ("EF", "RST 28H"),
        ("CB37", "SLL A"),
        ("CB46", "BIT 0,(HL)"),
        ("CBFF", "SET 7,A"),
        ("ED40", "IN B,(C)"),
        ("ED70", "IN F,(C)"),
        ("ED71", "OUT (C),0"),
        ("ED42", "SBC HL,BC"),
        ("ED7B0040", "LD SP,(4000H)"),
        ("ED4D", "RETI"),
        ("ED5E", "IM 2"),
        ("ED57", "LD A,I"),
        ("ED67", "RRD"),
        ("EDB0", "LDIR"),
        ("EDBB", "OTDR"),
        ("ED00", "DEFB 0EDH,00H"),
        ("DD210040", "LD IX,4000H"),
        ("DD7E05", "LD A,(IX+05H)"),
        ("FD70FE", "LD (IY-02H),B"),
        ("DD360506", "LD (IX+05H),06H"),
        ("DD6601", "LD H,(IX+01H)"),
        ("DD65", "LD IXH,IXL"),
        ("FD2C", "INC IYL"),
        ("DD29", "ADD IX,IX"),
        ("DD09", "ADD IX,BC"),
        ("DDE9", "JP (IX)"),
        ("FDF9", "LD SP,IY"),
        ("DDCB0546", "BIT 0,(IX+05H)"),
        ("DDCB05C6", "SET 0,(IX+05H)"),
        ("FDCBFF10", "RL (IY-01H),B"),
        ("DDDD", "DEFB 0DDH"),
        ("DD00", "DEFB 0DDH"),
        ("DDEB", "DEFB 0DDH"),
    ],
)
def test_an_instruction_is_told(code: str, told: str) -> None:
    assert text(code)[0] == told


def test_every_byte_sequence_is_told_and_as_long_as_the_processor_has_it() -> None:
    z80 = pytest.importorskip("z80")
    for prefix in ("", "CB", "ED", "DD", "FD", "DDCB05", "FDCBF0"):
        for opcode in range(256):
            code = f"{prefix}{opcode:02X}1234"
            told, length = text(code, 0)
            if told.startswith("DEFB"):
                continue
            assert length == z80.Z80Machine._disasm(bytes.fromhex(code) + bytes(4))[1], code


@given(st.binary(min_size=65536 // 64, max_size=65536 // 64), st.integers(0, 0xFFFF))
def test_a_listing_goes_through_any_memory_without_a_gap(memory: bytes, address: int) -> None:
    found = listing(lambda at: memory[at % len(memory)], address, 20)
    assert found[0].address == address
    for one, following in pairwise(found):
        assert 1 <= len(one.code) <= MOST_BYTES
        assert following.address == one.next
