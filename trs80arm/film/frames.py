"""A film: what a terminal showed, picture by picture, in colours."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import TypeAlias


@dataclass(frozen=True, slots=True)
class Look:
    """How a run of characters looks.

    Attributes:
        ink: its colour, `#rrggbb`.
        ground: the colour behind it.
        bold: whether it is.
    """

    ink: str
    ground: str
    bold: bool = False


Run: TypeAlias = tuple[str, Look]
Line: TypeAlias = tuple[Run, ...]


@dataclass(frozen=True, slots=True)
class Frame:
    """A picture.

    Attributes:
        time: seconds into the film from which on it is shown.
        lines: of the terminal, from the top.
    """

    time: float
    lines: tuple[Line, ...]


@dataclass
class Film:
    """A film.

    Attributes:
        width, height: of the terminal, cells.
        title: of the film.
        frames: its pictures, no two in a row alike.
        seconds: how long it is.
    """

    width: int
    height: int
    title: str
    frames: list[Frame] = field(default_factory=list)
    seconds: float = 0.0

    def add(self, time: float, lines: tuple[Line, ...]) -> None:
        """Show these lines from a time on."""
        self.seconds = time
        if not self.frames or self.frames[-1].lines != lines:
            self.frames.append(Frame(time, lines))

    def spells(self) -> Iterator[tuple[float, float, Frame]]:
        """Each picture with when it is shown: from and to, seconds."""
        ends = [frame.time for frame in self.frames[1:]] + [self.seconds]
        for frame, end in zip(self.frames, ends, strict=True):
            yield frame.time, end, frame
