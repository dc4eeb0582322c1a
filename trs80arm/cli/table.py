"""The table of commands: where each is, and the words that it has on the front page of the help.

It loads nothing, so that `trs80arm --help` is there as soon as the interpreter is: click alone
takes three times as long to load.
"""

from __future__ import annotations

COMMANDS = {
    "check": ("listings", "check", "Read PROGRAMS without running them, and tell what is wrong."),
    "convert": ("listings", "convert", "Convert a program or a cassette, bytes or sound; list it."),
    "demo": ("terminal", "demo", "Watch the article's pick-and-place task; any key ends it."),
    "export": ("making", "export_", "Write arm and bench, or a run, for other programs."),
    "figure": ("making", "figure", "Draw one of the article's figures from the running model."),
    "film": ("making", "film", "Film a run of PROGRAM: animated SVG, GIF or asciinema cast."),
    "programs": (
        "listings",
        "programs",
        "List the programs that come along, which open by name.",
    ),
    "replay": ("runs", "replay", "Play a recorded session again without a screen."),
    "run": ("runs", "run", "Run PROGRAMS without a screen, as fast as the computer can."),
    "serial": ("serial", "serial", "Put a TeachMover behind a serial line, for its clients."),
    "serve": ("terminal", "serve", "Serve the terminal to a browser (extra `web`)."),
    "sweep": ("runs", "sweep", "Run PROGRAM over a grid of values; tell how often it succeeds."),
    "terminal": ("terminal", "terminal", "Open the terminal, with PROGRAM loaded if one is given."),
    "tour": ("terminal", "tour", "The first five minutes, step by step: drive, pick, teach."),
}
"""Module in `trs80arm.cli`, name in it, and one line of help."""


def front_page() -> str:
    """What `trs80arm --help` prints, at most 79 columns wide."""
    commands = "\n".join(f"  {name:9} {words}" for name, (_, _, words) in COMMANDS.items())
    return f"""Usage: trs80arm [OPTIONS] COMMAND [ARGS]...

  A TRS-80 Level II with ARMBASIC and a MiniMover 5 robot arm.

  `trs80arm [PROGRAM]` opens the terminal; `trs80arm terminal --help` has its
  options.

Options:
  --version   Show the version and exit.
  -h, --help  Show this message and exit.

Commands:
{commands}
"""
