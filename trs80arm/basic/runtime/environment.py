"""The names that compiled statements know."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from trs80arm.basic.errors import BasicError, Code
from trs80arm.basic.numbers import convert, double, integer, single
from trs80arm.basic.runtime.arithmetic import Arithmetic
from trs80arm.basic.runtime.data import DataReader
from trs80arm.basic.runtime.flow import Flow
from trs80arm.basic.runtime.hardware import Hardware
from trs80arm.basic.runtime.printing import Printing
from trs80arm.basic.runtime.storage import Storage
from trs80arm.basic.runtime.strings import StringFunctions

if TYPE_CHECKING:
    from trs80arm.basic.interpreter import Interpreter


def fail(code: int) -> None:
    """Raise a Level II error."""
    raise BasicError(Code(code))


def byte(value: int) -> int:
    """An integer that must be 0..255; FC."""
    if not 0 <= value < 256:
        raise BasicError(Code.FC)
    return value


def below(value: int, limit: int) -> int:
    """A coordinate that must be below a limit; FC."""
    if value >= limit:
        raise BasicError(Code.FC)
    return value


def subscript(value: object) -> int:
    """A number rounded down to 0..32767 (1E45H); OV, FC."""
    number = convert.to_integer(value)
    if number < 0:
        raise BasicError(Code.FC)
    return number


def bad(value: object, dim: int) -> int:
    """A subscript that is outside its dimension, or not an integer yet; OV, FC, BS."""
    number = subscript(value)
    if number >= dim:
        raise BasicError(Code.BS)
    return number


def narrow(value: float) -> int | float:
    """A whole single as an integer if it fits into one."""
    return int(value) if -32768.0 <= value < 32768.0 else value


def always(_left: object, _right: object) -> bool:
    """The relation `<=>`."""
    return True


def integer_step(value: int, step: int) -> int:
    """The next value of an integer loop variable; OV."""
    value += step
    if not -32769 < value < 32768:
        raise BasicError(Code.OV)
    return value


class Runtime:
    """The parts of the runtime of one interpreter."""

    def __init__(self, basic: Interpreter) -> None:
        self._basic = basic
        self.printing = Printing(basic)
        self.flow = Flow(basic)
        self.storage = Storage(basic)
        self.strings = StringFunctions(basic)
        self.data = DataReader(basic)
        self.hardware = Hardware(basic)
        self.arithmetic = Arithmetic(basic)

    def environment(self) -> dict[str, Any]:
        """All names for compiled statements."""
        basic = self._basic
        names: dict[str, Any] = {
            "clock": basic.clock,
            "frames": basic.control.frames,
            "memory_room": basic.room,
            "BasicError": BasicError,
            "fail": fail,
            "byte": byte,
            "below": below,
            "subscript": subscript,
            "bad": bad,
            "always": always,
            "narrow": narrow,
            "floor": integer.floor_to_integer,
            "to_single": convert.to_single,
            "to_double": convert.to_double,
            "negate": convert.negate,
            "absolute": convert.absolute,
            "sign": convert.sign,
            "any_floor": convert.int_,
            "fix": convert.fix,
            "compare": convert.compare,
            "single_floor": single.floor,
            "integer_step": integer_step,
            "double_compare": double.compare,
            "double_negate": double.negate,
            "literal": basic.strings.literal,
            "concatenate": basic.strings.concatenate,
        }
        for operation in ("add", "sub", "mul", "div"):
            names[operation] = getattr(single, operation)
            names[f"any_{operation}"] = getattr(convert, operation)
            names[f"integer_{operation}"] = getattr(
                convert if operation == "div" else integer, operation
            )
        for part in (
            self.printing,
            self.flow,
            self.storage,
            self.strings,
            self.data,
            self.hardware,
            self.arithmetic,
        ):
            names.update(part.names())
        return names
