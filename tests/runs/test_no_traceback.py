"""No command shows a traceback, hangs or leaves without a word, whatever it is given.

Every parameter of every command is tried, as the command line itself lists them, so that a new one
is tried too: files with everything that is no such file, numbers with what is no number.
"""

from __future__ import annotations

import errno
import io
import json
import os
import signal
import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from xml.etree import ElementTree

import click
import pytest

from trs80arm.cli import main
from trs80arm.cli.ending import BROKEN_PIPE
from trs80arm.cli.group import load
from trs80arm.cli.table import COMMANDS
from trs80arm.desk.session import Session
from trs80arm.shown import LONGEST

GOOD = {
    "run": ["good.bas"],
    "replay": ["good.jsonl"],
    "check": ["good.bas"],
    "convert": ["good.bas", "o.cas"],
    "figure": ["8"],
    "programs": [],
    "sweep": ["good.bas", "--vary", "D=1,2", "--jobs", "1"],
    "export": ["good.bas", "-o", "o.csv", "--seconds", "0.1"],
    "film": ["good.bas", "-o", "o.svg", "--seconds", "0.1", "--fps", "0.5"],
    "terminal": ["--plain", "good.bas"],
    "tour": ["--plain"],
    "demo": [],
    "serve": ["good.bas"],
    "serial": ["--tcp", "0"],
}
"""What each command is given with which it works, and soon."""
LISTING = '10 D=50\n20 @STEP D,10\n30 PRINT "DONE"\n'

WRITTEN = {
    ("run", "trace"): ".csv",
    ("run", "trace_pose"): ".npz",
    ("run", "junit"): ".xml",
    ("convert", "target"): ".cas",
    ("figure", "output"): ".svg",
    ("sweep", "output"): ".csv",
    ("sweep", "plot"): ".svg",
    ("export", "output"): ".glb",
    ("film", "output"): ".cast",
    ("terminal", "record"): ".jsonl",
}
"""The files that are written, and what their names end with."""
PATIENCE = 300
"""Seconds that no command takes, however busy the computer is."""
OF_FOLDERS = ("own_folder",)
TAKEN = {"own_folder": ("", "folder", "/"), "programs": ("", "-")}
"""Names of no files that are right all the same: folders, and standard input."""
ANY_NUMBER = ("seed",)
"""Parameters that take a number below nought."""


@dataclass(frozen=True)
class Wrong:
    """A parameter of a command, and what is wrong for it."""

    command: str
    parameter: click.Parameter

    @property
    def name(self) -> str:
        return self.parameter.name or ""

    def words(self, value: str) -> list[str]:
        """The command line with a wrong value of the parameter, and all else as it should be."""
        good = [self.command, *GOOD[self.command]]
        if self.name == "font":
            good += ["-o", "o.gif"]
        if isinstance(self.parameter, click.Option):
            return [*good, max(self.parameter.opts, key=len), value]
        place = {"target": 2}.get(self.name, good.index("good.bas") if "good.bas" in good else 1)
        return [*good[:place], value, *good[place + 1 :]]

    @property
    def is_read(self) -> bool:
        takes_path = isinstance(self.parameter.type, click.Path)
        return takes_path and (self.command, self.name) not in WRITTEN

    def __str__(self) -> str:
        return f"{self.command} {self.name}"


def parameters() -> Iterator[Wrong]:
    """Every parameter that takes a value; those that commands share once."""
    seen = set()
    for command in GOOD:
        for parameter in load(command).params:
            option = parameter if isinstance(parameter, click.Option) else None
            shared = parameter.name, option.help if option else command
            if not (option and option.is_flag) and shared not in seen:
                seen.add(shared)
                yield Wrong(command, parameter)


EVERY = list(parameters())
FILES = [wrong for wrong in EVERY if wrong.is_read]
NUMBERS = [
    wrong
    for wrong in EVERY
    if isinstance(wrong.parameter.type, click.types.IntParamType | click.types.FloatParamType)
]
OUTPUTS = [wrong for wrong in EVERY if (wrong.command, wrong.name) in WRITTEN]
TEXTS = [wrong for wrong in EVERY if wrong not in (*FILES, *NUMBERS, *OUTPUTS)]


@cache
def a_recording() -> bytes:
    """A session in which something was typed."""
    session = Session()
    session.rig.type("PRINT 6*7\r")
    session.rig.run_until_waiting()
    with TemporaryDirectory() as folder:
        path = Path(folder) / "good.jsonl"
        session.save_recording(path)
        return path.read_bytes()


@pytest.fixture(autouse=True)
def settled(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """A folder to be in, with nobody's settings and a good program; nothing is served or typed."""
    from trs80arm.serial.serving import Server
    from trs80arm.ui.visitors import Visitors

    (tmp_path / "good.bas").write_text(LISTING)
    (tmp_path / "good.jsonl").write_bytes(a_recording())
    monkeypatch.setenv("TRS80ARM_CONFIG", os.devnull)
    monkeypatch.setenv("TRS80ARM_STATE", str(tmp_path / "state"))
    monkeypatch.setattr(Visitors, "serve", lambda self: None)
    monkeypatch.setattr(Server, "run", lambda self, keys: None)
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO()))
    monkeypatch.chdir(tmp_path)


Told = tuple[object, str]
"""The exit code of a command, and what it said on standard error."""
Tell = Callable[[list[str]], Told]


@pytest.fixture
def tell(monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]) -> Tell:
    """Gives a command line to the program and holds what it says to what must always be."""

    def told(words: list[str]) -> Told:
        monkeypatch.setattr(sys, "argv", ["trs80arm", *words])
        # What waits for ever is ended by the system, with the name of the test.
        signal.alarm(PATIENCE)
        try:
            main()
            code: object = 0
        except SystemExit as ending:
            code = ending.code
        finally:
            signal.alarm(0)
        out, err = capfd.readouterr()
        assert code in (0, 1, 2, BROKEN_PIPE), (words, err)
        assert "Traceback" not in out + err, words
        if code == 2:
            assert err.startswith("trs80arm: "), words
            assert err.count("\n") == 1, words
            assert err[:-1].isprintable(), words
            assert "None" not in err, words
            assert len(err) < LONGEST + 100, words
        return code, err

    return told


def no_such_files(folder: Path) -> Iterator[str]:
    """Names of what can be no file that is read: neither program nor bench, script or settings."""
    contents = {
        "zeros": b"\0" * 64,
        "crunched": b"\xff\x01\x02",
        "cassette": b"\0\0\xa5\xd3\xd3\xd3A\x3c",
        "latin": bytes(range(1, 256)),
        "wide": "A = 1\n".encode("utf-16"),
        "broken": b"a = [[[",
        "unknown": b"nonsense = 1\n",
        "kinds": b"part = 7\nseconds = 'x'\nterminal = 3\n",
        "nan": b"seconds = nan\nname = nan\n",
        "digits": b"seconds = " + b"9" * 5000,
        "deep": b"a = " + b"[" * 100_000,
        "dates": b"name = 1979-05-27\nseconds = 07:32:00\n",
        "codes\x1b]0;X\x07": b"\xff\x01\x01",
    }
    for name, content in contents.items():
        (folder / name).write_bytes(content)
        yield name
    with (folder / "huge").open("wb") as file:
        file.truncate(1 << 33)
    (folder / "folder").mkdir()
    (folder / "loop").symlink_to("loop")
    (folder / "broken link").symlink_to("nowhere")
    yield from ("huge", "folder", "loop", "broken link", "none", "none/x", "zeros/x", "/dev/zero")
    yield from ("", " ", "-", "/", "x" * 300, "\udcff\udcfe", "~nobody-of-that-name/x")


def test_every_command_is_tried() -> None:
    assert set(GOOD) == set(COMMANDS)


@pytest.mark.parametrize("wrong", FILES, ids=str)
def test_what_is_no_such_file_is_told_in_one_line(wrong: Wrong, tmp_path: Path, tell: Tell) -> None:
    taken = TAKEN.get(wrong.name, ()) if wrong.command != "run" else ()
    for name in no_such_files(tmp_path):
        if name == "/" and wrong.command == "check":
            continue  # All programs of the computer would be read.
        code, said = tell(wrong.words(name))
        if name not in taken:
            # What is checked may be held to be a program with lines that are wrong.
            assert code == 2 or (code == 1 and wrong.command == "check"), (name, said)


@pytest.mark.parametrize("wrong", FILES, ids=str)
@pytest.mark.parametrize("kind", ["empty", "pipe"])
def test_an_empty_file_and_a_pipe_that_nobody_writes_are_not_waited_for(
    wrong: Wrong, kind: str, tmp_path: Path, tell: Tell
) -> None:
    if kind == "pipe":
        os.mkfifo(tmp_path / kind)
    else:
        (tmp_path / kind).touch()
    code, _ = tell(wrong.words(kind))
    assert code in (0, 2)


@pytest.mark.parametrize("wrong", OUTPUTS, ids=str)
def test_what_cannot_be_written_is_told_in_one_line(
    wrong: Wrong, tmp_path: Path, tell: Tell
) -> None:
    suffix = WRITTEN[wrong.command, wrong.name]
    (tmp_path / "file").touch()
    (tmp_path / f"folder{suffix}").mkdir()
    os.mkfifo(tmp_path / f"pipe{suffix}")
    (tmp_path / f"loop{suffix}").symlink_to(f"loop{suffix}")
    (tmp_path / f"nowhere{suffix}").symlink_to("none/x")
    (tmp_path / f"full{suffix}").symlink_to("/dev/full")
    for name in ("folder", "pipe", "loop", "nowhere", "full", "none/x", "file/x", "x" * 300):
        code, said = tell(wrong.words(name + suffix))
        assert code == 2, (name, said)
    assert tell(wrong.words(""))[0] == 2


def test_of_two_traces_one_may_be_a_loop_of_links(tmp_path: Path, tell: Tell) -> None:
    (tmp_path / "loop.csv").symlink_to("loop.csv")
    for one, other in (("loop.csv", "t.csv"), ("t.csv", "loop.csv")):
        code, said = tell(["run", "good.bas", "--trace", one, "--trace-pose", other])
        assert code == 2
        assert "symbolic links" in said


@pytest.mark.parametrize("wrong", NUMBERS, ids=str)
def test_what_is_no_number_is_told_in_one_line(wrong: Wrong, tell: Tell) -> None:
    values = ["", "x", "nan", "inf", "-inf", "1e400", "1e308", "1,5", "9" * 5000, "\x1b[2J", "--"]
    for value in (*values, *([] if wrong.name in ANY_NUMBER else ["-1"])):
        assert tell(wrong.words(value))[0] == 2, value


@pytest.mark.parametrize("wrong", TEXTS, ids=str)
def test_odd_words_are_no_fault_of_the_program(wrong: Wrong, tell: Tell) -> None:
    for value in (
        "",
        "=",
        "D=nan",
        "D=1:2:0",
        "[",
        "1979",
        "6:nan",
        "A" * 5000,
        "\x1b[2J",
        "\udcff",
    ):
        tell(wrong.words(value))


@pytest.mark.parametrize("wrong", [*FILES, *OUTPUTS], ids=str)
def test_what_may_not_be_looked_at_is_told_in_one_line(
    wrong: Wrong, unprivileged: Path, tell: Tell
) -> None:
    suffix = WRITTEN.get((wrong.command, wrong.name), ".bas")
    shut, full = unprivileged / f"shut{suffix}", unprivileged / "folder"
    shut.write_text(LISTING)
    shut.chmod(0)
    full.mkdir()
    (full / f"x{suffix}").write_text(LISTING)
    full.chmod(0)
    for path in (shut, full / f"x{suffix}"):
        code, said = tell(wrong.words(str(path)))
        assert code == 2, said
        if wrong.name not in ("font", *OF_FOLDERS):
            # Who has no special rights is told so before it is tried.
            assert "ermission denied" in said or "is not readable" in said
    full.chmod(0o700)
    assert os.listdir(full) == [f"x{suffix}"]


@pytest.mark.parametrize("command", sorted(COMMANDS))
@pytest.mark.parametrize("option", ["--nonsense", "--option=x", "--jobs=x", "--format=7", "-o"])
def test_wrong_options_are_one_line_and_code_2(command: str, option: str, tell: Tell) -> None:
    code, _ = tell([command, "good.bas", option])
    assert code == 2


@pytest.mark.parametrize("command", ["run", "sweep", "export"])
def test_a_memory_size_that_the_machine_does_not_take_is_told_by_every_run(
    command: str, tell: Tell
) -> None:
    code, said = tell([command, *GOOD[command], "--memory-size", "99"])
    assert code == 2
    assert said == (
        "trs80arm: MEMORY SIZE? does not take '99': an address from 17430 to 32767, or nothing\n"
    )


PRINTING = [*sorted({*GOOD} - {"demo", "export", "film", "check"}), "--help", "--version"]
"""Commands that print something when all is well."""


@pytest.mark.parametrize("command", PRINTING)
def test_a_full_disk_behind_standard_output_is_told_of(
    command: str, monkeypatch: pytest.MonkeyPatch, tell: Tell
) -> None:
    with open("/dev/full", "w", encoding="utf-8") as full:
        monkeypatch.setattr(sys, "stdout", full)
        code, said = tell([command, *GOOD.get(command, [])])
    assert code == 2
    assert said == "trs80arm: standard output: No space left on device\n"


@pytest.mark.parametrize("command", [*PRINTING, "several"])
def test_a_reader_that_has_left_is_no_error(
    command: str, monkeypatch: pytest.MonkeyPatch, tell: Tell
) -> None:
    several = ["run", "good.bas", "good.bas", "--jobs", "1"]
    reader, writer = os.pipe()
    os.close(reader)
    with os.fdopen(writer, "w", encoding="utf-8") as left:
        monkeypatch.setattr(sys, "stdout", left)
        code, said = tell(several if command == "several" else [command, *GOOD.get(command, [])])
    assert (code, said) == (BROKEN_PIPE, "")


class Full(io.StringIO):
    def write(self, text: str) -> int:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))


@pytest.mark.parametrize("words", [["run", "none.bas"], ["run", "--nonsense"], ["figure", "x"]])
def test_an_exit_code_says_what_cannot_be_told(
    words: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys, "stderr", Full())
    monkeypatch.setattr(sys, "argv", ["trs80arm", *words])
    with pytest.raises(SystemExit) as ended:
        main()
    assert ended.value.code == 2


def test_many_wrong_files_at_once_are_told_in_a_line_each(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    names = [name for name in no_such_files(tmp_path) if name not in ("", "/", "-", "folder")]
    forms = {
        ("run", "--jobs", "1", "--junit", "j.xml"): "",
        ("run", "--jobs", "1", "--json"): "runs",
        ("check", "--format", "json"): "findings",
        ("check", "--format", "sarif"): "runs",
    }
    for words, key in forms.items():
        monkeypatch.setattr(sys, "argv", ["trs80arm", *words, "good.bas", *names])
        with pytest.raises(SystemExit) as ended:
            main()
        assert ended.value.code == 2
        out, err = capfd.readouterr()
        lines = err.splitlines()
        assert all(line.startswith("trs80arm: ") and line.isprintable() for line in lines)
        if words[0] == "run":
            assert len(lines) == len(names)
        if key:
            assert key in json.loads(out)
    assert len(ElementTree.parse("j.xml").getroot().findall("*/testcase")) == len(names) + 1
