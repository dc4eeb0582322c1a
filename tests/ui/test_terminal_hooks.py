"""Textual's private hooks are as our driver, parser and what writes cells need them."""

from __future__ import annotations

import inspect

import pytest
from rich.color import ColorSystem
from rich.console import Console
from rich.style import Style
from textual import events
from textual._compositor import Compositor, CompositorUpdate
from textual._styles_cache import StylesCache
from textual._xterm_parser import XTermParser
from textual.app import App
from textual.css.stylesheet import Stylesheet
from textual.drivers.linux_driver import LinuxDriver
from textual.drivers.web_driver import WebDriver
from textual.geometry import Region
from textual.message import Message
from textual.widget import Widget
from textual.widgets import Static

from tests.ui.piloted import piloted
from trs80arm.options import KeyMode
from trs80arm.ui.terminal.driver import (
    InsistingDriver,
    KeyReleaseDriver,
    TerminalDriver,
    choose_driver,
)
from trs80arm.ui.terminal.messages import KeyReport, KeyWentDown, KeyWentUp
from trs80arm.ui.terminal.parser import KeyParser


def parse(data: str, *, releases: bool = True, chunk: int = 0) -> list[Message]:
    parser = KeyParser(releases=releases)
    size = chunk or len(data) or 1
    found: list[Message] = []
    for start in range(0, len(data), size):
        found.extend(parser.feed(data[start : start + size]))
    return found


def told(messages: list[Message]) -> list[str]:
    """The messages in short: `+base`, `-base`, `key name`, `report`."""
    words = []
    for message in messages:
        match message:
            case KeyWentDown():
                words.append(f"+{message.base}")
            case KeyWentUp():
                words.append(f"-{message.base}")
            case KeyReport():
                words.append(f"report {message.releases}")
            case events.Key():
                words.append(f"key {message.key}")
            case _:
                words.append(type(message).__name__)
    return words


def test_the_parser_still_has_the_hook_that_ours_overrides() -> None:
    hook = XTermParser._sequence_to_key_events
    assert list(inspect.signature(hook).parameters) == ["self", "sequence", "alt"]
    assert "sequence_to_key_events" in inspect.getsource(XTermParser.parse)


def test_the_driver_still_has_what_ours_overrides_and_uses() -> None:
    source = inspect.getsource(LinuxDriver)
    for name in ("start_application_mode", "stop_application_mode", "run_input_thread"):
        assert callable(getattr(LinuxDriver, name))
    for name in ("self.fileno", "self.exit_event", "self._writer_thread", "self._debug"):
        assert name in source
    assert "self._file = sys.__stderr__" in source
    assert source.count("self._file") == 2
    assert "WriterThread(self._file)" in inspect.getsource(LinuxDriver.start_application_mode)
    assert "self._get_terminal_size()" in inspect.getsource(LinuxDriver.start_application_mode)
    assert "XTermParser(self._debug)" in inspect.getsource(LinuxDriver.run_input_thread)


def test_only_the_linux_driver_is_replaced() -> None:
    assert choose_driver(LinuxDriver, KeyMode.AUTO) is KeyReleaseDriver
    assert choose_driver(LinuxDriver, KeyMode.LATCH) is KeyReleaseDriver
    assert choose_driver(LinuxDriver, KeyMode.EVENTS) is InsistingDriver
    assert choose_driver(LinuxDriver, KeyMode.REPEAT) is TerminalDriver
    assert choose_driver(WebDriver, KeyMode.AUTO) is WebDriver


def test_three_keys_are_held_at_once_and_let_go_in_any_order() -> None:
    data = "\x1b[49;1:1;49u\x1b[119;1:1;119u\x1b[51;1;51u\x1b[119;1:3u\x1b[49;1:3u\x1b[51;1:3u"
    ups_and_downs = [word for word in told(parse(data)) if word[0] in "+-"]
    assert ups_and_downs == ["+49u", "+119u", "+51u", "-119u", "-49u", "-51u"]


@pytest.mark.parametrize("chunk", [1, 2, 3, 5])
def test_pieces_of_any_size_give_the_same(chunk: int) -> None:
    data = "\x1b[97;1:1;97u\x1b[97;1:2;97u\x1b[97;1:3u\x1b[1;1:1A\x1b[1;1:3A"
    assert told(parse(data, chunk=chunk)) == [
        "+97u",
        "key a",
        "key a",
        "-97u",
        "+1A",
        "key up",
        "-1A",
    ]


def test_shift_let_go_before_the_letter_leaves_no_key_hanging() -> None:
    down, up = parse("\x1b[105:73;2:1;73u\x1b[105;1:3u")[::2]
    assert isinstance(down, KeyWentDown)
    assert isinstance(up, KeyWentUp)
    assert down.base == up.base == "105u"
    assert down.text == "I"


def test_repeats_are_keys_but_no_new_press() -> None:
    assert told(parse("\x1b[97;1:2;97u")) == ["key a"]


def test_alternates_stand_in_for_text_only_under_shift() -> None:
    [down, _] = parse("\x1b[50:34;2u")
    assert isinstance(down, KeyWentDown)
    assert down.text == '"'
    [down, key] = parse("\x1b[97:65;6u")
    assert isinstance(down, KeyWentDown)
    assert down.text is None
    assert isinstance(key, events.Key)
    assert key.key == "ctrl+shift+a"


@pytest.mark.parametrize(
    ("data", "name", "character"),
    [
        ("\x1b[13;1:1u", "enter", "\r"),
        ("\x1b[32u", "space", " "),
        ("\x1b[32;1:1;32u", "space", " "),
        ("\x1b[27;1:1u", "escape", None),
        ("\x1b[127;1:1u", "backspace", "\x7f"),
        ("\x1b[15;1:1~", "f5", None),
        ("\x1b[1;1:1P", "f1", None),
        ("\x1b[97;65;97u", "a", "a"),
        ("\x1b[97;129;97u", "a", "a"),
        ("\x1b[57441;2:1u", "left_shift", None),
    ],
)
def test_textual_gets_its_keys_as_ever(data: str, name: str, character: str | None) -> None:
    keys = [message for message in parse(data) if isinstance(message, events.Key)]
    assert [(key.key, key.character) for key in keys] == [(name, character)]


def test_replies_are_no_keys() -> None:
    assert told(parse("\x1b[?31u\x1b[?62;22c", releases=False)) == ["report True"]
    assert told(parse("\x1b[?1u\x1b[?62;22c", releases=False)) == ["report False"]


def test_a_release_proves_what_the_answer_denied() -> None:
    words = told(parse("\x1b[?0u\x1b[97;1:3u\x1b[98;1:1;98u", releases=False))
    assert words == ["report False", "report True", "-97u", "+98u", "key b"]


def test_a_terminal_without_releases_never_has_a_press_without_a_release() -> None:
    words = told(parse("a\x1b[A\x1b[1;5C\x1bOP", releases=False))
    assert words == ["key a", "key up", "key ctrl+right", "key f1"]


def test_mouse_and_paste_pass_in_between() -> None:
    words = told(parse("\x1b[97;1:1;97u\x1b[<0;5;6M\x1b[200~X\r\x1b[201~\x1b[97;1:3u"))
    assert words == ["+97u", "key a", "MouseDown", "Paste", "-97u"] or words == [
        "+97u",
        "key a",
        "MouseDown",
        "-97u",
        "Paste",
    ]


@pytest.mark.parametrize(
    "sequence",
    [
        "\x1b[1114112u",
        "\x1b[55296u",
        "\x1b[97;1;1114112u",
        "\x1b[97:99999999;2u",
        "\x1b[97;1;56320:97u",
        "\x1b[" + "9" * 5000 + "u",
    ],
)
@pytest.mark.parametrize("releases", [False, True])
def test_codes_of_no_character_are_no_keys(sequence: str, releases: bool) -> None:
    parser = KeyParser(releases=releases)
    heard = [*parser.feed(sequence), *parser.feed("a")]
    for message in heard:
        assert not getattr(message, "character", None) or message.character.isprintable()
    assert [getattr(message, "character", None) for message in heard][-1] == "a"


def test_the_styles_of_components_still_come_from_the_hooks_that_ours_override() -> None:
    source = inspect.getsource(Stylesheet._process_component_classes)
    assert "virtual_node._attach(node)" in source
    assert "node._component_styles[component] = virtual_node.styles" in source
    assert "node.notify_style_update()" in inspect.getsource(Stylesheet.replace_rules)


@pytest.mark.parametrize(
    ("owner", "name", "parameters"),
    [
        (App, "_display", ["self", "screen", "renderable"]),
        (CompositorUpdate, "render_segments", ["self", "console"]),
        (Compositor, "_get_renders", ["self", "crop"]),
        (Compositor, "render_partial_update", ["self"]),
        (StylesCache, "set_dirty", ["self", "regions"]),
        (Style, "_make_ansi_codes", ["self", "color_system"]),
    ],
)
def test_what_cells_are_written_by_is_still_called_so(
    owner: type, name: str, parameters: list[str]
) -> None:
    hook = getattr(owner, name, None)
    where = "trs80arm/ui/terminal/layers.py and changes.py write cells by it"
    assert hook is not None, f"{owner.__name__}.{name} is gone; {where}"
    taken = list(inspect.signature(hook).parameters)
    assert taken == parameters, f"{owner.__name__}.{name} takes {taken}; {where}"


@piloted
async def test_what_tells_where_a_widget_is_seen_still_does() -> None:
    app: App[None] = App()
    async with app.run_test(size=(20, 5)) as pilot:
        await app.mount(panel := Static("seen"))
        await pilot.pause()
        screen, compositor = app.screen, app.screen._compositor
        assert screen._layout_required is False, (
            "Screen._layout_required: laid out, and not said so"
        )
        seen = compositor.visible_widgets
        assert list(seen)[-1] is screen, "Compositor.visible_widgets: the foremost were the first"
        region, clip = seen[panel]
        assert clip.contains_region(region), "Compositor.visible_widgets: place and clip"
        panel.refresh()
        await pilot.pause()
        same = compositor.visible_widgets is seen
        assert same, "Compositor.visible_widgets: the same mapping until the layout changes"
        panel.styles.height = 3
        await pilot.pause()
        assert compositor.visible_widgets is not seen, "... and another one from then on"


@piloted
async def test_lines_that_were_written_past_textual_are_rendered_again_by_it() -> None:
    class Counted(Widget):
        rendered = 0

        def render(self) -> str:
            self.rendered += 1
            return "line"

    app: App[None] = App()
    async with app.run_test(size=(20, 5)) as pilot:
        await app.mount(panel := Counted())
        await pilot.pause()
        crop = panel.size.region
        panel.render_lines(crop)
        cache = panel._styles_cache
        assert not cache.is_dirty(0), "Widget._styles_cache: holds what was rendered"
        cache.set_dirty(Region(0, 0, 1, 1))
        assert cache.is_dirty(0), "StylesCache.set_dirty: forgets the lines of a region"
        assert not cache.is_dirty(1), "StylesCache.set_dirty: and no others"


def test_colours_of_the_console_are_told_as_before() -> None:
    console = Console(color_system="truecolor", force_terminal=True)
    assert console._color_system is ColorSystem.TRUECOLOR, "rich's Console._color_system"
    codes = Style(bold=True, color="red").without_color._make_ansi_codes(ColorSystem.TRUECOLOR)
    assert codes == "1", "rich's Style._make_ansi_codes: bold alone"
