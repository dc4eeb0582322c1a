"""The rasteriser: from solids seen by a camera to samples finer than a cell, nearest in front.

A `Raster` has so many samples a cell as the style of drawing asks for. Each solid is one operation
on arrays over the box that it covers: a sample is inside it if the nearest face turned away from
the eye is behind the farthest one turned towards it.
"""

from __future__ import annotations

import copy
from collections.abc import Iterator
from math import inf
from typing import TypeAlias, TypeVar

import numpy as np
import numpy.typing as npt

from trs80arm.drawing.camera import Projected
from trs80arm.drawing.solids import Floats, Ints, Solids
from trs80arm.drawing.viewport import ASPECT, Window

_Number = TypeVar("_Number", bound=np.generic)
Nearness: TypeAlias = npt.NDArray[np.float32]
Faces: TypeAlias = npt.NDArray[np.int32]
Bits: TypeAlias = npt.NDArray[np.bool_]

SMALL = 400
"""Up to so many samples, the nearest face is quickest found for all of them at once."""
FEW = 6
"""Up to so many faces turned to the eye, it is quicker face by face than for the samples hit."""
NOWHERE = -1
"""The face of a sample that shows nothing."""


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
        nearness: of what each sample shows, in the camera's measure.
        face: which face it is, counted over all solids drawn, or `NOWHERE`.
    """

    def __init__(self, width: int, height: int, samples: tuple[int, int], window: Window) -> None:
        self.width, self.height = width, height
        self.across, self.down = samples
        columns, rows = width * self.across, height * self.down
        step = 1 / (window.scale * ASPECT * self.across)
        self.x = (window.left + (np.arange(columns) + 0.5) * step).astype(np.float32)
        drop = 1 / (window.scale * self.down)
        self.y = (window.top - (np.arange(rows) + 0.5) * drop).astype(np.float32)
        self.nearness: Nearness = np.full((rows, columns), -inf, dtype=np.float32)
        self.face = np.full((rows, columns), NOWHERE, dtype=np.int32)
        self._step, self._drop = step, drop
        self._faces = 0

    def draw(self, solids: Solids, seen: Projected, chosen: Bits | None = None) -> None:
        """Draw solids, each where nothing nearer is.

        Args:
            solids: what is drawn; its faces are counted on from those drawn before.
            seen: them, as the camera has them.
            chosen: which of them, None for all.
        """
        order, parts = _sorted(solids, seen)
        across, down = self._lines(seen.nearness[order])
        numbers = (order + self._faces).astype(np.int32)
        for solid, rows, columns in self._spans(seen.boxes):
            first, middle, last = parts[solid]
            if not first < middle < last or (chosen is not None and not chosen[solid]):
                continue
            planes = down[first:last, rows] + across[first:last, :, columns]
            fronts, turned = planes[: middle - first], numbers[first:middle]
            held, face = self.nearness[rows, columns], self.face[rows, columns]
            near = fronts.min(0)
            hit = near > held
            hit &= near >= planes[middle - first :].max(0)
            np.copyto(held, near, where=hit)
            if held.size <= SMALL:
                np.copyto(face, turned.take(fronts.argmin(0)), where=hit)
            elif len(fronts) <= FEW:
                np.copyto(face, _nearest(fronts, near, turned), where=hit)
            else:
                places = hit.nonzero()
                face[places] = turned.take(fronts[:, places[0], places[1]].argmin(0))
        self._faces += len(order)

    def copy(self) -> Raster:
        """One like it, to be drawn on."""
        twin = copy.copy(self)
        twin.nearness, twin.face = self.nearness.copy(), self.face.copy()
        return twin

    def covered(self, solids: Solids, seen: Projected, chosen: Bits) -> Bits:
        """Which samples those of the solids that are chosen cover, whatever is drawn."""
        covered = np.zeros(self.face.shape, dtype=np.bool_)
        order, parts = _sorted(solids, seen)
        across, down = self._lines(seen.nearness[order])
        for solid, rows, columns in self._spans(seen.boxes):
            first, middle, last = parts[solid]
            if not first < middle < last or not chosen[solid]:
                continue
            planes = down[first:last, rows] + across[first:last, :, columns]
            covered[rows, columns] |= planes[: middle - first].min(0) >= planes[
                middle - first :
            ].max(0)
        return covered

    def gathered(self, values: npt.NDArray[_Number]) -> npt.NDArray[_Number]:
        """Values of the samples gathered by cells: samples a cell x height x width."""
        cells = values.reshape(self.height, self.down, self.width, self.across)
        return cells.transpose(1, 3, 0, 2).reshape(-1, self.height, self.width)

    def _spans(self, boxes: Floats) -> Iterator[tuple[int, slice, slice]]:
        """The solids that are in the picture, each with the rows and columns that it may cover."""
        columns, rows = len(self.x), len(self.y)
        left = np.clip(np.floor((boxes[:, 0] - self.x[0]) / self._step), 0, columns)
        right = np.clip(np.ceil((boxes[:, 2] - self.x[0]) / self._step) + 1, 0, columns)
        top = np.clip(np.floor((self.y[0] - boxes[:, 3]) / self._drop), 0, rows)
        bottom = np.clip(np.ceil((self.y[0] - boxes[:, 1]) / self._drop) + 1, 0, rows)
        spans = np.stack((top, bottom, left, right), axis=1).astype(np.int64).tolist()
        for solid, (y0, y1, x0, x1) in enumerate(spans):
            if y1 > y0 and x1 > x0:
                yield solid, slice(y0, y1), slice(x0, x1)

    def _lines(self, nearness: Floats) -> tuple[Nearness, Nearness]:
        """How near faces are at each column and at each row; the sum is how near at a sample."""
        planes = nearness.astype(np.float32)
        across = planes[:, 0, None] * self.x
        down = planes[:, 1, None] * self.y + planes[:, 2, None]
        return across[:, None, :], down[:, :, None]


def _nearest(fronts: Nearness, near: Nearness, numbers: Faces) -> Faces:
    """By which of its few faces a solid is so near, the first of those that are."""
    which = np.full(near.shape, numbers[0], dtype=np.int32)
    for face, number in zip(fronts[:0:-1], numbers[:0:-1].tolist(), strict=True):
        np.copyto(which, number, where=face == near)
    np.copyto(which, numbers[0], where=fronts[0] == near)
    return which


def _sorted(solids: Solids, seen: Projected) -> tuple[Ints, list[tuple[int, int, int]]]:
    """The faces of all solids, those turned to the eye first in each; and where the two kinds are.

    The three numbers of a solid are where its faces begin, where those turned away begin, and
    where they end. Every closed solid has faces of both kinds.
    """
    counts = solids.face_counts
    last = solids.first_face + counts
    solid = np.repeat(np.arange(len(counts)), counts)
    order = np.lexsort((~seen.facing, solid))
    turned = solids.first_face + np.add.reduceat(seen.facing.astype(np.int64), solids.first_face)
    parts = zip(solids.first_face.tolist(), turned.tolist(), last.tolist(), strict=True)
    return order, list(parts)
