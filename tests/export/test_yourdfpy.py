"""yourdfpy has the exported arm where the arm's own kinematics has it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.export.poses import ARMS, CLOSE, frames, poses, rig_of
from trs80arm.arm.models import model_named
from trs80arm.export.chain import JOINTS, joint_values
from trs80arm.export.exporting import Export, export
from trs80arm.export.units import METRES
from trs80arm.export.urdf import urdf
from trs80arm.rig import RigSettings


def load(path: Path, **how: bool) -> Any:
    """The arm of a file. The library takes a second to import, which those who do not ask save."""
    import yourdfpy

    return yourdfpy.URDF.load(str(path), **how)


def write(arm: str, folder: Path) -> Path:
    text, meshes = urdf(rig_of(arm), "meshes")
    (folder / "meshes").mkdir()
    for name, content in meshes.items():
        (folder / "meshes" / name).write_bytes(content)
    path = folder / "arm.urdf"
    path.write_text(text, encoding="utf-8")
    return path


@pytest.mark.parametrize("arm", ARMS)
def test_a_thousand_poses_are_the_same(arm: str, tmp_path: Path) -> None:
    robot = load(write(arm, tmp_path), load_meshes=False)
    worst = 0.0
    for angles, opening in poses(model_named(arm)):
        values = joint_values(angles, opening)
        at = dict(zip(JOINTS, (*values[:5], *(v * METRES for v in values[5:])), strict=True))
        del at["right_finger"]  # It follows the left one.
        robot.update_cfg(at)
        for name, place, turn in frames(model_named(arm), angles, opening):
            frame = robot.get_transform(name)
            worst = max(worst, np.abs(frame[:3, 3] / METRES - place).max())
            worst = max(worst, np.abs(frame[:3, :3].ravel() - turn).max())
    assert worst < CLOSE


def test_it_is_a_valid_file_and_every_moving_link_has_its_inertia(tmp_path: Path) -> None:
    robot = load(write("minimover5", tmp_path))
    assert robot.validate(), robot.errors
    moving = [joint.child for joint in robot.robot.joints if joint.type != "fixed"]
    for link in moving:
        inertial = robot.link_map[link].inertial
        assert inertial.mass > 0
        assert np.linalg.eigvalsh(inertial.inertia).min() > 0


def test_parts_are_where_they_lie_with_their_meshes(tmp_path: Path) -> None:
    robot = load(write("minimover5", tmp_path))
    disc = rig_of("minimover5").arm.bench.parts["disc"]
    assert robot.get_transform("disc")[:3, 3] / METRES == pytest.approx(disc.place, abs=CLOSE)
    (low, high) = robot.scene.geometry["disc.stl"].bounds / METRES
    assert high[2] - low[2] == pytest.approx(0.25, abs=1e-6)


def test_the_command_writes_the_same_with_its_meshes(tmp_path: Path) -> None:
    export(Export(tmp_path / "arm.urdf", rig=RigSettings()))
    robot = load(tmp_path / "arm.urdf")
    assert robot.num_actuated_joints == 6
