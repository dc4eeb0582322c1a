"""A machine that is a copy of one that began before is as good as one made from nothing."""

from __future__ import annotations

import gc
import types
from enum import Enum
from pathlib import Path
from typing import Any

import pytest

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
    # Who names the bench has everything made for it.
    expected = run(Rig(settings, Bench.standard()))
    Rig(settings), Rig(settings)
    copy = Rig(settings)
    assert copy.settings is settings
    assert run(copy) == expected
    # What became of one copy is nothing to the next.
    assert run(Rig(settings)) == expected


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


def things_of(rig: Rig) -> dict[int, Any]:
    """Everything that a machine is made of, down to what never changes."""
    found: dict[int, Any] = {}
    left: list[Any] = [rig._works]
    while left:
        thing = left.pop()
        if isinstance(thing, _LEAVES) or id(thing) in found:
            continue
        found[id(thing)] = thing
        left.extend(gc.get_referents(thing))
    return found


def test_copies_share_nothing_that_changes() -> None:
    rigs = [Rig() for _ in range(4)]
    things = [things_of(rig) for rig in rigs]
    assert all(len(each) > 200 for each in things)
    for one in range(4):
        for other in range(one):
            shared = [
                thing
                for number, thing in things[one].items()
                if number in things[other] and not (type(thing) is tuple and fixed(thing))
            ]
            assert not shared


def fixed(thing: Any) -> bool:
    """Whether a tuple holds nothing but what never changes."""
    return all(isinstance(item, _LEAVES) or (type(item) is tuple and fixed(item)) for item in thing)
