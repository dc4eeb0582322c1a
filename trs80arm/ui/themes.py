"""The phosphors of the tube as Textual themes, one of high contrast, one for light terminals."""

from __future__ import annotations

from collections.abc import Container
from typing import ClassVar, TypeVar

from textual.app import App
from textual.theme import Theme

from trs80arm.ui.contrast import readable

Result = TypeVar("Result")

GREEN = Theme(
    name="green",
    primary="#45e06f",
    secondary="#9fd8a8",
    accent="#d8f36a",
    foreground="#a9e8b5",
    background="#07130a",
    surface="#0b1c10",
    panel="#12301a",
    success="#45e06f",
    warning="#ffcf5c",
    error="#ff6b5e",
    dark=True,
    variables={"tube": "#54f07d", "tube-background": "#03100a"},
)
"""The P31 phosphor of a monitor of the time."""

WHITE = Theme(
    name="white",
    primary="#dfe8f2",
    secondary="#9db4c8",
    accent="#8fd3ff",
    foreground="#cfd6de",
    background="#0c0f13",
    surface="#12161c",
    panel="#222a33",
    success="#7fd88f",
    warning="#ffcf5c",
    error="#ff7a70",
    dark=True,
    variables={"tube": "#eef4ff", "tube-background": "#0a0c10"},
)
"""The P4 phosphor of the Model I's own display."""

AMBER = Theme(
    name="amber",
    primary="#ffb347",
    secondary="#d99a4e",
    accent="#ffe08a",
    foreground="#f0c48a",
    background="#150d04",
    surface="#1d1206",
    panel="#38230c",
    success="#b7d36a",
    warning="#ffe08a",
    error="#ff6b52",
    dark=True,
    variables={"tube": "#ffb93e", "tube-background": "#120a02"},
)

CONTRAST = Theme(
    name="contrast",
    primary="#ffffff",
    secondary="#00ffff",
    accent="#ffff00",
    foreground="#ffffff",
    background="#000000",
    surface="#000000",
    panel="#303030",
    success="#00ff00",
    warning="#ffff00",
    error="#ff8080",
    dark=True,
    variables={"tube": "#ffffff", "tube-background": "#000000"},
)

PAPER = Theme(
    name="paper",
    primary="#14532d",
    secondary="#3f5f7f",
    accent="#7a3e00",
    foreground="#222222",
    background="#f6f4ee",
    surface="#eeebe2",
    panel="#d9d4c5",
    success="#14602d",
    warning="#8a5a00",
    error="#a31515",
    dark=False,
    variables={"tube": "#10240f", "tube-background": "#fbfaf4"},
)
"""For terminals with a light background."""

THEMES: tuple[Theme, ...] = (GREEN, WHITE, AMBER, CONTRAST, PAPER)


class Themed(App[Result]):
    """An application with the own themes, and with colours that can be read in every theme."""

    _mixed: ClassVar[dict[str, tuple[Theme, dict[str, str], dict[str, str]]]] = {}
    """By name of a theme: it, its variables, and those that were changed. Colours are asked for
    twice before the first frame, and to mix them takes a millisecond and a half."""

    def get_theme_variable_defaults(self) -> dict[str, str]:
        """The tube's colours in themes that know no tube: those of any text."""
        colours = self.current_theme.to_color_system().generate()
        return {"tube": colours["foreground"], "tube-background": colours["background"]}

    def get_css_variables(self) -> dict[str, str]:
        """The theme's variables, those changed that could not be read."""
        theme = self.current_theme
        known = self._mixed.get(theme.name)
        if known is None or known[0] is not theme:
            variables = super().get_css_variables()
            known = self._mixed[theme.name] = (theme, variables, readable(variables))
        _, variables, changed = known
        self.theme_variables = dict(variables)
        return variables | changed


def refusal(name: str, available: Container[str]) -> str:
    """Why there is no theme of a name; empty if there is."""
    if name in available:
        return ""
    own = ", ".join(theme.name for theme in THEMES)
    return f"theme: there is no theme {name!r}; there are {own} and those of Textual"
