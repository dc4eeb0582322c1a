"""Colours that can be read: those of any theme, moved towards black or white as far as needed.

Themes are made for programs of panels and buttons; here their accents are lines and letters on the
theme's own grounds. Contrast is that of the web's rules (WCAG 2.1): 4.5 for text, 3 for lines.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from textual.color import BLACK, WHITE, Color, ColorParseError

TEXT, LINE = 4.5, 3.0
"""The contrast that text needs, and a line that only separates."""
_STEPS = 20
_ON_GROUND = (
    "text-primary",
    "text-secondary",
    "text-accent",
    "text-warning",
    "text-error",
    "text-success",
    "tube",
)
"""Variables of a theme with which is written on its background and in its dialogs."""
OF_PARTS = {
    "obstacle": "#cf9166",
    "part-2": "#ff8f6b",
    "part-3": "#6bb8ff",
    "part-4": "#c98bff",
    "part-5": "#ff7bb0",
    "part-6": "#6fd8c0",
}
"""Colours that no theme has: of obstacles, and of the second part on a bench and those after it."""


def contrast(one: Color, other: Color) -> float:
    """The contrast of two colours, 1 to 21."""
    high, low = sorted((_luminance(one), _luminance(other)), reverse=True)
    return (high + 0.05) / (low + 0.05)


def _luminance(colour: Color) -> float:
    linear = (
        value / 12.92 if value <= 0.03928 else ((value + 0.055) / 1.055) ** 2.4
        for value in colour.normalized
    )
    return sum(share * value for share, value in zip((0.2126, 0.7152, 0.0722), linear, strict=True))


def legible(colour: Color, *grounds: Color, least: float = TEXT) -> Color:
    """The colour, or the nearest on its way to black or white that can be read on all grounds."""

    def worst(candidate: Color) -> float:
        return min(contrast(candidate, ground) for ground in grounds)

    end = max((BLACK, WHITE), key=worst)
    candidates = (colour.blend(end, step / _STEPS) for step in range(_STEPS + 1))
    return next((candidate for candidate in candidates if worst(candidate) >= least), end)


def readable(variables: Mapping[str, str]) -> dict[str, str]:
    """The variables of a theme that have to change, and those that only this program has.

    A theme of the terminal's own sixteen colours, of which nobody knows how they look, keeps them.

    Args:
        variables: of the theme, as Textual makes them.
    """
    return dict(_readable(variables))


def _readable(variables: Mapping[str, str]) -> Iterator[tuple[str, str]]:
    try:
        background, surface, panel, primary, accent, foreground, secondary, warning, tube_ground = (
            Color.parse(variables[name])
            for name in (
                "background",
                "surface",
                "panel",
                "primary",
                "accent",
                "foreground",
                "secondary",
                "warning",
                "tube-background",
            )
        )
    except ColorParseError:
        known = False
    else:
        known = all(colour.ansi is None for colour in (background, foreground, accent))
    if not known:
        yield from (
            ("frame", variables["secondary"]),
            ("lead", variables["primary"]),
            ("title", variables["secondary"]),
            ("key", variables["accent"]),
            ("word", variables["foreground"]),
            ("on-warning", variables["background"]),
            ("on-primary", variables["background"]),
            *OF_PARTS.items(),
        )
        return
    for name in _ON_GROUND:
        text = variables.get(name, "")
        if text and not text.startswith("auto"):
            grounds = (tube_ground,) if name == "tube" else (background, surface)
            yield name, legible(Color.parse(text), *grounds).hex
    for name, text in OF_PARTS.items():
        yield name, legible(Color.parse(text), background, surface).hex
    yield "frame", legible(background.blend(secondary, 0.35), background, surface, least=LINE).hex
    yield "lead", legible(primary, background, surface).hex
    yield "title", legible(secondary, background, surface).hex
    yield "key", legible(accent, panel).hex
    yield "word", legible(foreground, panel).hex
    yield "on-warning", legible(background, warning).hex
    yield "on-primary", legible(background, primary).hex
