"""Snapshots of a rig as files of their own, by syrupy: text, SVG, and traces as CSV."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import dropwhile
from typing import Any

from syrupy.extensions.single_file import SingleFileSnapshotExtension, WriteMode
from syrupy.terminal import received_style, reset, snapshot_style

from trs80arm.drawing.readings import Readings
from trs80arm.drawing.vectors import svg
from trs80arm.rig import Rig
from trs80arm.testing.portraits import SIDE_VIEW, portrait
from trs80arm.testing.program_rig import CsvTrace


class ArmText(SingleFileSnapshotExtension):
    """A rig as one readable text file; what is text already stays as it is."""

    _write_mode = WriteMode.TEXT
    file_extension = "arm.txt"

    def serialize(self, data: Any, **_: Any) -> str:
        """The portrait of a rig."""
        return portrait(data) if isinstance(data, Rig) else str(data)

    def diff_lines(self, serialized_data: Any, snapshot_data: Any) -> Iterator[str]:
        """What differs, line by line; of the side view both pictures, each in one piece.

        Args:
            serialized_data: what is now.
            snapshot_data: what is stored.
        """
        title = f"\n{SIDE_VIEW}\n"
        stored, _, was = str(snapshot_data).partition(title)
        now, _, is_ = str(serialized_data).partition(title)
        yield from super().diff_lines(now, stored)
        if was != is_:
            yield f"  {title.strip()}"
            for sign, style, picture in (("-", snapshot_style, was), ("+", received_style, is_)):
                rows = dropwhile(lambda row: not row, picture.splitlines())
                yield from (reset(style(f"{sign} {row}".rstrip())) for row in rows)


class ArmSvg(SingleFileSnapshotExtension):
    """A rig as a drawing from the side and from above."""

    _write_mode = WriteMode.TEXT
    file_extension = "svg"

    def serialize(self, data: Any, **_: Any) -> str:
        """The drawing of a rig."""
        return svg(Readings.of(data)) if isinstance(data, Rig) else str(data)


class ArmCsv(SingleFileSnapshotExtension):
    """A trace as CSV."""

    _write_mode = WriteMode.TEXT
    file_extension = "csv"

    def serialize(self, data: Any, **_: Any) -> str:
        """The lines of a trace."""
        return data.text if isinstance(data, CsvTrace) else str(data)
