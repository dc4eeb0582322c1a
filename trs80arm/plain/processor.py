"""The processor in lines: registers, instructions, breakpoints in machine code, steps."""

from __future__ import annotations

from collections.abc import Callable

from trs80arm.desk.debugger import Reason
from trs80arm.desk.memory_view import parse_address
from trs80arm.plain.command import Group, LineCommand, Sitting

INSTRUCTIONS = 8
"""Instructions that one command tells."""
MOST_TIMES = 1000
"""Steps that one command does at most."""
STACK_WORDS = 6


def _processor(sitting: Sitting, _: str) -> None:
    if missing := sitting.session.rig.processor.missing:
        sitting.tell(f"{missing[:1].upper()}{missing[1:]}.")
    words = "  ".join(f"{word:04X}" for word in sitting.code.stack(STACK_WORDS))
    sitting.tell("\n".join([*sitting.code.registers(), f"stack  {words}"]))


def _address(sitting: Sitting, words: str) -> int | None:
    """The address that was typed; None after having said that it is none."""
    try:
        return parse_address(words)
    except ValueError as error:
        text = str(error)
        sitting.tell(f"{text[:1].upper()}{text[1:]}.")
        return None


def _code(sitting: Sitting, words: str) -> None:
    first = _address(sitting, words) if words else sitting.code.pc
    if first is not None:
        found = sitting.code.listing(first, INSTRUCTIONS)
        sitting.tell("\n".join(sitting.code.row(each) for each in found))


def _break(sitting: Sitting, words: str) -> None:
    code = sitting.code
    if not words:
        rows = [code.row(code.instruction(address)) for address in sorted(code.breakpoints)]
        sitting.tell("\n".join(rows) or "No breakpoints in machine code.")
        return
    address = _address(sitting, words)
    if address is not None:
        stops = code.toggle(address)
        sitting.tell(f"{'Stops at' if stops else 'Does not stop any more at'} {address:04X}H.")


def _walk(sitting: Sitting, step: Callable[[], None], words: str) -> None:
    times = words or "1"
    if not times.isdecimal() or not 1 <= int(times) <= MOST_TIMES:
        sitting.tell(f"How often? A number from 1 to {MOST_TIMES}.")
        return
    debugger = sitting.debugger
    for _ in range(int(times)):
        step()
        stop = debugger.stop
        if stop is None:
            if debugger.session.rig.basic.next_address is None:
                sitting.tell("No code runs; it stops before the first instruction of the next.")
            return
        if stop.reason is not Reason.CODE or stop.text.startswith("Breakpoint"):
            return


GROUP = Group(
    "The processor",
    (
        LineCommand("cpu", "registers and stack", _processor),
        LineCommand("code", "instructions from there, or an address", _code, "[ADDRESS]"),
        LineCommand(
            "codebreak",
            "stop before an instruction, or no more; alone: where",
            _break,
            "[ADDRESS]",
            "As 28672 or 7000H.",
        ),
        LineCommand(
            "codestep",
            "one instruction, into CALL",
            lambda sitting, words: _walk(sitting, sitting.code.into, words),
            "[NUMBER]",
        ),
        LineCommand(
            "codeover",
            "one instruction, with all of a CALL",
            lambda sitting, words: _walk(sitting, sitting.code.over, words),
            "[NUMBER]",
        ),
        LineCommand(
            "codeout",
            "on until the subroutine has returned",
            lambda sitting, _: _walk(sitting, sitting.code.out, ""),
        ),
    ),
)
