"""`trs80arm run` as a shell sees it: output, exit codes, one clear line for what is wrong."""

from __future__ import annotations

from pathlib import Path

import pytest
from click.testing import CliRunner, Result

from trs80arm.cli import main
from trs80arm.cli.commands import cli

PROGRAMS = Path(__file__).parents[2] / "programs"


@pytest.fixture(autouse=True)
def no_settings(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """Keep the settings of whoever runs the tests out of them."""
    empty = tmp_path / "settings.toml"
    empty.write_text("")
    monkeypatch.setenv("TRS80ARM_CONFIG", str(empty))


def run(*arguments: object) -> Result:
    return CliRunner().invoke(cli, ["run", *map(str, arguments)])


def program(folder: Path, text: str) -> Path:
    path = folder / "program.bas"
    path.write_text(text)
    return path


def test_what_the_program_prints_goes_to_standard_output(tmp_path: Path) -> None:
    done = run(program(tmp_path, '10 PRINT "HELLO"\n20 PRINT 1/3;\n'))
    assert (done.exit_code, done.stdout, done.stderr) == (0, "HELLO\n .333333 \n", "")


def test_a_basic_error_is_shown_and_gives_exit_code_1(tmp_path: Path) -> None:
    done = run(program(tmp_path, '10 PRINT "A"\n20 GOTO 99\n'))
    assert done.exit_code == 1
    assert done.stdout == "A\n?UL Error in 20\n"


def test_a_syntax_error_does_not_wait_in_edit(tmp_path: Path) -> None:
    done = run(program(tmp_path, "10 PRIMT\n"))
    assert (done.exit_code, done.stdout) == (1, "?SN Error in 10\n")


def test_inputs_are_answered_in_order(tmp_path: Path) -> None:
    path = program(tmp_path, '10 INPUT "NAME";N$:INPUT A\n20 PRINT N$;A*2\n')
    done = run(path, "--input", "JO", "--input", "4")
    assert (done.exit_code, done.stdout) == (0, "NAME? JO\n? 4\nJO 8 \n")


def test_an_input_that_nobody_answers_stops_the_run_and_says_so(tmp_path: Path) -> None:
    done = run(program(tmp_path, "10 INPUT A\n"))
    assert done.exit_code == 0
    assert "--input" in done.stderr


@pytest.mark.parametrize(
    ("option", "statement", "device"),
    [("--tapes", 'CSAVE "A"', "cassette"), ("--printer", 'LPRINT "A"', "printer")],
)
def test_a_device_that_cannot_keep_what_it_was_given_is_told_of(
    option: str, statement: str, device: str, tmp_path: Path
) -> None:
    in_the_way = tmp_path / "file"
    in_the_way.write_text("")
    done = run(program(tmp_path, f'10 {statement}\n20 PRINT "ON"\n'), option, in_the_way / "x")
    assert (done.exit_code, done.stdout) == (0, "ON\n")
    assert done.stderr.startswith(f"trs80arm: {device}: {in_the_way}")
    assert done.stderr.count("\n") == 1


def test_the_limit_counts_virtual_seconds_from_run(tmp_path: Path) -> None:
    path = program(tmp_path, "10 @STEP 60,1:PRINT 1;:GOTO 10\n")
    done = run(path, "--seconds", 10, "--registers")
    assert done.exit_code == 0
    steps = int(done.stdout.splitlines()[-1].split()[0])
    assert abs(steps - done.stdout.count(" 1 ")) <= 1
    # A step of 3 ms, and some 10 to 20 ms for the three statements and scrolling now and then.
    assert 300 < steps < 1100


def test_screen_registers_and_pose_are_printed_when_asked_for(tmp_path: Path) -> None:
    path = program(tmp_path, '10 CLS:PRINT "OK"\n20 @STEP 50,100,0,0,0,0,-5\n')
    done = run(path, "--screen", "--registers", "--pose")
    lines = done.stdout.splitlines()
    assert lines[-18] == "OK"
    assert lines[-2] == "100 0 0 0 0 -5"
    x, y, z, pitch, roll, _opening = map(float, lines[-1].split())
    assert (x, z, pitch) == pytest.approx((4.97, 0.0, -90.0), abs=0.02)
    assert y == pytest.approx(0.532, abs=0.02)
    assert abs(roll) < 10


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["nowhere.bas"], "nowhere.bas"),
        ([str(PROGRAMS / "table4.bas"), "--bench", "nowhere.toml"], "nowhere.toml"),
        ([str(PROGRAMS / "table4.bas"), "--set", "9:x"], "KEYS:SECONDS"),
        ([str(PROGRAMS / "table4.bas"), "--ram", "17"], "ram"),
        ([str(PROGRAMS / "table4.bas"), "--arm", "pump"], "--arm pump: no arm pump: there are min"),
        ([str(PROGRAMS / "table4.bas"), "--trace", "trace.xyz"], "trace.xyz"),
        ([str(PROGRAMS / "table4.bas"), "--seconds", "soon"], "seconds"),
        ([str(PROGRAMS)], "programs"),
    ],
)
def test_bad_usage_is_exit_code_2_and_says_what_is_wrong(arguments: list[str], words: str) -> None:
    done = run(*arguments)
    assert done.exit_code == 2
    assert words in done.stderr
    assert "Traceback" not in done.stderr
    assert done.stdout == ""


def test_a_file_that_is_no_program_is_refused_in_one_line(tmp_path: Path) -> None:
    path = tmp_path / "noise.bas"
    path.write_bytes(bytes(range(256)))
    done = run(path)
    assert done.exit_code == 2
    assert "noise.bas: neither text nor a crunched program" in done.stderr
    assert len(done.stderr.splitlines()) == 1


def test_traces_that_would_be_lost_are_refused_in_one_line(tmp_path: Path) -> None:
    path, trace = program(tmp_path, "10 @STEP 50,5\n"), tmp_path / "trace.csv"
    for arguments in (["--trace-rate", 10], ["--trace", trace, "--trace-pose", trace]):
        done = run(path, *arguments)
        assert done.exit_code == 2
        assert done.stderr.startswith("trs80arm: ")
        assert "--trace-pose" in done.stderr
        assert done.stderr.count("\n") == 1
    assert not trace.exists()


def test_convert_there_and_back_keeps_the_program(tmp_path: Path) -> None:
    runner = CliRunner()
    source = PROGRAMS / "table4.bas"
    for name in ("a.cas", "b.bas", "c.txt"):
        done = runner.invoke(cli, ["convert", str(source), str(tmp_path / name)])
        assert done.exit_code == 0
        source = tmp_path / name
    listed = (tmp_path / "c.txt").read_text().splitlines()
    printed = (PROGRAMS / "table4.bas").read_text().splitlines()
    assert [line.rstrip() for line in listed] == [line.rstrip() for line in printed]


def test_table_4_cycles_parts_until_the_limit_and_twice_the_same() -> None:
    arguments = [PROGRAMS / "table4.bas", "--set", "6:1.0 0", "--seconds", 120]
    arguments += ["--registers", "--pose", "--screen"]
    first, second = run(*arguments), run(*arguments)
    assert first.exit_code == 0
    assert first.stdout == second.stdout
    assert "SET ARM TO THE FOLLOWING POSITION & ORIENTATION" in first.stdout
    assert " RUN THE PROGRAM" in first.stdout


@pytest.mark.parametrize("name", ["1", "2", "3", "4", "5", "6", "7", "8", "9", "10", "11", "12"])
def test_figures_are_drawn_as_text(name: str) -> None:
    done = CliRunner().invoke(cli, ["figure", name, "--width", "70"])
    assert done.exit_code == 0
    assert done.stdout.startswith(f"Figure {name}. ")
    assert max(map(len, done.stdout.splitlines())) <= 92


def test_a_figure_that_is_not_in_the_article_is_refused(tmp_path: Path) -> None:
    done = CliRunner().invoke(cli, ["figure", "13"])
    assert (done.exit_code, done.stderr.count("\n")) == (2, 1)
    done = CliRunner().invoke(cli, ["figure", "8", "-o", str(tmp_path / "8.gif")])
    assert (done.exit_code, done.stderr.count("\n")) == (2, 1)


def test_figure_10_shows_the_article_s_21_steps_against_3() -> None:
    text = CliRunner().invoke(cli, ["figure", "10"]).stdout
    assert "base, 21 steps" in text
    assert "shoulder, 3 steps" in text


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["run"], "Missing argument 'PROGRAMS...'"),
        (["run", "a.bas", "--seconds", "soon"], "--seconds"),
        (["terminal", "--speed", "3"], "--speed 3"),
        (["--frobnicate"], "--frobnicate"),
        (["convert", "only-one.bas"], "TARGET"),
    ],
)
def test_bad_usage_is_told_in_one_line(
    arguments: list[str],
    words: str,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setattr("sys.argv", ["trs80arm", *arguments])
    with pytest.raises(SystemExit) as ended:
        main()
    said = capsys.readouterr().err
    assert ended.value.code == 2
    assert said.startswith("trs80arm: ")
    assert words in said
    assert said.count("\n") == 1
