"""Rows of the commands for the sitting: recordings, tour, settings, and leaving."""

from __future__ import annotations

from trs80arm.ui.commands.command import Command

SESSION: tuple[Command, ...] = (
    Command(
        "save_recording",
        lambda to: to.files.save_recording(),
        "Session: save a recording",
        "All that was done since power-on.",
        also="record session journal",
    ),
    Command(
        "replay",
        lambda to: to.files.play(),
        "Session: play a recording",
        "Play a recorded session.",
        also="recording playback",
    ),
    Command(
        "discard_recovered",
        lambda to: to.files.discard_recovered(),
        "Session: remove recovered programs",
        "Remove what sessions that ended badly have left.",
        also="discard delete clean",
    ),
    Command(
        "demo",
        lambda to: to.machine.demo(),
        "Session: demonstration",
        "The article's pick and place, with captions.",
        also="tour show example",
    ),
    Command(
        "tour",
        lambda to: to.tour.menu(),
        "Session: tour",
        "The first five minutes, step by step; again: skip, back, leave.",
        "ctrl+n,alt+n",
        also="tutorial learn guide begin first help introduction",
    ),
    Command(
        "settings",
        lambda to: to.program.settings(),
        "Settings",
        "Every setting with its meaning and default, to change and save.",
        also="options preferences config",
    ),
    Command(
        "suspend",
        lambda to: to.program.suspend(),
        "Suspend",
        "Suspend: to the shell; fg comes back.",
        "ctrl+z",
        also="shell background job",
    ),
    Command(
        "interrupt",
        lambda to: to.program.interrupt(),
        "Program: BREAK, or leave",
        "BREAK while something runs or moves; at READY, leave.",
        "ctrl+c",
        priority=True,
        also="stop quit exit",
    ),
    Command(
        "leave",
        lambda to: to.program.leave(),
        "Leave",
        "Leave; asks if the program is unsaved.",
        "f10,ctrl+q",
        "Quit",
        True,
        also="quit exit close end",
    ),
)
