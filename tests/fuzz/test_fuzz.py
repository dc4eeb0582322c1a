"""A bounded part of the noise, what was found before, and the harness itself."""

from __future__ import annotations

import json
from pathlib import Path
from random import Random
from typing import Any

import pytest

from tests.fuzz.smaller import smallest
from tests.fuzz.target import Target
from tests.fuzz.targets import TARGETS
from tests.fuzz.work import FOUND, case_of, fault_of, keep

CASES = {"programs": 12, "moments": 3, "crunched": 60, "pokes": 25, "storms": 40, "typing": 60}
CASES |= {"machine-code": 12, "wires": 12, "windows": 4}
CASES |= {"editing": 50, "hands": 8, "tapes": 8, "benches": 60, "snapshots": 60, "lines": 60}
CASES |= {"statements": 100, "settings": 60, "program-files": 150, "commands": 60}
MANY = 400
"""Some tenths of a second for each door."""


@pytest.mark.parametrize("name", sorted(TARGETS))
def test_noise_at_every_door(name: str) -> None:
    for number in range(CASES.get(name, MANY)):
        case = case_of(TARGETS[name], 0, number)
        assert fault_of(TARGETS[name], case) is None, json.dumps(case)


@pytest.mark.parametrize("path", sorted(FOUND.glob("*.json")), ids=lambda path: path.stem)
def test_what_was_found_once_stays_mended(path: Path) -> None:
    found = json.loads(path.read_text(encoding="utf-8"))
    if found["target"] not in TARGETS:
        pytest.skip("there is no such door without the extra z80")
    assert fault_of(TARGETS[found["target"]], found["case"]) is None


def test_a_case_is_the_same_for_its_seed_and_number() -> None:
    for target in TARGETS.values():
        assert case_of(target, 5, 7) == case_of(target, 5, 7)
        json.dumps(case_of(target, 5, 7))


def play(case: Any) -> None:
    if "XY" in "".join(case["lines"]):
        raise KeyError("a fault put in on purpose")


def test_a_fault_is_found_made_small_and_kept(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    target = Target("pretence", lambda rng: None, play)
    noisy = [f"{n} PRINT {Random(n).random()}" for n in range(30)] + ["31 GOTO XY", "32 END"]
    case = {"lines": noisy}
    fault = fault_of(target, case)
    assert fault is not None
    assert fault.startswith("KeyError")
    monkeypatch.setattr("tests.fuzz.work.FOUND", tmp_path)
    kept = json.loads(keep(target, case, fault, tell=lambda text: None).read_text())
    assert kept == {"target": "pretence", "fault": fault, "case": {"lines": ["XY"]}}


def test_the_smallest_of_several_causes_is_one_of_them() -> None:
    assert smallest(list("abcab"), lambda case: "a" in case) == ["a"]
