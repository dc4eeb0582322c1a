"""Khronos's validator finds nothing to say of a run as glTF."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from tests.export.poses import ARMS, rig_of
from tests.export.validator import issues
from trs80arm.export.gltf import glb, gltf
from trs80arm.export.recording import Recording, record
from trs80arm.rig import Rig

PROGRAM = "10 @STEP 20,100,-120,30,60,-80,90\n20 PRINT 1\n"


@pytest.mark.parametrize("arm", ARMS)
@pytest.mark.parametrize("write", [gltf, glb])
def test_there_is_nothing_wrong_with_it(
    arm: str, write: Callable[[Rig, Recording], bytes], tmp_path: Path
) -> None:
    rig = rig_of(arm)
    rig.load_text(PROGRAM)
    recording = record(rig, 30, 20)
    path = tmp_path / f"run.{write.__name__}"
    path.write_bytes(write(rig, recording))
    found = issues(path)
    assert found["messages"] == []
    assert found["numErrors"] == found["numWarnings"] == 0


def test_it_would_say_so(tmp_path: Path) -> None:
    path = tmp_path / "run.gltf"
    path.write_text('{"asset": {"version": "2.0"}, "scene": 3}')
    assert issues(path)["numErrors"] == 1
