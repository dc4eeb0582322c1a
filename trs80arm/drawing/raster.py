"""The rasteriser: from solids seen by a camera to samples finer than a cell, nearest in front.

A `Raster` has so many samples a cell as the style of drawing asks for. All faces that are turned to
the eye are drawn at once, in a few operations on arrays: their edges row by row, from these the
columns between, and of the faces that meet in a sample the nearest. What is nearest is the greatest
of numbers that have the nearness in their upper half and the face in their lower.
"""

from __future__ import annotations

import copy
from dataclasses import dataclass
from math import inf
from typing import NamedTuple, TypeAlias, TypeVar

import numpy as np
import numpy.typing as npt

from trs80arm.drawing.camera import Projected
from trs80arm.drawing.solids import Floats, Ints, Shape, Solids
from trs80arm.drawing.viewport import ASPECT, Window

_Number = TypeVar("_Number", bound=np.generic)
Nearness: TypeAlias = npt.NDArray[np.float32]
Faces: TypeAlias = npt.NDArray[np.int32]
Bits: TypeAlias = npt.NDArray[np.bool_]

NOWHERE = -1
"""The face of a sample that shows nothing."""
_HALF = 32
_LOWER = np.int64((1 << _HALF) - 1)
_FIRST = np.int64((1 << 31) - 1)
"""The lower half of the number of face 0: of faces as near as each other the first is seen."""
_SIGN = np.int32(31)
_MAGNITUDE = np.int32(0x7FFFFFFF)


class _Runs(NamedTuple):
    """Samples in a row that a face covers, many of them.

    Attributes:
        rows: of each.
        first, many: its first column, and how many.
        faces: which face it is.
    """

    rows: Ints
    first: Ints
    many: Ints
    faces: Ints


@dataclass(frozen=True, slots=True, eq=False)
class Seen:
    """What samples show.

    Attributes:
        keys: a number for each sample, the greater the nearer.
    """

    keys: npt.NDArray[np.int64]

    @property
    def nearness(self) -> Nearness:
        """Of what each sample shows, in the camera's measure."""
        bits = (self.keys >> _HALF).astype(np.int32)
        bits ^= (bits >> _SIGN) & _MAGNITUDE
        return bits.view(np.float32)

    @property
    def face(self) -> Faces:
        """Which face each sample shows, counted over all solids drawn, or `NOWHERE`."""
        return (_FIRST - (self.keys & _LOWER)).astype(np.int32)


class Raster:
    """Samples of a picture of `width` x `height` cells, nothing in them at first.

    Args:
        width: cells.
        height: cells.
        samples: how many samples a cell has across and down.
        window: which part of the picture plane the cells show.

    Attributes:
        across, down: samples a cell.
        x, y: of the middles of the columns and rows of samples, in the picture plane, inches.
    """

    def __init__(self, width: int, height: int, samples: tuple[int, int], window: Window) -> None:
        self.width, self.height = width, height
        self.across, self.down = samples
        columns, rows = width * self.across, height * self.down
        step = 1 / (window.scale * ASPECT * self.across)
        self.x = (window.left + (np.arange(columns) + 0.5) * step).astype(np.float32)
        drop = 1 / (window.scale * self.down)
        self.y = (window.top - (np.arange(rows) + 0.5) * drop).astype(np.float32)
        self._left, self._top = window.left + step / 2, window.top - drop / 2
        self._step, self._drop = step, drop
        self._keys = np.full(rows * columns, _key(-inf, NOWHERE), dtype=np.int64)
        self._faces = 0

    @property
    def seen(self) -> Seen:
        """What the samples show, rows x columns."""
        return Seen(self._keys.reshape(len(self.y), len(self.x)))

    @property
    def gathered_seen(self) -> Seen:
        """The same gathered by cells, as `gathered` has it."""
        return Seen(self.gathered(self.seen.keys))

    def draw(self, solids: Solids, seen: Projected, chosen: Bits | None = None) -> None:
        """Draw solids, each where nothing nearer is.

        Args:
            solids: what is drawn; its faces are counted on from those drawn before.
            seen: them, as the camera has them.
            chosen: which of their faces, None for all.
        """
        rows, first, count, faces = self._runs(solids.shape, seen.corners, _shown(seen, chosen))
        plane = seen.nearness.astype(np.float32)[faces]
        begin = np.cumsum(count) - count
        place = np.arange(count.sum())
        place += np.repeat(rows * len(self.x) + first - begin, count)
        near = np.repeat(plane[:, 0], count)
        near *= self.x.take(np.arange(len(place)) + np.repeat(first - begin, count))
        near += np.repeat(plane[:, 1] * self.y[rows] + plane[:, 2], count)
        bits = near.view(np.int32)
        bits ^= (bits >> _SIGN) & _MAGNITUDE
        key = bits.astype(np.int64)
        key <<= _HALF
        key |= np.repeat(_FIRST - self._faces - faces, count)
        np.maximum.at(self._keys, place, key)
        self._faces += len(seen.facing)

    def send_back(self, nearness: float) -> None:
        """Take all that is drawn to be so near, that is far behind whatever is drawn later."""
        far = _key(nearness, 0) & ~_LOWER
        shown = (self._keys & _LOWER) <= _FIRST
        np.copyto(self._keys, (self._keys & _LOWER) | far, where=shown)

    def copy(self) -> Raster:
        """One like it, to be drawn on."""
        twin = copy.copy(self)
        twin._keys = self._keys.copy()
        return twin

    def covered(self, solids: Solids, seen: Projected, chosen: Bits) -> Bits:
        """Which samples those of the faces that are chosen cover, whatever is drawn."""
        rows, first, count, _ = self._runs(solids.shape, seen.corners, _shown(seen, chosen))
        columns = len(self.x)
        # At the ends of runs one more of them covers what follows, or one less.
        ends = np.zeros(len(self.y) * (columns + 1), dtype=np.int32)
        place = rows * (columns + 1) + first
        np.add.at(ends, place, 1)
        np.subtract.at(ends, place + count, 1)
        covered: Bits = ends.reshape(-1, columns + 1).cumsum(1)[:, :columns] > 0
        return covered

    def gathered(self, values: npt.NDArray[_Number]) -> npt.NDArray[_Number]:
        """Values of the samples gathered by cells: samples a cell x height x width."""
        cells = values.reshape(self.height, self.down, self.width, self.across)
        return cells.transpose(1, 3, 0, 2).reshape(-1, self.height, self.width)

    def _runs(self, shape: Shape, corners: Floats, shown: Bits) -> _Runs:
        """The samples that faces cover.

        Args:
            shape: whose faces they are.
            corners: where their corners are in the picture, inches.
            shown: which of the faces.
        """
        across = (corners[:, 0] - self._left) / self._step
        along = (self._top - corners[:, 1]) / self._drop
        edge = shown[shape.edge_faces].nonzero()[0]
        begins, ends = shape.edges[:, edge]
        faces = shape.edge_faces[edge]
        # A convex face is bounded on one side by the edges that lead down, and on the other by
        # those that lead up; each side crosses the same rows.
        from_row, to_row = along[begins], along[ends]
        down = to_row > from_row
        high = np.clip(np.ceil(np.minimum(from_row, to_row)), 0, len(self.y)).astype(np.int64)
        low = np.clip(np.ceil(np.maximum(from_row, to_row)), 0, len(self.y)).astype(np.int64)
        order = np.argsort((faces + ~down * len(shown)) * (len(self.y) + 1) + high)
        order = order[(low > high)[order]]
        count = (low - high)[order]
        slope = (across[ends] - across[begins])[order] / (to_row - from_row)[order]
        offset = across[begins][order] - from_row[order] * slope
        rows = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count - high[order], count)
        columns = np.repeat(offset, count) + np.repeat(slope, count) * rows
        face = np.repeat(faces[order], count)
        half = len(rows) // 2
        if not np.array_equal(face[:half], face[half:]):
            # By rounding the sides of a face that is all but a line may cross unlike rows.
            way = np.where(down, 1, -1)[order] * count
            uneven = np.bincount(faces[order], way, len(shown)) != 0
            return self._runs(shape, corners, shown & ~uneven)
        one, other = columns[:half], columns[half : 2 * half]
        first = np.clip(np.ceil(np.minimum(one, other)), 0, len(self.x)).astype(np.int64)
        last = np.clip(np.floor(np.maximum(one, other)) + 1, 0, len(self.x)).astype(np.int64)
        return _Runs(rows[:half], first, np.maximum(last - first, 0), face[:half])


def _shown(seen: Projected, chosen: Bits | None) -> Bits:
    """The faces that are turned to the eye, of those chosen."""
    return seen.facing if chosen is None else seen.facing & chosen


def _key(nearness: float, face: int) -> np.int64:
    """The number of a sample that shows a face so near."""
    bits = np.float32(nearness).view(np.int32)
    bits ^= (bits >> _SIGN) & _MAGNITUDE
    return (np.int64(bits) << np.int64(_HALF)) | (_FIRST - np.int64(face))
