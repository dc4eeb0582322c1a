"""The plugin in a stranger's repository: a wheel in a fresh venv, one program, one bench, tests.

Kept quick, and no registry is asked: the setuptools that is there builds the wheel, as pip would
have it do, and pip puts it into a venv that has no pip of its own; what trs80arm stands on is taken
from this run's environment by a `.pth` file.
"""

from __future__ import annotations

import os
import shlex
import shutil
import subprocess
import sys
import sysconfig
import venv
from pathlib import Path

import pytest

from tests.testing.stranger import files, hurry, settle, steps

pytest_plugins = ["pytester"]
TREE = Path(__file__).parents[2]
OFFLINE = ("--no-deps", "--no-index")
BUILD = "import sys; from setuptools.build_meta import build_wheel; build_wheel(sys.argv[1])"
"""What pip has a backend do, in the folder of the source."""
EXE = ".exe" if os.name == "nt" else ""


def apart(lines: list[str]) -> None:
    """The diff of the snapshot shows base and shoulder where register and joint had agreed."""
    text = "\n".join(line.removeprefix("E").strip() for line in lines)
    assert "-   J1 base                 300       300         0" in text
    assert "+   J1 base                 300         4       296" in text
    assert "-   J2 shoulder             -80       -80         0" in text


def wheel(folder: Path) -> Path:
    """A wheel of the tree."""
    source = folder / "source"
    unwanted = shutil.ignore_patterns("__pycache__", "*.egg-info")
    for name in ("trs80arm", "programs"):
        shutil.copytree(TREE / name, source / name, ignore=unwanted)
    for name in ("pyproject.toml", "README.md", "LICENSE"):
        shutil.copy(TREE / name, source / name)
    # pip itself would take longer to find out what to do than the backend does for it.
    subprocess.run(
        [sys.executable, "-c", BUILD, folder], cwd=source, check=True, capture_output=True
    )
    (made,) = folder.glob("*.whl")
    return made


def fresh_environment(folder: Path, made: Path) -> Path:
    """The folder of commands of a new venv with the wheel, and this run's packages behind it."""
    venv.create(folder, with_pip=False, symlinks=os.name != "nt")
    places = {"base": str(folder), "platbase": str(folder)}
    commands = Path(sysconfig.get_path("scripts", "venv", places))
    quiet = ("--disable-pip-version-check", "--quiet")
    there = ("--python", commands / f"python{EXE}")
    subprocess.run(
        [sys.executable, "-m", "pip", *quiet, *there, "install", *OFFLINE, "--no-compile", made],
        check=True,
        capture_output=True,
    )
    behind = [place for place in sys.path if place.endswith("-packages")]
    site = Path(sysconfig.get_path("purelib", "venv", places))
    (site / "behind.pth").write_text("\n".join(behind))
    return commands


def test_a_strangers_tests_pass_and_a_hurried_arm_fails_them(pytester: pytest.Pytester) -> None:
    aside = pytester.mkdir("aside")
    commands = fresh_environment(aside / "venv", wheel(aside))
    repository = pytester.mkdir("repository")
    settle(repository)
    clean = {name: value for name, value in os.environ.items() if not name.startswith("PYT")}

    def said(command: str, *arguments: str) -> tuple[int, list[str]]:
        done = subprocess.run(
            [commands / Path(command).with_suffix(EXE), *arguments],
            cwd=repository,
            env=clean,
            capture_output=True,
            text=True,
            timeout=120,
            check=False,
        )
        return done.returncode, [*done.stdout.splitlines(), *done.stderr.splitlines()]

    # This run's pytest lies behind, and its command with it; of its plugins a stranger has syrupy.
    without = ("cacheprovider", "hypothesispytest", "anyio", "xdist")
    tests = ("python", "-m", "pytest", *(f"-pno:{plugin}" for plugin in without))
    _, (where,) = said("python", "-c", "import trs80arm; print(trs80arm.__file__)")
    assert Path(where).is_relative_to(aside)
    code, lines = said(*tests, "--snapshot-update", "-k", "table")
    assert code == 0, lines
    for step in steps():
        command, *arguments = shlex.split(step)
        code, lines = said(*(tests if command == "pytest" else (command,)), *arguments)
        assert code == 0, (step, lines)
    assert (repository / "results.xml").is_file()
    hurry(repository)
    code, lines = said(*tests)
    assert code == 1
    apart(lines)
    text = "\n".join(lines)
    assert "motors have slipped" in text
    assert "shoulder slipped 88 steps: too fast" in text
    assert "What the arm did" in text
    # A summary, which is long in some places, repeats the messages.
    report, _, _ = text.partition("short test summary info")
    assert report.count("shoulder: register -80, joint -168") == 2, "once for each failure"
    assert "1 passed" in text
    assert "2 failed" in text


def test_the_page_leads_to_a_whole_repository() -> None:
    assert set(files()) == {
        "arm/fetch.bas",
        "arm/fetch.toml",
        "pyproject.toml",
        "tests/test_fetch.py",
        ".github/workflows/arm.yml",
    }
