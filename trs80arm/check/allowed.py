"""Remarks that allow what a rule would tell: `REM CHECK: ALLOW NEVER-SET`."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Final

from trs80arm.basic import tokens
from trs80arm.check.findings import RULES, Rule
from trs80arm.check.statements import Statement

_ALLOW: Final = re.compile(rb"\s*CHECK\s*:\s*ALLOW\b(.*)", re.IGNORECASE | re.DOTALL)
_NAME: Final = re.compile(r"[^\s,]+")


@dataclass
class Allowed:
    """What the remarks of a program allow.

    Attributes:
        everywhere: by remarks that have a line to themselves.
        in_line: by line number, by remarks behind other statements.
        unknown: names that are no rules, each with the remark that they stand in.
    """

    everywhere: set[Rule] = field(default_factory=set)
    in_line: dict[int, set[Rule]] = field(default_factory=dict)
    unknown: list[tuple[Statement, str]] = field(default_factory=list)

    @classmethod
    def by(cls, program: Iterable[Statement]) -> Allowed:
        """What the remarks in a program allow."""
        allowed = cls()
        for statement in program:
            if statement.word != tokens.REM or statement.arm:
                continue
            apostrophe = bytes((tokens.APOSTROPHE,))
            found = _ALLOW.match(statement.text.removeprefix(apostrophe))
            if found is None:
                continue
            rules = allowed.everywhere
            if statement.position > 1:
                rules = allowed.in_line.setdefault(statement.line, set())
            for name in _NAME.findall(found[1].decode("latin-1")):
                rule = RULES.get(name.lower())
                if rule is None:
                    allowed.unknown.append((statement, name))
                else:
                    rules.add(rule)
        return allowed

    def has(self, rule: Rule, line: int | None) -> bool:
        """Whether a rule is allowed to be broken in a line."""
        return rule in self.everywhere or rule in self.in_line.get(-1 if line is None else line, ())
