"""How long a frame of each view takes in each style, at 100 x 50 cells.

Time of the processor, the best and the median of many frames, so that what else the computer does
counts little; the arm moves from one frame to the next. From the readings to the rows of text,
without putting them on the screen; in pixels as far as the samples.
"""

from __future__ import annotations

import time
from collections.abc import Iterator
from statistics import median

from benchmarks.rows import Row
from trs80arm.arm.model import Pose
from trs80arm.drawing.picture import FROM_ABOVE, FROM_THE_SIDE, IN_SPACE, Picture
from trs80arm.drawing.readings import Readings
from trs80arm.options import ArmStyle
from trs80arm.rig import Rig

WIDTH, HEIGHT = 100, 50
GRAIN = (10, 20)
"""Samples a cell of a picture in pixels."""
FRAMES = 120
"""Of each view and style, a second asked for."""
VIEWS = {"side": FROM_THE_SIDE, "top": FROM_ABOVE, "space": IN_SPACE}


def frames(count: int) -> list[Readings]:
    """The arm at so many places above its bench."""
    rig = Rig()
    looks = []
    for number in range(count):
        rig.move_to(Pose(6.0 + 4 * number / count, 0.0, 2.0, -90.0, 0.0, 1.0))
        looks.append(Readings.of(rig))
    return looks


def rows(seconds: float) -> Iterator[Row]:
    """Each view in each style."""
    looks = frames(max(3, int(FRAMES * seconds)))
    # A program that has run for a while keeps the memory that a picture needs (mallopt(3)).
    Picture(FROM_ABOVE).draw(looks[0], 4 * WIDTH, 4 * HEIGHT)
    for name, subject in VIEWS.items():
        for style in ArmStyle:
            picture = Picture(subject)
            picture.style = style
            costs = []
            for readings in looks:
                began = time.thread_time()
                if style is ArmStyle.PIXELS:
                    picture.pixels(readings, WIDTH, HEIGHT, GRAIN)
                else:
                    picture.draw(readings, WIDTH, HEIGHT)
                costs.append(1000 * (time.thread_time() - began))
            yield Row(f"{name}, {style}", {"ms, best": min(costs), "ms, median": median(costs)})
