"""Bench files: what they can say, and the one line that a bad one gets."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.arm.refusals import refusal
from trs80arm.arm import BenchError, MiniMover, benchfile

PROGRAMS = Path(__file__).parents[2] / "programs"
DOCS = Path(__file__).parents[2] / "docs" / "arm.md"


@pytest.mark.parametrize("path", sorted(PROGRAMS.glob("*.toml")), ids=lambda p: p.stem)
def test_every_bench_beside_a_program_can_be_set_up(path: Path) -> None:
    assert MiniMover(bench=benchfile.load(path)).inputs(0) & 1


def test_the_example_of_the_manual_is_a_bench() -> None:
    text = DOCS.read_text(encoding="utf-8")
    example = text.split("```toml\n", 1)[1].split("```", 1)[0]
    bench = benchfile.parse(example)
    assert bench.parts
    assert bench.feeders
    assert bench.trays
    assert len(bench.sensors) == 3
    assert [device.title for device in bench.cell.devices] == ["turntable"]
    assert bench.start is not None
    MiniMover(bench=bench)


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("[[part]]\nsize=[1,1,1]", "b.toml: part[1].at: expected 2 numbers from -60 to 60"),
        ("[[part]]\nat=[8,0]", "b.toml: part[1].size: expected 3 numbers from 0.1 to 60"),
        (
            "[[part]]\nat=[8,0]\nsize=[1,1,1]\nweigth=3",
            "b.toml: part[1].weigth: expected nothing by that name; the keys here are "
            "name, at, bottom, turn, tilt, roll, shape, size, weight, friction",
        ),
        (
            "[[part]]\nat=[8,0]\nsize=[1,1,1]\nweight='heavy'",
            "b.toml: part[1].weight: expected a number from 0.01 to 1600",
        ),
        (
            "[[part]]\nat=[8,0]\nsize=[1,1,1]\nweight=nan",
            "b.toml: part[1].weight: expected a number from 0.01 to 1600",
        ),
        (
            "[[part]]\nat=[8,0]\nsize=[1,1,1]\n[[part]]\nat=[8.5,0]\nsize=[1,1,1]",
            "b.toml: part[2].at: expected a free place; it overlaps part 1",
        ),
        (
            "[[part]]\nat=[0,0]\nsize=[1,1,1]",
            "b.toml: part[1].at: expected a free place; it overlaps base",
        ),
        (
            "[[beam]]\nbit=0\nfrom=[0,0,0]\nto=[1,1,1]",
            "b.toml: beam[1].bit: expected a whole number from 1 to 3",
        ),
        ("[part]\nat=[1,2]", "b.toml: part: expected tables, written [[part]]"),
        (
            "[[turntable]]\nat=[1,2]",
            "b.toml: turntable[1].radius: expected a number from 0.1 to 60",
        ),
        (
            "colour='red'",
            "b.toml: colour: expected nothing by that name; the keys here are name, "
            "arm, part, feeder, tray, obstacle, conveyor, machine, turntable, selector, proximity, "
            "tactile, beam, force, home, goal",
        ),
        (
            "[arm]\nat=[30,0,0]",
            "b.toml: arm.at: expected a pose within reach; the wrist is "
            "farther from the shoulder than the two links are long",
        ),
        (
            "[[part]]\nat=[5,0]\nsize=[1,1,1]",
            "b.toml: arm.at: expected a free place for the hand; part 1 is in the way",
        ),
        (
            "[arm]\nat=[10,0,6]\npitch=90",
            "b.toml: arm.at: expected a pose within the stops; it is beyond pitch +-90",
        ),
        ("part = [3]", "b.toml: part[1]: expected a table"),
    ],
)
def test_a_bad_bench_gets_one_line_with_file_key_and_what_was_expected(
    text: str, line: str
) -> None:
    assert refusal(text) == line


SHAPED = {
    "box": {"size": "[1, 1, 1]"},
    "cylinder": {"diameter": "1", "height": "1"},
    "disc": {"diameter": "1", "height": "1"},
    "prism": {"outline": "[[-1, -1], [1, -1], [0, 1]]", "height": "1"},
    "tray": {"size": "[2, 2, 1]", "wall": "0.1"},
    "holed": {"size": "[2, 2, 1]", "hole": "[0.5, 0.5]"},
    "pegs": {
        "size": "[2, 2, 0.25]",
        "pegs": "[[0, 0]]",
        "peg_diameter": "0.3",
        "peg_height": "0.5",
    },
}
LENGTH = "a number from 0.1 to 60"
SIZE = "3 numbers from 0.1 to 60"
POINTS = "points [x, y], each from -60 to 60"
EXPECTED = {
    ("box", "size"): SIZE,
    ("cylinder", "diameter"): LENGTH,
    ("cylinder", "height"): LENGTH,
    ("disc", "diameter"): LENGTH,
    ("disc", "height"): LENGTH,
    ("prism", "outline"): f"3 to 24 {POINTS}",
    ("prism", "height"): LENGTH,
    ("tray", "size"): SIZE,
    ("tray", "wall"): "a number from 0.02 to 0.98",
    ("holed", "size"): SIZE,
    ("holed", "hole"): "2 numbers from 0.02 to 60",
    ("pegs", "size"): SIZE,
    ("pegs", "pegs"): f"1 to 32 {POINTS}",
    ("pegs", "peg_diameter"): LENGTH,
    ("pegs", "peg_height"): LENGTH,
}
"""What each key that describes a shape wants."""
COMMON = {
    "bottom": "a number from 0 to 60",
    "turn": "a number from -360 to 360",
    "tilt": "a number from -360 to 360",
    "roll": "a number from -360 to 360",
    "weight": "a number from 0.01 to 1600",
    "friction": "a number from 0.01 to 10",
}
NONSENSE = ["'x'", "true", "nan", "inf", "-1000", "1e9", "[1]", "[true, true, true]", "{a = 1}"]


def thing(head: str, shape: str, **keys: str) -> str:
    """A table of a bench file."""
    described = {"at": "[10, 3]", "shape": f"'{shape}'", **SHAPED.get(shape, {}), **keys}
    return f"[[{head}]]\n" + "\n".join(f"{key} = {value}" for key, value in described.items())


@pytest.mark.parametrize("head", ["part", "feeder", "obstacle"])
@pytest.mark.parametrize("shape", SHAPED)
def test_a_thing_of_any_shape_stands_on_the_bench(head: str, shape: str) -> None:
    assert complaint(thing(head, shape)) == ""


@pytest.mark.parametrize(("shape", "key"), EXPECTED)
@pytest.mark.parametrize("value", NONSENSE)
def test_a_shapes_key_that_cannot_be_is_named_with_what_it_wants(
    shape: str, key: str, value: str
) -> None:
    for head in ("part", "feeder", "obstacle"):
        line = complaint(thing(head, shape, **{key: value}))
        assert line == f"bench: {head}[1].{key}: expected {EXPECTED[shape, key]}"


@pytest.mark.parametrize(("shape", "key"), EXPECTED)
def test_a_shapes_key_that_lacks_is_named(shape: str, key: str) -> None:
    text = "\n".join(
        line for line in thing("part", shape).split("\n") if not line.startswith(f"{key} =")
    )
    assert complaint(text) == f"bench: part[1].{key}: expected {EXPECTED[shape, key]}"


@pytest.mark.parametrize("key", COMMON)
@pytest.mark.parametrize("value", NONSENSE)
def test_what_all_parts_have_in_common_is_checked_too(key: str, value: str) -> None:
    line = complaint(thing("part", "box", **{key: value}))
    assert line == f"bench: part[1].{key}: expected {COMMON[key]}"


@pytest.mark.parametrize(
    ("shape", "key", "value", "line"),
    [
        ("ball", "weight", "1", f"shape: expected one of {', '.join(SHAPED)}"),
        (
            "box",
            "wall",
            "0.1",
            "wall: expected nothing by that name; the keys here are "
            "name, at, bottom, turn, tilt, roll, shape, size, weight, friction",
        ),
        ("holed", "hole", "[1.99, 0.5]", "hole: expected a hole smaller than the block"),
        ("pegs", "pegs", "[[1, 0]]", "pegs: expected pegs that stand on the board"),
        ("pegs", "pegs", "[[0, 0], [0.2, 0]]", "pegs: expected pegs that are not in each other"),
        ("tray", "wall", "1.5", "wall: expected a number from 0.02 to 0.98"),
        ("box", "friction", "0", "friction: expected a number from 0.01 to 10"),
        ("box", "weight", "0", "weight: expected a number from 0.01 to 1600"),
        ("box", "bottom", "-0.1", "bottom: expected a number from 0 to 60"),
        ("box", "tilt", "361", "tilt: expected a number from -360 to 360"),
        ("box", "name", "''", "name: expected a name"),
    ],
)
def test_a_thing_that_cannot_be_gets_one_line(shape: str, key: str, value: str, line: str) -> None:
    assert complaint(thing("part", shape, **{key: value})) == f"bench: part[1].{line}"


@pytest.mark.parametrize(
    "outline",
    [
        "[[0, 0], [0, 1], [1, 0]]",  # clockwise
        "[[0, 0], [1, 0], [2, 0]]",  # a line
        "[[0, 0], [2, 0], [1, 0.5], [1, 2]]",  # a dent
        "[[1, 0], [-0.81, 0.59], [0.31, -0.95], [0.31, 0.95], [-0.81, -0.59]]",  # a star
        "[[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]]",  # a corner twice
    ],
)
def test_an_outline_goes_once_around_and_bends_outwards(outline: str) -> None:
    assert complaint(thing("part", "prism", outline=outline)) == (
        "bench: part[1].outline: "
        "expected a convex outline, its corners counter-clockwise from above"
    )


def test_an_outline_is_no_sliver() -> None:
    line = complaint(thing("part", "prism", outline="[[0, 0], [1, 0.95], [1, 1]]"))
    assert line == "bench: part[1].outline: expected an outline at least 0.1 in wide, whichever way"


def test_a_file_that_is_not_there_or_not_text_gets_one_line(tmp_path: Path) -> None:
    with pytest.raises(BenchError, match="cannot be read"):
        benchfile.load(tmp_path / "none.toml")
    with pytest.raises(BenchError, match="cannot be read"):
        benchfile.load(tmp_path)
    (tmp_path / "picture.toml").write_bytes(b"\x89PNG\xff\xfe\x00")
    with pytest.raises(BenchError, match="UTF-8"):
        benchfile.load(tmp_path / "picture.toml")


def complaint(text: str) -> str:
    """What a bench's text is refused with; nothing if an arm can work on it."""
    try:
        MiniMover(bench=benchfile.parse(text))
    except BenchError as error:
        return str(error)
    return ""


@settings(max_examples=150, deadline=None)
@given(st.text(max_size=60))
def test_no_text_brings_more_than_a_bench_error(text: str) -> None:
    assert "\n" not in complaint(text)


KEYS = st.sampled_from(
    [
        "at",
        "size",
        "weight",
        "turn",
        "bottom",
        "name",
        "bit",
        "count",
        "range",
        "on",
        "face",
        "threshold",
        "joint",
        "play",
        "bank",
        "bits",
    ]
)
VALUES = st.one_of(
    st.integers(-(10**20), 10**20).map(str),
    st.floats().map(str),
    st.sampled_from(["'hand'", "'left finger'", "'palm'", "'base'", "'tip'", "1", "2"]),
    st.sampled_from(["[8,0]", "[1,1,1]", "'x'", "true", "[[1]]", "{a=1}", "1979-05-27", "''"]),
)


@settings(max_examples=150, deadline=None)
@given(
    st.sampled_from(
        [
            "[[part]]",
            "[[feeder]]",
            "[[tray]]",
            "[turntable]",
            "[arm]",
            "[selector]",
            "[[proximity]]",
            "[[tactile]]",
            "[[force]]",
            "[[home]]",
        ]
    ),
    st.dictionaries(KEYS, VALUES, max_size=5),
)
def test_no_table_brings_more_than_a_bench_error(head: str, keys: dict[str, str]) -> None:
    text = "\n".join([head, *(f"{key} = {value}" for key, value in keys.items())])
    assert "\n" not in complaint(text)
