"""What comes along opens by name from anywhere, after files of that name where one is."""

from __future__ import annotations

from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from tests.own_places import PROGRAMS
from trs80arm.bundled import BENCH_SUFFIX, PROGRAM_SUFFIX, described, named, programs_folder
from trs80arm.cli import main
from trs80arm.cli.commands import cli


@pytest.fixture(autouse=True)
def elsewhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with nothing in it, where one is."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("TRS80ARM_CONFIG", str(tmp_path / "settings.toml"))
    (tmp_path / "settings.toml").write_text("")
    return tmp_path


def run(*arguments: object) -> Result:
    return CliRunner().invoke(cli, [*map(str, arguments)])


@pytest.mark.parametrize("name", ["table4", "table4.bas"])
def test_a_program_that_comes_along_has_a_name(name: str) -> None:
    assert named(Path(name), PROGRAM_SUFFIX) == PROGRAMS / "table4.bas"


def test_a_bench_that_comes_along_has_one_too() -> None:
    assert named(Path("tower"), BENCH_SUFFIX) == PROGRAMS / "tower.toml"


@pytest.mark.parametrize("here", ["table4", "table4.bas"])
def test_a_file_of_that_name_here_comes_first(here: str, elsewhere: Path) -> None:
    (elsewhere / here).write_text("10 REM MINE\n")
    assert named(Path("table4"), PROGRAM_SUFFIX).resolve() == elsewhere / here


def test_a_folder_of_that_name_is_no_program(elsewhere: Path) -> None:
    (elsewhere / "table4").mkdir()
    assert named(Path("table4"), PROGRAM_SUFFIX) == PROGRAMS / "table4.bas"


@pytest.mark.parametrize("name", ["nothing", "/table4", "", "..", "a\0b", "x" * 300])
def test_other_names_stay_as_they_were_typed(name: str) -> None:
    assert named(Path(name), PROGRAM_SUFFIX) == Path(name)


@pytest.mark.parametrize(
    ("package", "programs"),
    [
        ("trs80arm", "programs"),
        ("lib/python3.11/site-packages/trs80arm", "share/trs80arm/programs"),
        ("Lib/site-packages/trs80arm", "share/trs80arm/programs"),
        ("trs80arm", "share/trs80arm/programs"),
    ],
    ids=["checkout", "environment", "windows", "target"],
)
def test_programs_are_found_wherever_the_package_was_installed(
    package: str, programs: str, elsewhere: Path
) -> None:
    module = elsewhere / package / "bundled.py"
    assert programs_folder(module) is None
    (elsewhere / programs).mkdir(parents=True)
    (elsewhere / programs / "table4.bas").write_text("10 END\n")
    assert programs_folder(module) == elsewhere / programs


def test_programs_lists_all_that_come_along() -> None:
    done = run("programs")
    names = [line.split()[0] for line in done.output.splitlines()]
    assert sorted(names) == sorted(path.stem for path in PROGRAMS.glob("*.bas"))
    assert done.exit_code == 0


def test_everything_that_comes_along_is_described() -> None:
    assert all(len(words) > 10 for _, words in described())


def test_a_program_that_comes_along_runs_with_its_bench() -> None:
    done = run("run", "table4", "--set", "0", "--seconds", 60, "--pose")
    assert done.exit_code == 0
    assert "RUN THE PROGRAM" in done.output


def test_it_runs_on_another_bench_that_comes_along() -> None:
    done = run("run", "table4", "--bench", "table3", "--seconds", 1)
    assert done.exit_code == 0


def test_a_word_that_is_neither_command_nor_program_is_told_as_that(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("sys.argv", ["trs80arm", "runn", "x"])
    with pytest.raises(SystemExit) as ending:
        main()
    assert ending.value.code == 2
    said = capsys.readouterr().err
    assert "there is no command and no program 'runn'" in said
    assert "is run meant?" in said
    assert "argument" not in said


@pytest.mark.parametrize("words", [("--speed", "5", "demo"), ("--run", "run", "a.bas")])
def test_a_command_behind_options_is_told_where_it_belongs(
    words: tuple[str, ...], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("sys.argv", ["trs80arm", *words])
    with pytest.raises(SystemExit) as ending:
        main()
    assert ending.value.code == 2
    assert "is a command: it comes first" in capsys.readouterr().err


@pytest.mark.parametrize("answer", ["99999", "1", "words", "-5"])
def test_an_answer_that_memory_size_does_not_take_ends_a_run(
    answer: str, elsewhere: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (elsewhere / "one.bas").write_text("10 PRINT 1\n")
    done = run("run", "one.bas", "--memory-size", answer)
    assert done.exit_code == 2
    assert done.stdout == ""
    assert "MEMORY SIZE?" in done.stderr
    assert answer in done.stderr


@pytest.mark.parametrize(
    ("option", "text"), [("--bench", "x = 1\n"), ("--config", '[terminal]\nspeed = "7"\n')]
)
def test_a_mistake_in_a_file_names_it_once(elsewhere: Path, option: str, text: str) -> None:
    (elsewhere / "own.toml").write_text(text)
    done = run("run", "table4", option, "own.toml")
    assert done.exit_code == 2
    assert done.stderr.startswith("trs80arm: own.toml: ")
    assert done.stderr.count("own.toml") == 1


def test_a_file_that_fails_while_it_is_read_is_named() -> None:
    odd = Path("/proc/self/mem")
    if not odd.exists():
        odd = Path("/")
    done = run("run", odd)
    assert done.exit_code == 2
    assert done.stderr.startswith(f"trs80arm: {odd}: ")
