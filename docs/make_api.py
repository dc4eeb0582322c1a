"""Writes the reference in docs/api.md, from the docstrings of what the page documents.

    python docs/make_api.py

What stands above the mark in the page is written by hand; below it every line comes from here.
"""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from trs80arm.arm.events import ArmEvent
from trs80arm.arm.fixtures import Part
from trs80arm.arm.goals import Mark, Score
from trs80arm.arm.state import ArmState
from trs80arm.operator import Operator, parse_holds
from trs80arm.rig import Pose, Rig, RigSettings
from trs80arm.testing.assertions import (
    assert_at,
    assert_no_slip,
    assert_part_at,
    assert_registers,
)
from trs80arm.testing.program_rig import ProgramRig
from trs80arm.trace import PoseTrace, Trace
from trs80arm.works.named_variables import NamedVariables

PAGE = Path(__file__).parent / "api.md"
MARK = "<!-- from here on written by docs/make_api.py -->\n"
DOCUMENTED = (
    Rig,
    RigSettings,
    NamedVariables,
    Trace,
    PoseTrace,
    Operator,
    parse_holds,
    Part,
    ArmEvent,
    ArmState,
    Pose,
    Score,
    Mark,
    ProgramRig,
    assert_at,
    assert_part_at,
    assert_no_slip,
    assert_registers,
)
_SECTION = re.compile(r"(Args|Returns|Raises|Attributes):")
_ENTRY = re.compile(r"(\*?[\w, ]+): (.*)")
_CALLED = {"__getitem__": "[name]", "__setitem__": "[name] = value"}


def reference() -> str:
    """The whole reference as Markdown."""
    return "\n".join(line for thing in DOCUMENTED for line in _about(thing)).strip() + "\n"


def page() -> str:
    """The page as it is to be: what was written by hand, and the reference below it."""
    by_hand, mark, _ = PAGE.read_text(encoding="utf-8").partition(MARK)
    if not mark:
        raise SystemExit(f"{PAGE}: has no line {MARK.strip()}")
    return f"{by_hand}{MARK}\n{reference()}"


def _about(thing: Any) -> Iterator[str]:
    yield f"## {thing.__name__}"
    yield ""
    if inspect.isfunction(thing):
        yield f"`{thing.__module__}`: `{thing.__name__}{_signature(thing)}`"
        yield from _prose(thing)
        return
    yield f"`from {thing.__module__} import {thing.__name__}`"
    yield from _prose(thing)
    for name, member in vars(thing).items():
        if (name.startswith("_") and name not in _CALLED) or not _is_code(member):
            continue
        if name in _CALLED:
            yield f"### `{thing.__name__}{_CALLED[name]}`"
        elif isinstance(member, property):
            yield f"### `{thing.__name__}.{name}`"
        else:
            function = getattr(member, "__func__", member)
            yield f"### `{thing.__name__}.{name}{_signature(function)}`"
        yield from _prose(member)


def _is_code(member: Any) -> bool:
    return isinstance(member, property | classmethod) or inspect.isfunction(member)


def _signature(function: Any) -> str:
    """Names and defaults; types are told in words."""
    told = []
    for parameter in inspect.signature(function).parameters.values():
        if parameter.name != "self":
            default = parameter.default
            bare = default is inspect.Parameter.empty
            told.append(parameter.name if bare else f"{parameter.name}={default!r}")
    return f"({', '.join(told)})"


def _prose(thing: Any) -> Iterator[str]:
    """A docstring as Markdown: its sections as lists."""
    yield ""
    in_section = False
    for line in (inspect.getdoc(thing) or "").splitlines():
        section = _SECTION.fullmatch(line)
        if section:
            in_section = True
            yield f"*{section[1]}*"
            yield ""
        elif in_section and line.startswith("    "):
            entry = _ENTRY.fullmatch(line[4:])
            if entry and not line.startswith("     "):
                yield f"- `{entry[1]}`: {entry[2]}"
            else:
                yield f"  {line.strip()}" if line.startswith("     ") else line.strip()
        else:
            yield line
    yield ""


if __name__ == "__main__":
    PAGE.write_text(page(), encoding="utf-8")
