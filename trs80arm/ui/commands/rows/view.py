"""Rows of the commands for what is seen: panels, the arm's views, the arm in space, the scope."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from trs80arm.ui import layout
from trs80arm.ui.commands.command import Command
from trs80arm.ui.panels.registry import PANELS, PanelRow


def panel_commands(panels: Iterable[PanelRow]) -> Iterator[Command]:
    """The commands that bring panels to sight, as their rows want them."""
    rows = list(panels)
    for row in rows:
        if row.shows:
            yield Command(
                f"show_{row.group}",
                lambda to, group=row.group: to.view.show_bottom(group),  # type: ignore[misc]
                f"View: {row.group}",
                row.shows,
                row.key,
            )
    for row in rows:
        if row.fills:
            yield Command(
                f"fill_{row.id}",
                lambda to, id=row.id: to.view.zoom(id),  # type: ignore[misc]
                f"View: {row.title.lower()} large",
                row.fills,
            )


VIEW: tuple[Command, ...] = (
    Command(
        "panel",
        lambda to: to.view.next_panel(),
        "View: next panel",
        "Switch the panel under the tube.",
        "f4",
        "Panel",
        also="tab",
    ),
    Command(
        "zoom",
        lambda to: to.view.zoom(layout.ARM),
        "View: arm large, and back",
        "The arm large, and back.",
        "f11",
        "Zoom",
        also="zoom maximize full",
    ),
    Command(
        "lead",
        lambda to: to.view.lead(),
        "View: room for the arm, or for the tube",
        "Give the room to the other of arm and tube; again: to whichever needs it.",
        "ctrl+e",
        also="space larger lead swap",
    ),
    *panel_commands(PANELS),
    Command(
        "arm_style",
        lambda to: to.view.next_arm_style(),
        "Arm view: next style",
        "Draw the arm in ASCII, blocks, braille dots or bare lines.",
        "ctrl+a",
        also="dots drawing braille sextant half blocks outline",
    ),
    Command(
        "choose_arm_style",
        lambda to: to.view.choose_arm_style(),
        "Arm view: choose the style",
        "Choose how the arm is drawn.",
        also="dots drawing braille sextant half blocks outline ascii",
    ),
    Command(
        "space_left",
        lambda to: to.view.turn_space(-10, 0),
        "Arm in space: from further left",
        "Walk round the arm in space.",
        "ctrl+left",
        also="orbit rotate turn 3d",
    ),
    Command(
        "space_right",
        lambda to: to.view.turn_space(10, 0),
        "Arm in space: from further right",
        "The other way round.",
        "ctrl+right",
        also="orbit rotate turn 3d",
    ),
    Command(
        "space_higher",
        lambda to: to.view.turn_space(0, 8),
        "Arm in space: from higher up",
        "Look at the arm in space from higher up.",
        "ctrl+pageup",
        also="orbit tilt 3d",
    ),
    Command(
        "space_lower",
        lambda to: to.view.turn_space(0, -8),
        "Arm in space: from lower down",
        "Look at the arm in space from lower down.",
        "ctrl+pagedown",
        also="orbit tilt 3d",
    ),
    Command(
        "scope_back",
        lambda to: to.view.scroll_scope(-16),
        "Scope: back in time",
        "Go back in time in the scope.",
        "alt+left",
        also="logic analyser history earlier",
    ),
    Command(
        "scope_on",
        lambda to: to.view.scroll_scope(16),
        "Scope: on in time",
        "Go on in time in the scope.",
        "alt+right",
        also="logic analyser later",
    ),
    Command(
        "scope_closer",
        lambda to: to.view.zoom_scope(1),
        "Scope: more detail",
        "Less time a column in the scope.",
        "alt+pageup",
        also="logic analyser zoom in",
    ),
    Command(
        "scope_farther",
        lambda to: to.view.zoom_scope(-1),
        "Scope: less detail",
        "More time a column in the scope.",
        "alt+pagedown",
        also="logic analyser zoom out",
    ),
    Command(
        "scope_next",
        lambda to: to.view.next_joint(1),
        "Scope: next joint",
        "All latches in the scope, or one joint after the other.",
        "alt+down",
        also="strip chart phases",
    ),
    Command(
        "scope_previous",
        lambda to: to.view.next_joint(-1),
        "Scope: joint before",
        "The joint before in the scope.",
        "alt+up",
        also="strip chart phases",
    ),
    Command(
        "envelope",
        lambda to: to.view.arm_option("envelope"),
        "Arm view: envelope",
        "Where the hand can reach.",
        also="reach range",
    ),
    Command(
        "trail",
        lambda to: to.view.arm_option("trail"),
        "Arm view: trail",
        "Where the fingertip has been.",
        also="path trace",
    ),
    Command(
        "labels",
        lambda to: to.view.arm_option("labels"),
        "Arm view: labels",
        "Names in the arm's views.",
        also="names captions",
    ),
    Command(
        "clear_trail",
        lambda to: to.view.clear_trail(),
        "Arm view: clear the trail",
        "Forget where the fingertip has been.",
        also="path erase",
    ),
    Command(
        "arm_closer",
        lambda to: to.view.zoom_arm("in"),
        "Arm view: closer",
        "Show the arm larger.",
        "ctrl+up",
        also="zoom in larger",
    ),
    Command(
        "arm_farther",
        lambda to: to.view.zoom_arm("out"),
        "Arm view: farther",
        "Show the arm smaller.",
        "ctrl+down",
        also="zoom out smaller",
    ),
    Command(
        "arm_fit",
        lambda to: to.view.zoom_arm("fit"),
        "Arm view: fit",
        "Show all of the arm and the bench.",
        also="zoom all whole",
    ),
)
