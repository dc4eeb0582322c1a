"""`trs80arm check`: several programs, one after the other."""

from __future__ import annotations

import sys
from collections.abc import Collection, Iterator, Sequence
from pathlib import Path
from typing import Final

from trs80arm.arm.model import ArmModel
from trs80arm.check.findings import Finding, Level, Rule
from trs80arm.check.forms import FORMS, Report
from trs80arm.check.program import check_bytes, check_program
from trs80arm.files import LARGEST, FileFormatError
from trs80arm.paths import is_folder
from trs80arm.reasons import one_line

FOUND: Final = 1
UNUSABLE: Final = 2
STANDARD_INPUT: Final = Path("-")
_SHOWN_INPUT: Final = Path("stdin")
_SUFFIXES: Final = frozenset((".bas", ".cas"))


def run_check(
    programs: Sequence[Path],
    form: str = "text",
    *,
    strict: bool = False,
    ignored: Collection[Rule] = (),
    armbasic: bool = True,
    arm: ArmModel | None = None,
) -> int:
    """Read programs and print what is wrong in them.

    Args:
        programs: their files; `-` is standard input, and of a folder every `.bas` and `.cas` in it
            and in the folders in it is read, hidden ones left out.
        form: `text`, `json` or `sarif`.
        strict: whether warnings count as errors do. Notes never do.
        ignored: rules whose findings are left out.
        armbasic: whether ARMBASIC is loaded.
        arm: the make of arm; None for that of a program's bench, or the MiniMover 5.

    Returns:
        The exit code: 0 no errors, 1 errors found, 2 a file that is no program, told in one line on
        standard error; the others are read all the same.
    """
    report = Report()
    for program in programs:
        try:
            for file in _files(program):
                _read(file, report, armbasic, arm)
        except (FileFormatError, OSError) as error:
            _unusable(error, report)
    report.findings[:] = [each for each in report.findings if each.rule not in ignored]
    sys.stdout.write(FORMS[form](report))
    sys.stdout.flush()
    if report.unusable:
        return UNUSABLE
    counted = (Level.ERROR, Level.WARNING) if strict else (Level.ERROR,)
    return FOUND if any(each.level in counted for each in report.findings) else 0


def _files(program: Path) -> Iterator[Path]:
    """The files that are meant.

    Raises:
        FileFormatError: a folder has no programs in it.
        OSError: a folder cannot be read.
    """
    if not is_folder(program):
        yield program
        return
    found = sorted(
        path
        for path in program.rglob("*")
        if path.suffix.lower() in _SUFFIXES
        and not any(part.startswith(".") for part in path.relative_to(program).parts)
        and not is_folder(path)
    )
    if not found:
        raise FileFormatError(f"{program}: a folder without programs (.bas, .cas)")
    yield from found


def _read(file: Path, report: Report, armbasic: bool, arm: ArmModel | None) -> None:
    """Take down what is wrong in one file."""
    try:
        if file == STANDARD_INPUT:
            file = _SHOWN_INPUT
            report.findings += _of_input(armbasic, arm)
        else:
            report.findings += check_program(file, armbasic=armbasic, arm=arm)
        report.files.append(file)
    except (FileFormatError, OSError) as error:
        _unusable(error, report)


def _of_input(armbasic: bool, arm: ArmModel | None) -> list[Finding]:
    data = sys.stdin.buffer.read(LARGEST + 1)
    try:
        if len(data) > LARGEST:
            raise FileFormatError("too large for a program")
        return check_bytes(_SHOWN_INPUT, data, armbasic=armbasic, arm=arm)
    except FileFormatError as error:
        raise FileFormatError(f"{_SHOWN_INPUT}: {error}") from None


def _unusable(error: FileFormatError | OSError, report: Report) -> None:
    if isinstance(error, OSError) and error.filename is None:
        raise error
    told = one_line(error)
    report.unusable.append(told)
    print(f"trs80arm: {told}", file=sys.stderr)
