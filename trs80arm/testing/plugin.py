"""The pytest plugin: fixtures, a marker, an ini option, and what the arm did beside a failure.

pytest imports this module wherever trs80arm is installed, so it imports nothing but pytest; the
rig is loaded when a test asks for one.
"""

from __future__ import annotations

from collections.abc import Generator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from syrupy.assertion import SnapshotAssertion

    from trs80arm.testing.program_rig import ProgramRig

PROGRAMS = "trs80arm_programs"
"""The ini option."""
MARKER = "trs80arm"
RIG = pytest.StashKey["ProgramRig"]()
"""The rig of a test, for its report."""


def pytest_addoption(parser: pytest.Parser) -> None:
    """Declare the ini option."""
    parser.addini(
        PROGRAMS,
        "folder of the programs and benches that @pytest.mark.trs80arm names, as seen from the "
        "configuration file",
        default="programs",
    )


def pytest_configure(config: pytest.Config) -> None:
    """Declare the marker."""
    config.addinivalue_line(
        "markers",
        f"{MARKER}(program, bench=..., arm=..., ram=...): the program, bench file, make of arm and "
        "KiB of memory of the test's rig",
    )


@pytest.fixture
def rig(request: pytest.FixtureRequest) -> ProgramRig:
    """A fresh TRS-80 with card, arm and bench, as the marker `trs80arm` says."""
    from trs80arm.testing.fitting import MarkerError, from_marker

    marker = request.node.get_closest_marker(MARKER)
    args, kwargs = (marker.args, marker.kwargs) if marker else ((), {})
    wrong = ""
    try:
        made = request.node.stash[RIG] = from_marker(_programs(request.config), args, kwargs)
    except MarkerError as error:
        wrong = str(error)
    if wrong:
        # Not in the handler: the report would begin with the error that led to this one.
        pytest.fail(f"trs80arm: {wrong}", pytrace=False)
    return made


def _programs(config: pytest.Config) -> Path:
    """The folder of the programs."""
    beside = config.inipath.parent if config.inipath else config.rootpath
    return beside / str(config.getini(PROGRAMS))


@pytest.fixture
def arm_snapshot(request: pytest.FixtureRequest) -> SnapshotAssertion:
    """Compares a rig with its stored text: `assert rig == arm_snapshot`."""
    snapshot = _syrupy(request)
    from trs80arm.testing.snapshots import ArmText

    return snapshot.use_extension(ArmText)


@pytest.fixture
def arm_svg_snapshot(request: pytest.FixtureRequest) -> SnapshotAssertion:
    """Compares a rig with its stored drawing: `assert rig == arm_svg_snapshot`."""
    snapshot = _syrupy(request)
    from trs80arm.testing.snapshots import ArmSvg

    return snapshot.use_extension(ArmSvg)


@pytest.fixture
def arm_csv_snapshot(request: pytest.FixtureRequest) -> SnapshotAssertion:
    """Compares a trace with its stored CSV: `assert trace == arm_csv_snapshot`."""
    snapshot = _syrupy(request)
    from trs80arm.testing.snapshots import ArmCsv

    return snapshot.use_extension(ArmCsv)


def _syrupy(request: pytest.FixtureRequest) -> SnapshotAssertion:
    """The snapshot of the test, where syrupy is there to keep it."""
    if not request.config.pluginmanager.has_plugin("syrupy"):
        pytest.fail(
            "trs80arm: snapshots are kept by syrupy: pip install 'trs80arm[pytest]'", pytrace=False
        )
    found: SnapshotAssertion = request.getfixturevalue("snapshot")
    return found


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(
    item: pytest.Item, call: pytest.CallInfo[Any]
) -> Generator[None, pytest.TestReport, pytest.TestReport]:
    """Put what the arm did beside a failure."""
    report = yield
    made = item.stash.get(RIG, None)
    if report.failed and report.when == "call" and made is not None:
        from trs80arm.testing.story import failure_report

        report.sections.append(("What the arm did", failure_report(made, report.longreprtext)))
    return report
