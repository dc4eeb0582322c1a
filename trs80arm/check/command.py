"""`trs80arm check`: several programs, one after the other."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path

from trs80arm.check.findings import Finding, Level
from trs80arm.check.forms import FORMS
from trs80arm.check.program import check_program
from trs80arm.files import FileFormatError
from trs80arm.reasons import one_line

FOUND = 1
UNUSABLE = 2


def run_check(
    programs: Sequence[Path], form: str = "text", *, strict: bool = False, armbasic: bool = True
) -> int:
    """Read programs and print what is wrong in them.

    Args:
        programs: their files.
        form: `text`, `json` or `sarif`.
        strict: whether warnings count as errors do.
        armbasic: whether ARMBASIC is loaded.

    Returns:
        The exit code: 0 no errors, 1 errors found, 2 a file that is no program, told in one line on
        standard error; the others are read all the same.
    """
    findings: list[Finding] = []
    read: list[Path] = []
    code = 0
    for program in programs:
        try:
            findings += check_program(program, armbasic=armbasic)
            read.append(program)
        except (FileFormatError, OSError) as error:
            if isinstance(error, OSError) and error.filename is None:
                raise
            print(f"trs80arm: {one_line(error)}", file=sys.stderr)
            code = UNUSABLE
    sys.stdout.write(FORMS[form](read, findings))
    sys.stdout.flush()
    if code:
        return code
    wrong = any(strict or each.level is Level.ERROR for each in findings)
    return FOUND if wrong else 0
