"""The commands that change what is seen: panels, zoom, arm views, glyphs, help, settings."""

from __future__ import annotations

import json
from typing import Any

from trs80arm.options import ArmStyle, CursorStyle, GlyphSet
from trs80arm.plain_values import as_table
from trs80arm.settings import SettingsError, remember
from trs80arm.ui import layout
from trs80arm.ui.desk import Desk
from trs80arm.ui.layout import Bottom
from trs80arm.ui.screens.dialog import Choice, Choose
from trs80arm.ui.screens.help import HelpScreen
from trs80arm.ui.screens.settings import SettingsScreen

GLYPH_NOTES = {
    GlyphSet.SEXTANT: "solid, exact; most terminals have them",
    GlyphSet.BRAILLE: "dots, exact",
    GlyphSet.QUADRANT: "solid, but two rows for three",
    GlyphSet.ASCII: "anywhere",
}


class ViewCommands(Desk):
    """What is shown, and how."""

    def action_help(self) -> None:
        """The page of help."""
        self.push_screen(HelpScreen(self.keyboard.in_use))

    def action_panel(self) -> None:
        """The next panel under the tube."""
        choices = layout.bottoms(*self.size)
        if self.zoomed is not None or self.bottom not in choices:
            self._show(choices[0])
        else:
            self._show(choices[(choices.index(self.bottom) + 1) % len(choices)])

    def action_show_bottom(self, name: str) -> None:
        """A panel under the tube; asked for again, the first one."""
        wanted = Bottom(name)
        choices = layout.bottoms(*self.size)
        if wanted not in choices:
            self.action_maximise({"motors": "coils", "log": "events"}.get(name, "arm"))
        elif wanted is self.bottom and self.zoomed is None:
            self._show(choices[0])
        else:
            self._show(wanted)

    def _show(self, bottom: Bottom) -> None:
        self.bottom = bottom
        self.zoomed = None
        self.arrange()

    def action_zoom(self) -> None:
        """The arm large, and back."""
        self.action_maximise("arm")

    def action_maximise(self, name: str) -> None:
        """One panel on all of the screen, and back."""
        self.zoomed = None if self.zoomed is not None else name
        self.arrange()

    # -- the arm ----------------------------------------------------------------------------------

    def action_arm_style(self) -> None:
        """Draw the arm in the other style."""
        other = ArmStyle.ASCII if self.arm_style is ArmStyle.BRAILLE else ArmStyle.BRAILLE
        self.use_arm_style(other)
        self.remember("arm", other.value)

    def action_arm_option(self, name: str) -> None:
        """Envelope, trail or labels on or off."""
        shown = not getattr(self.side, name)
        for view in (self.side, self.top):
            setattr(view, name, shown)
        self.say(f"{name.capitalize()} {'on' if shown else 'off'}.")

    def action_clear_trail(self) -> None:
        """Forget where the fingertip has been."""
        self.side.clear_trail()
        self.top.clear_trail()

    def action_arm_zoom(self, way: str) -> None:
        """Closer, farther, or all of it."""
        for view in (self.side, self.top):
            getattr(view, f"zoom_{way}")()

    # -- glyphs, cursor, themes -------------------------------------------------------------------

    def action_glyphs(self) -> None:
        """Choose the glyphs of the graphics."""
        choices = [
            Choice(chosen.value, chosen.value, f"\u2502{sample(chosen)}\u2502 {note}")
            for chosen, note in GLYPH_NOTES.items()
        ]
        self.push_screen(
            Choose("Graphics glyphs", choices, self.tube.glyph_set.value), self._chosen_glyphs
        )

    def _chosen_glyphs(self, value: str | None) -> None:
        if value is not None:
            self.use_glyphs(GlyphSet(value))
            self.remember("glyphs", value)

    def action_cursor(self) -> None:
        """The cursor blinks, or is steady as the ROM's own."""
        blinks = self.cursor_style is CursorStyle.BLINK
        self.cursor_style = CursorStyle.STEADY if blinks else CursorStyle.BLINK
        self.remember("cursor", self.cursor_style.value)

    def watch_theme(self, name: str) -> None:
        """A theme was chosen, here or in the palette: remember it."""
        if self.is_running and name != self._remembered_theme:
            self._remembered_theme = name
            self.remember("theme", name)

    def remember(self, key: str, value: str) -> None:
        """Write a choice into the settings file, if one is used."""
        if self.options.settings_file is None:
            return
        try:
            remember(self.options.settings_file, key, value)
        except SettingsError as error:
            self.say(f"Not remembered: {error}", error=True)
        except OSError as error:
            file = self.options.settings_file
            self.say(f"Not remembered in {file}: {error.strerror or error}", error=True)

    def action_settings(self) -> None:
        """What is set."""
        rig = self.session.rig.settings
        tables: dict[str, dict[str, Any]] = {
            "terminal": {
                "speed": "max" if self.pacer.speed is None else f"{self.pacer.speed:g}",
                "keys": self.keyboard.mode.value,
                "glyphs": self.tube.glyph_set.value,
                "theme": self.theme,
                "arm": self.arm_style.value,
                "cursor": self.cursor_style.value,
                "fps": self.options.fps,
                "tap_ms": self.options.tap_ms,
                "repeat_ms": self.options.repeat_ms,
            },
            "machine": {
                "ram": rig.ram_kib,
                "memory_size": rig.memory_size,
                "armbasic": rig.armbasic,
                "ghosting": rig.ghosting,
                "tapes": str(rig.tape_folder or ""),
                "printer": str(rig.printer_file or ""),
            },
            "card": as_table(rig.card, with_defaults=True),
            "driver": as_table(rig.driver, with_defaults=True),
            "arm": as_table(rig.arm, with_defaults=True),
        }
        shown = {
            name: {key: json.dumps(value) for key, value in table.items()}
            for name, table in tables.items()
        }
        self.push_screen(SettingsScreen(self.options.settings_file, shown))


def sample(chosen: GlyphSet) -> str:
    """A few blocks in a set of glyphs, to see whether the terminal has them."""
    from trs80arm.drawing.glyphs import GLYPHS

    return GLYPHS[chosen].row(bytes((129, 132, 144, 136, 151, 171, 183, 191)), wide=False)
