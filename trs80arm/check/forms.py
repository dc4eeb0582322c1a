"""Findings as lines that editors read, as JSON, and as SARIF 2.1.0 that code hosts read."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any
from urllib.parse import quote

from trs80arm import __version__
from trs80arm.check.findings import Finding, Level, Rule
from trs80arm.shown import shown

SARIF_SCHEMA = "https://json.schemastore.org/sarif-2.1.0.json"


def as_text(_files: Sequence[Path], findings: Iterable[Finding]) -> str:
    """`file:line: error: text`, a line for each; nothing where there are none."""
    return "".join(
        shown(f"{each.file}:{each.place}: {each.level.value}: {each.text}") + "\n"
        for each in findings
    )


def as_json(files: Sequence[Path], findings: Iterable[Finding]) -> str:
    """One object: the files read, the findings, and how many of each level."""
    found = list(findings)
    told = {
        "files": [str(file) for file in files],
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
        "errors": sum(each.level is Level.ERROR for each in found),
        "warnings": sum(each.level is Level.WARNING for each in found),
    }
    return json.dumps(told, indent=1) + "\n"


def as_sarif(_files: Sequence[Path], findings: Iterable[Finding]) -> str:
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
                        "rules": [
                            {"id": rule.label, "shortDescription": {"text": rule.sentence}}
                            for rule in rules
                        ],
                    }
                },
                "columnKind": "unicodeCodePoints",
                "results": [_result(each, rules.index(each.rule)) for each in findings],
            }
        ],
    }
    return json.dumps(log, indent=1) + "\n"


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
                    "artifactLocation": {"uri": _uri(finding.file)},
                    "region": region,
                }
            }
        ],
    }


def _uri(file: Path) -> str:
    """A relative file stays relative, to the folder that the check was started in."""
    return file.as_uri() if file.is_absolute() else quote(os.fsencode(file.as_posix()))


FORMS = {"text": as_text, "json": as_json, "sarif": as_sarif}
"""The forms by their names."""
