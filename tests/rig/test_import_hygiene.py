"""What is loaded when: the core without Textual, the help with nothing heavy, no dialog early."""

from __future__ import annotations

import subprocess
import sys

import pytest

from trs80arm.cli.group import load
from trs80arm.cli.table import COMMANDS, front_page

HEAVY = ("textual", "numpy", "matplotlib", "rich")


def loaded_after(code: str) -> set[str]:
    script = f"import sys\n{code}\nprint(*sys.modules)"
    done = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=True, timeout=60
    )
    return set(done.stdout.split())


def test_importing_the_package_loads_nothing_heavy() -> None:
    assert loaded_after("import trs80arm").isdisjoint(HEAVY)


def test_the_library_works_without_textual() -> None:
    modules = loaded_after("from trs80arm import Rig; Rig()")
    assert "textual" not in modules
    assert "trs80arm.ui" not in modules


@pytest.mark.parametrize("arguments", [["--help"], ["run", "--help"], ["terminal", "--help"]])
def test_help_answers_without_textual_or_numpy(arguments: list[str]) -> None:
    modules = loaded_after(
        "from trs80arm.cli.commands import cli\n"
        f"cli.main({arguments!r}, prog_name='trs80arm', standalone_mode=False)"
    )
    assert modules.isdisjoint({"textual", "numpy", "matplotlib"})


def test_the_front_page_of_the_help_loads_no_library() -> None:
    modules = loaded_after(
        "sys.argv = ['trs80arm', '--help']\nfrom trs80arm.cli import main\nmain()"
    )
    assert modules.isdisjoint({"click", "typing", "textual", "numpy", "rich"})
    ours = {name for name in modules if name.startswith("trs80arm.")}
    cli = {f"trs80arm.cli.{name}" for name in ("entry", "streams", "table")}
    assert ours == {"trs80arm.cli", *cli}


def test_the_front_page_has_every_command_in_80_columns() -> None:
    page = front_page()
    assert max(map(len, page.splitlines())) < 80
    for name in COMMANDS:
        assert load(name).name == name
        assert f"\n  {name} " in page


def test_the_first_frame_waits_for_no_large_dialog() -> None:
    modules = loaded_after("import trs80arm.ui.start, trs80arm.ui.app")
    screens = {name for name in modules if name.startswith("trs80arm.ui.screens.")}
    small = ("desk", "dialog", "lists", "palette")
    assert screens == {f"trs80arm.ui.screens.{name}" for name in small}


def test_what_cannot_be_used_is_told_without_textual() -> None:
    modules = loaded_after(
        "from pathlib import Path\n"
        "from trs80arm.options import TerminalOptions\n"
        "from trs80arm.ui import start\n"
        "start._has_terminal = lambda: True\n"
        "assert start.run_terminal(TerminalOptions(program=Path('/nowhere/a.bas'))) == 2"
    )
    assert "trs80arm.desk.opening" in modules
    assert modules.isdisjoint({"textual", "rich"})


def test_the_line_mode_starts_without_textual() -> None:
    modules = loaded_after(
        "import io, os, sys\n"
        "sys.stdin, real = io.StringIO('PRINT 1+1\\n'), sys.stdout\n"
        "sys.stdout = io.StringIO()\n"
        "from trs80arm.cli.commands import cli\n"
        "try:\n"
        "    cli.main(['terminal', '--plain', '--speed', 'max'], prog_name='trs80arm')\n"
        "except SystemExit as end:\n"
        "    assert not end.code, end.code\n"
        "text, sys.stdout = sys.stdout.getvalue(), real\n"
        "assert ' 2' in text, text"
    )
    assert "trs80arm.plain" in modules
    assert modules.isdisjoint({"textual", "trs80arm.ui"})


def test_the_wire_to_a_real_arm_costs_who_has_none_nothing() -> None:
    modules = loaded_after(
        "import trs80arm.batch, trs80arm.plain, trs80arm.ui.start, trs80arm.ui.app"
    )
    assert modules.isdisjoint({"trs80arm.serial.courier", "trs80arm.serial.port", "serial"})
