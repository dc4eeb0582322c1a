"""A machine that is a copy of one that began before is as good as one made from nothing."""

from __future__ import annotations

import gc
import pickle
import types
from enum import Enum
from pathlib import Path
from typing import Any
from unittest.mock import patch

import pytest

from tests.own_places import PROGRAMS
from trs80arm.arm import benchfile
from trs80arm.arm.bench import Bench
from trs80arm.arm.models import MODELS
from trs80arm.arm.settings import ArmSettings
from trs80arm.machine.card import CardSettings
from trs80arm.rig import Rig, RigSettings, Waiting
from trs80arm.snapshot_classes import NAMED, VALUES
from trs80arm.works import beginnings

PROGRAM = """10 DIM A(20): FOR I=1 TO 20: A(I)=SQR(I): NEXT
20 A$="ELBOW"+STR$(A(4)): PRINT A$: POKE 16500,7: LPRINT A$
30 @STEP 60,100,120,100,10,10,60
40 @CLOSE: @STEP 60,-100,-100,0,0,0,20: PRINT INP(5), RND(0)
50 CSAVE "A": INPUT B
"""
KINDS = {
    "default": RigSettings(),
    "single statements": RigSettings(blocks=False),
    "without ARMBASIC": RigSettings(armbasic=False, ram_kib=4),
    "48K": RigSettings(ram_kib=48, memory_size="40000", card=CardSettings(base=0x40)),
    **{model: RigSettings(arm=ArmSettings(model=model)) for model in MODELS},
}


BENCHES = sorted(path.stem for path in PROGRAMS.glob("*.toml"))


def bench_of(name: str) -> Bench:
    """One of the benches that come along."""
    return benchfile.parse((PROGRAMS / f"{name}.toml").read_text(), name)


def from_nothing(settings: RigSettings, bench: Bench | None = None) -> Rig:
    """A machine that is no copy."""
    with patch("trs80arm.rig.switched_on", beginnings._switched_on):
        return Rig(settings, bench)


def run(rig: Rig) -> list[bytes]:
    """A machine's bytes as it begins, at work and afterwards."""
    states = [rig.snapshot()]
    rig.load_text(PROGRAM)
    rig.type("RUN\r")
    for _ in range(3):
        rig.run_for(2.5)
        states.append(rig.snapshot())
    # Without ARMBASIC it ends with an error in line 30.
    assert rig.run_until_waiting() is (Waiting.INPUT if rig.settings.armbasic else Waiting.EDIT)
    return [*states, rig.snapshot(), rig.printer.sent]


@pytest.mark.parametrize("kind", KINDS)
def test_a_copy_is_equal_to_a_machine_made_from_nothing_and_has_the_same_run(kind: str) -> None:
    settings = KINDS[kind]
    expected = run(from_nothing(settings))
    Rig(settings), Rig(settings)
    copy = Rig(settings)
    assert copy.settings is settings
    assert run(copy) == expected
    # What became of one copy is nothing to the next.
    assert run(Rig(settings)) == expected


@pytest.mark.parametrize("name", BENCHES)
def test_a_copy_at_a_bench_is_equal_to_a_machine_made_from_nothing(name: str) -> None:
    settings = RigSettings()
    expected = from_nothing(settings, bench_of(name))
    bench = bench_of(name)
    before = pickle.dumps(bench)
    for _ in range(4):
        rig = Rig(settings, bench)
        assert rig.snapshot() == expected.snapshot()
        rig.set_bench(bench)
        rig.refill()
    assert pickle.dumps(bench) == before


@pytest.mark.parametrize("name", ["carousel", "conveyor", "tending"])
def test_a_copy_at_a_bench_has_the_same_run(name: str) -> None:
    expected = run(from_nothing(RigSettings(), bench_of(name)))
    for _ in range(3):
        last = run(Rig(RigSettings(), bench_of(name)))
    assert last == expected


def test_benches_that_differ_are_never_taken_for_each_other() -> None:
    bench = bench_of("hanoi")
    for number in range(3):
        expected = from_nothing(RigSettings(), bench).snapshot()
        assert [Rig(bench=bench).snapshot() for _ in range(3)] == [expected] * 3
        bench.add_part(f"one {number}", (0.5, 0.5, 1.0), 1.0, -9.0, 2.0 * number)


def test_folder_and_file_are_those_of_the_settings_asked_with(tmp_path: Path) -> None:
    for name in ("one", "two", "three"):
        place = tmp_path / name
        place.mkdir()
        rig = Rig(RigSettings(tape_folder=place, printer_file=place / "paper.txt"))
        rig.load_text('10 LPRINT "HERE"\n20 CSAVE "A"\n')
        rig.type("RUN\r")
        rig.run_until_waiting()
        assert sorted(path.name for path in place.iterdir()) == ["A.cas", "paper.txt"]
    rig = Rig()
    assert rig.settings.tape_folder is None
    assert rig.printer.path is None


def test_no_more_kinds_are_kept_than_there_is_room_for() -> None:
    many = beginnings._Beginning(beginnings._assembled)
    for size in range(2 * beginnings.MOST):
        settings = RigSettings(memory_size=str(20000 + size))
        for _ in range(3):
            assert many(settings).settings == settings
    assert len(many._moulds) == beginnings.MOST


_LEAVES = (
    type(None),
    bool,
    int,
    float,
    str,
    bytes,
    frozenset,
    Enum,
    Path,
    type,
    types.FunctionType,
    types.BuiltinFunctionType,
    types.ModuleType,
    *VALUES.values(),
    *(cls for cls, _ in NAMED.values()),
)
"""What machines may share, with everything in it."""


def things_of(whole: object) -> dict[int, Any]:
    """Everything that a machine or a bench is made of, down to what never changes."""
    found: dict[int, Any] = {}
    left: list[Any] = [whole]
    while left:
        thing = left.pop()
        if isinstance(thing, _LEAVES) or id(thing) in found:
            continue
        found[id(thing)] = thing
        left.extend(gc.get_referents(thing))
    return found


@pytest.mark.parametrize("name", [None, *BENCHES])
def test_copies_share_nothing_that_changes(name: str | None) -> None:
    bench = None if name is None else bench_of(name)
    rigs = [Rig(bench=bench) for _ in range(4)]
    # Nor do they with the bench that was given for them.
    things = [*(things_of(rig._works) for rig in rigs), things_of(bench)]
    # Two that are made from nothing share some tables of their classes.
    one, two = (from_nothing(RigSettings(), bench) for _ in range(2))
    of_all = things_of(one._works).keys() & things_of(two._works).keys()
    assert len(of_all) < 30
    # Before Python 3.13 the attributes of most objects are a thing more each.
    assert all(len(each) > 150 for each in things[:4])
    for number, mine in enumerate(things):
        for theirs in things[:number]:
            shared = [
                thing
                for where, thing in mine.items()
                if where in theirs
                and where not in of_all
                and not (type(thing) is tuple and fixed(thing))
            ]
            assert not shared


def fixed(thing: Any) -> bool:
    """Whether a tuple holds nothing but what never changes."""
    return all(isinstance(item, _LEAVES) or (type(item) is tuple and fixed(item)) for item in thing)
