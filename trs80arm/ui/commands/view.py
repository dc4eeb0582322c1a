"""The commands that change what is seen: panels, zoom, arm views, glyphs, cursor."""

from __future__ import annotations

from typing import Protocol

from trs80arm.desk.asking import Asking, Choice, ListQuestion, Say
from trs80arm.desk.remembered import Remembered
from trs80arm.drawing.glyphs import GLYPHS
from trs80arm.options import ArmStyle, CursorStyle, GlyphSet
from trs80arm.ui.layout import Lead

GLYPH_NOTES = {
    GlyphSet.SEXTANT: "solid, exact; most terminals have them",
    GlyphSet.BRAILLE: "dots, exact",
    GlyphSet.QUADRANT: "solid, but two rows for three",
    GlyphSet.ASCII: "anywhere",
}
STYLE_NOTES = {
    ArmStyle.ASCII: "solid, in plain ASCII",
    ArmStyle.HALF: "solid, in half blocks",
    ArmStyle.SEXTANT: "solid, in blocks of 2x3",
    ArmStyle.BRAILLE: "solid, in braille dots",
    ArmStyle.PIXELS: "solid, in pixels",
    ArmStyle.OUTLINE: "in bare lines, for screen readers and slow lines",
}
LACKING = {
    GlyphSet.ASCII: (ArmStyle.HALF, ArmStyle.SEXTANT, ArmStyle.BRAILLE),
    GlyphSet.QUADRANT: (ArmStyle.SEXTANT,),
    GlyphSet.BRAILLE: (ArmStyle.SEXTANT,),
}
"""The styles whose characters a terminal with such glyphs is taken not to have."""
LEADS = {
    Lead.TUBE: "The tube has the room. Ctrl+E: whichever needs it.",
    Lead.ARM: "The arm has the room. Ctrl+E: whichever needs it.",
    None: "The arm has the room while it moves, else the tube.",
}
ARM_OPTIONS = {
    "envelope": ("Envelope off.", "Envelope on: + is how far the fingertip reaches."),
    "trail": ("Trail off.", "Trail on: , marks the way of the fingertip from now on."),
    "labels": ("Labels off.", "Labels on: scales, and the angles below."),
}
"""What is said when one of them is turned off, and on."""
_SAMPLE = bytes((129, 132, 144, 136, 151, 171, 183, 191))


class View(Protocol):
    """What is seen, and how."""

    arm_style: ArmStyle
    no_pixels: str
    cursor_style: CursorStyle
    zoomed: str | None

    @property
    def glyph_set(self) -> GlyphSet:
        """The set that graphics are drawn with."""

    def use_glyphs(self, chosen: GlyphSet) -> None:
        """Draw graphics with another set."""

    def use_arm_style(self, style: ArmStyle) -> None:
        """Draw the arm in another style."""

    def next_bottom(self) -> None:
        """Show the next group of panels under the tube."""

    def show_bottom(self, group: str) -> None:
        """Show a group of panels under the tube; asked for again, the first one."""

    def scroll_page(self, pages: int) -> None:
        """Look further down, or up, in the panels that are switched in, or in the paper."""

    def zoom(self, name: str) -> None:
        """One panel or group on all of the screen; asked for again, or by the arm, back."""

    def choose_lead(self) -> Lead | None:
        """The other one leads, and after that whichever has something to show."""

    def toggle_arm_option(self, name: str) -> bool:
        """Turn `envelope`, `trail` or `labels` on or off; whether it is on now."""

    def clear_trail(self) -> None:
        """Forget where the fingertip has been."""

    def zoom_arm(self, way: str) -> None:
        """Closer (`in`), farther (`out`), or all of it (`fit`)."""

    def turn_space(self, round_it: float, above: float) -> None:
        """Look at the arm in space from elsewhere, by so many degrees round it and up."""

    def scroll_scope(self, columns: int) -> None:
        """Go back in time in the scope, or on, by so many columns."""

    def zoom_scope(self, way: int) -> None:
        """More (1) or less (-1) detail in the scope."""

    def next_joint(self, way: int) -> None:
        """All latches in the scope, or one joint after the other."""


class ViewCommands:
    """Changes what is shown, and how.

    Args:
        view: what is seen.
        remembered: keeps the choices for the next time.
        ask: a way to ask.
        say: a way to say something.
    """

    def __init__(self, view: View, remembered: Remembered, ask: Asking, say: Say) -> None:
        self._view = view
        self._remembered = remembered
        self._ask = ask
        self._say = say

    def next_panel(self) -> None:
        """The next panel under the tube."""
        self._view.next_bottom()

    def show_bottom(self, group: str) -> None:
        """A group of panels under the tube; asked for again, the first one."""
        self._view.show_bottom(group)
        self._say_the_way_back()

    def scroll_page(self, pages: int) -> None:
        """A page further down in what is switched in, or up: paper, listing, variables."""
        self._view.scroll_page(pages)

    def zoom(self, name: str) -> None:
        """One panel on all of the screen, and back."""
        self._view.zoom(name)
        self._say_the_way_back()

    def _say_the_way_back(self) -> None:
        if self._view.zoomed is not None:
            self._say("F11 goes back to all panels.")

    def lead(self) -> None:
        """Give the room to the arm or to the tube, and the next time to whichever needs it."""
        self._say(LEADS[self._view.choose_lead()])

    # -- the arm ----------------------------------------------------------------------------------

    def next_arm_style(self) -> None:
        """Draw the arm in the next style of those whose characters the terminal has.

        Which these are is known from the glyphs of the tube's graphics.
        """
        styles = self._arm_styles()
        now = styles.index(self._view.arm_style)
        lacking = LACKING.get(self._view.glyph_set, ())
        following = (*styles[now + 1 :], *styles[: now + 1])
        self._use_arm_style(next(style for style in following if style not in lacking).value)

    def _arm_styles(self) -> list[ArmStyle]:
        """The styles that there are; pixels only where the terminal shows them."""
        return [s for s in ArmStyle if s is not ArmStyle.PIXELS or not self._view.no_pixels]

    def choose_arm_style(self) -> None:
        """Choose how the arm is drawn."""
        styles = self._arm_styles()
        choices = tuple(Choice(style.value, style.value, STYLE_NOTES[style]) for style in styles)
        question = ListQuestion("How the arm is drawn", choices, self._view.arm_style.value)
        self._ask.choose(question, self._use_arm_style)

    def _use_arm_style(self, value: str) -> None:
        self._view.use_arm_style(ArmStyle(value))
        self._remembered.choose("arm", value)
        self._say(f"The arm: {STYLE_NOTES[ArmStyle(value)]}.")

    def turn_space(self, round_it: float, above: float) -> None:
        """Look at the arm in space from elsewhere, by so many degrees."""
        self._view.turn_space(round_it, above)

    # -- the scope --------------------------------------------------------------------------------

    def scroll_scope(self, columns: int) -> None:
        """Go back in time in the scope, or on, by so many columns."""
        self._view.scroll_scope(columns)

    def zoom_scope(self, way: int) -> None:
        """More or less detail in the scope."""
        self._view.zoom_scope(way)

    def next_joint(self, way: int) -> None:
        """All latches in the scope, or one joint after the other."""
        self._view.next_joint(way)

    def arm_option(self, name: str) -> None:
        """Envelope, trail or labels on or off."""
        shown = self._view.toggle_arm_option(name)
        self._say(ARM_OPTIONS[name][shown])

    def clear_trail(self) -> None:
        """Forget where the fingertip has been."""
        self._view.clear_trail()
        self._say("The trail begins anew.")

    def zoom_arm(self, way: str) -> None:
        """Closer, farther, or all of it."""
        self._view.zoom_arm(way)

    # -- glyphs and cursor ------------------------------------------------------------------------

    def choose_glyphs(self) -> None:
        """Choose the glyphs of the graphics."""
        choices = tuple(
            Choice(chosen.value, chosen.value, f"\u2502{sample(chosen)}\u2502 {note}")
            for chosen, note in GLYPH_NOTES.items()
        )
        question = ListQuestion("Graphics glyphs", choices, self._view.glyph_set.value)
        self._ask.choose(question, self._use_glyphs)

    def _use_glyphs(self, value: str) -> None:
        self._view.use_glyphs(GlyphSet(value))
        self._remembered.choose("glyphs", value)

    def switch_cursor(self) -> None:
        """The cursor blinks, or is steady as the ROM's own."""
        blinks = self._view.cursor_style is CursorStyle.BLINK
        self._view.cursor_style = CursorStyle.STEADY if blinks else CursorStyle.BLINK
        self._remembered.choose("cursor", self._view.cursor_style.value)
        self._say(f"The cursor {'is steady' if blinks else 'blinks'}.")


def sample(chosen: GlyphSet) -> str:
    """A few blocks in a set of glyphs, to see whether the terminal has them."""
    return GLYPHS[chosen].row(_SAMPLE, wide=False)
