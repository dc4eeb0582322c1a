"""Makes the page of the article's figures: each drawn by the program, with its words below it.

    python docs/make_figures.py [NAME ...]

Writes docs/figures.md and docs/figures/*.svg, or of the pictures only those named.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path

from trs80arm.article import NAMES, draw

PAGE = Path(__file__).parent / "figures.md"
FOLDER = Path(__file__).parent / "figures"

HEAD = """# The article's figures

The figures of John W. Hill's *Introducing Mini Mover 5* (Robotics Age, 1980), drawn from the model
that runs: lengths, ranges, ratios, signs, addresses and keys are those of arm, card and keyboard,
so another setting is another figure. `trs80arm figure 3` prints one as text, `-o FILE.svg` draws it
(`.png` and `.pdf`, and the charts, need the extra `plot`); `--arm teachmover` is of the later arm,
but for Figure 12 and Table 1, which are the article's arm's own.
The printed ones are lost; what they showed is known from their captions and from the text.
"""

SAID = {
    "1": "To scale. The pose is any; the motors stand behind the body, three on either side.",
    "2": "Found by taking the arm by hand to every combination of angles that its stops allow.",
    "3": "Cables side by side, each from its drum over idlers to what it turns.",
    "4": "Pitch from the horizontal, roll about the pointing vector; the wrist's two gears.",
    "5": "From the motor to the grips, and from the tension switch back to the computer.",
    "6": "A hand that closes half-step by half-step, empty and on a part.",
    "7": "One motor of six. Coils of one path oppose each other.",
    "8": "Found by trying all sixteen patterns on a motor.",
    "9": "Addresses as they are set; here the default ones.",
    "10": "`@STEP 50,21,3`, as the driver writes it to the card.",
    "11": "The keys of `@SET`. The figure is lost: see [armbasic.md](armbasic.md).",
    "12": "The fingertip through one cycle of the article's Table 4.",
    "table1": "Each row measured on the arm; [arm.md](arm.md) says what cannot be had at once.",
}


def main(names: Sequence[str]) -> None:
    """Draw the figures, or those named, and write the page."""
    FOLDER.mkdir(exist_ok=True)
    pieces = [HEAD]
    for name in NAMES:
        figure = draw(name)
        if not names or name in names:
            figure.save(FOLDER / f"{name}.svg")
        pieces.append(
            f"## {figure.title}\n\n{SAID[name]}\n\n![{figure.title}](figures/{name}.svg)\n"
        )
    PAGE.write_text("\n".join(pieces), encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])
