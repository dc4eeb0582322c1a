"""Makes the film that the README opens with: docs/film.svg, Table 4 at work.

    python docs/make_film.py

The machine's clock is in the camera's hands, so the film is the same every time.
"""

from __future__ import annotations

import os
import tempfile
from pathlib import Path

from make_screenshots import PROGRAMS, in_any_terminal

from trs80arm.options import ArmStyle, TerminalOptions
from trs80arm.ui.filming import Shooting, make_film

HERE = Path(__file__).parent


def main() -> None:
    """Make it."""
    in_any_terminal()
    with tempfile.TemporaryDirectory() as folder:
        os.environ["TRS80ARM_STATE"] = folder
        shooting = Shooting(100, 30, fps=6, speed=4, seconds=34, sets=("6:1.0 0",))
        make_film(
            TerminalOptions(program=PROGRAMS / "table4.bas", arm=ArmStyle.SEXTANT),
            shooting,
            HERE / "film.svg",
        )
    print(HERE / "film.svg")


if __name__ == "__main__":
    main()
