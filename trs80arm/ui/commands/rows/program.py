"""Rows of the commands for help, palette and the program: open and save it, RUN and BREAK."""

from __future__ import annotations

from trs80arm.ui.commands.command import Command

PROGRAM: tuple[Command, ...] = (
    Command(
        "help",
        lambda to: to.program.help(),
        "Help",
        "The help: searched, and opened at what is being done.",
        "f1",
        "Help",
        also="manual keys ?",
    ),
    Command(
        "palette",
        lambda to: to.program.palette(),
        "Commands",
        "All commands: type to search, Enter does the one that is marked.",
        "ctrl+p",
        "Commands",
    ),
    Command(
        "open",
        lambda to: to.files.open(),
        "Program: open",
        "Load a program file.",
        "f2,ctrl+o",
        "Open",
        also="load file",
    ),
    Command(
        "save",
        lambda to: to.files.save(),
        "Program: save",
        "Save the program in memory.",
        "f3,ctrl+s",
        "Save",
        also="write store file",
    ),
    Command(
        "run",
        lambda to: to.machine.run(),
        "Program: run",
        "Type RUN.",
        "f5",
        "Run",
        also="start go",
    ),
    Command(
        "break",
        lambda to: to.machine.press_break(),
        "Program: BREAK",
        "BREAK, as Escape.",
        "f9",
        "Break",
        also="stop escape interrupt",
    ),
    Command(
        "check",
        lambda to: to.proof.read(),
        "Program: check",
        "What is wrong in the program in memory, as reading it tells; the line chosen is listed.",
        also="errors problems lint syntax reach read proof",
    ),
    Command(
        "paste",
        lambda to: to.files.paste(),
        "Program: paste a listing",
        "Paste a listing: typed in, or loaded at once.",
        "ctrl+v",
        also="listing type in clipboard insert",
    ),
)
