"""Findings as lines that editors read, as JSON, and as SARIF 2.1.0 that code hosts read."""

from __future__ import annotations

import json
import os
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Final
from urllib.parse import quote

from trs80arm import __version__
from trs80arm.check.findings import Finding, Level, Rule
from trs80arm.shown import shown

SARIF_SCHEMA: Final = "https://json.schemastore.org/sarif-2.1.0.json"
_ROOT: Final = "%SRCROOT%"
"""What relative files are relative to, as code hosts call it: the checkout's folder."""


@dataclass
class Report:
    """What one call of the command has found.

    Attributes:
        files: that were read.
        findings: in them.
        unusable: of each file that was not, why; one line that begins with its name.
    """

    files: list[Path] = field(default_factory=list)
    findings: list[Finding] = field(default_factory=list)
    unusable: list[str] = field(default_factory=list)


def as_text(report: Report) -> str:
    """`file:line: error: text [rule]`, a line for each; nothing where there are none."""
    return "".join(
        shown(f"{each.file}:{each.place}: {each.level.value}: {each.text} [{each.rule.label}]")
        + "\n"
        for each in report.findings
    )


def as_json(report: Report) -> str:
    """One object: the files read, the findings, and how many of each level."""
    found = report.findings
    told = {
        "files": [str(file) for file in report.files],
        "unusable": report.unusable,
        "findings": [
            {
                "file": str(each.file),
                "line": each.place,
                "column": each.column,
                "number": each.number,
                "rule": each.rule.label,
                "level": each.level.value,
                "text": each.text,
            }
            for each in found
        ],
        **{f"{level.value}s": sum(each.level is level for each in found) for level in Level},
    }
    return json.dumps(told, indent=1) + "\n"


def as_sarif(report: Report) -> str:
    """A SARIF log of one run."""
    rules = list(Rule)
    log = {
        "$schema": SARIF_SCHEMA,
        "version": "2.1.0",
        "runs": [
            {
                "tool": {
                    "driver": {
                        "name": "trs80arm",
                        "version": __version__,
                        "rules": [_rule(rule) for rule in rules],
                    }
                },
                "invocations": [
                    {
                        "executionSuccessful": not report.unusable,
                        "toolExecutionNotifications": [
                            {"level": "error", "message": {"text": told}}
                            for told in report.unusable
                        ],
                    }
                ],
                "columnKind": "unicodeCodePoints",
                "results": [_result(each, rules.index(each.rule)) for each in report.findings],
            }
        ],
    }
    return json.dumps(log, indent=1) + "\n"


def _rule(rule: Rule) -> dict[str, Any]:
    return {
        "id": rule.label,
        "name": rule.label.replace("-", " ").title().replace(" ", ""),
        "shortDescription": {"text": rule.sentence},
        "fullDescription": {"text": f"{rule.sentence} {rule.remedy}"},
        "help": {"text": rule.remedy},
        "defaultConfiguration": {"level": rule.level.value},
    }


def _result(finding: Finding, rule: int) -> dict[str, Any]:
    region = {"startLine": finding.place}
    if finding.column is not None:
        region["startColumn"] = finding.column
    return {
        "ruleId": finding.rule.label,
        "ruleIndex": rule,
        "level": finding.level.value,
        "message": {"text": shown(finding.text)},
        "locations": [
            {
                "physicalLocation": {
                    "artifactLocation": _location(finding.file),
                    "region": region,
                }
            }
        ],
    }


def _location(file: Path) -> dict[str, str]:
    """A relative file stays relative, to the folder that the check was started in.

    So does one below that folder that was given with its whole path.
    """
    if file.is_absolute():
        try:
            file = file.relative_to(Path.cwd())
        except (ValueError, OSError):
            return {"uri": file.as_uri()}
    return {"uri": quote(os.fsencode(file.as_posix())), "uriBaseId": _ROOT}


FORMS: Final[dict[str, Callable[[Report], str]]] = {
    "text": as_text,
    "json": as_json,
    "sarif": as_sarif,
}
"""The forms by their names."""
