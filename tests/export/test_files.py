"""The files that are written, and what is said of those that cannot be."""

from __future__ import annotations

from pathlib import Path
from xml.etree import ElementTree

import pytest

from tests.export.command import refusal, run
from tests.export.poses import ARMS, BENCH, rig_of
from tests.goldens import check_golden
from trs80arm.export.mjcf import mjcf
from trs80arm.export.urdf import urdf


@pytest.mark.parametrize("arm", ARMS)
def test_an_arm_as_mjcf_is_this(arm: str) -> None:
    check_golden(f"export-{arm}", mjcf(rig_of(arm)), "xml")


@pytest.mark.parametrize("arm", ARMS)
def test_an_arm_as_urdf_is_this(arm: str) -> None:
    check_golden(f"export-{arm}", urdf(rig_of(arm), "meshes")[0], "urdf")


def test_every_moving_link_has_its_inertia() -> None:
    robot = ElementTree.fromstring(urdf(rig_of("minimover5"), "meshes")[0])
    links = {link.get("name"): link for link in robot.iter("link")}
    for joint in robot.iter("joint"):
        child = joint.find("child")
        assert child is not None
        if joint.get("type") != "fixed":
            assert links[child.get("link")].find("inertial/mass") is not None


def test_meshes_lie_in_a_folder_beside_a_urdf(tmp_path: Path) -> None:
    bench = tmp_path / "bench.toml"
    bench.write_text(BENCH, encoding="utf-8")
    assert run("--bench", bench, "-o", tmp_path / "arm.urdf") == (0, "")
    text = (tmp_path / "arm.urdf").read_text(encoding="utf-8")
    assert 'filename="arm-meshes/disc.stl"' in text
    # Eighty bytes of title, a count, fifty bytes for each triangle of a prism of 24 sides.
    assert len((tmp_path / "arm-meshes" / "disc.stl").read_bytes()) == 84 + 50 * (2 * 22 + 2 * 24)


def test_a_program_brings_its_bench(tmp_path: Path) -> None:
    assert run("conveyor", "-o", tmp_path / "arm.mjcf", "--arm", "teachmover") == (0, "")
    text = (tmp_path / "arm.mjcf").read_text(encoding="utf-8")
    assert '<mujoco model="teachmover">' in text
    assert 'name="belt"' in text or "conveyor" in text


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["-o", "{}/arm.obj"], "an export is a .xml"),
        (["-o", "{}/arm"], "an export is a .xml"),
        (["-o", "{}/nowhere/arm.xml"], "No such file or directory"),
        (["-o", "{}/nowhere/arm.urdf"], "No such file or directory"),
        (["-o", "{}/arm.xml", "--bench", "{}/none.toml"], "none.toml"),
        (["{}/none.bas", "-o", "{}/arm.xml"], "none.bas"),
        (["{}", "-o", "{}/arm.xml"], "directory"),
        (["-o", "{}"], "an export is a .xml"),
        (["-o", "{}/arm.xml", "--arm", "puma"], "puma"),
    ],
)
def test_what_cannot_be_written_is_told_in_one_line(
    words: list[str], said: str, tmp_path: Path
) -> None:
    assert said in refusal(words, tmp_path)


@pytest.mark.parametrize("suffix", [".xml", ".mjcf", ".urdf", ".URDF"])
@pytest.mark.parametrize(
    "option", [("--seconds", "60"), ("--fps", "30"), ("--input", "1"), ("--set", "6:1.0 0")]
)
def test_an_arm_as_it_stands_takes_no_option_of_a_run(
    suffix: str, option: tuple[str, str], tmp_path: Path
) -> None:
    target = tmp_path / f"arm{suffix}"
    told = (
        f"trs80arm: {target}: {option[0]} is for a run; a {suffix} file has the arm as it stands\n"
    )
    assert run("table4", "-o", target, *option) == (2, told)
    assert not target.exists()
