"""Every make of arm, from BASIC to pictures and taught programs; and one that nobody made.

That one is unlike the others in all that can be chosen, and entered among them in one place.
"""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import pytest
from click.testing import CliRunner

from tests.block_bench import BLOCK
from tests.slices import elsewhere
from tests.statements import done
from trs80arm import Rig
from trs80arm.arm import ArmSettings, benchfile
from trs80arm.arm.cell.home import JOINTS
from trs80arm.arm.geometry import inverse
from trs80arm.arm.model import ArmModel, Hand, Motor, Pose
from trs80arm.arm.models import MINIMOVER5, MODELS
from trs80arm.basic.activity import Waiting
from trs80arm.cli.commands import cli
from trs80arm.desk.taught_programs import Manner, written
from trs80arm.desk.teach import Lesson
from trs80arm.drawing.picture import FROM_ABOVE, FROM_THE_SIDE, IN_SPACE, Picture
from trs80arm.drawing.readings import Readings
from trs80arm.works.devices import RigSettings

TOY = replace(
    MINIMOVER5,
    name="toy",
    title="Toy",
    shoulder_height=5.0,
    link=5.0,
    hand_length=2.5,
    drives=(
        replace(MINIMOVER5.drives[0], steps=300.0),
        replace(MINIMOVER5.drives[1], steps=500.0, sign=1),
        replace(MINIMOVER5.drives[2], steps=400.0, sign=-1),
        replace(MINIMOVER5.drives[4], sign=-1),
        replace(MINIMOVER5.drives[3], sign=-1),
        replace(MINIMOVER5.drives[5], steps=300.0),
    ),
    elbow_pays_out=0,
    compensated=False,
    hand=Hand(range=2.0, pound_steps=40, full_grip=2.0, switch_force=0.125, finger_length=1.2),
    solids=tuple(
        replace(solid, center=(solid.center[0] * 0.7, *solid.center[1:]))
        for solid in MINIMOVER5.solids
    ),
    start=Pose(4.0, 0.0, 1.0, -90.0, 0.0, 0.5),
)


@pytest.fixture(params=[*MODELS.values(), TOY], ids=lambda model: model.name)
def model(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> ArmModel:
    """Each of the arms, the toy entered among them."""
    monkeypatch.setitem(MODELS, TOY.name, TOY)
    found: ArmModel = request.param
    return found


def machine(model: ArmModel, bench: str, *statements: str) -> Rig:
    """A machine with an arm, when it has done some statements."""
    rig = Rig(RigSettings(arm=ArmSettings(model=model.name)), benchfile.parse(bench))
    return done(rig, *statements)


def lift(model: ArmModel) -> str:
    """@STEP that raises the upper arm by a tenth of a radian, and turns the base."""
    base, shoulder = (model.drives[model.latch(m)] for m in (Motor.BASE, Motor.SHOULDER))
    up = shoulder.sign * round(0.1 * shoulder.steps)
    return f"@STEP 150,{base.sign * round(0.2 * base.steps)},{up}"


def test_it_takes_a_part_turns_and_lifts_it_as_its_drives_say(model: ArmModel) -> None:
    rig = machine(model, BLOCK, "@CLOSE 100", "@STEP 150,0,0,0,0,0,-20", lift(model))
    assert rig.state.held == "block"
    assert rig.registers == rig.joints, "no step is lost"
    assert rig.pose.opening == pytest.approx(0.4, abs=0.01)
    pose = rig.pose
    now = inverse(model, pose.x, pose.y, pose.z, pose.pitch, pose.roll)
    start = inverse(model, 6.0, 0.0, 0.3, -90.0, 0.0)
    assert now.base - start.base == pytest.approx(0.2, abs=0.002)
    assert now.shoulder - start.shoulder == pytest.approx(0.1, abs=0.002)
    assert now.elbow == pytest.approx(start.elbow, abs=0.002)


def test_its_home_switches_close_where_its_joints_are_at_their_marks(model: ArmModel) -> None:
    settings = RigSettings(arm=ArmSettings(model=model.name))
    start = Rig(settings).state.angles
    marks = dict(zip(JOINTS, (math.degrees(angle) + 1 for angle in start.driven), strict=True))
    tables = (
        f"[[home]]\njoint = '{joint}'\nat = {mark}\nbit = {1 + number % 3}\nbank = {number // 3}"
        for number, (joint, mark) in enumerate(marks.items())
    )
    rig = Rig(settings, benchfile.parse("\n".join(["[selector]\nbits = [0]", *tables])))
    for joint, motor in JOINTS.items():
        latch = model.latch(motor)
        name, drive = f"{joint} home", model.drives[latch]
        for _ in range(40):
            if rig.sensors[name].given:
                break
            done(rig, f"@STEP 200{',0' * latch},{drive.sign}")
        beyond = rig.state.angles.driven[motor] - math.radians(marks[joint])
        assert 0 <= beyond * drive.steps < 1


def test_it_goes_on_from_a_snapshot(model: ArmModel) -> None:
    rig = machine(model, BLOCK, "@CLOSE 100")
    other = elsewhere(rig)
    for each in (rig, other):
        done(each, lift(model))
    assert other.snapshot() == rig.snapshot()
    assert other.arm.model is model


@pytest.mark.parametrize("subject", [FROM_THE_SIDE, FROM_ABOVE, IN_SPACE])
def test_it_is_drawn_as_it_stands(model: ArmModel, subject: object) -> None:
    rig = machine(model, BLOCK)
    drawn = []
    for statement in ("", lift(model)):
        done(rig, statement)
        picture = Picture(subject)  # type: ignore[arg-type]
        picture.labels = False
        drawn.append(picture.draw(Readings.of(rig), 80, 24))
    assert drawn[0] != drawn[1]


@pytest.mark.parametrize("in_coordinates", [True, False], ids=["coordinates", "steps"])
def test_what_was_taught_on_it_takes_it_there(model: ArmModel, in_coordinates: bool) -> None:
    bench = "[arm]\nat = [6, 0, 2]\n"
    rig, lesson = machine(model, bench), Lesson()
    lesson.add(Readings.of(rig))
    for statement in (lift(model), "@STEP 150,30,0,40,20,10"):
        done(rig, statement)
        lesson.add(Readings.of(rig))
    program = written(lesson, Manner(), model, in_coordinates=in_coordinates)
    assert not program.problem
    again = machine(model, bench)
    again.load_text(program.listing)
    again.type("RUN\r")
    again.run_for(1)
    if in_coordinates:
        assert again.run_until(lambda rig: rig.waiting is Waiting.SET, seconds=30)
        again.hold(["0"], 0.2)
    assert again.run_until(lambda rig: rig.waiting is Waiting.COMMAND, seconds=90)
    for axis in ("x", "y", "z", "pitch", "roll"):
        assert getattr(again.pose, axis) == pytest.approx(getattr(rig.pose, axis), abs=0.5)


def test_run_takes_the_arm_by_its_name(model: ArmModel, tmp_path: Path) -> None:
    (tmp_path / "lift.bas").write_text(f"10 {lift(model)}\n", encoding="utf-8")
    done = CliRunner().invoke(cli, ["run", str(tmp_path / "lift.bas"), "--arm", model.name])
    assert done.exit_code == 0, done.output
    unknown = CliRunner().invoke(cli, ["run", str(tmp_path / "lift.bas"), "--arm", "robko"])
    assert unknown.exit_code != 0
    assert "there are minimover5, teachmover" in unknown.output


def test_the_help_lists_the_arms_that_there_are() -> None:
    told = " ".join(CliRunner().invoke(cli, ["run", "--help"]).output.split())
    assert f"The arm on the cable: {' or '.join(sorted(MODELS))}." in told
