"""Expressions as long as a line can be: the ROM's limits hold, and none of Python's."""

from __future__ import annotations

import pytest

from tests.basic.machine import Machine
from trs80arm import Rig, RigSettings


def answers(statement: str, *before: str, blocks: bool = True) -> list[str]:
    """What a machine shows that runs a statement, however long, in a program."""
    rig = Rig(RigSettings(ram_kib=48, blocks=blocks))
    lines = [*before, statement]
    rig.load_text("\n".join(f"{10 + 10 * place} {text}" for place, text in enumerate(lines)))
    rig.type("RUN\r")
    rig.run_until_waiting()
    shown = rig.screen()
    return shown[shown.index(">RUN") + 1 : shown.index("READY", shown.index(">RUN"))]


@pytest.mark.parametrize("blocks", [True, False])
@pytest.mark.parametrize("terms", [2, 51, 52, 53, 69, 110, 400])
def test_a_sum_has_as_many_terms_as_fit_on_a_line(terms: int, blocks: bool) -> None:
    assert answers("PRINT " + "+".join("A" * terms), "A=1", blocks=blocks) == [f" {terms}"]


@pytest.mark.parametrize(
    ("statement", "shown"),
    [
        ("PRINT " + "*".join("A" * 110), " 1"),
        ("PRINT " + "-".join("A" * 101), "-99"),
        ("PRINT " + "/".join("A" * 101), " 1"),
        ("PRINT " + "[".join("A" * 101), " 1"),
        ("PRINT " + " AND ".join("A" * 101), " 1"),
        ("PRINT " + " OR ".join("A" * 101), " 1"),
        ("PRINT " + "=".join("A" * 101), " 0"),
        ("PRINT " + "<".join("A" * 101), "-1"),
        ("CLEAR 999:B$=\"X\":PRINT LEN(" + "+".join(["B$"] * 110) + ")", " 110"),
        ("PRINT " + "A+" * 60 + "A*" * 60 + "A", " 61"),
        ("PRINT RND(0)*0+(" + "+".join("A" * 100) + ")", " 100"),
        ("PRINT " + "-" * 100 + "A", " 1"),
        ("PRINT " + "NOT " * 60 + "A", " 1"),
        ("PRINT " + "(" * 99 + "A" + ")" * 99, " 1"),
        ("PRINT " + "ABS(" * 80 + "A" + ")" * 80, " 1"),
        ("PRINT " + "(A+" * 79 + "A" + ")" * 79, " 80"),
        ("PRINT " + "+".join(["C(A)"] * 100), " 300"),
        ("PRINT " + "C(" * 70 + "A" + ")" * 70, " 0"),
        ("PRINT " + "+".join(["D#"] * 100), " 50"),
        ("PRINT " + "+".join(["I%"] * 100), " 200"),
        ("IF " + "+".join("A" * 100) + "=100 THEN PRINT 7", " 7"),
        ("C(" + "+".join("A" * 60) + "-59)=5:PRINT C(1)", " 5"),
        ("X=" + "+".join("A" * 200) + ":PRINT X", " 200"),
        ("FOR I=1 TO " + "+".join("A" * 99) + ":NEXT:PRINT I", " 100"),
    ],
    ids=lambda text: text[:12],
)  # fmt: skip
def test_every_kind_of_long_expression_has_its_value(statement: str, shown: str) -> None:
    got = answers(statement, 'A=1:B$="X":D#=.5:I%=2:DIM C(9):C(1)=3:C(0)=0')
    assert [line.rstrip() for line in got] == [shown]


def test_a_long_expression_is_evaluated_in_the_order_of_a_short_one() -> None:
    """Both draw from RND, term by term; an error comes when what stands before it is done."""
    terms = [f"{n % 7}*RND(0)" for n in range(90)]
    long = Machine().run("10 X=" + "+".join(terms), "20 PRINT X")
    short = [f"{10 + place} X=X+{term}" for place, term in enumerate(terms)]
    assert long == Machine().run(*short, "500 PRINT X")
    got = answers("PRINT " + "+".join("A" * 90) + "+1/0+LEN(A)", "A=1")
    assert got == ["?/0 ERROR IN 20"] or got == ["?TM ERROR IN 20"]


@pytest.mark.parametrize(
    ("elements", "expression"),
    [
        (948, "-" * 220 + "1"),
        (1278, "(" * 110 + "1" + ")" * 110),
        (1383, "ABS(" * 45 + "1" + ")" * 45),
        (1144, "1+(" * 58 + "1" + ")" * 58),
        (1443, "NOT " * 55 + "1"),
    ],
    ids=lambda value: str(value)[:4],
)
def test_nesting_ends_where_the_stack_meets_the_variables(elements: int, expression: str) -> None:
    """How large an array may be beside each was found out on the ROM, to the byte."""
    for more, fits in ((0, True), (1, False)):
        rig = Rig(RigSettings(ram_kib=4))
        rig.type(f"DIM A%({elements + more})\r")
        rig.run_until_waiting()
        rig.type("CLS\r")
        rig.type(f"PRINT {expression}\r")
        rig.run_until_waiting()
        assert ("?OM ERROR" not in rig.screen()) == fits


@pytest.mark.parametrize("blocks", [True, False])
@pytest.mark.parametrize(
    ("ram", "levels", "shown"),
    [
        (16, 2000, " 1"),
        (48, 6000, " 1"),
        (16, 6000, "?OM ERROR IN 10"),
        (48, 9000, "?OM ERROR IN 10"),
    ],
)
def test_a_line_longer_than_any_typed_one_is_nested_as_deeply_as_memory_allows(
    ram: int, levels: int, shown: str, blocks: bool
) -> None:
    rig = Rig(RigSettings(ram_kib=ram, blocks=blocks))
    rig.load_lines([(10, b"\xb2" + b"\xce" * levels + b"1")])
    rig.type("CLS:RUN\r")
    rig.run_until_waiting()
    assert rig.screen()[0].rstrip() == shown or rig.screen()[1].rstrip() == shown
