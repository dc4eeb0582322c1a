"""The cassette recorder and its shelf: what is in it, its counter, and what goes by."""

from __future__ import annotations

from trs80arm.drawing.rows import Ink, Row
from trs80arm.inspection import Inspection
from trs80arm.ui.panels.inspector import Asked, Inspector

_BAR = 20
"""Cells of a full bar."""


class TapesPanel(Inspector):
    """Recorder, counter, progress, and the cassettes there are."""

    NOTHING = "no cassette: CSAVE makes one, Ctrl+F puts one in"
    HELP = """
## Tapes

The cassette in the recorder, its counter in minutes and seconds of tape, what CSAVE, CLOAD, PRINT#
and INPUT# do, with how much of it is done, and the cassettes on the shelf; `>` marks the one that
is in. Ctrl+F, or a click, puts one in, rewinds and ejects. With none put in by hand the recorder
helps itself: CSAVE "A" makes the cassette `A` anew, and CLOAD looks through all of them.

While a tape goes by the machine runs flat out (`turbo` in the status line), and returns to its
speed afterwards; `turbo` in the settings turns that off.
"""

    def rows(self, inspection: Inspection) -> list[Row]:
        """The recorder, then the shelf."""
        deck = inspection.deck
        rows: list[Row] = []
        if deck.cassette is not None:
            kept = "" if deck.by_hand else ", not put in by hand"
            rows.append(
                (
                    ("cassette ", Ink.LABEL),
                    (deck.cassette, Ink.STRONG),
                    (f"{kept}  ", Ink.LABEL),
                    (deck.counter, Ink.PLAIN),
                )
            )
        if deck.running:
            rows.append(((deck.progress, Ink.STRONG),))
            if deck.done is not None:
                full = round(deck.done * _BAR)
                rows.append((("=" * full, Ink.LAMP_ON), ("-" * (_BAR - full), Ink.LAMP_OFF)))
        for name in inspection.cassettes:
            row: Row = (("  ", Ink.PLAIN), (name, Ink.PLAIN))
            if name == deck.cassette:
                row = (("> ", Ink.ALARM), (name, Ink.PLAIN), (f"  {deck.holds}", Ink.LABEL))
            rows.append(row)
        return rows

    def on_click(self) -> None:
        """What can be done at the recorder."""
        self.post_message(Asked("tapes"))
