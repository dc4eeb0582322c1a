"""A snapshot is all of a rig: what it does next depends on nothing else."""

from __future__ import annotations

import base64
import contextlib
import copy
import json
import os
import pickle
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import is_dataclass
from pathlib import Path
from typing import Any, get_type_hints

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.sealing import sealed
from trs80arm import Rig, RigSettings
from trs80arm.arm import benchfile
from trs80arm.arm.settings import ArmSettings
from trs80arm.machine.card import CardSettings
from trs80arm.machine.clock import END_OF_TIME
from trs80arm.machine.driver import DriverSettings
from trs80arm.rig import SnapshotError
from trs80arm.snapshot_classes import OBJECTS, VALUES

BENCH = "[[part]]\nname = 'cube'\nat = [9, 1]\nsize = [1, 1, 1]\nweight = 1\n"
SETTINGS = RigSettings(
    ram_kib=48,
    memory_size="40000",
    armbasic=False,
    blocks=False,
    card=CardSettings(base=0x40, switch_closed=1),
    driver=DriverSettings(set_delay=7),
    arm=ArmSettings(speed_margin=2.0),
    ghosting=True,
)


def free(rig: Rig) -> int:
    rig.type("PRINT MEM\r")
    rig.run_until_waiting()
    lines = rig.screen()
    return int(lines[lines.index("READY", lines.index(">PRINT MEM")) - 1])


def test_a_48k_snapshot_makes_a_16k_rig_one_of_48k_also_after_a_reset() -> None:
    big = Rig(RigSettings(ram_kib=48))
    rig = Rig()
    rig.restore(big.snapshot())
    assert rig.settings.ram_kib == 48
    expected = free(big)
    assert free(rig) == expected > 40000
    rig.reset()
    assert free(rig) == expected


def test_a_snapshot_brings_all_settings_and_the_bench() -> None:
    source = Rig(SETTINGS, benchfile.parse(BENCH))
    rig = Rig()
    rig.restore(source.snapshot())
    assert rig.settings == SETTINGS
    rig.reset()
    assert rig.settings == SETTINGS
    assert rig.card.settings == SETTINGS.card
    assert rig.driver.settings == SETTINGS.driver
    assert list(rig.arm.bench.parts) == ["cube"]


def test_a_snapshot_names_no_file_and_leaves_those_of_the_rig(tmp_path: Path) -> None:
    there, here = tmp_path / "their-folder", tmp_path / "my-folder"
    theirs = RigSettings(tape_folder=there / "tapes", printer_file=there / "paper.txt")
    mine = RigSettings(tape_folder=here / "tapes", printer_file=here / "paper.txt")
    snapshot = Rig(theirs).snapshot()
    assert b"their-folder" not in snapshot
    here.mkdir()
    rig = Rig(mine)
    rig.restore(snapshot)
    assert rig.settings == mine
    rig.load_text('10 LPRINT "HELLO":CSAVE "A"')
    rig.type("RUN\r")
    rig.run_until_waiting()
    assert (here / "paper.txt").read_text() == "HELLO\n"
    assert (here / "tapes" / "A.cas").is_file()
    assert not there.exists()


def test_the_cassettes_of_a_rig_without_a_folder_are_in_its_snapshot() -> None:
    source = Rig()
    source.load_text("10 REM KEPT")
    source.type('CSAVE "A"\r')
    source.run_until_waiting()
    rig = Rig()
    rig.restore(source.snapshot())
    rig.reset()
    rig.type("CLOAD\rLIST\r")
    rig.run_until_waiting()
    assert "10 REM KEPT" in rig.screen()


# -- the format ------------------------------------------------------------------------------------

SESSION = """\
10 DIM A(5):A$="X"+"Y":B#=1/3:FOR I=1 TO 3:GOSUB 100:NEXT
20 INPUT "N";N,M$
30 @STEP 50,100,-50:@CLOSE
40 @SET
50 ON ERROR GOTO 200:X=1/0
60 PRINT#-1,5:LPRINT "H"
70 GOTO 70
100 READ Q:RETURN
110 DATA 1,2,3
200 RESUME NEXT
"""


def moments() -> Iterator[Rig]:
    """A rig at many moments of a session in which everything happens once."""
    rig = Rig()
    yield rig
    rig.load_text(SESSION)
    rig.type("RUN\r")
    for typed, seconds in (("", 3), ("5,A\r", 12), ("", 9)):
        rig.type(typed)
        for _ in range(seconds):
            rig.run_for(1)
            yield rig
    rig.press("1")
    rig.run_for(0.3)
    yield rig
    rig.release_all()
    rig.hold(["0"], 0.2)
    for _ in range(5):
        rig.run_for(1.5)
        yield rig
    rig.hold(["BREAK"], 0.2)
    rig.run_for(1)
    yield rig
    keys = ["EDIT 20\r", "IN", "\x1b", "Q", "AUTO\r", "\x01", "LIST\r", 'CSAVE"A"\r', "\x01"]
    keys += ["CLOAD\r", "\x01", "SYSTEM\r", "X\r", "\x01", "INPUT#-1,A\r", "\x01", "PRINT@9"]
    for typed in keys:
        rig.type(typed)
        rig.run_for(0.4)
        yield rig


def test_at_every_moment_a_snapshot_restores_to_the_same_bytes() -> None:
    """The rig itself goes on from its restored self every third time."""
    twin = Rig()
    for number, rig in enumerate(moments()):
        snapshot = rig.snapshot()
        twin.restore(snapshot)
        assert twin.snapshot() == snapshot
        if number % 3 == 0:
            rig.restore(snapshot)
    assert number > 40


def test_restoring_does_not_change_a_run() -> None:
    straight, restored = Rig(), Rig()
    for rig in (straight, restored):
        rig.load_text(SESSION)
        rig.type("RUN\r5,B\r")
        for _ in range(25):
            if rig is restored:
                rig.restore(rig.snapshot())
            rig.run_for(0.57)
    assert straight.snapshot() == restored.snapshot()


def test_variables_that_were_compiled_and_not_made_are_no_part_of_a_snapshot() -> None:
    """Which they are depends on how far blocks went, and so on how time was sliced."""
    rigs = [Rig(), Rig()]
    for rig, slices in zip(rigs, (1, 24), strict=True):
        rig.load_text("0FORR=0TO7:READP:NEXT\n6DATA\n7E")
        rig.type("RUN\r")
        for _ in range(slices):
            rig.run_for(1.5 / slices)
    assert rigs[0].snapshot() == rigs[1].snapshot()


SCRIPT = """
from trs80arm import Rig
import hashlib
rig = Rig()
rig.load_text('10 A$=A$+"X":@STEP 20,9,-9,0,3,4,5:PRINT RND(9)/3:DIM B(3):LPRINT A$:K$=INKEY$')
rig.type("RUN\\r")
rig.press("1")
rig.press("Q")
rig.run_for(2)
print(hashlib.sha256(rig.snapshot()).hexdigest())
"""


def test_equal_machines_have_equal_bytes_in_every_process() -> None:
    sums = {
        subprocess.run(
            [sys.executable, "-c", SCRIPT],
            env=os.environ | {"PYTHONHASHSEED": seed},
            capture_output=True,
            check=True,
            timeout=60,
        ).stdout
        for seed in ("1", "2")
    }
    assert len(sums) == 1


def busy() -> bytes:
    rig = Rig()
    rig.load_text(SESSION)
    rig.type("RUN\r")
    rig.run_for(4)
    rig.type("5,A\r")
    rig.run_for(3)
    return rig.snapshot()


BUSY = busy()
CONTENT = json.loads(BUSY.partition(b"\n")[2])


def test_the_snapshot_is_what_the_format_says() -> None:
    assert list(CONTENT) == ["settings", "state"]
    places = [place for place, _ in CONTENT["state"]]
    assert len(places) == len(set(places))
    ram = dict(CONTENT["state"])["memory.ram"]
    assert ram[0] == "bytearray"
    assert len(base64.b64decode(ram[1])) == 65536


def forged_key(time: Any) -> bytes:
    """A snapshot with a key that goes down at a time."""
    key = {"time": time, "order": 1, "key": ["named", "Key", "A"], "down": True, "typed": False}
    events = ["list", ["new", "KeyEvent", key]]
    return sealed({"settings": {}, "state": [["events", events]]})


def forged_registers(first: Any) -> bytes:
    state = [["driver", {"registers": ["tuple", first, 0, 0, 0, 0, 0]}]]
    return sealed({"settings": {}, "state": state})


@pytest.mark.parametrize(
    ("data", "told"),
    [
        (b"", "no snapshot"),
        (b"x", "no snapshot"),
        (pickle.dumps(Rig), "no snapshot"),
        (BUSY[:-1], "damaged"),
        (BUSY + b"\n", "damaged"),
        (BUSY[:5000] + b"A" + BUSY[5001:], "damaged"),
        (BUSY.replace(b"snapshot 1", b"snapshot 2", 1), "of another version"),
        (sealed([]), "expected a table"),
        (sealed({}), "no snapshot"),
        (sealed({"settings": {"ram_kib": 5}, "state": []}), "ram_kib must be"),
        (sealed({"settings": {"printer_file": "/x"}, "state": []}), "names a file"),
        (sealed({"settings": {}, "state": [["os", {}]]}), "a place that no machine has"),
        (sealed({"settings": {}, "state": [["works", {"__class__": 1}]]}), "no machine has"),
        (sealed({"settings": {}, "state": [["clock", {"limits": 1}]]}), "no machine has"),
        (sealed({"settings": {}, "state": [["clock", {"now": "5"}]]}), "another kind of value"),
        (sealed({"settings": {}, "state": [["works", {"order": ["new", "Popen", {}]}]]}), "be"),
        (sealed({"settings": {}, "state": "[" * 9}), "no list"),
        (sealed({"settings": {}, "state": [["events", "later"]]}), "another kind of content"),
        (sealed({"settings": {}, "state": [["matrix", {"_image": None}]]}), "kind of value"),
        (sealed({"settings": {}, "state": [["works", {"order": 10**400}]]}), "a number larger"),
        (sealed({"settings": {}, "state": [["clock", {"now": 10**18}]]}), "a time at which no"),
        (sealed({"settings": {}, "state": [["clock", {"now": -1}]]}), "a time at which no"),
        (forged_key("later"), "kind of value"),
        (forged_key(True), "kind of value"),
        (forged_registers("odd"), "kind of value"),
        (forged_registers(40000), "in a state that cannot be"),
    ],
)
def test_what_is_no_snapshot_is_refused_in_one_sentence(data: bytes, told: str) -> None:
    rig = Rig()
    before = rig.snapshot()
    with pytest.raises(SnapshotError) as caught:
        rig.restore(data)
    assert told in str(caught.value)
    assert "\n" not in str(caught.value)
    assert rig.snapshot() == before


def leaves(value: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """Where in a JSON value something stands that is no list or object."""
    if isinstance(value, list | dict):
        for key in value if isinstance(value, dict) else range(len(value)):
            yield from leaves(value[key], (*path, key))
    else:
        yield path


LEAVES = [path for path in leaves(CONTENT) if path[0] == "state"]
OTHER = st.sampled_from(
    [
        None,
        True,
        0,
        -1,
        5,
        10**18,
        1.5,
        "",
        "x",
        "list",
        ["list"],
        ["tuple", 1],
        {},
        [],
        ["at", "x"],
    ]
)


SENSING = """
[[tactile]]
on = "left finger"
bit = 1
[[home]]
joint = "base"
at = 10
bit = 2
"""


@pytest.mark.parametrize(
    ("was", "forged"),
    [
        ('"bit":2', '"bit":4'),
        ('["named","Motor","BASE"]', '["named","Motor","HAND"]'),
        ('["named","Link","LEFT_FINGER"]', '["named","Link","FOREARM"]'),
        ('["value","TactilePad"', '["value","Pose"'),
        ('["list",["value","TactilePad"', '["list",["list"],["value","TactilePad"'),
    ],
)
def test_a_forged_sensor_is_refused(was: str, forged: str) -> None:
    _, _, content = Rig(bench=benchfile.parse(SENSING)).snapshot().partition(b"\n")
    text = content.decode("ascii")
    assert text.count(was) == 1
    with pytest.raises(SnapshotError):
        Rig().restore(sealed(json.loads(text.replace(was, forged))))


def test_a_forged_snapshot_of_which_the_operator_cannot_break_off_is_refused() -> None:
    """Its stack has nothing to come back to."""
    stack = ["list", ["new", "Pause", {}]]
    with pytest.raises(SnapshotError, match="cannot be"):
        Rig().restore(sealed({"settings": {}, "state": [["basic.state.stack", stack]]}))


def test_the_latest_time_leaves_a_machine_time_enough() -> None:
    latest = END_OF_TIME // 2
    rig = Rig()
    rig.restore(sealed({"settings": {}, "state": [["clock", {"now": latest}]]}))
    rig.type("\rPRINT 5\r")
    rig.run_until_waiting()
    assert " 5" in rig.screen()


def test_the_types_of_all_fields_that_a_snapshot_may_fill_are_known() -> None:
    for cls in (*VALUES.values(), *OBJECTS.values()):
        if is_dataclass(cls):
            assert get_type_hints(cls)


@settings(max_examples=120, deadline=None)
@given(st.lists(st.tuples(st.sampled_from(LEAVES), OTHER), min_size=1, max_size=3))
def test_a_forged_snapshot_is_refused_or_is_a_machine(changes: list[tuple[Any, Any]]) -> None:
    content = copy.deepcopy(CONTENT)
    for path, value in changes:
        place = content
        try:
            for key in path[:-1]:
                place = place[key]
            place[path[-1]] = value
        except (TypeError, LookupError):
            continue  # A change before took that place away.
    rig = Rig()
    with contextlib.suppress(SnapshotError):
        rig.restore(sealed(content))
    before = rig.clock.now
    # From now: a statement may have taken it far beyond the time that was asked for.
    rig.run_to(before + 17_000)
    rig.hold(["BREAK"], 0.1)
    rig.run_to(before + 400_000)
    assert rig.clock.now > before
