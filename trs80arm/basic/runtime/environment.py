"""The names that compiled statements know: a list, and what stands behind each name.

Generated text may use these names and no others: the emitter looks at every function that it
builds. A routine is found by its name among the parts of the runtime; what a row of `words` calls
need not be listed here again.
"""

from __future__ import annotations

from functools import cache
from typing import Any, Final

from trs80arm.basic import words
from trs80arm.basic.errors import BasicError
from trs80arm.basic.numbers import convert, double, integer, single
from trs80arm.basic.runtime import checks
from trs80arm.basic.runtime.arithmetic import Arithmetic
from trs80arm.basic.runtime.data import DataReader
from trs80arm.basic.runtime.flow import Flow
from trs80arm.basic.runtime.hardware import Hardware
from trs80arm.basic.runtime.known import known_functions
from trs80arm.basic.runtime.part import Part
from trs80arm.basic.runtime.printing import Printing
from trs80arm.basic.runtime.storage import Storage
from trs80arm.basic.runtime.strings import StringFunctions
from trs80arm.basic.state import State

CHARACTERS: Final = tuple(bytes((code,)) for code in range(256))
"""What CHR$ gives, by the code."""
FUNCTIONS: Final[dict[str, Any]] = {
    # Python's own, and the error that a tape statement holds back.
    "abs": abs,
    "float": float,
    "int": int,
    "len": len,
    "BasicError": BasicError,
    # Errors and checks.
    "fail": checks.fail,
    "byte": checks.byte,
    "from_one": checks.from_one,
    "below": checks.below,
    "subscript": checks.subscript,
    "bad": checks.bad,
    "always": checks.always,
    # Conversions.
    "floor": integer.floor_to_integer,
    "to_kind": convert.to_kind,
    "to_single": convert.to_single,
    "to_double": convert.to_double,
    "narrow": single.narrow,
    # Numbers whose types are known only when they are there.
    "negate": convert.negate,
    "absolute": convert.absolute,
    "sign": convert.sign,
    "any_floor": convert.int_,
    "fix": convert.fix,
    "compare": convert.compare,
    "any_add": convert.add,
    "any_sub": convert.sub,
    "any_mul": convert.mul,
    "any_div": convert.div,
    # Integers.
    "integer_add": integer.add,
    "integer_sub": integer.sub,
    "integer_mul": integer.mul,
    "integer_step": integer.step,
    # Singles, where the short way in line does not do; products and quotients are among the parts.
    "add": single.add,
    "sub": single.sub,
    # Doubles; what takes its time by the operands is among the parts.
    "double_compare": double.compare,
    "double_negate": double.negate,
}
"""Names of functions that need no machine."""

ROUTINES: Final[dict[type[Part], tuple[str, ...]]] = {
    Printing: (
        *("to_screen", "to_printer", "print_at", "print_newline", "print_comma", "print_tab"),
        *("print_string", "print_number", "print_anything"),
        *("using", "using_literal", "using_number", "using_string", "using_end"),
        *("tape_number", "tape_string"),
    ),
    Flow: (
        *("room", "open_subroutine", "drop_loop", "open_loop", "step_loop", "other_step"),
        "goes_on",
        *("set_trap", "end_handling", "resume_again", "resume_next"),
        *("end_of_text", "end_program", "stop_program", "now_at", "leave"),
    ),
    Storage: (
        *("create", "place", "element", "element_address", "scalar_address"),
        *("scalar_reference", "element_reference", "clear_all", "clear_strings"),
    ),
    StringFunctions: (
        *("assign", "string_equal", "string_compare", "alike", "order"),
        *("first_code", "free_strings", "shown", "text_at"),
    ),
    DataReader: (
        *("begin_read", "end_item", "end_read", "read_number", "read_string"),
        *("begin_input", "begin_tape_input"),
    ),
    Hardware: (
        *("tape_unit", "begin_tape_print", "user_value"),
        *("arm_step", "arm_close", "arm_set", "arm_reset", "arm_read"),
    ),
    Arithmetic: (
        *("mul", "div"),
        *("double_add", "double_sub", "double_mul", "double_div"),
    ),
}
"""The parts of the runtime with their routines, beside those that a row of `words` calls."""


class NamesError(Exception):
    """The list of names and what there is do not agree: a mistake of ours, found at the start."""


def environment(state: State) -> dict[str, Any]:
    """All names for the compiled statements of one machine.

    Raises:
        NamesError: as `_routines`.
    """
    names: dict[str, Any] = {
        "__builtins__": {},
        "clock": state.clock,
        "frames": state.control.frames,
        "memory_room": state.room,
        "literal": state.strings.literal,
        "concatenate": state.strings.concatenate,
        "characters_of": state.strings.characters_of,
        "space": state.strings,
        "view": state.memory.view,
        "ram_end": state.memory.top,
        "characters": CHARACTERS,
        **FUNCTIONS,
        **known_functions(state.clock),
    }
    for kind, routines in _routines(frozenset(names), words.CALLS):
        part = kind(state)
        names.update((name, getattr(part, name)) for name in routines)
    return names


@cache
def _routines(others: frozenset[str], called: frozenset[str]) -> list[tuple[type[Part], list[str]]]:
    """The parts of the runtime with the names of all their routines: the same for every machine.

    Args:
        others: the names that stand for something else.
        called: what rows of `words` call.

    Raises:
        NamesError: a name that stands for nothing or for two things, or a routine without a name.
    """
    found = []
    names = set(others)
    for kind, listed in ROUTINES.items():
        routines = {name for name in dir(kind) if not name.startswith("_")}
        missing = set(listed) - routines
        unlisted = routines - set(listed) - called
        twice = routines & names
        if missing or unlisted or twice:
            raise NamesError(f"{kind.__name__}: {sorted(missing | unlisted | twice)}")
        names |= routines
        found.append((kind, sorted(routines)))
    if called - names:
        raise NamesError(f"words: {sorted(called - names)}")
    return found
