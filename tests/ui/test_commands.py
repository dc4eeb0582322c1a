"""The groups of commands, without a screen: what they ask, do and say."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from tests.desk.sitting import NOTHING, Sitting
from trs80arm.desk.asking import ListQuestion
from trs80arm.desk.base_pendant import BasePendant
from trs80arm.desk.debugger import Debugger
from trs80arm.desk.leaving import NOTHING_UNSAVED, PROGRAM_UNSAVED
from trs80arm.desk.pacing import Pacer
from trs80arm.desk.pendant import Pendant
from trs80arm.desk.remembered import Remembered
from trs80arm.desk.sound import LineSound
from trs80arm.desk.stage import Stage
from trs80arm.desk.states import States
from trs80arm.options import ArmStyle, CursorStyle, GlyphSet, KeyMode, Speed, TerminalOptions
from trs80arm.rig import Key, Waiting
from trs80arm.ui.commands.arm import ArmCommands
from trs80arm.ui.commands.comfort import ComfortCommands
from trs80arm.ui.commands.debug import DebugCommands
from trs80arm.ui.commands.keys import KeyCommands
from trs80arm.ui.commands.machine import MachineCommands
from trs80arm.ui.commands.program import ProgramCommands
from trs80arm.ui.commands.table import COMMANDS
from trs80arm.ui.commands.tube import TubeCommands
from trs80arm.ui.commands.view import ARM_OPTIONS, ViewCommands
from trs80arm.ui.help_topics import Topic
from trs80arm.ui.keys.held_keys import HeldKeys
from trs80arm.ui.keys.jog_keyboard import JogKeyboard
from trs80arm.ui.keys.keyboard import Keyboard
from trs80arm.ui.layout import Lead
from trs80arm.ui.screens.debugger import DebuggerScreen
from trs80arm.ui.screens.dialog import Dialog
from trs80arm.ui.screens.hand_move import HandMoveScreen
from trs80arm.ui.screens.key_test import KeyTest
from trs80arm.ui.screens.pendant import PendantScreen
from trs80arm.ui.screens.settings import SettingsScreen
from trs80arm.ui.screens.taught_program import TeachResult


class Shown:
    """What would be on the screen, and dialogs that are answered at once."""

    def __init__(self) -> None:
        self.arm_style = ArmStyle.ASCII
        self.no_pixels = "no pixels here"
        self.cursor_style = CursorStyle.BLINK
        self.zoomed: str | None = None
        self.glyph_set = GlyphSet.SEXTANT
        self.done: list[tuple[str, ...]] = []
        self.opened: list[Dialog[Any]] = []
        self.result: Any = None
        self.clipboard = ""
        self.tube_text = "READY"
        self.theme = "green"
        self.dialog_is_open = False
        self.lead: Lead | None = None

    def use_glyphs(self, chosen: GlyphSet) -> None:
        self.glyph_set = chosen

    def use_arm_style(self, style: ArmStyle) -> None:
        self.arm_style = style

    def next_bottom(self) -> None:
        self.done.append(("next",))

    def show_bottom(self, group: str) -> None:
        self.done.append(("bottom", group))

    def zoom(self, name: str) -> None:
        self.done.append(("zoom", name))

    def choose_lead(self) -> Lead | None:
        self.lead = Lead.ARM if self.lead is None else None
        return self.lead

    def toggle_arm_option(self, name: str) -> bool:
        self.done.append(("toggle", name))
        return self.done.count(("toggle", name)) % 2 == 1

    def clear_trail(self) -> None:
        self.done.append(("clear",))

    def zoom_arm(self, way: str) -> None:
        self.done.append(("arm", way))

    @property
    def help_here(self) -> str:
        return ""

    def open(self, dialog: Dialog[Any], then: Any = None) -> None:
        self.opened.append(dialog)
        if self.result is not None and then is not None:
            then(self.result)

    theme_names = ("green", "amber")

    def show_theme(self, name: str) -> None:
        self.done.append(("shown", name))

    def use_theme(self, name: str) -> None:
        self.theme = name

    def action_suspend_process(self) -> None:
        self.done.append(("suspend",))

    def copy_to_clipboard(self, text: str) -> None:
        self.clipboard = text

    def export_screenshot(self) -> str:
        return "<svg/>"


class Desk(Sitting):
    """A sitting with its commands."""

    def __init__(self, folder: Path) -> None:
        super().__init__(folder)
        self.wall = 100.0
        self.shown = Shown()
        self.pacer = Pacer(self.session, lambda: self.wall, 1.0)
        self.debugger = Debugger(self.session)
        self.keyboard = Keyboard(self.session, HeldKeys(), KeyMode.AUTO, lambda: self.wall)
        self.session.watch_machine(self.keyboard.start_afresh)
        person = self.person
        self.stage = Stage(self.session, person.say)
        self.machine = MachineCommands(
            self.session,
            self.debugger,
            self.pacer,
            self.keyboard,
            self.files,
            self.stage,
            person,
            person.say,
        )
        self.states = States(folder / "states")
        self.debug = DebugCommands(
            self.session,
            self.debugger,
            self.states,
            self.pacer,
            self.shown,
            person.say,
            lambda: True,
        )
        pendant = Pendant(self.session, self.lesson)
        jog_keyboard = JogKeyboard(
            self.session, pendant, HeldKeys(), self.keyboard, lambda: self.wall
        )
        base_pendant = BasePendant(self.session)
        base_keyboard = JogKeyboard(
            self.session, base_pendant, HeldKeys(), self.keyboard, lambda: self.wall
        )
        self.arm = ArmCommands(
            self.session,
            pendant,
            jog_keyboard,
            base_pendant,
            base_keyboard,
            self.machine,
            self.files,
            person,
            person.say,
            self.shown,
            lambda: ArmStyle.ASCII,
        )
        remembered = Remembered(folder / "settings.toml", person.say)
        self.view = ViewCommands(self.shown, remembered, person, person.say)
        self.keys = KeyCommands(self.keyboard, KeyMode.AUTO, person.say, self.shown)
        self.tube = TubeCommands(self.shown, self.files, person.say)
        self.rung: list[float] = []
        self.sound = LineSound(
            self.session, lambda: self.rung.append(self.session.time), person.say
        )
        self.comfort = ComfortCommands(self.pacer, self.sound, remembered, person, person.say)
        self.program = ProgramCommands(
            self.session,
            self.pacer,
            self.sound,
            self.keyboard,
            self.shown,
            TerminalOptions(),
            self.leaving,
            self.machine,
            self.stage,
            self.shown,
            person,
            self.shown,
            lambda: [Topic("Help", "What is done.")],
        )

    @property
    def settings(self) -> str:
        return (self.folder / "settings.toml").read_text()


@pytest.fixture
def desk(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Desk:
    monkeypatch.chdir(tmp_path)
    return Desk(tmp_path)


def test_run_stops_what_runs_and_types_run(desk: Desk) -> None:
    desk.type("10 X=X+1", "20 GOTO 10")
    desk.machine.run()
    desk.session.run_for(2)
    assert desk.session.waiting is Waiting.NOTHING
    desk.machine.run()
    desk.session.run_for(2)
    assert sum(line == ">RUN" for line in desk.session.rig.screen()) == 2


def test_break_also_ends_a_pause(desk: Desk) -> None:
    desk.type("10 GOTO 10")
    desk.machine.run()
    desk.session.run_for(2)
    desk.machine.pause()
    assert desk.pacer.paused
    desk.machine.press_break()
    assert not desk.pacer.paused
    desk.session.run_for(0.2)
    assert desk.session.waiting is Waiting.COMMAND


def test_pausing_twice_goes_on(desk: Desk) -> None:
    desk.machine.pause()
    desk.machine.pause()
    assert desk.person.told == ["Paused: F6 goes on, F7 opens the debugger.", "Going on."]


def test_the_debugger_opens_and_then_a_statement_at_a_time_is_told(desk: Desk) -> None:
    desk.debug.step()
    assert isinstance(desk.shown.opened[-1], DebuggerScreen)
    desk.type("10 A=1", "20 GOTO 10")
    desk.machine.run()
    desk.session.run_for(1)
    desk.debug.step()
    assert isinstance(desk.shown.opened[-1], DebuggerScreen)
    desk.debug.step()
    assert desk.person.told[-1] in ("Before 10: A=1", "Before 20: GOTO 10")
    assert desk.pacer.paused


def test_a_quick_state_is_saved_and_comes_back(desk: Desk) -> None:
    desk.type("A=5")
    desk.debug.quick_save()
    desk.type("A=6")
    desk.debug.quick_load()
    assert desk.person.told == ["Saved; Shift+F2 comes back to here.", "State quick is loaded."]
    desk.type("PRINT A")
    assert " 5" in desk.session.rig.screen()


def test_a_quick_state_that_was_never_saved_is_told(desk: Desk) -> None:
    desk.debug.quick_load()
    assert desk.person.errors == ["there is no state 'quick'"]


def test_a_motor_step_says_whether_there_was_one(desk: Desk) -> None:
    desk.machine.step_motor()
    desk.session.rig.type("@STEP 50,9\r")
    desk.session.run_for(0.9)
    desk.machine.step_motor()
    assert desk.person.told == ["No motor moved within a second.", "One motor step."]


@pytest.mark.parametrize("speed", list(Speed))
def test_the_speed_is_chosen_from_a_list_that_marks_the_present_one(
    desk: Desk, speed: Speed
) -> None:
    desk.answer(speed.value)
    desk.machine.choose_speed()
    [question] = desk.person.asked
    assert isinstance(question, ListQuestion)
    assert question.now == "1"
    assert desk.pacer.speed == speed.factor


def test_off_and_on_asks_and_lets_go_of_every_key(desk: Desk) -> None:
    desk.type("10 REM MINE")
    desk.keyboard.held.latch((Key.A,))
    desk.answer("stay", "go")
    desk.machine.reset()
    assert desk.lines == [10]
    desk.machine.reset()
    assert desk.lines == []
    assert not desk.keyboard.held.latched
    assert desk.person.told == ["Switched off and on."]


def test_the_demonstration_asks_plays_and_ends_at_a_key(desk: Desk) -> None:
    desk.type("10 REM MINE")
    desk.answer("go")
    desk.machine.demo()
    desk.stage.go_on()
    assert desk.person.told[-1].startswith("A TRS-80 with ARMBASIC")
    assert desk.stage.operator_came()
    assert not desk.stage.operator_came()
    assert desk.person.told[-1] == "The machine is yours."


def test_without_its_program_there_is_no_demonstration(
    desk: Desk, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("trs80arm.bundled.programs_folder", lambda: None)
    desk.machine.demo()
    desk.stage.go_on()
    assert desk.person.errors[0].startswith("No demonstration: ")


def test_a_bench_is_chosen_among_those_beside_the_program(desk: Desk) -> None:
    part = '[[part]]\nname = "cube"\nsize = [1, 1, 1]\nat = [8, 2]\nweight = 2\n'
    bench = desk.write("own.toml", part)
    desk.write("bad.toml", "[[part]]\n")
    desk.answer(str(bench), str(desk.folder / "bad.toml"), "")
    desk.arm.choose_bench()
    labels = [choice.label for choice in desk.person.asked[0].choices]
    assert labels[0] == "table"
    assert {"own", "bad", "table4"} <= set(labels)
    notes = {choice.label: choice.note for choice in desk.person.asked[0].choices}
    assert (notes["own"], notes["table4"]) == (str(desk.folder), "comes along")
    assert list(desk.session.rig.arm.bench.parts) == ["cube"]
    desk.arm.choose_bench()
    assert "bad.toml" in desk.person.errors[-1]
    desk.arm.choose_bench()
    assert desk.session.bench_path is None


def test_parts_go_back_where_they_were(desk: Desk) -> None:
    part = next(iter(desk.session.rig.arm.bench.parts.values()))
    before = part.box
    desk.type("@STEP 50,0,-207,290,0,0,340", "@STEP 50,0,132,-36", "@CLOSE")
    desk.type("@STEP 50,0,-400")
    desk.arm.refill()
    after = next(iter(desk.session.rig.arm.bench.parts.values())).box
    assert after.center == pytest.approx(before.center, abs=0.001)


def test_after_a_slip_the_way_back_is_offered_with_the_reason(desk: Desk) -> None:
    rig = desk.session.rig
    rig.type("@STEP 50,0,0,-3000\r")
    rig.run_for(20)
    desk.answer("home")
    desk.arm.come_back()
    [question] = desk.person.asked
    assert "slipped" in question.text
    assert "at its stop" in question.text
    assert "J3" in question.text or "elbow" in question.text
    assert rig.state.slipped == (0,) * 6
    assert rig.registers == (0,) * 6


def test_without_a_slip_it_says_that_nothing_is_lost(desk: Desk) -> None:
    desk.answer("stay")
    desk.arm.come_back()
    assert "No motor has lost steps" in desk.person.asked[0].text


def test_positions_are_taught_and_loaded_as_a_program(desk: Desk) -> None:
    desk.arm.teach_here()
    assert desk.person.told == ["Position 1 is taught: F12 lists them."]
    desk.shown.result = TeachResult("10 END\n")
    desk.arm.teach()
    assert isinstance(desk.shown.opened[0], PendantScreen)
    assert desk.lines == [10]
    assert not desk.lesson.unwritten


def test_a_lesson_that_could_not_be_loaded_is_not_called_written(desk: Desk) -> None:
    desk.arm.teach_here()
    desk.shown.result = TeachResult("NO PROGRAM\n")
    desk.arm.teach()
    assert desk.lesson.unwritten


def test_the_override_goes_through_all_speeds_and_stops_at_the_ends(desk: Desk) -> None:
    said = [desk.machine.speed_text]
    for _ in range(5):
        desk.machine.other_speed(-1)
        said.append(desk.machine.speed_text)
    assert said == ["100 %", "50 %", "25 %", "10 %", "5 %", "5 %"]
    assert desk.pacer.speed == 0.05
    for _ in range(9):
        desk.machine.other_speed(1)
    assert desk.machine.speed_text == "flat out"


def test_the_dialog_for_hands_is_opened(desk: Desk) -> None:
    desk.arm.move_by_hand()
    assert isinstance(desk.shown.opened[0], HandMoveScreen)


def test_choices_of_the_view_are_remembered(desk: Desk) -> None:
    desk.answer("quadrant")
    desk.view.choose_glyphs()
    desk.view.next_arm_style()
    desk.view.switch_cursor()
    assert desk.shown.glyph_set is GlyphSet.QUADRANT
    assert desk.shown.arm_style is ArmStyle.HALF
    assert desk.shown.cursor_style is CursorStyle.STEADY
    assert 'glyphs = "quadrant"' in desk.settings
    assert 'arm = "half"' in desk.settings
    assert 'cursor = "steady"' in desk.settings
    desk.answer("braille")
    desk.view.choose_arm_style()
    assert desk.shown.arm_style is ArmStyle.BRAILLE
    assert 'arm = "braille"' in desk.settings
    desk.view.next_arm_style()
    assert desk.shown.arm_style is ArmStyle.OUTLINE


@pytest.mark.parametrize("glyphs", [GlyphSet.BRAILLE, GlyphSet.QUADRANT])
def test_who_has_no_sextants_in_the_tube_has_none_in_the_arm(desk: Desk, glyphs: GlyphSet) -> None:
    desk.shown.glyph_set = glyphs
    desk.shown.arm_style = ArmStyle.HALF
    desk.view.next_arm_style()
    assert desk.shown.arm_style is ArmStyle.BRAILLE


def test_pixels_are_offered_where_the_terminal_shows_them(desk: Desk) -> None:
    desk.shown.arm_style = ArmStyle.BRAILLE
    desk.view.next_arm_style()
    assert desk.shown.arm_style is ArmStyle.OUTLINE
    desk.shown.no_pixels = ""
    desk.shown.arm_style = ArmStyle.BRAILLE
    desk.view.next_arm_style()
    assert desk.shown.arm_style is ArmStyle.PIXELS
    assert 'arm = "pixels"' in desk.settings


@pytest.mark.parametrize(
    ("glyphs", "styles"),
    [
        ("sextant", {"ascii", "half", "sextant", "braille", "outline"}),
        ("quadrant", {"ascii", "half", "braille", "outline"}),
        ("ascii", {"ascii", "outline"}),
    ],
)
def test_styles_that_the_terminal_has_not_are_passed_over(
    desk: Desk, glyphs: str, styles: set[str]
) -> None:
    desk.shown.glyph_set = GlyphSet(glyphs)
    seen = set()
    for _ in ArmStyle:
        desk.view.next_arm_style()
        seen.add(desk.shown.arm_style.value)
    assert seen == styles


def test_a_choice_that_cannot_be_remembered_is_told_and_made(desk: Desk) -> None:
    (desk.folder / "settings.toml").mkdir()
    desk.view.switch_cursor()
    assert desk.shown.cursor_style is CursorStyle.STEADY
    assert desk.person.errors[0].startswith("Not remembered in ")


def test_options_of_the_arms_views_say_whether_they_are_on(desk: Desk) -> None:
    desk.view.arm_option("trail")
    desk.view.arm_option("trail")
    assert desk.person.told == [*ARM_OPTIONS["trail"][::-1]]


def test_who_gives_the_room_away_is_told_how_to_have_it_back(desk: Desk) -> None:
    desk.view.lead()
    desk.view.lead()
    assert desk.person.told == [
        "The arm has the room. Ctrl+E: whichever needs it.",
        "The arm has the room while it moves, else the tube.",
    ]


def test_latch_mode_is_switched_on_and_off(desk: Desk) -> None:
    desk.keys.latch()
    assert desk.keyboard.in_use is KeyMode.LATCH
    desk.keys.latch()
    assert desk.keyboard.in_use is KeyMode.REPEAT
    assert desk.person.told[-1] == "Keys: repeat."


def test_the_key_test_is_opened(desk: Desk) -> None:
    desk.keys.test()
    assert isinstance(desk.shown.opened[0], KeyTest)


def test_the_tube_is_copied_and_saved(desk: Desk) -> None:
    desk.tube.copy()
    assert desk.shown.clipboard == "READY"
    desk.answer(desk.folder / "a.txt", desk.folder / "a.svg")
    desk.tube.save_text()
    desk.tube.save_picture()
    assert (desk.folder / "a.txt").read_text() == "READY\n"
    assert (desk.folder / "a.svg").read_text() == "<svg/>"


@pytest.mark.parametrize(
    ("typed", "waiting"),
    [
        ("GOTO 10", Waiting.NOTHING),
        ("RUN", Waiting.INPUT),
        ("@SET", Waiting.SET),
        ("@STEP 500,2000", Waiting.NOTHING),
        ("AUTO", Waiting.AUTO),
    ],
)
def test_the_interrupt_key_is_break_while_something_runs_or_moves(
    desk: Desk, typed: str, waiting: Waiting
) -> None:
    desk.session.rig.load_text("5 INPUT A\n10 GOTO 10\n")
    desk.session.rig.type(typed + "\r")
    desk.session.run_for(2.5)
    assert desk.session.waiting is waiting
    desk.program.interrupt()
    for _ in range(6):
        desk.session.run_for(0.1)
        desk.keyboard.feed()
    if typed.startswith("@STEP"):
        desk.session.rig.run_until_waiting(60)
    assert desk.session.waiting is Waiting.COMMAND
    assert desk.ended == []
    assert desk.person.asked == []


def test_the_interrupt_key_at_ready_asks_and_the_second_time_leaves(desk: Desk) -> None:
    desk.answer(NOTHING)
    desk.program.interrupt()
    assert desk.person.asked == [NOTHING_UNSAVED]
    desk.program.interrupt()
    assert desk.ended == ["left"]


def test_the_interrupt_key_asks_for_what_is_unsaved_first(desk: Desk) -> None:
    desk.type("10 REM MINE")
    desk.answer("stay")
    desk.program.interrupt()
    assert desk.person.asked == [PROGRAM_UNSAVED]


def test_the_interrupt_key_ends_the_demonstration(desk: Desk) -> None:
    desk.machine.demo()
    desk.stage.go_on()
    desk.session.run_for(1)
    desk.program.interrupt()
    assert desk.person.told[-1] == "The machine is yours."
    assert desk.person.asked == []


def test_themes_are_seen_on_the_way_to_the_chosen_one(desk: Desk) -> None:
    desk.answer("amber")
    desk.program.theme()
    assert desk.shown.done == [("shown", "green"), ("shown", "amber")]
    assert desk.shown.theme == "amber"


def test_the_settings_are_shown_as_they_are_now(desk: Desk) -> None:
    desk.machine.set_speed(Speed.FLAT_OUT)
    desk.program.settings()
    assert isinstance(desk.shown.opened[0], SettingsScreen)


def test_no_two_commands_have_a_name_or_a_key_in_common() -> None:
    names = [command.name for command in COMMANDS]
    keys = [key for command in COMMANDS for key in command.keys.split(",") if key]
    assert len(set(names)) == len(names)
    assert len(set(keys)) == len(keys)


def test_turbo_is_switched_off_and_on_and_remembered(desk: Desk) -> None:
    desk.comfort.switch_turbo()
    assert not desk.pacer.hurries
    assert "turbo = false" in (desk.folder / "settings.toml").read_text()
    desk.comfort.switch_turbo()
    assert desk.pacer.hurries
    assert desk.person.told == [
        "Tapes and pastes go at the speed set.",
        "Tapes and pastes go flat out, then at the speed set.",
    ]


def test_sound_is_chosen_and_heard(desk: Desk) -> None:
    desk.answer("bell")
    desk.comfort.choose_sound()
    desk.type("OUT 255,1:OUT 255,2")
    desk.sound.go_on()
    assert len(desk.rung) == 1
    assert 'sound = "bell"' in (desk.folder / "settings.toml").read_text()
