"""Dataclasses that cost little to declare: of their methods only `__init__` is compiled.

The standard library writes and compiles up to ten methods for a class when its module is imported,
which was a third of what the program needed to start. `dataclass` here takes the options that this
program uses and gives the same class but for that: what compares, hashes, shows and guards a record
are functions that go by the names of its fields, compiled once for all of them.
"""

from __future__ import annotations

import dataclasses
import operator
from collections.abc import Callable
from dataclasses import MISSING, FrozenInstanceError
from reprlib import recursive_repr
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from dataclasses import dataclass as dataclass
else:

    def dataclass(cls=None, /, *, eq=True, order=False, frozen=False, slots=False):
        """What `dataclasses.dataclass` is, for these of its options."""

        def declared(cls):
            return _declared(cls, eq, order, frozen, slots)

        return declared if cls is None else declared(cls)


Record = type[Any]
_AT_EACH_CALL: Any = object()
"""Stands as default where one is made for each record."""
_ORDERS = ("__lt__", "__le__", "__gt__", "__ge__")


def _declared(cls: Record, eq: bool, order: bool, frozen: bool, slots: bool) -> Record:
    # What the class says itself is asked before anything is put into it.
    own = {name: thing for name, thing in vars(cls).items() if callable(thing) or thing is None}
    cls = dataclasses.dataclass(init=False, repr=False, eq=False, slots=slots)(cls)
    fields = dataclasses.fields(cls)
    values = _getter([field.name for field in fields if field.compare])
    methods: dict[str, Any] = {"__repr__": _shows([field.name for field in fields if field.repr])}
    if "__init__" not in own:
        methods["__init__"] = _begins(cls, frozen, slots)
    if eq:
        methods["__eq__"] = _equals(values)
    if order:
        methods |= {name: _orders(name, values) for name in _ORDERS}
    if frozen:
        names = [field.name for field in fields]
        methods |= _guards(cls, frozenset(names))
        if slots or hasattr(cls, "__setstate__"):
            methods |= _states(names)
    for name in own.keys() & methods.keys():
        del methods[name]
    # Python itself says that what compares in its own way has no hash.
    if eq and (own.get("__hash__") is None and ("__hash__" not in own or "__eq__" in own)):
        hashed = [f.name for f in fields if (f.compare if f.hash is None else f.hash)]
        methods["__hash__"] = _hashes(_getter(hashed)) if frozen else None
    for name, method in methods.items():
        if method is not None:
            method.__name__, method.__qualname__ = name, f"{cls.__qualname__}.{name}"
            method.__module__ = cls.__module__
        setattr(cls, name, method)
    return cls


def _getter(names: list[str]) -> Callable[[Any], tuple[Any, ...]]:
    """What gives the values of fields."""
    if not names:
        return lambda record: ()
    get = operator.attrgetter(*names)
    # Of one field it gives the value itself.
    return get if len(names) > 1 else lambda record: (get(record),)


def _begins(cls: Record, frozen: bool, slots: bool) -> Callable[..., None]:
    """The one method that is compiled, for it is called far more often than all others."""
    known: dict[str, Any] = {"_set": object.__setattr__, "_AT_EACH_CALL": _AT_EACH_CALL}
    given, lines, types = ["self"], [], {}
    for field in dataclasses.fields(cls):
        name, default, value = field.name, f"_default_{field.name}", field.name
        if field.default_factory is not MISSING:
            known[default] = field.default_factory
            given_as, value = f"{name}=_AT_EACH_CALL", f"{default}()"
            if field.init:
                value += f" if {name} is _AT_EACH_CALL else {name}"
        elif field.default is not MISSING:
            known[default] = field.default
            given_as = f"{name}={default}"
            if not field.init:
                # Without slots the class itself has it.
                value = default if slots else ""
        else:
            given_as, value = name, name if field.init else ""
        if field.init:
            given.append(given_as)
            types[name] = field.type
        if value:
            lines.append(f"_set(self, {name!r}, {value})" if frozen else f"self.{name} = {value}")
    if hasattr(cls, "__post_init__"):
        lines.append("self.__post_init__()")
    made: dict[str, Any] = {}
    exec(f"def __init__({', '.join(given)}):\n " + "\n ".join(lines or ["pass"]), known, made)
    begins: Callable[..., None] = made["__init__"]
    begins.__annotations__ = {**types, "return": None}
    return begins


def _shows(names: list[str]) -> Callable[..., Any]:
    @recursive_repr()
    def __repr__(self: Any) -> str:  # noqa: N807
        shown = ", ".join([f"{name}={getattr(self, name)!r}" for name in names])
        return f"{type(self).__qualname__}({shown})"

    return __repr__


def _equals(values: Callable[[Any], tuple[Any, ...]]) -> Callable[..., Any]:
    def __eq__(self: Any, other: object) -> bool:  # noqa: N807
        if other.__class__ is self.__class__:
            return values(self) == values(other)
        return NotImplemented

    return __eq__


def _orders(name: str, values: Callable[[Any], tuple[Any, ...]]) -> Callable[..., Any]:
    compare = getattr(operator, name)

    def order(self: Any, other: object) -> Any:
        if other.__class__ is self.__class__:
            return compare(values(self), values(other))
        return NotImplemented

    return order


def _hashes(values: Callable[[Any], tuple[Any, ...]]) -> Callable[..., Any]:
    def __hash__(self: Any) -> int:  # noqa: N807
        return hash(values(self))

    return __hash__


def _guards(cls: Record, names: frozenset[str]) -> dict[str, Any]:
    """What keeps a frozen record as it is."""

    def __setattr__(self: Any, name: str, value: object) -> None:  # noqa: N807
        if type(self) is cls or name in names:
            raise FrozenInstanceError(f"cannot assign to field {name!r}")
        super(cls, self).__setattr__(name, value)

    def __delattr__(self: Any, name: str) -> None:  # noqa: N807
        if type(self) is cls or name in names:
            raise FrozenInstanceError(f"cannot delete field {name!r}")
        super(cls, self).__delattr__(name)

    return {"__setattr__": __setattr__, "__delattr__": __delattr__}


def _states(names: list[str]) -> dict[str, Any]:
    """What copies and pickles ask of a frozen record that has slots."""
    values = _getter(names)

    def __getstate__(self: Any) -> tuple[Any, ...]:  # noqa: N807
        return values(self)

    def __setstate__(self: Any, state: tuple[Any, ...]) -> None:  # noqa: N807
        for name, value in zip(names, state, strict=True):
            object.__setattr__(self, name, value)

    return {"__getstate__": __getstate__, "__setstate__": __setstate__}
