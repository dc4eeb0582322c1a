"""The debugger in lines: stopping, going on and back, looking, changing, saved states."""

from __future__ import annotations

import re
from collections.abc import Callable
from datetime import datetime

from trs80arm import inspection
from trs80arm.desk.debugger import Reason
from trs80arm.desk.memory_view import ROW, parse_address, poke_statement, row_text
from trs80arm.desk.states import QUICK
from trs80arm.desk.watches import LATCH_NAMES
from trs80arm.inspection import MOST_ELEMENTS, line_text
from trs80arm.plain.command import Group, LineCommand, Sitting

AROUND = 3
"""Lines shown before and behind one."""
MOST_TIMES = 1000
"""Steps that one command does at most."""
MOST_ROWS = 64
"""Rows of memory that one command shows at most."""


def tell_stop(sitting: Sitting) -> bool:
    """Say where the machine has come to stand, if that was not said yet; whether it stands."""
    if sitting.debugger.new_stop() is not None:
        _tell_where(sitting)
    return sitting.debugger.stop is not None


def _tell_where(sitting: Sitting) -> None:
    """Where the machine stands and why, and at which T-state."""
    stop = sitting.debugger.stop
    if stop is not None:
        rig = sitting.session.rig
        past = ", in the past" if sitting.session.timeline.behind else ""
        sitting.tell(f"{stop.text}\nT-state {rig.clock.now} ({rig.time:.3f} s{past})")
    elif (spot := sitting.debugger.spot) is not None:
        sitting.tell(f"Under way: {spot}")
    else:
        sitting.tell("No program runs.")


def _trying(sitting: Sitting, do: Callable[[], object]) -> bool:
    """Do it, or say why it cannot be done."""
    try:
        do()
    except (ValueError, LookupError) as error:
        text = str(error.args[0])
        sitting.tell(f"{text[:1].upper()}{text[1:]}.")
        return False
    return True


# -- stopping and going ----------------------------------------------------------------------------


def _break(sitting: Sitting, words: str) -> None:
    points = sitting.debugger.breakpoints
    if words:
        line, _, condition = re.sub(r"(?i)\bif\b", "\n", words, count=1).partition("\n")
        if _trying(sitting, lambda: sitting.debugger.set(_line(line), condition)):
            sitting.tell(f"Stops before {words}.")
        return
    rows = [f"{line}{f' if {when.text}' if when else ''}" for line, when in points.items()]
    sitting.tell("\n".join(rows) or "No breakpoints.")


def _clear(sitting: Sitting, words: str) -> None:
    if _trying(sitting, lambda: sitting.debugger.clear(_line(words) if words else None)):
        sitting.tell("Cleared.")


def _watch(sitting: Sitting, words: str) -> None:
    debugger = sitting.debugger
    if not words:
        rows = [f"{each.name} = {each.value}" for each in debugger.watches.values()]
        sitting.tell("\n".join(rows) or "Nothing is watched.")
        return
    if _trying(sitting, lambda: debugger.watch(words)):
        sitting.tell(f"Stops behind a change of {words}.")


def _unwatch(sitting: Sitting, words: str) -> None:
    if _trying(sitting, lambda: sitting.debugger.unwatch(words)):
        sitting.tell(f"{words.strip()} is not watched any more.")


def _walk(sitting: Sitting, step: Callable[[], None], words: str) -> None:
    """Step so often, or until there is something else to stop for."""
    debugger = sitting.debugger
    for _ in range(_times(sitting, words)):
        if not _trying(sitting, step):
            return
        stop = debugger.stop
        if stop is None:
            if debugger.waits_to_stop and sitting.session.rig.basic.next_address is None:
                sitting.tell("No program runs; it stops before the first statement of the next.")
            return
        if stop.reason in (Reason.ENDED, Reason.BREAKPOINT, Reason.WATCH):
            return


def _until(sitting: Sitting, words: str) -> None:
    _trying(sitting, lambda: sitting.debugger.run_to(_line(words)))


def _go(sitting: Sitting, words: str) -> None:
    sitting.debugger.go()


def _back(sitting: Sitting, words: str) -> None:
    if words == "stop":
        if not sitting.debugger.back_to_stop():
            sitting.tell("Nothing is known of an earlier stop.")
        return
    for _ in range(_times(sitting, words)):
        if not sitting.debugger.back():
            sitting.tell("Nothing is known of an earlier statement.")
            return


def _times(sitting: Sitting, words: str) -> int:
    """How often, 1 if nothing is said; 0 after having said that it is no number."""
    text = words or "1"
    if text.isdecimal() and 1 <= int(text) <= MOST_TIMES:
        return int(text)
    sitting.tell(f"How often? A number from 1 to {MOST_TIMES}.")
    return 0


def _line(text: str) -> int:
    if not text.strip().isdecimal():
        raise ValueError("which line? A number")
    return int(text)


# -- looking and changing --------------------------------------------------------------------------


def _print(sitting: Sitting, words: str) -> None:
    rig = sitting.session.rig
    names = [name.strip(",") for name in re.findall(r"[^\s(]+(?:\([^)]*\))?", words)]
    if not names:
        sitting.tell("Which variable? As .print A$ B(1,2)")
    for name in names:

        def tell(name: str = name) -> None:
            sitting.tell(f"{name.upper()} = {inspection.value_text(rig, name)}")

        _trying(sitting, tell)


def _variables(sitting: Sitting, words: str) -> None:
    found = inspection.elements(sitting.session.rig, MOST_ELEMENTS)
    rows = [f"{variable.name} = {variable.value.strip()}" for variable in found]
    sitting.tell("\n".join(rows) or "No variables.")


def _stack(sitting: Sitting, words: str) -> None:
    frames = inspection.open_frames(sitting.session.rig)
    sitting.tell("\n".join(frames) or "No FOR or GOSUB is open.")


def _change(sitting: Sitting, statement: Callable[[], str]) -> None:
    if _trying(sitting, lambda: sitting.session.rig.change(statement())):
        sitting.tell("Changed.")


def _memory(sitting: Sitting, words: str) -> None:
    word, _, count = words.partition(" ")
    rows = min(max(int(count), 1), MOST_ROWS) if count.strip().isdecimal() else 4
    peek = sitting.session.rig.memory.peek

    def tell() -> None:
        first = parse_address(word or "0")
        sitting.tell("\n".join(row_text(peek, first + ROW * row) for row in range(rows)))

    _trying(sitting, tell)


def _list(sitting: Sitting, words: str) -> None:
    """The lines around one, or around where the program is: `*` a breakpoint, `>` next."""
    lines = sitting.session.rig.basic.program.lines()
    spot = sitting.debugger.spot
    now = None if spot is None else spot.line
    wanted = int(words) if words.isdecimal() else now
    places = [place for place, line in enumerate(lines) if wanted and line[0] >= wanted]
    place = places[0] if places else 0
    rows = [
        ("*" if line[0] in sitting.debugger.breakpoints else " ")
        + (">" if line[0] == now else " ")
        + line_text(line)
        for line in lines[max(0, place - AROUND) : place + AROUND + 1]
    ]
    sitting.tell("\n".join(rows) or "No program in memory.")


# -- saved states ----------------------------------------------------------------------------------


def _states(sitting: Sitting, words: str) -> None:
    rows = [
        f"{state.name}  {datetime.fromtimestamp(state.saved):%Y-%m-%d %H:%M}  {state.line}".rstrip()
        for state in sitting.states.all()
    ]
    sitting.tell("\n".join(rows) or "No saved states.")


def _keep(sitting: Sitting, words: str) -> None:
    name = words or QUICK
    if _trying(sitting, lambda: sitting.states.save(name, sitting.session)):
        sitting.tell(f"State {name} is saved.")


def _take(sitting: Sitting, words: str) -> None:
    name = words or QUICK
    if _trying(sitting, lambda: sitting.states.load(name, sitting.session)):
        sitting.tell(f"State {name} is loaded.")
        sitting.debugger.stand_here()


def _drop(sitting: Sitting, words: str) -> None:
    if _trying(sitting, lambda: sitting.states.delete(words)):
        sitting.tell(f"State {words} is removed.")


_OFTEN = "With a number: so often."

GROUP = Group(
    "The debugger",
    (
        LineCommand(
            "break",
            "stop before a line; alone: which ones",
            _break,
            "[LINE [if I>10]]",
            "The condition compares a variable with a number, a text in quotes, or a variable.",
        ),
        LineCommand(
            "clear", "do not stop there any more; alone: nowhere, for nothing", _clear, "[LINE]"
        ),
        LineCommand(
            "watch",
            "stop behind a change; alone: of what",
            _watch,
            "[I|B$(2)|latch base|3C00H]",
            f"The latches are {', '.join(LATCH_NAMES)}. A motion comes to its end first.",
        ),
        LineCommand("unwatch", "do not stop for that any more", _unwatch, "I"),
        LineCommand(
            "step",
            "one statement, into GOSUB",
            lambda sitting, words: _walk(sitting, sitting.debugger.into, words),
            "[NUMBER]",
            _OFTEN,
        ),
        LineCommand(
            "over",
            "one statement, with all of a GOSUB",
            lambda sitting, words: _walk(sitting, sitting.debugger.over, words),
            "[NUMBER]",
            _OFTEN,
        ),
        LineCommand(
            "out",
            "on until the GOSUB has returned",
            lambda sitting, words: _walk(sitting, sitting.debugger.out, words),
        ),
        LineCommand("until", "on to a line", _until, "LINE"),
        LineCommand("go", "let the machine go on", _go),
        LineCommand(
            "back",
            "one statement back in time; stop: to the breakpoint before",
            _back,
            "[NUMBER|stop]",
            _OFTEN,
        ),
        LineCommand("where", "where the machine stands", lambda sitting, _: _tell_where(sitting)),
        LineCommand("list", "lines around that one, or another", _list, "[LINE]"),
        LineCommand("print", "what variables hold", _print, "A$ B(1,2)"),
        LineCommand("vars", "all variables", _variables),
        LineCommand("stack", "open FOR and GOSUB", _stack),
        LineCommand(
            "let",
            "change a variable",
            lambda sitting, words: _change(sitting, lambda: words),
            "A=5",
        ),
        LineCommand("memory", "rows of memory", _memory, "ADDRESS [ROWS]"),
        LineCommand(
            "poke",
            "change memory",
            lambda sitting, words: _change(sitting, lambda: poke_statement(words)),
            "ADDRESS,VALUE",
            "Both as 15360 or 3C00H.",
        ),
        LineCommand("states", "saved states", _states),
        LineCommand("keep", f"save the whole machine; alone: as {QUICK}", _keep, "[NAME]"),
        LineCommand("take", "load a saved state", _take, "[NAME]"),
        LineCommand("drop", "remove a saved state", _drop, "NAME"),
    ),
)
