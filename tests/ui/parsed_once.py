"""Style sheets of a Textual program that are parsed once for all the programs that tests start.

Every test starts the program anew, with the same three dozen sheets. What comes of parsing one is
looked at and never changed, so programs may share it as the widgets of one program do.
"""

from __future__ import annotations

from typing import Any

from textual.css.model import RuleSet
from textual.css.stylesheet import Stylesheet

_parse = Stylesheet._parse_rules
_parsed: dict[tuple[Any, ...], list[RuleSet]] = {}


def parse_once(sheet: Stylesheet, css: str, *args: Any, **kwargs: Any) -> list[RuleSet]:
    """The rules of a sheet, in the place of `Stylesheet._parse_rules`."""
    known = (css, args, *kwargs.items(), *sheet._variables.items())
    if known not in _parsed:
        _parsed[known] = _parse(sheet, css, *args, **kwargs)
    return _parsed[known]
