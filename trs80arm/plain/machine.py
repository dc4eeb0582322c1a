"""The machine in lines: programs, the tube, recordings."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from trs80arm.bundled import PROGRAM_SUFFIX, named
from trs80arm.plain.command import Group, LineCommand, Sitting


def at_file(
    sitting: Sitting,
    name: str,
    do: Callable[[Path], object],
    *,
    to_write: bool,
    ask: Callable[[], object] | None = None,
) -> None:
    """Do something with the file that is named, if it can be reached.

    Args:
        sitting: the desk.
        name: what was typed.
        do: is given the path.
        to_write: whether the file will be written.
        ask: asks for a name where none was typed.
    """
    if not name:
        (ask or (lambda: sitting.tell("Which file?")))()
        return
    path = sitting.reach.typed(name)
    if outside := sitting.reach.refusal(path, to_write=to_write):
        sitting.tell(outside)
    else:
        do(path)


def _run(sitting: Sitting, _: str) -> None:
    sitting.session.rig.type("RUN\r")


def _screen(sitting: Sitting, _: str) -> None:
    sitting.tell("\n".join(sitting.session.rig.screen()))


def _open(sitting: Sitting, name: str) -> None:
    files = sitting.files

    def load(path: Path) -> None:
        program = named(path, PROGRAM_SUFFIX)
        files.if_program_may_go("Open", lambda: files.load_file(program))

    at_file(sitting, name, load, to_write=False, ask=files.open)


def _save(sitting: Sitting, name: str) -> None:
    at_file(sitting, name, sitting.files.save_as, to_write=True, ask=sitting.files.save)


def _record(sitting: Sitting, name: str) -> None:
    files = sitting.files
    at_file(sitting, name, files.save_recording_as, to_write=True, ask=files.save_recording)


def _play(sitting: Sitting, name: str) -> None:
    files = sitting.files
    at_file(sitting, name, files.play_if_may_go, to_write=False, ask=files.play)


GROUP = Group(
    "The machine",
    (
        LineCommand(
            "open", "load a program, its bench with it", _open, "[FILE]", "Without a name: a list."
        ),
        LineCommand("save", "save the program", _save, "[FILE]"),
        LineCommand("run", "type RUN", _run),
        LineCommand(
            "check",
            "what is wrong in the program, as reading it tells",
            lambda sitting, _: sitting.proof.read(),
            more="The line that is chosen is listed.",
        ),
        LineCommand(
            "button",
            "push the reset button: out of machine code to READY",
            lambda sitting, _: sitting.session.rig.push_reset(),
        ),
        LineCommand("screen", "read the tube", _screen),
        LineCommand(
            "record",
            "save what was done so far, to be played again",
            _record,
            "[FILE]",
            "Everything since the machine was switched on, as JSON lines. --record FILE writes "
            "it as it happens.",
        ),
        LineCommand("play", "play a recording; Ctrl+C ends it", _play, "[FILE]"),
    ),
)
