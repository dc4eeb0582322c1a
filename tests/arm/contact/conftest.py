"""The referee's tests run where MuJoCo is installed; the header of a run says whether it is."""

from __future__ import annotations

from importlib.metadata import version
from importlib.util import find_spec

REFEREE = find_spec("mujoco") is not None

collect_ignore = [] if REFEREE else ["test_referee.py", "referee.py"]


def pytest_report_header() -> str:
    if REFEREE:
        return f"contact: scenes also before MuJoCo {version('mujoco')}"
    return "contact: without MuJoCo (extra `referee`); scenes are held to their ends as text"
