"""Rows of the commands for cassettes, paper and sound, and for keeping what no file holds."""

from __future__ import annotations

from trs80arm.ui.commands.command import Command

PERIPHERALS: tuple[Command, ...] = (
    Command(
        "tapes",
        lambda to: to.peripherals.tapes(),
        "Tape: cassettes",
        "Put a cassette in, rewind it, eject it.",
        "ctrl+f",
        also="shelf insert recorder csave cload folder",
    ),
    Command(
        "new_tape",
        lambda to: to.peripherals.new_cassette(),
        "Tape: insert a new one",
        "Put a blank cassette into the recorder.",
        also="cassette blank",
    ),
    Command(
        "rewind",
        lambda to: to.peripherals.rewind(),
        "Tape: rewind",
        "Rewind the cassette in the recorder.",
        also="cassette",
    ),
    Command(
        "eject",
        lambda to: to.peripherals.eject(),
        "Tape: eject",
        "Take the cassette out of the recorder.",
        also="cassette",
    ),
    Command(
        "paper",
        lambda to: to.peripherals.paper(),
        "Paper: save or tear off",
        "Save what is printed, or tear it off.",
        "ctrl+u",
        also="printer lprint",
    ),
    Command(
        "save_paper",
        lambda to: to.peripherals.save_paper(),
        "Paper: save",
        "Save what is printed as a text file.",
        also="printer lprint export",
    ),
    Command(
        "tear_off",
        lambda to: to.peripherals.tear_off(),
        "Paper: tear off",
        "Take away what is printed.",
        also="printer lprint clear remove",
    ),
    Command(
        "turbo",
        lambda to: to.comfort.switch_turbo(),
        "Machine: turbo for tapes and pastes",
        "Flat out while a tape goes by or a paste is typed, or not.",
        also="fast cassette speed",
    ),
    Command(
        "sound",
        lambda to: to.comfort.choose_sound(),
        "Machine: sound",
        "How programs are heard that make sound by OUT 255.",
        also="beep bell audio loudspeaker cassette noise",
    ),
    Command(
        "save_keepsakes",
        lambda to: to.files.save_keepsakes(),
        "Machine: save cassettes and paper",
        "What was recorded or printed and is in memory only.",
        also="tape csave lprint printer export",
    ),
)
