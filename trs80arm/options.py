"""What the command line asks of the terminal program: plain values, no Textual.

`cli.py` fills a `TerminalOptions` from flags, environment and the settings file and hands it to
`trs80arm.ui.app.run_terminal`, which alone imports Textual.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from trs80arm.rig import RigSettings

SPEEDS: tuple[float | None, ...] = (1.0, 2.0, 5.0, 20.0, None)
"""Virtual seconds per second of the wall; None is as fast as this computer can."""


class KeyMode(StrEnum):
    """How key presses of the terminal become held keys of the TRS-80."""

    AUTO = "auto"
    """Real releases where the terminal reports them, else the repeat timer."""
    EVENTS = "events"
    """Real releases, asked for although the terminal did not promise them."""
    REPEAT = "repeat"
    """The repeat timer: a press is a tap, auto-repeat holds. Nothing is asked of the terminal."""
    LATCH = "latch"
    """In manual mode a press turns a key on and the next one off."""


class GlyphSet(StrEnum):
    """With which characters the 2x3 graphics blocks are drawn."""

    AUTO = "auto"
    SEXTANT = "sextant"
    BRAILLE = "braille"
    QUADRANT = "quadrant"
    ASCII = "ascii"


class ArmStyle(StrEnum):
    """With which characters the arm is drawn."""

    ASCII = "ascii"
    BRAILLE = "braille"


class CursorStyle(StrEnum):
    """What the cursor of the tube does: the ROM's own is steady."""

    BLINK = "blink"
    STEADY = "steady"


@dataclass(frozen=True)
class TerminalOptions:
    """How the terminal program is to start."""

    program: Path | None = None
    """A program file to load."""
    run: bool = False
    """Whether to type RUN at once."""
    bench: Path | None = None
    """A bench file (TOML); None takes the one named like the program, if there is one."""
    speed: float | None = 1.0
    """Virtual seconds per second of the wall; None is flat out."""
    keys: KeyMode = KeyMode.AUTO
    glyphs: GlyphSet = GlyphSet.AUTO
    theme: str = "green"
    arm_style: ArmStyle = ArmStyle.ASCII
    cursor: CursorStyle = CursorStyle.BLINK
    fps: int = 30
    """The most frames a second that are drawn."""
    tap_ms: int = 100
    """How long a key is held after a press, where the terminal reports no releases."""
    repeat_ms: int = 120
    """How long it is held after each repeat."""
    plain: bool = False
    """The line mode for screen readers and pipes instead of the full screen."""
    demo: bool = False
    """Whether to play the demonstration until a key is pressed."""
    record: Path | None = None
    """A file to which everything the operator does is written as it happens."""
    replay: Path | None = None
    """A recorded session to play."""
    rig: RigSettings | None = None
    """The machine's fittings; None is a 16K machine with ARMBASIC."""
    settings_file: Path | None = None
    """Where choices made in the program are remembered; None does not remember them."""
