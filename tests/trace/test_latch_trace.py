"""The logic analyser's files: CSV, NPZ and VCD hold every write, and appear when complete."""

from __future__ import annotations

import csv
import re
from pathlib import Path

import numpy as np
import pytest

from tests.machine.bench_top import Machine
from trs80arm.machine.clock import T_STATES_PER_SECOND
from trs80arm.machine.half_steps import HALF_STEPS
from trs80arm.trace import Trace, TraceError


def traced(path: Path) -> Machine:
    """A machine that has made a coordinated move, an OUT and a `@RESET` under the analyser."""
    machine = Machine()
    machine.step(20, 2)
    machine.analyser.writes.clear()
    with Trace(machine, path):
        machine.step(50, 100, -30, 20)
        machine.card.write(0x9E, 0b1100)
        machine.driver.reset()
        machine.clock.now += 1_774_080
    machine.step(0, 5)
    return machine


def test_csv_lists_every_write_with_its_time(tmp_path):
    machine = traced(tmp_path / "a.csv")
    rows = list(csv.DictReader((tmp_path / "a.csv").open()))
    names = ["base", "shoulder", "elbow", "left wrist", "right wrist", "hand", "auxiliary"]
    read = [(int(row["t_states"]), names.index(row["latch"]), int(row["nibble"])) for row in rows]
    assert read == machine.analyser.writes[: len(read)]
    assert len(read) == 100 + 30 + 20 + 20 + 1 + 6
    for row in rows:
        assert abs(float(row["seconds"]) * T_STATES_PER_SECOND - int(row["t_states"])) < 0.01


def test_npz_holds_the_same_as_arrays(tmp_path):
    machine = traced(tmp_path / "a.NPZ")
    with np.load(tmp_path / "a.NPZ") as arrays:
        times, latches, nibbles = arrays["t_states"], arrays["latch"], arrays["nibble"]
        read = list(zip(times.tolist(), latches.tolist(), nibbles.tolist(), strict=True))
        assert arrays["names"][3] == "left wrist"
        assert np.allclose(arrays["seconds"] * T_STATES_PER_SECOND, times)
    assert read == machine.analyser.writes[: len(read)]


def read_vcd(text: str) -> tuple[dict[str, str], list[tuple[int, str, int]]]:
    """A small reader: signal code to `scope.name`, and (nanoseconds, code, value) changes."""
    header, body = text.split("$enddefinitions $end\n")
    signals: dict[str, str] = {}
    scopes: list[str] = []
    for line in header.splitlines():
        words = line.split()
        if words[0] == "$scope":
            scopes.append(words[2])
        elif words[0] == "$upscope":
            scopes.pop()
        elif words[0] == "$var":
            assert words[1:3] == ["wire", "1"]
            assert words[3] not in signals
            signals[words[3]] = ".".join([*scopes, words[4]])
    assert not scopes
    changes, now = [], -1
    for line in body.splitlines():
        if line.startswith("#"):
            assert int(line[1:]) > now
            now = int(line[1:])
        elif not line.startswith("$"):
            assert re.fullmatch(r"[01][!-~]", line)
            changes.append((now, line[1], int(line[0])))
    return signals, changes


def test_vcd_has_one_signal_per_coil_and_shows_the_latches(tmp_path):
    machine = traced(tmp_path / "a.vcd")
    text = (tmp_path / "a.vcd").read_text("ascii")
    assert "$timescale 1 ns $end" in text
    signals, changes = read_vcd(text)
    assert len(signals) == 28
    assert signals["!"] == "card.base.phi1"
    assert [value for _, _, value in changes[:4]] == [0, 1, 1, 0]
    held = {code: value for _, code, value in changes}
    nibbles = [0] * 7
    nibbles[0] = HALF_STEPS[2]
    for time, latch, nibble in machine.analyser.writes[:177]:
        nibbles[latch] = nibble
        last = time
    final = [int("".join(str(held[chr(33 + 4 * k + c)]) for c in range(4)), 2) for k in range(7)]
    assert final == nibbles == [0, 0, 0, 0, 0, 0, 0b1100]
    assert last * 10**9 // T_STATES_PER_SECOND == changes[-1][0]
    # The last values are shown until the trace ended, a second after the last write.
    end = int(text.rsplit("#", 1)[1])
    assert end == (last + T_STATES_PER_SECOND) * 10**9 // T_STATES_PER_SECOND


def test_vcd_lists_only_changes(tmp_path):
    machine = Machine()
    with Trace(machine, tmp_path / "a.vcd"):
        for _ in range(3):
            machine.card.write(0x98, 0b0101)
            machine.clock.now += 1000
    _, changes = read_vcd((tmp_path / "a.vcd").read_text())
    assert not any(value for _, _, value in changes[:28])
    assert changes[28:] == [(0, '"', 1), (0, "$", 1)]


def test_a_trace_appears_when_it_is_complete(tmp_path):
    machine, path = Machine(), tmp_path / "a.csv"
    path.write_text("older")
    trace = Trace(machine, path)
    machine.step(0, 5)
    assert path.read_text() == "older"
    trace.close()
    trace.close()
    assert len(path.read_text().splitlines()) == 6
    assert [entry.name for entry in tmp_path.iterdir()] == ["a.csv"]
    assert machine.card.observers == [machine.analyser]


def test_a_trace_is_kept_when_the_run_fails(tmp_path):
    machine, path = Machine(), tmp_path / "a.csv"

    def fail() -> None:
        with Trace(machine, path):
            machine.step(0, 5)
            raise RuntimeError

    with pytest.raises(RuntimeError):
        fail()
    assert len(path.read_text().splitlines()) == 6


@pytest.mark.parametrize("name", ["a.txt", "a", "nowhere/a.csv"])
def test_a_trace_that_cannot_be_written_says_so_in_one_line(tmp_path, name):
    machine = Machine()
    with pytest.raises(TraceError) as error:
        Trace(machine, tmp_path / name)
    assert str(tmp_path / name) in str(error.value)
    assert "\n" not in str(error.value)
    assert machine.card.observers == [machine.analyser]


def test_a_path_may_be_plain_text(tmp_path):
    machine = Machine()
    with Trace(machine, str(tmp_path / "a.csv")):
        machine.step(20, 2)
    assert len((tmp_path / "a.csv").read_text().splitlines()) == 1 + 2


def test_without_a_path_the_writes_are_arrays_at_any_time():
    machine = Machine()
    with Trace(machine) as trace:
        machine.step(20, 2)
        assert len(trace.arrays["nibble"]) == 2
        machine.step(20, 0, 3)
    machine.step(20, 5)
    arrays = trace.arrays
    assert [arrays["names"][latch] for latch in arrays["latch"]] == ["base"] * 2 + ["shoulder"] * 3
    assert [*zip(arrays["t_states"], arrays["latch"], arrays["nibble"], strict=True)] == (
        machine.analyser.writes[:5]
    )


def test_a_text_file_has_no_arrays(tmp_path):
    with Trace(Machine(), tmp_path / "a.vcd") as trace, pytest.raises(TraceError, match="arrays"):
        _ = trace.arrays
