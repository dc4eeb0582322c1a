"""Comparing what the machine did with what the ROM did."""

from __future__ import annotations

from dataclasses import dataclass

from tests.conformance.case import Case
from tests.conformance.player import Played


@dataclass(frozen=True)
class Difference:
    """One thing that is not as the ROM had it."""

    what: str
    expected: object
    found: object

    def __str__(self) -> str:
        return f"{self.what}\n    ROM:  {self.expected!r}\n    here: {self.found!r}"


def compare(case: Case, played: Played) -> list[Difference]:
    """What differs; the times of the segments are not looked at."""
    expected = case.expected
    pairs: list[tuple[str, object, object]] = [
        ("transcript", expected["transcript"], played.transcript),
        ("end", expected["end"], played.end),
        ("wide", bool(expected.get("wide", False)), played.wide),
    ]
    if expected.get("screen_valid"):
        pairs.append(("screen", expected["screen"], played.screen))
        pairs.append(("cursor", expected["cursor"], played.cursor))
    if "printer" in expected:
        pairs.append(("printer", expected["printer"], played.printer))
    if "dump" in expected:
        dumped = expected["dump"]
        wanted = dumped if isinstance(dumped, dict) else dict(dumped)
        pairs.append(
            (
                "dump",
                {name: bytes.fromhex(data).hex() for name, data in wanted.items()},
                played.dump,
            )
        )
    return [Difference(what, rom, here) for what, rom, here in pairs if rom != here]
