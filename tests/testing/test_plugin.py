"""What the plugin gives to a test, and what it costs who does not use it."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest

from trs80arm.testing import (
    ProgramRig,
    assert_at,
    assert_no_slip,
    assert_part_at,
    assert_registers,
    portrait,
)
from trs80arm.testing.fitting import MarkerError, fitted_rig, from_marker
from trs80arm.testing.snapshots import ArmCsv, ArmSvg, ArmText

pytest_plugins = ["pytester"]
ASKS = '10 INPUT "HOW MANY";N\n20 @STEP 50,N\n30 @SET\n40 PRINT "AT";N\n'


OTHERS = ("-pno:hypothesispytest", "-pno:anyio", "-pno:xdist")
"""Plugins of this run that have no part in what a run of their own is to show, and take a while."""


def rig_with(program: str) -> ProgramRig:
    rig = ProgramRig()
    rig.load_text(program)
    rig.run()
    return rig


def test_answers_and_held_keys_are_given_when_the_machine_asks() -> None:
    rig = rig_with(ASKS)
    rig.answer(100)
    rig.jog("2:0.5 0")
    assert rig.expect(re.compile(r"AT +\d+"), seconds=20) == "AT 100"
    rig.finish()
    assert rig.registers[0] == 100
    assert rig.registers[1] != 0


def test_what_was_printed_before_the_last_match_does_not_count() -> None:
    rig = rig_with('10 PRINT "ONE":PRINT "TWO"\n')
    rig.expect("TWO")
    with pytest.raises(AssertionError, match="'ONE' was not printed, and nothing more is to"):
        rig.expect("ONE")


def test_what_is_typed_is_not_what_the_program_prints() -> None:
    rig = ProgramRig()
    rig.run('X=5:REM "HELLO"')
    with pytest.raises(AssertionError):
        rig.expect("HELLO", seconds=5)


def test_a_program_that_nobody_answers_says_what_it_waits_for() -> None:
    rig = rig_with(ASKS)
    with pytest.raises(AssertionError, match=r"it waits \(input\) at line 10"):
        rig.finish(seconds=20)


def test_an_error_is_expected_by_its_letters() -> None:
    rig_with("10 X=1/0\n").finish(error="/0")
    with pytest.raises(AssertionError, match=r"\?/0 Error in line 10"):
        rig_with("10 X=1/0\n").finish()
    with pytest.raises(AssertionError, match="shall end with"):
        rig_with("10 END\n").finish(error="UL")


def test_an_endless_program_ends_at_its_time() -> None:
    rig = rig_with("10 GOTO 10\n")
    begun = rig.time
    with pytest.raises(AssertionError, match="has not ended within 2 virtual seconds"):
        rig.finish(seconds=2)
    with pytest.raises(AssertionError, match=r"'A' was not printed within 0\.1 virtual seconds"):
        rig.expect("A", seconds=0.1)
    assert rig.time - begun == pytest.approx(2.1, abs=0.01)


def test_slips_are_told_with_motor_and_reason() -> None:
    rig = rig_with("10 @STEP 5,0,0,0,0,0,400\n")
    rig.finish()
    with pytest.raises(AssertionError, match=r"hand slipped \d+ steps: too fast") as failed:
        assert_no_slip(rig)
    assert re.search(r"hand: register \d+, joint -?\d+", str(failed.value))


def test_places_have_tolerances_and_say_by_how_much() -> None:
    rig = rig_with("10 @STEP 50,100\n")
    rig.finish()
    assert_no_slip(rig)
    assert_registers(rig, 100, None, 0)
    assert_registers(rig, 98, within=2)
    with pytest.raises(AssertionError, match=r"J1 is 100, wanted 98 within 1: off by \+2"):
        assert_registers(rig, 98, within=1)
    here = rig.pose
    assert_at(rig, here.x + 0.04, here.y, pitch=here.pitch)
    with pytest.raises(AssertionError, match=r"x is .* wanted .* off by -0\.100"):
        assert_at(rig, here.x + 0.1)
    with pytest.raises(TypeError, match="6 registers"):
        assert_registers(rig, *range(7))


def test_parts_are_found_by_name() -> None:
    rig = ProgramRig()
    (name, part), *_ = rig.arm.bench.parts.items()
    x, y, z = part.box.center
    assert_part_at(rig, name, x, y, z)
    with pytest.raises(AssertionError, match=f"part '{name}' is elsewhere"):
        assert_part_at(rig, name, x + 1)
    with pytest.raises(AssertionError, match=f"no part 'gold' on the bench; there are: {name}"):
        assert_part_at(rig, "gold")


def test_a_portrait_shows_screen_registers_joints_pose_parts_slips_and_the_side() -> None:
    text = portrait(rig_with(""))
    for title in ("screen", "motors", "pose", "hand", "parts", "slips", "side view"):
        assert f"\n{title}" in text
    assert text == portrait(rig_with(""))
    assert ArmText().serialize(rig_with("")) == text


def test_a_diff_has_each_side_view_in_one_piece_and_both_of_one_scale() -> None:
    far, near = rig_with("10 @STEP 50,0,200\n"), rig_with("10 @STEP 50,0,-200\n")
    far.finish()
    near.finish()
    lines = ArmText().diff_snapshots(portrait(near), portrait(far)).splitlines()
    assert any(line.startswith("-   J2 shoulder") for line in lines)
    view = lines[lines.index("  side view") + 1 :]
    signs = [line[0] for line in view]
    assert signs == sorted(signs, key="-+".index)
    stored, now = view[: signs.index("+")], view[signs.index("+") :]
    # The base, which did not move, is drawn alike.
    assert [row[1:33] for row in stored[-3:]] == [row[1:33] for row in now[-3:]]


def test_a_diff_of_equal_side_views_has_none() -> None:
    rig = rig_with("")
    before = portrait(rig)
    rig.run_for(1)
    assert "side view" not in ArmText().diff_snapshots(portrait(rig), before)


def test_the_drawing_shows_register_and_joint_and_is_the_same_each_time() -> None:
    rig = rig_with("10 @STEP 5,0,0,0,0,0,400\n")
    rig.finish()
    drawn = ArmSvg().serialize(rig)
    assert re.search(r"hand +400 +-?\d+<", drawn)
    assert drawn.count("<g ") == 2
    assert drawn == ArmSvg().serialize(rig)


def test_a_trace_is_csv_when_its_block_has_ended() -> None:
    rig = rig_with("10 @STEP 50,3\n")
    with rig.trace("latches") as latches, rig.trace("pose", rate=10) as pose:
        rig.finish()
    assert latches.text.splitlines()[0] == "t_states,seconds,latch,nibble"
    assert latches.text.count(",base,") == 3
    assert ArmCsv().serialize(pose).startswith("t_states,seconds,base,")
    with pytest.raises(ValueError, match="'pose' or 'latches'"), rig.trace("sound"):
        pass


def test_a_marker_says_what_the_rig_is(tmp_path: Path) -> None:
    (tmp_path / "a.bas").write_text("10 PRINT MEM\n")
    (tmp_path / "a.toml").write_text('name = "beside"\n')
    (tmp_path / "b.toml").write_text('name = "other"\n')
    assert fitted_rig(tmp_path, "a.bas").arm.bench.name == "beside"
    rig = fitted_rig(tmp_path, "a.bas", bench="b.toml", arm="teachmover", ram=4)
    assert (rig.arm.bench.name, rig.arm.model.name) == ("other", "teachmover")
    assert rig.settings.ram_kib == 4


@pytest.mark.parametrize(
    ("args", "kwargs", "words"),
    [
        (("gone.bas",), {}, "gone.bas"),
        ((), {"bench": "gone.toml"}, "gone.toml"),
        ((), {"arm": "puma"}, "no arm puma"),
        ((), {"ram": 5}, "4, 16, 32 or 48"),
        ((), {"speed": 2}, "not speed"),
        (("a.bas", "b.toml"), {}, "takes one program"),
        ((5,), {}, "int"),
    ],
)
def test_a_marker_that_cannot_be_is_one_line(
    tmp_path: Path, args: tuple[object, ...], kwargs: dict[str, object], words: str
) -> None:
    with pytest.raises(MarkerError, match=re.escape(words)) as failed:
        from_marker(tmp_path, args, kwargs)
    assert "\n" not in str(failed.value)


def test_kinds_of_snapshot_and_a_wrong_marker_in_a_run(pytester: pytest.Pytester) -> None:
    pytester.makepyfile(
        """
        import pytest

        def test_kinds(rig, arm_snapshot, arm_svg_snapshot, arm_csv_snapshot):
            with rig.trace(rate=1) as trace:
                rig.run_for(2)
            assert rig == arm_snapshot
            assert rig == arm_svg_snapshot
            assert trace == arm_csv_snapshot

        @pytest.mark.trs80arm("gone.bas")
        def test_gone(rig):
            pass
        """
    )
    written = pytester.runpytest_subprocess(*OTHERS, "--strict-markers", "--snapshot-update")
    written.assert_outcomes(passed=1, errors=1)
    written.stdout.fnmatch_lines(["trs80arm: *gone.bas*"])
    assert "another exception" not in written.stdout.str()
    kept = {path.name for path in pytester.path.rglob("__snapshots__/*/*")}
    assert kept == {"test_kinds.arm.txt", "test_kinds.svg", "test_kinds.csv"}
    again = pytester.runpytest_subprocess(*OTHERS, "-k", "not gone")
    again.assert_outcomes(passed=1, deselected=1)


def test_without_syrupy_a_line_says_what_to_install(pytester: pytest.Pytester) -> None:
    pytester.makepyfile("def test_it(rig, arm_snapshot): pass")
    done = pytester.runpytest_subprocess(*OTHERS, "-p", "no:syrupy")
    assert done.ret == pytest.ExitCode.TESTS_FAILED
    done.stdout.fnmatch_lines(["*pip install 'trs80arm?pytest?'*"])


def test_whoever_does_not_use_the_plugin_loads_no_rig() -> None:
    script = "import sys, trs80arm.testing.plugin as _; print(*sys.modules)"
    done = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=True, timeout=60
    )
    loaded = set(done.stdout.split())
    assert loaded.isdisjoint({"numpy", "syrupy", "textual", "trs80arm.rig"})
