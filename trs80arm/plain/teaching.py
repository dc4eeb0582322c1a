"""Teaching in lines: positions, and programs of them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from trs80arm.desk.taught_programs import Written, written
from trs80arm.plain.command import Group, LineCommand, Sitting
from trs80arm.plain.machine import at_file
from trs80arm.reasons import reason
from trs80arm.saving import write_whole

STYLES = {"steps": False, "data": True}
"""How a program can be written: whether in coordinates."""
ONCE, ROUND = "once", "round"


def show_positions(sitting: Sitting, _: str) -> None:
    """What was taught."""
    if not sitting.lesson.positions:
        sitting.tell("Nothing is taught yet: .teach teaches where the arm is.")
    for number, position in enumerate(sitting.lesson.positions, 1):
        pose = position.pose
        grip = "holds" if position.grips else f"open {pose.opening:.2f}"
        sitting.tell(
            f"{number} {position.name}: X {pose.x:.2f}, Y {pose.y:.2f}, Z {pose.z:.2f}, pitch "
            f"{pose.pitch:.1f}, roll {pose.roll:.1f}, hand {grip}; registers "
            f"{' '.join(map(str, position.registers))}"
            f"{'; ' + position.comment if position.comment else ''}"
        )


def _teach(sitting: Sitting, name: str) -> None:
    position = sitting.pendant.teach(name)
    number = 1 + (sitting.pendant.place or 0)
    grip = ", the hand holds" if position.grips else ""
    sitting.tell(f"Position {number}, {position.name}, is taught{grip}.")
    sitting.pendant.message = ""


def at_position(sitting: Sitting, words: str, do: Callable[[int, str], object]) -> None:
    """Do something with the position whose number comes first, and list all."""
    number, _, rest = words.partition(" ")
    if not number.isdecimal() or not 1 <= int(number) <= len(sitting.lesson):
        sitting.tell("Which position? .positions lists them by number.")
        return
    do(int(number) - 1, rest.strip())
    show_positions(sitting, "")


def _again(sitting: Sitting, words: str) -> None:
    standing = sitting.pendant.stance
    at_position(sitting, words, lambda place, _: sitting.lesson.teach_again(place, standing))


def _rename(sitting: Sitting, words: str) -> None:
    at_position(sitting, words, sitting.lesson.rename)


def _move(sitting: Sitting, words: str) -> None:
    def move(place: int, to: str) -> None:
        if to.isdecimal():
            sitting.lesson.move(place, int(to) - 1 - place)
        else:
            sitting.tell("To which number?")

    at_position(sitting, words, move)


def _remove(sitting: Sitting, words: str) -> None:
    at_position(sitting, words, lambda place, _: sitting.lesson.remove(place))


def _program(sitting: Sitting, words: list[str]) -> Written:
    """A program of the lesson in the manner that the words say."""
    in_coordinates = any(STYLES.get(word.casefold(), False) for word in words)
    manner = sitting.pendant.manner
    if manners := [word.casefold() for word in words if word.casefold() in (ONCE, ROUND)]:
        manner = replace(manner, repeats=manners[-1] == ROUND)
    model = sitting.session.rig.arm.model
    return written(sitting.lesson, manner, model, in_coordinates=in_coordinates)


def _told(sitting: Sitting, program: Written) -> bool:
    """Say what is wrong with a program; whether there is one."""
    for text in filter(None, (program.problem, program.warning)):
        sitting.tell(text)
    return bool(program.listing)


def _load(sitting: Sitting, words: str) -> None:
    program = _program(sitting, words.split())

    def load() -> None:
        if sitting.files.load_listing(program.listing):
            sitting.lesson.written()

    if _told(sitting, program):
        sitting.files.if_program_may_go("Load the lesson", load)


def _write(sitting: Sitting, words: str) -> None:
    manner = [word for word in words.split() if word.casefold() in (*STYLES, ONCE, ROUND)]
    name = " ".join(word for word in words.split() if word not in manner)
    program = _program(sitting, manner)

    def write(path: Path) -> None:
        try:
            write_whole(path, program.listing.encode("ascii"))
        except OSError as error:
            sitting.tell(f"{path}: {reason(error)}")
        else:
            sitting.lesson.written()
            sitting.tell(f"{path.name} is written.")

    if _told(sitting, program):
        at_file(sitting, name, write, to_write=True)


_MANNER = (
    "steps (Table 3's style: @STEP with differences) or data (Table 4's: coordinates in DATA "
    "lines), once or round and round."
)
GROUP = Group(
    "Teaching",
    (
        LineCommand(
            "teach",
            "teach where the arm is",
            _teach,
            "[NAME]",
            "Move the arm, by .jog, @SET, @STEP or .hand, and teach each position; it comes behind "
            "the one where the arm was last. Where the grip switch is closed the program will "
            "close the hand by @CLOSE.",
        ),
        LineCommand("positions", "what is taught", show_positions),
        LineCommand("again", "teach a position anew, where the arm is", _again, "NUMBER"),
        LineCommand("rename", "call a position something else", _rename, "NUMBER NAME"),
        LineCommand("move", "put a position elsewhere in the order", _move, "NUMBER NUMBER"),
        LineCommand("remove", "forget a position", _remove, "NUMBER"),
        LineCommand(
            "lesson", "load a program of the positions", _load, "[steps|data] [once|round]", _MANNER
        ),
        LineCommand(
            "write", "write such a program", _write, "FILE [steps|data] [once|round]", _MANNER
        ),
    ),
)
