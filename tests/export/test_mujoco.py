"""MuJoCo has the exported arm where the arm's own kinematics has it, cables and all."""

from __future__ import annotations

import mujoco
import numpy as np
import pytest

from tests.export.poses import ARMS, CLOSE, frames, poses, rig_of
from trs80arm.arm.models import model_named
from trs80arm.export.chain import counts, joint_values
from trs80arm.export.mjcf import mjcf
from trs80arm.export.units import METRES

UNITS = np.array([1.0] * 5 + [METRES] * 2)


def load(arm: str) -> tuple[mujoco.MjModel, mujoco.MjData]:
    model = mujoco.MjModel.from_xml_string(mjcf(rig_of(arm)))
    return model, mujoco.MjData(model)


@pytest.mark.parametrize("arm", ARMS)
def test_a_thousand_poses_are_the_same(arm: str) -> None:
    model, data = load(arm)
    worst = 0.0
    for angles, opening in poses(model_named(arm)):
        data.qpos[:7] = np.array(joint_values(angles, opening)) * UNITS
        mujoco.mj_kinematics(model, data)
        for name, place, turn in frames(model_named(arm), angles, opening):
            body = data.body(name)
            worst = max(worst, np.abs(body.xpos / METRES - place).max())
            worst = max(worst, np.abs(body.xmat - turn).max())
    assert worst < CLOSE


@pytest.mark.parametrize("arm", ARMS)
def test_tendons_are_as_long_as_the_motors_have_half_steps(arm: str) -> None:
    model, data = load(arm)
    made = model_named(arm)
    random = np.random.default_rng(1)
    zero = np.array(counts(made, (0.0,) * 7))
    for _ in range(1000):
        rotors = random.integers(-200, 200, 6)
        base, shoulder, elbow, left, right = made.turned(rotors)
        half = made.paid_out(rotors) / made.hand_steps / 2
        pitch, roll = (left + right) / 2, (left - right) / 2
        joints = base, shoulder, elbow - shoulder, pitch - elbow, roll, half, half
        data.qpos[:7] = np.array(joints) * UNITS
        mujoco.mj_fwdPosition(model, data)
        assert np.abs(data.ten_length - rotors).max() < 1e-6
        assert counts(made, joints) == pytest.approx(rotors + zero, abs=1e-9)


@pytest.mark.parametrize("arm", ARMS)
def test_the_keyframe_has_arm_and_parts_where_they_are(arm: str) -> None:
    rig = rig_of(arm)
    model, data = load(arm)
    mujoco.mj_resetDataKeyframe(model, data, model.key("now").id)
    mujoco.mj_kinematics(model, data)
    pose = rig.pose
    tip = data.site("fingertip").xpos / METRES
    assert tip == pytest.approx((pose.x, pose.y, pose.z), abs=CLOSE)
    places = [part.place for part in rig.arm.bench.parts.values()]
    found = data.qpos[7:].reshape(-1, 7)[:, :3] / METRES
    assert np.abs(found - places).max() < CLOSE


@pytest.mark.parametrize("arm", ARMS)
def test_the_links_weigh_on_the_joints_as_the_models_do(arm: str) -> None:
    model, data = load(arm)
    made, weights = model_named(arm), model_named(arm).weights
    mujoco.mj_forward(model, data)  # Stretched forward: every lever is as long as it can be.
    ounce_inches = data.qfrc_bias[1] / (0.028349523125 * 9.80665 * METRES)
    out = 2 * made.link + weights.hand_at
    levers = weights.upper_arm * weights.upper_arm_at, weights.hand * out
    whole = sum(levers) + weights.forearm * (made.link + weights.forearm_at)
    assert ounce_inches == pytest.approx(whole, rel=1e-9)


@pytest.mark.parametrize("arm", ARMS)
def test_the_servos_hold_the_arm_and_the_table_the_parts(arm: str) -> None:
    model, data = load(arm)
    mujoco.mj_resetDataKeyframe(model, data, model.key("now").id)
    before = data.qpos.copy()
    for _ in range(400):
        mujoco.mj_step(model, data)
    assert np.abs(data.qpos - before).max() < 0.02
