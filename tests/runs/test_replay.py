"""A session recorded at the terminal, played again without a screen."""

from __future__ import annotations

import io
import json
import sys
from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from trs80arm import bars
from trs80arm.batch import BatchOptions
from trs80arm.cli.commands import cli
from trs80arm.desk.session import Session
from trs80arm.replay import replay_session


@pytest.fixture(scope="module")
def session(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Session]:
    sitting = Session()
    sitting.load_bytes(b'10 @SET\n20 PRINT "DONE"\n')
    sitting.rig.type("RUN\r")
    sitting.rig.run_for(2)
    sitting.rig.hold(["1"], 0.5)
    sitting.rig.run_for(1)
    sitting.rig.hold(["0"], 0.1)
    sitting.rig.run_for(1)
    path = tmp_path_factory.mktemp("sessions") / "s.jsonl"
    sitting.save_recording(path)
    return path, sitting


def replay(path: Path, *options: str) -> Result:
    return CliRunner().invoke(cli, ["replay", str(path), *options])


def test_it_comes_to_where_the_session_was_and_prints_what_was_seen(
    session: tuple[Path, Session],
) -> None:
    path, sitting = session
    done = replay(path, "--registers", "--screen")
    assert (done.exit_code, done.stderr) == (0, "")
    assert done.stdout.startswith("RUN\nDONE\nREADY\n")
    assert done.stdout.splitlines()[-1] == " ".join(map(str, sitting.rig.registers))
    assert sitting.rig.registers[0] != 0


def test_it_is_one_object_too(session: tuple[Path, Session], tmp_path: Path) -> None:
    path, sitting = session
    told = json.loads(replay(path, "--json", "--trace", str(tmp_path / "t.csv")).stdout)
    assert told["joints"] == list(sitting.rig.joints)
    assert told["ended"]["how"] == "end"
    assert told["seconds"]["virtual"] == pytest.approx(sitting.rig.time, abs=0.001)
    assert ",base," in (tmp_path / "t.csv").read_text()


def test_what_it_is_to_come_to_can_be_said(session: tuple[Path, Session], tmp_path: Path) -> None:
    script = tmp_path / "wanted.toml"
    script.write_text('[expect]\noutput = "DONE"\nregisters = [1, 0, 0, 0, 0, 0]\n')
    done = replay(session[0], "--script", str(script))
    assert done.exit_code == 1
    (line,) = done.stderr.splitlines()
    assert "registers: expected 1 0 0 0 0 0, not" in line


@pytest.mark.parametrize(
    ("content", "script", "words"),
    [
        ("10 PRINT\n", "", "line 1: no JSON object"),
        (None, 'inputs = ["5"]\n', "a recording is its own operator"),
        (None, "seconds = 5\n", "a recording is its own operator"),
    ],
)
def test_what_cannot_be_played_is_one_line(
    session: tuple[Path, Session], tmp_path: Path, content: str | None, script: str, words: str
) -> None:
    path, wanted = tmp_path / "s.jsonl", tmp_path / "s.run.toml"
    path.write_text(session[0].read_text() if content is None else content)
    wanted.write_text(script)
    done = replay(path)
    assert done.exit_code == 2
    assert words in done.stderr
    assert done.stderr.count("\n") == 1


def test_who_looks_on_changes_nothing(
    session: tuple[Path, Session], monkeypatch: pytest.MonkeyPatch
) -> None:
    class Screen(io.StringIO):
        def isatty(self) -> bool:
            return True

    monkeypatch.setenv("TERM", "xterm")
    monkeypatch.setattr(bars, "_SOON", -1.0)
    told = []
    for screen in (io.StringIO(), Screen()):
        monkeypatch.setattr(sys, "stderr", screen)
        printed = io.StringIO()
        assert replay_session(BatchOptions(session[0], as_json=True), printed) == 0
        told.append(printed.getvalue())
        assert ("s" in screen.getvalue()) is screen.isatty()
    assert told[0] == told[1]
