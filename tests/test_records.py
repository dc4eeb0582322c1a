"""A record of the program's beside the same class as the standard library makes it."""

from __future__ import annotations

import copy
import dataclasses
import inspect
import pickle
import re
from collections.abc import Callable
from dataclasses import FrozenInstanceError, field
from pathlib import Path
from typing import Any

import pytest

import trs80arm
from trs80arm.records import dataclass

KINDS: list[dict[str, bool]] = [
    {},
    {"slots": True},
    {"frozen": True},
    {"frozen": True, "slots": True},
    {"eq": False},
    {"frozen": True, "eq": False},
    {"order": True},
    {"frozen": True, "order": True, "slots": True},
]


def family(decorator: Callable[..., Any], kind: dict[str, bool]) -> dict[str, Any]:
    """Classes with what records have: defaults, what is made anew, what is not compared."""

    class Empty:
        """Nothing."""

    class One:
        """A single field, that may be no number."""

        only: float

    class Pair:
        """Two fields and what hangs on them."""

        left: float
        right: float = 2.0
        named: list[int] = field(default_factory=list)
        note: str = field(default="", compare=False)
        unhashed: int = field(default=0, hash=False)
        hidden: dict[str, int] = field(default_factory=dict, init=False, repr=False, compare=False)
        late: float = field(default=5.0, init=False, repr=False)

        def __post_init__(self) -> None:
            object.__setattr__(self, "late", self.left + self.right)

    class Own:
        """Says itself how it is shown and compared."""

        inside: int

        def __repr__(self) -> str:
            return "own"

        def __eq__(self, other: object) -> bool:
            return True

    class Hashed:
        """Says itself what its hash is."""

        inside: int

        def __hash__(self) -> int:
            return 7

    made = {cls.__name__: decorator(**kind)(cls) for cls in (Empty, One, Pair, Own, Hashed)}

    class Third(made["Pair"]):  # type: ignore[misc]
        """One with more."""

        right: float = 9.0
        more: tuple[int, ...] = ()

    return {**made, "Third": decorator(**kind)(Third)}


def told(ask: Callable[[], Any]) -> Any:
    """What comes of a question, or how it fails."""
    try:
        return ask()
    except Exception as error:
        return type(error), re.sub("test_\\w+|0x[0-9a-f]+", "", str(error))


def answers(made: dict[str, Any]) -> list[Any]:
    """All that can be asked of such classes and of what is made of them."""
    pair, third, one = made["Pair"], made["Third"], made["One"]
    nan = float("nan")
    things = [
        made["Empty"](),
        one(1.0),
        one(nan),
        pair(1.0),
        pair(1.0),
        pair(1.0, 3.0, note="x"),
        pair(1.0, 2.0, [1]),
        pair(left=1.0, unhashed=3),
        third(1.0),
        third(1.0, 9.0, [], "", 0, (4,)),
        third(1.0, 9.0, [], "", 0, (4,)),
        made["Own"](1),
        made["Hashed"](1),
    ]
    found: list[Any] = []
    for thing in things:
        # Names and values, for of two that compare in no way each is equal to itself alone.
        values = [(part.name, getattr(thing, part.name)) for part in dataclasses.fields(thing)]
        found += [
            repr(thing),
            repr(values),
            thing == copy.copy(thing),
            thing == copy.deepcopy(thing),
        ]
        found += [
            repr(copy.deepcopy(thing)),
            repr(told(lambda thing=thing: dataclasses.replace(thing))),
        ]
        hashed = told(lambda thing=thing: hash(thing) == object.__hash__(thing))
        found += [hashed, type(thing).__hash__ is None, type(thing).__doc__]
        found += [getattr(type(thing), "__match_args__", None), hasattr(thing, "__dict__")]
        for other in (*things, 5, None):
            found += [thing == other, thing != other, told(lambda o=other, t=thing: t < o)]
            found += [told(lambda o=other, t=thing: t >= o)]
            both = told(lambda o=other, t=thing: hash(t) == hash(o))
            found.append(both)
        for part in dataclasses.fields(thing):
            for change in (
                lambda t, name=part.name: setattr(t, name, 1),
                lambda t, name=part.name: delattr(t, name),
            ):
                changed = copy.copy(thing)
                found += [told(lambda c=change, t=changed: c(t)), told(lambda t=changed: repr(t))]
    for cls in made.values():
        signature = inspect.signature(cls)
        found += [
            [(p.name, p.kind, p.annotation) for p in signature.parameters.values()],
            [p.default is not p.empty for p in signature.parameters.values()],
            signature.return_annotation,
            cls.__init__.__qualname__.rpartition(".")[2],
            sorted(name for name in vars(cls) if re.fullmatch("__(l|g)[et]__", name)),
        ]
    found += [told(pair), told(lambda: pair(1, nothing=2)), told(lambda: pair(1.0).hidden)]
    found += [pair(1.0).named is pair(1.0).named, pair(1.0).hidden is pair(1.0).hidden]
    return found


@pytest.mark.parametrize("kind", KINDS, ids=lambda kind: "-".join(kind) or "plain")
def test_a_record_is_what_the_standard_library_makes_of_it(kind: dict[str, bool]) -> None:
    ours = answers(family(dataclass, kind))
    theirs = answers(family(dataclasses.dataclass, kind))
    assert len(ours) > 1000
    assert ours == theirs


@dataclass(frozen=True, slots=True)
class Kept:
    """Can be found by its name, as what is pickled has to."""

    single: int
    others: tuple[int, ...] = ()


@dataclass(frozen=True)
class Derived(Kept):
    """With a field, and room for more."""

    more: int = 3


@pytest.mark.parametrize("thing", [Kept(1), Kept(1, (2, 3)), Derived(1, (2,), 4)])
def test_a_frozen_record_with_slots_is_pickled(thing: Kept) -> None:
    for protocol in range(2, pickle.HIGHEST_PROTOCOL + 1):
        again = pickle.loads(pickle.dumps(thing, protocol))
        assert again == thing
        assert type(again) is type(thing)


def test_what_is_derived_from_a_frozen_record_may_have_more() -> None:
    class Loose(Kept):
        pass

    loose: Any = Loose(1)
    loose.more = 5
    assert loose.more == 5
    del loose.more
    with pytest.raises(FrozenInstanceError, match="cannot assign to field 'single'"):
        loose.single = 2
    with pytest.raises(FrozenInstanceError, match="cannot delete field 'single'"):
        del loose.single


def test_one_that_holds_itself_can_be_shown() -> None:
    @dataclass
    class Chain:
        """Holds another."""

        inner: Any = None

    chain = Chain()
    chain.inner = chain
    assert repr(chain).endswith("Chain(inner=...)")


def test_the_whole_program_declares_its_records_so() -> None:
    folder = Path(trs80arm.__file__).parent
    own = re.compile(r"from dataclasses import .*\bdataclass\b|dataclasses\.dataclass\(")
    assert [path.name for path in sorted(folder.rglob("*.py")) if own.search(path.read_text())] == [
        "records.py"
    ]
