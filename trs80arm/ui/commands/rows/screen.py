"""Rows of the commands for keys, the tube, its looks, and scrolling beside it."""

from __future__ import annotations

from trs80arm.ui.commands.command import Command

SCREEN: tuple[Command, ...] = (
    Command(
        "latch",
        lambda to: to.keys.latch(),
        "Keys: latch on or off",
        "Latch mode: in @SET a press turns a key on or off.",
        "ctrl+d",
        also="sticky hold",
    ),
    Command(
        "key_test",
        lambda to: to.keys.test(),
        "Keys: test",
        "What the terminal tells about keys.",
        also="keyboard terminal",
    ),
    Command(
        "copy_screen",
        lambda to: to.tube.copy(),
        "Screen: copy",
        "Copy the tube's text.",
        "ctrl+y",
        also="clipboard tube text",
    ),
    Command(
        "save_text",
        lambda to: to.tube.save_text(),
        "Screen: save as text",
        "The tube as a text file.",
        also="export tube",
    ),
    Command(
        "save_picture",
        lambda to: to.tube.save_picture(),
        "Screen: save as picture",
        "The whole window as SVG.",
        also="screenshot svg export image",
    ),
    Command(
        "theme",
        lambda to: to.program.theme(),
        "Screen: theme",
        "Green, white, amber, high contrast, paper.",
        also="colour color dark light green white amber contrast paper",
    ),
    Command(
        "glyphs",
        lambda to: to.view.choose_glyphs(),
        "Screen: graphics glyphs",
        "Sextants, braille, quadrants or ASCII.",
        also="characters font graphics blocks",
    ),
    Command(
        "cursor",
        lambda to: to.view.switch_cursor(),
        "Screen: cursor blinks or not",
        "The ROM's own is steady.",
        also="blink steady",
    ),
    Command(
        "page_up",
        lambda to: to.view.scroll_page(-1),
        "View: page up",
        "Look back in paper, listing or variables.",
        "pageup",
        also="scroll",
    ),
    Command(
        "page_down",
        lambda to: to.view.scroll_page(1),
        "View: page down",
        "Look on in paper, listing or variables.",
        "pagedown",
        also="scroll",
    ),
)
