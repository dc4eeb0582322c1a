"""Recorder and printer in lines."""

from __future__ import annotations

from trs80arm.deck import Deck
from trs80arm.plain.command import Group, LineCommand, Sitting
from trs80arm.plain.machine import at_file

LAST_LINES = 20
"""Lines of the paper that are read aloud unless more are asked for."""


def _tapes(sitting: Sitting, _: str) -> None:
    deck = Deck.of(sitting.session.rig)
    if deck.cassette is not None:
        sitting.tell(f"In the recorder: {deck.cassette}, at {deck.counter}.")
    if deck.running:
        sitting.tell(f"{deck.progress}.")
    shelf = sitting.peripherals.shelf()
    if not shelf:
        sitting.tell("There are no cassettes: CSAVE makes one.")
    for name, content in shelf:
        sitting.tell(f"{name}: {content}")


def _insert(sitting: Sitting, name: str) -> None:
    if name:
        sitting.peripherals.insert(name)
    else:
        sitting.peripherals.tapes()


def _rewind(sitting: Sitting, _: str) -> None:
    sitting.peripherals.rewind()


def _eject(sitting: Sitting, _: str) -> None:
    sitting.peripherals.eject()


def _paper(sitting: Sitting, words: str) -> None:
    command, _, name = words.partition(" ")
    if command.casefold() == "save":
        save = sitting.peripherals.save_paper
        at_file(
            sitting,
            name.strip(),
            sitting.peripherals.save_paper_as,
            to_write=True,
            ask=save,
        )
        return
    if words and not words.isdecimal():
        sitting.tell("How many lines, or save?")
        return
    lines = sitting.session.rig.printer.text.splitlines()
    wanted = int(words) if words else LAST_LINES
    shown = lines[max(0, len(lines) - wanted) :]
    if len(shown) < len(lines):
        sitting.tell(f"The last {len(shown)} of {len(lines)} lines:")
    sitting.tell("\n".join(shown) if lines else "Nothing is printed: LPRINT and LLIST print.")


def _tear(sitting: Sitting, _: str) -> None:
    sitting.peripherals.tear_off()


GROUP = Group(
    "Recorder and printer",
    (
        LineCommand("tapes", "the recorder, and what is on each cassette", _tapes),
        LineCommand(
            "insert",
            "put a cassette in, rewound; a new one if there is none",
            _insert,
            "[NAME]",
            "Without a name: a list. With a cassette put in, everything is recorded behind what "
            "is on it; with none, CSAVE makes one of its own.",
        ),
        LineCommand("rewind", "rewind it", _rewind),
        LineCommand("eject", "take it out", _eject),
        LineCommand("paper", "read what was printed, or save it", _paper, "[LINES | save FILE]"),
        LineCommand("tear", "tear the paper off; asks if no file has it", _tear),
    ),
)
