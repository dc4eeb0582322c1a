"""What the command line asks of the terminal program: plain values, no Textual.

`cli/` fills a `TerminalOptions` from flags, environment and the settings file and hands it to
`trs80arm.ui.start.run_terminal`, which alone imports Textual.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum, StrEnum
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from trs80arm.rig import RigSettings
    from trs80arm.serial.limits import Plugging


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
    """Solid, filled with a ramp of characters."""
    HALF = "half"
    """Solid, in half blocks."""
    SEXTANT = "sextant"
    """Solid, in blocks of 2x3."""
    BRAILLE = "braille"
    """Solid, in dots."""
    PIXELS = "pixels"
    """Solid, in pixels, where the terminal shows them."""
    OUTLINE = "outline"
    """In bare lines of ASCII."""


class CursorStyle(StrEnum):
    """What the cursor of the tube does: the ROM's own is steady."""

    BLINK = "blink"
    STEADY = "steady"


class Sound(StrEnum):
    """How programs are heard that make sound on the line to the recorder, by OUT 255."""

    OFF = "off"
    BELL = "bell"
    """The terminal's bell, once where a sound begins."""
    SAMPLES = "samples"
    """As it was, through the computer's loudspeaker; extra `sound`."""


class Speed(Enum):
    """Virtual seconds per second of the wall, from slow motion on."""

    TWENTIETH = "0.05"
    TENTH = "0.1"
    QUARTER = "0.25"
    HALF = "0.5"
    ONE = "1"
    TWO = "2"
    FIVE = "5"
    TWENTY = "20"
    FLAT_OUT = "max"

    @property
    def factor(self) -> float | None:
        """The number; None for flat out."""
        return None if self is Speed.FLAT_OUT else float(self.value)

    @property
    def percent(self) -> str:
        """As an override says it."""
        return "flat out" if self.factor is None else f"{100 * self.factor:g} %"

    def other(self, by: int) -> Speed:
        """A faster speed, or a slower one; the last ones stay."""
        speeds = list(Speed)
        return speeds[min(max(speeds.index(self) + by, 0), len(speeds) - 1)]


@dataclass(frozen=True)
class TerminalSettings:
    """The table `[terminal]`.

    Attributes:
        speed: how fast the machine's time goes: 1 as it was, 2, 5 or 20 times, or max; 0.05, 0.1,
            0.25 and 0.5 are slow motion.
        keys: how presses become held keys: events (real releases), repeat (a timer), latch (on and
            off), or auto, which takes releases where the terminal reports them.
        glyphs: the characters of the tube's graphics: sextant, braille, quadrant, ascii, or auto.
        theme: the colours: green, white, amber, contrast, paper, or any theme of Textual.
        arm: how the arm is drawn: solid in ascii, half blocks, sextants, braille dots or pixels, or
            in bare lines (outline).
        cursor: whether the tube's cursor blinks, or is steady as the ROM's own.
        turbo: whether the machine goes flat out while a tape goes by or a paste is typed.
        sound: of programs that OUT to port 255: off, the terminal's bell, or samples.
        fps: the most frames a second, 1 to 60.
        tap_ms: how long the timer holds a key after a press, milliseconds.
        repeat_ms: how long the timer holds a key after a repeat, milliseconds.
    """

    speed: Speed = Speed.ONE
    keys: KeyMode = KeyMode.AUTO
    glyphs: GlyphSet = GlyphSet.AUTO
    theme: str = "green"
    arm: ArmStyle = ArmStyle.ASCII
    cursor: CursorStyle = CursorStyle.BLINK
    turbo: bool = True
    sound: Sound = Sound.OFF
    fps: int = 30
    tap_ms: int = 100
    repeat_ms: int = 120

    def __post_init__(self) -> None:
        if not 1 <= self.fps <= 60:
            raise ValueError(f"fps must be 1 to 60, not {self.fps}")
        for name in ("tap_ms", "repeat_ms"):
            if not 10 <= getattr(self, name) <= 2000:
                raise ValueError(f"{name} must be 10 to 2000, not {getattr(self, name)}")


@dataclass(frozen=True)
class TerminalOptions(TerminalSettings):
    """How the terminal program is to start: its settings, and what it is to open."""

    program: Path | None = None
    """A program file to load."""
    run: bool = False
    """Whether to type RUN at once."""
    bench: Path | None = None
    """A bench file (TOML); None takes the one named like the program, if there is one."""
    plain: bool = False
    """The line mode for screen readers and pipes instead of the full screen."""
    tour: bool = False
    """Whether to begin the tour of the first five minutes, or go on with it."""
    demo: bool = False
    """Whether to play the demonstration until a key is pressed."""
    record: Path | None = None
    """A file to which everything the operator does is written as it happens."""
    replay: Path | None = None
    """A recorded session to play."""
    rig: RigSettings | None = None
    """The machine's fittings; None is a 16K machine with ARMBASIC."""
    plug: Plugging | None = None
    """The wire to a real arm that does what the model does; None plugs nothing in."""
    serial: bool = False
    """Whether the arm's serial line is open to programs, on a pseudo-terminal."""
    serial_tcp: int | None = None
    """The TCP port of this computer on which it is open instead; 0 for any."""
    own_folder: Path | None = None
    """The one folder whose files its user can name; None for all files."""
    settings_file: Path | None = None
    """Where choices made in the program are remembered; None does not remember them."""

    @property
    def serves_line(self) -> bool:
        """Whether programs can drive the arm over its serial line."""
        return self.serial or self.serial_tcp is not None
