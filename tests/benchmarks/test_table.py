"""The table of `python -m benchmarks`: every part has rows, and JSON and page have their shape."""

from __future__ import annotations

import json
import math
from importlib import import_module
from itertools import islice
from pathlib import Path

import pytest

from benchmarks import growth, language, peers
from benchmarks.report import PARTS, markdown, plain, written
from benchmarks.rows import Row

ROWS = [Row("bm1", {"M statements/s": 4.0, "x bwbasic": 12.345}), Row("bm2", {"x bwbasic": 1234.5})]
TINY = 0.001
PAGE = Path(__file__).parents[2] / "docs" / "performance.md"


@pytest.mark.parametrize("part", sorted(set(PARTS) - {"language", "terminal", "suite"}))
def test_each_part_has_rows_of_numbers(part: str) -> None:
    first = list(islice(import_module(f"benchmarks.{part}").rows(TINY), 1))
    assert first
    assert all(math.isfinite(value) for row in first for value in row.measures.values())


def test_the_language_is_told_beside_python_written_by_hand() -> None:
    *listings, mean = language.rows(TINY, ["bm1"], [])
    assert [row.name for row in listings] == ["bm1"]
    assert mean.measures.keys() == {"M statements/s", "with fast", "of hand-written"}


def test_native_loops_are_told_only_where_they_are_installed(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(language, "find_spec", lambda name: None)
    *_, mean = language.rows(TINY, ["bm1"], [])
    assert mean.measures.keys() == {"M statements/s", "of hand-written"}


def test_a_program_of_200_lines_has_begun_within_20_ms() -> None:
    assert growth.until_the_first(200) < 0.02


def test_a_terminal_is_timed_through_a_pty(monkeypatch: pytest.MonkeyPatch) -> None:
    terminal = import_module("benchmarks.terminal")
    with terminal.sitting((80, 24), watched=False) as program:
        assert program.wait_for(b"F10 LEAVES.") > program.began


def test_json_has_the_machine_and_the_parts() -> None:
    told = json.loads(json.dumps(plain({"language": ROWS})))
    assert set(told) == {"machine", "parts"}
    assert set(told["machine"]) == {"python", "system", "cores"}
    assert told["parts"]["language"][1] == {"name": "bm2", "measures": {"x bwbasic": 1234.5}}


def test_a_table_has_a_column_for_each_measure_and_three_digits() -> None:
    assert markdown(ROWS).splitlines() == [
        "| | M statements/s | x bwbasic |",
        "| --- | ---: | ---: |",
        "| bm1 | 4 | 12.3 |",
        "| bm2 |  | 1234 |",
    ]


def test_the_page_has_a_place_for_every_part_and_keeps_its_words() -> None:
    page = PAGE.read_text()
    done = written(page, dict.fromkeys(PARTS, ROWS))
    assert done.count("| bm1 | 4 | 12.3 |") == len(PARTS)
    assert written(done, dict.fromkeys(PARTS, ROWS)) == done
    assert page.splitlines()[0] == done.splitlines()[0]


def test_a_part_without_a_place_in_the_page_is_told() -> None:
    with pytest.raises(ValueError, match="no marks for"):
        written("# Speed\n", {"language": ROWS})


@pytest.mark.parametrize("name", language.STANDARD)
def test_a_longer_listing_executes_in_proportion(name: str) -> None:
    assert language.listing(name, 3) != language.listing(name, 1)


def test_listings_are_spelled_as_each_dialect_has_them() -> None:
    spelled = {peer.name: peer.spell for peer in peers.PEERS}
    assert spelled["PC-BASIC"](["10 A=K[2", "20 END"]) == [
        "10 A=K^2",
        "20 GOTO 9998",
        '9998 PRINT "ALL DONE"',
        "9999 SYSTEM",
    ]
    assert spelled["yabasic"](["10 IF X=0 THEN Y=1 ELSE Y=2"])[:3] == [
        "10 IF X<>0 GOTO 13",
        "11 Y=1",
        "12 GOTO 15",
    ]
    assert spelled["brandy"](["10 CLEAR 500:B=LOG(K)"])[0] == "10 B=LN(K)"
    assert spelled["bas55"](["10 IF A<1 OR A>2 GOTO 50"])[:2] == [
        "10 IF A<1 THEN 50",
        "11 IF A>2 THEN 50",
    ]
