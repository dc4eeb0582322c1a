"""How the machine's times compare with the ROM's, segment by segment."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from statistics import median

LONG = 200_000
"""T-states from which on a segment's own ratio counts."""
LOWEST, HIGHEST = 0.85, 1.15
_WORST = 40


@dataclass(frozen=True)
class Segment:
    """One segment's times in T-states."""

    case: str
    group: str
    entry: str
    rom: int
    here: int

    @property
    def ratio(self) -> float:
        """1 where the machine takes exactly as long as the ROM."""
        return self.here / self.rom

    @property
    def is_close(self) -> bool:
        """Whether the ratio is where a long segment's should be."""
        return LOWEST <= self.ratio <= HIGHEST


def report(segments: Sequence[Segment]) -> Iterator[str]:
    """The lines of the report."""
    if not segments:
        yield "no segments"
        return
    long = [segment for segment in segments if segment.rom > LONG]
    for group in sorted({segment.group for segment in segments}):
        of_group = [segment for segment in segments if segment.group == group]
        yield f"{group} {_line(of_group)}"
    yield "worst of the long ones:"
    for segment in sorted(long, key=lambda one: abs(one.ratio - 1), reverse=True)[:_WORST]:
        if not segment.is_close:
            yield (
                f"  {segment.ratio:.3f} {segment.case} {segment.entry!r} "
                f"ROM {segment.rom} here {segment.here}"
            )
    yield f"all {_line(segments)}"


def _line(segments: Sequence[Segment]) -> str:
    long = [segment for segment in segments if segment.rom > LONG]
    close = sum(segment.is_close for segment in long)
    share = f"{close}/{len(long)} = {close / len(long):.3f}" if long else "none"
    return (
        f"median ratio {median(segment.ratio for segment in segments):.4f} of {len(segments)}, "
        f"within {LOWEST}..{HIGHEST} of those over {LONG}: {share}"
    )
