"""Generators of programs and texts that are almost right: grammar with slips, and mutation."""

from __future__ import annotations

import contextlib
from pathlib import Path
from random import Random
from typing import Any

from trs80arm.basic import words


def _words(text: str) -> list[str]:
    return text.split()


PROGRAMS = [
    path.read_text(encoding="latin-1")
    for path in sorted((Path(__file__).parents[2] / "programs").glob("*.bas"))
]
WORDS = [word.decode() for word in words.SPELLINGS] + ["@STEP", "@CLOSE", "@SET", "@RESET", "@READ"]
NUMBERS = _words(
    "0 1 2 -1 255 256 32767 32768 -32768 65535 65536 1E38 1.7E38 -1.7E38 1E-38 2.9E-39 1D38 .5 1.5 "
    "1# 1! 1% 1.234567890123456D10 99999999999 1E 1E+ 1E99 -0 14336 15360 16383 16384 16396 16416 "
    "16512 16526 16549 16561 16598 16633 16639 17129 20480 -2 -32767 7 10 20 100"
)
VARIABLES = _words(
    "A B I J X A% I% B% A# D# A! A$ B$ S$ Z9 AB A(1) A(I) B%(2,3) A$(3) D#(I) A(A(1)) X(0,0)"
)
TEXTS = ['""', '"A"', '"ABC"', '"-5"', '" 12 "', '"##.##"', '"$$**,.-[[[["', '"%  %!"']
TEXTS += ['"' + "X" * 200 + '"']
FUNCTIONS = _words(
    "SGN INT ABS FRE INP POS SQR RND LOG EXP COS SIN TAN ATN PEEK CINT CSNG CDBL FIX USR "
    "LEN ASC VAL CHR$ STR$ STRING$ LEFT$ RIGHT$ MID$ POINT VARPTR"
)
OPERATORS = _words("+ - * / [ AND OR = < > <= >= <> =<")
EDITABLE = 'ABCXYZ 0123456789"$:=+-*/(),;' + "PRINT"
ESCAPE = "\x1b"
"""SHIFT and the up-arrow, which ends an insertion."""
ODD_BYTES = (b"\0", b"\xff", b'"', b"[" * 50, b"9" * 400, b"\x1b]0;X\x07", b"1e400", b"nan")
ODD_JSON: tuple[Any, ...] = (
    *(None, True, 0, 1, -1, 5, 10**18, 2**63, 2**64, 10**400, 1e308, -0.0, 0.5),
    *("", "odd", "\x1b[2J", float("nan"), float("inf"), [], {}, [[]], {"hex": "00"}, {"pose": [1]}),
    *([["new", "Clock", {}]], ["same", 0], ["at", "clock"], ["bytes", "AAAA"], ["bytes", "!"]),
    *(["tuple"], ["float", "inf"]),
)
TYPABLE = "".join(map(chr, range(32, 91))) + "[`abz\x08\x09\n\x18\x19\x1a\x1b\x1f\x01\r\r\r"


def number(rng: Random) -> str:
    """A constant."""
    if rng.random() < 0.8:
        return rng.choice(NUMBERS)
    return str(rng.choice([rng.randrange(-70000, 70000), rng.uniform(-1e5, 1e5)]))


def expression(rng: Random, depth: int = 0) -> str:
    """An expression; of the right kinds most of the time."""
    pick = rng.random()
    if depth > 4 or pick < 0.2:
        return number(rng)
    if pick < 0.45:
        return rng.choice(VARIABLES)
    if pick < 0.55:
        return rng.choice(TEXTS)
    inner = depth + 1
    if pick < 0.8:
        return expression(rng, inner) + rng.choice(OPERATORS) + expression(rng, inner)
    if pick < 0.95:
        count = 1 if rng.random() < 0.6 else rng.randrange(4)
        arguments = ",".join(expression(rng, inner) for _ in range(count))
        return f"{rng.choice(FUNCTIONS)}({arguments})"
    if pick < 0.98:
        return rng.choice(["-", "NOT ", "("]) + expression(rng, inner) + rng.choice(["", ")"])
    return rng.choice(["MEM", "ERR", "ERL", "INKEY$", "TIME$"])


def statement(rng: Random, lines: int = 8) -> str:
    """A statement."""
    line = str(rng.randrange(lines + 2) * 10)
    variable = rng.choice(VARIABLES)
    value = expression(rng)
    listed = ",".join(expression(rng, 3) for _ in range(rng.randrange(4)))
    return rng.choice(
        [
            f"{variable}={value}",
            f"{variable}={value}",
            f"PRINT {value};{listed}",
            f"PRINT@{number(rng)},{value}",
            f"PRINT USING {rng.choice(TEXTS)};{value}",
            f"LPRINT {value}",
            f"GOTO {line}",
            f"GOSUB {line}",
            "RETURN",
            f"IF {value} THEN {line} ELSE PRINT {variable}",
            f"FOR I={expression(rng, 4)} TO {expression(rng, 4)} STEP {number(rng)}",
            "FOR I=1 TO 3",
            "NEXT",
            f"ON {expression(rng, 3)} GOTO {line},{line}",
            f"ON ERROR GOTO {line}",
            rng.choice(["RESUME", "RESUME NEXT", f"RESUME {line}", f"ERROR {number(rng)}"]),
            f"DIM {rng.choice(VARIABLES)}({listed})",
            f"READ {variable},{rng.choice(VARIABLES)}",
            f"DATA {number(rng)},{rng.choice(TEXTS)},X Y,",
            f"INPUT {variable}",
            f"CLEAR {rng.choice(['', '50', '0', '1000', number(rng)])}",
            f"DEF{rng.choice(['INT', 'STR', 'SNG', 'DBL'])} {rng.choice(['A', 'A-Z', 'I-J,X'])}",
            f"POKE {address(rng)},{rng.randrange(256)}",
            f"OUT {rng.choice([152, 153, 157, 158, 255, rng.randrange(256)])},{rng.randrange(256)}",
            f"SET({expression(rng, 4)},{number(rng)})",
            rng.choice(["CLS", "RANDOM", "RESTORE", "STOP", "END", "TRON", "TROFF", "CONT", "NEW"]),
            rng.choice(["LIST", "LLIST", "EDIT 10", "AUTO", "CLOAD", 'CSAVE"A"', "PRINT#-1,A,A$"]),
            f"@STEP {','.join(str(rng.randrange(-60, 60)) for _ in range(rng.randrange(1, 8)))}",
            rng.choice(["@CLOSE", "@SET", "@RESET", f"@READ {variable}", f"@CLOSE {value}"]),
            "".join(rng.choice(WORDS) for _ in range(rng.randrange(1, 6))),
        ]
    )


def address(rng: Random) -> str:
    """An address worth a POKE: system area, program, video, anywhere."""
    spans = ((0x4000, 0x4330), (0x42E9, 0x4600), (0x3C00, 0x4000), (-32768, 32768))
    return str(rng.randrange(*rng.choice(spans)))


def listing(rng: Random) -> list[str]:
    """The lines of a program."""
    if rng.random() < 0.15:
        lines = rng.choice(PROGRAMS).splitlines()
        for _ in range(rng.randrange(8)):
            place = rng.randrange(len(lines))
            lines[place] = mutated_text(rng, lines[place])
        return lines
    count = rng.randrange(1, 10)
    return [
        f"{(place + 1) * 10} " + ":".join(statement(rng) for _ in range(rng.randrange(1, 4)))
        for place in range(count)
    ]


def typed(rng: Random) -> str:
    """Keys pressed at random, commands among them."""
    return "".join(
        rng.choice(
            [
                rng.choice(TYPABLE),
                statement(rng) + "\r",
                f"{rng.randrange(99)} {statement(rng)}\r",
                rng.choice(["RUN\r", "LIST\r", "EDIT .\r", "EDIT 10\r", "AUTO\r", "NEW\r", "\x01"]),
            ]
        )
        for _ in range(rng.randrange(1, 20))
    )


def edit_keys(rng: Random) -> str:
    """EDIT begun on a line, and keys pressed in it: commands, counts, texts, ways out."""
    keys = [f"EDIT {rng.choice(['10', '20', '30', '.', '99', ''])}\r"]
    for _ in range(rng.randrange(1, 16)):
        count = rng.choice(["", "", "", str(rng.randrange(300))])
        command = rng.choice(["L", "X", "I", "H", "D", "C", "S", "K", "A", " ", "\x08", "Z"])
        text = "".join(rng.choice(EDITABLE) for _ in range(rng.randrange(6)))
        keys.append(f"{count}{command}{text}{rng.choice(['', '', ESCAPE])}")
    return "".join([*keys, rng.choice(["", ESCAPE]), rng.choice(["E", "Q", "\r", "", "\x01"])])


def odd_changes(rng: Random, value: Any) -> list[list[Any]]:
    """Changes of a JSON value: the way to a place, and what is to stand there, nothing for gone."""
    return [_odd_change(rng, value) for _ in range(rng.choice([1, 1, 1, 2, 3]))]


def _odd_change(rng: Random, value: Any) -> list[Any]:
    way: list[Any] = []
    while isinstance(value, dict | list) and value and (not way or rng.random() > 0.1):
        key = rng.choice(list(value)) if isinstance(value, dict) else rng.randrange(len(value))
        way.append(key)
        value = value[key]
    pick = rng.random()
    if pick < 0.1:
        return [way]
    return [way, rng.choice(ODD_JSON) if pick < 0.7 else _near(rng, value)]


def with_changes(value: Any, changes: list[list[Any]]) -> Any:
    """A JSON value after changes; those whose place is gone are left out."""
    for way, *new in changes:
        with contextlib.suppress(LookupError, TypeError):
            value = _with_change(value, way, new)
    return value


def _with_change(value: Any, way: list[Any], new: list[Any]) -> Any:
    if not way:
        return new[0]
    key, *rest = way
    changed = dict(value) if isinstance(value, dict) else list(value)
    if rest or new:
        changed[key] = _with_change(value[key], rest, new)
    else:
        del changed[key]
    return changed


def _near(rng: Random, value: Any) -> Any:
    """A value of the same kind."""
    if isinstance(value, bool):
        return not value
    if isinstance(value, int | float):
        return value + rng.choice([1, -1, 8, 256, 65536, -(10**6), 10**18, 2**63])
    return mutated_text(rng, value) if isinstance(value, str) else value


def mutated_text(rng: Random, text: str) -> str:
    """A text with some slips in it."""
    return mutated(rng, text.encode("latin-1", "replace")).decode("latin-1")


def mutated(rng: Random, data: bytes) -> bytes:
    """Bytes with some changed, lost, doubled or put in."""
    return spliced(data, splices(rng, data))


def splices(rng: Random, data: bytes) -> list[list[Any]]:
    """Changes of some bytes: where, how many go, and what comes in their place, in hex."""
    found: list[list[Any]] = []
    for _ in range(rng.randrange(1, 6)):
        place = rng.randrange(len(data) + 1)
        count = rng.choice([1, 1, 2, 8, 100])
        match rng.randrange(5):
            case 0:
                found.append([place, 1, rng.randbytes(1).hex()])
            case 1:
                found.append([place, count, ""])
            case 2:
                found.append([place, 0, data[place : place + count].hex()])
            case 3:
                found.append([place, 0, rng.randbytes(count).hex()])
            case _:
                found.append([place, 0, rng.choice(ODD_BYTES).hex()])
    return found


def spliced(data: bytes, changes: list[list[Any]]) -> bytes:
    """Bytes after changes, one after the other."""
    changed = bytearray(data)
    for place, count, new in changes:
        changed[place : place + count] = bytes.fromhex(new)
    return bytes(changed)
