"""Single statements take as long as on the ROM.

The T-states were observed there between two OUT statements around each one, as in
`10 OUT1,0:A=B:OUT1,0`, so they hold the rest of the first OUT and the beginning of the second.
"""

from __future__ import annotations

import pytest

from tests.basic.machine import Machine

SETUP = (
    'DEFINTI-N:A=1.5:B=2:C=12.25:I=1:J=12:A#=1.25:B#=3:A$="HELLO":B$="Y":Z=0:K=0:Z#=0:Z$="":'
    "DIMD(10),E(5,5)"
)
ROM = {
    "": 5421,
    ":": 7441,
    "A=B": 10160,
    "K=J": 12399,
    "Z#=B#": 13390,
    "Z=A+B": 15177,
    "Z=A-C": 15516,
    "Z=B*C": 16746,
    "Z=A/C": 22993,
    "K=I+J": 15401,
    "K=I*J": 16716,
    "Z=I/J": 25188,
    "Z#=A#+B#": 20092,
    "Z#=A#*B#": 26935,
    "Z#=A#/B#": 97339,
    "K=A<B": 15135,
    "K=IANDJ": 15379,
    "Z=5": 12229,
    "Z=3.14159": 75152,
    "Z=1E5": 19909,
    "Z#=1.23456789012": 944251,
    "Z=SIN(B)": 56141,
    "Z=SQR(C)": 102863,
    "Z=B[C": 101203,
    "Z=LOG(C)": 49396,
    "Z=EXP(A)": 61908,
    "Z=ATN(B)": 70519,
    "K=INT(C)": 14709,
    "Z=RND(6)": 24842,
    "Z=RND(0)": 18007,
    "K=PEEK(16400)": 15400,
    "POKE16900,I": 13216,
    "SET(I,J)": 13080,
    "K=POINT(I,J)": 17393,
    "D(J-I-I)=A": 19997,
    "Z=E(I,2)": 18837,
    "Z$=A$": 13254,
    "Z$=A$+B$": 17861,
    "Z$=LEFT$(A$,2)": 18290,
    "Z$=MID$(A$,2,2)": 20585,
    "K=LEN(A$)": 14484,
    "K=A$=B$": 16702,
    "Z$=CHR$(65)": 15452,
    "Z$=STR$(C)": 30444,
    'K=VAL("12")': 23991,
    "Z$=STRING$(9,42)": 17816,
    "K=VARPTR(A)": 12034,
    "FORK=1TO10:NEXT": 36146,
    "FORZ=1TO10:NEXTZ": 76935,
    "IFA>BTHENZ=1ELSEZ=2": 18411,
    "IFI=1THENZ=1": 17663,
    "ONIGOSUB900": 13629,
    "GOSUB900": 10704,
}


class Marks:
    """A port 1 that notes when it is written."""

    def __init__(self, machine: Machine) -> None:
        self._clock = machine.clock
        self.times: list[int] = []

    def read(self, port: int) -> int:
        return 255

    def write(self, port: int, value: int) -> None:
        if port == 1:
            self.times.append(self._clock.now)


@pytest.fixture(scope="module", params=[True, False], ids=["blocks", "statements"])
def times(request: pytest.FixtureRequest) -> dict[str, int]:
    """T-states of each statement on this machine, all of them in one program."""
    machine = Machine(blocks=request.param)
    marks = Marks(machine)
    object.__setattr__(machine.basic.state.host, "ports", marks)
    lines = [f"10 {SETUP}"]
    lines += [
        f"{20 + place} OUT1,0:{text}:OUT1,0" if text else f"{20 + place} OUT1,0:OUT1,0"
        for place, text in enumerate(ROM)
    ]
    assert machine.run(*lines, "800 END", "900 RETURN") == ""
    spans = zip(marks.times[::2], marks.times[1::2], strict=True)
    return dict(zip(ROM, (end - start for start, end in spans), strict=True))


@pytest.mark.parametrize("text", ROM)
def test_a_statement_takes_as_long_as_on_the_rom(times: dict[str, int], text: str) -> None:
    assert times[text] == pytest.approx(ROM[text], rel=0.05)


JUMPS = {
    ("20 FORI%=10TO{}", "25 NEXT"): 2284,
    ("20 FORI%=10TO{}:GOTO25", "25 NEXT"): 4740,
    ("20 FORI%=10TO{}:GOTO25", "22 REM", "25 NEXT"): 4939,
    ("20 FORI%=10TO{}:GOTO25", "22 REM", "23 REM", "25 NEXT"): 5138,
    ("20 FORI%=10TO{}:GOTO30", "25 NEXT:END", "30 GOTO25"): 7663,
    ("1 REM", "20 FORI%=10TO{}:GOTO30", "25 NEXT:END", "30 GOTO25"): 7862,
    ("2 FORI%=10TO{}:GOTO5", "5 NEXT"): 4405,
    ("2 FORI%=10TO{}:GOTO50000", "50000 NEXT"): 5733,
    ("2 FORI%=10TO{}:GOSUB5:NEXT:END", "5 RETURN"): 6406,
    ("20 FORI%=10TO{}", "22 REM", "25 NEXT"): 3671,
}
"""Loops with jumps, and what the ROM takes for a round of each."""


@pytest.mark.parametrize("lines", JUMPS, ids=" ".join)
def test_a_jump_takes_what_the_search_for_its_line_takes(lines: tuple[str, ...]) -> None:
    def lasting(last: int) -> int:
        machine = Machine()
        machine.load(*(line.format(last) for line in lines))
        began = machine.clock.now
        assert machine.do("RUN") == ""
        return machine.clock.now - began

    assert (lasting(90) - lasting(10)) / 80 == pytest.approx(JUMPS[lines], rel=0.02)
