"""When loops are native: where it pays, while nothing has changed, where it is installed."""

from __future__ import annotations

import subprocess
import sys

import pytest

from tests.basic.machine import Machine
from tests.basic.native.machines import at_once, finish, left, taken
from trs80arm import Rig, RigSettings
from trs80arm.basic.code import CompiledCode
from trs80arm.basic.native.hot import Hot
from trs80arm.machine.keys import Key

LOOP = ["10 K=K+1:A=K/3+A/2", "20 IF K<{} THEN 10"]


def loop(rounds: int) -> list[str]:
    return [line.format(rounds) for line in LOOP]


def hot_of(machine: Machine) -> Hot:
    engine = machine.basic.state.engine
    assert isinstance(engine, CompiledCode)
    assert engine.hot is not None
    return engine.hot


@pytest.fixture
def machine() -> Machine:
    """A machine whose loops are native at once."""
    with at_once():
        machine = Machine()
        machine.load(*loop(300))
        machine.do("RUN")
    assert taken(machine) > machine.clock.now / 2
    return machine


def test_a_long_loop_becomes_native_in_time_and_a_short_one_does_not() -> None:
    machine = Machine()
    assert "Error" not in machine.run(*loop(3000))
    assert not taken(machine)
    machine.run(*(line.replace("<3000", "<300000") for line in loop(3000)))
    machine.load("20 IF K<300000 THEN 10")
    machine.do("RUN", seconds=100_000)
    assert taken(machine) > machine.clock.now / 5
    assert machine.do("PRINT K") == " 300000 \n"


def test_another_run_finds_its_loop(machine: Machine) -> None:
    kept = list(hot_of(machine)._kept)
    with at_once():
        machine.do("RUN")
    assert hot_of(machine)._kept == kept


@pytest.mark.parametrize(
    ("change", "shown"),
    [
        ("10 K=K+2:A=K/3+A/2", " 301  200.333 \n"),
        ("5 DEFINT A", " 300  99 \n"),
        ("5 B=1:C=2:D=3", " 300  199.333 \n"),
        ("20 IF K<200 THEN 10", " 200  132.667 \n"),
    ],
)
def test_what_was_changed_is_compiled_anew(machine: Machine, change: str, shown: str) -> None:
    with at_once():
        machine.load(change)
        machine.do("RUN")
        native = machine.do("PRINT K;A")
    python = Machine(native=False)
    python.load(*loop(300), change)
    python.do("RUN")
    assert native == python.do("PRINT K;A")
    assert left(machine)["scalars"] == left(python)["scalars"]


def test_a_poke_into_the_program_counts_at_once() -> None:
    # The 1 of A+1 becomes a 2 when K has come to 50.
    lines = ["10 K=K+1:A=A+1:IF K=50 THEN POKE 17143,50", "20 IF K<100 THEN 10"]
    machine = finish(lines, native=True)
    assert left(machine) == left(finish(lines, native=False))
    assert machine.do("PRINT A") == " 150 \n"


def test_an_array_made_anew_has_its_new_elements() -> None:
    lines = [
        "10 FOR P=1 TO 3:DIM A(P*4),B(5):FOR I=0 TO 4:A(I)=A(I)+P*I:B(I)=A(I):NEXT",
        "20 PRINT A(4);B(4);:Q=P:CLEAR 100:P=Q",
        "30 NEXT",
    ]
    assert left(finish(lines, native=True)) == left(finish(lines, native=False))


def test_whoever_watches_statements_sees_each() -> None:
    class Watcher:
        def __init__(self) -> None:
            self.seen: list[int] = []

        def statement(self, line: int, address: int) -> None:
            self.seen.append(address)

    watchers = Watcher(), Watcher()
    for watcher, native in zip(watchers, (True, False), strict=True):
        with at_once():
            machine = Machine(native=native)
            machine.load(*loop(50))
            machine.basic.listeners.append(watcher)
            machine.do("RUN")
            assert not taken(machine)
    assert watchers[0].seen == watchers[1].seen
    assert len(watchers[0].seen) > 150


def test_trace_and_break_come_between_statements_as_ever() -> None:
    traced = ["5 TRON", *loop(5), "30 TROFF"]
    assert left(finish(traced, native=True)) == left(finish(traced, native=False))
    rigs: list[Rig] = []
    for native in (True, False):
        with at_once():
            rig = Rig(RigSettings(native=native))
            rigs.append(rig)
            rig.run_until_waiting(10)
            for line in loop(30000):
                rig.type(line + "\r")
            rig.type("RUN\r")
            rig.run_for(20)
            rig.hold([Key.BREAK], 0.1)
            rig.run_for(2)
            rig.type("PRINT K;A\r")
            rig.run_until_waiting(10)
    assert rigs[0].screen() == rigs[1].screen()
    assert any("BREAK IN" in line for line in rigs[0].screen())
    assert rigs[0].clock.now == rigs[1].clock.now
    engine = rigs[0].basic.state.engine  # type: ignore[union-attr]
    assert isinstance(engine, CompiledCode)
    assert engine.hot is not None
    assert engine.hot.taken > 20_000_000


def test_a_loop_that_is_soon_left_each_time_is_given_up() -> None:
    machine = Machine()
    machine.load("10 FOR I=1 TO 30000:FOR J=1 TO 20:K=K+J:NEXT:PRINT @0,I:NEXT")
    machine.do("RUN", seconds=100_000)
    assert not hot_of(machine)._kept or taken(machine) > machine.clock.now / 2


def test_it_can_be_switched_off() -> None:
    assert finish(loop(300), native=False).basic.state.engine.hot is None  # type: ignore[attr-defined]
    assert Rig(RigSettings(native=False)).basic.state.native is False  # type: ignore[union-attr]


def test_without_the_library_everything_is_python(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "wasmtime", None)
    machine = finish(loop(300), native=True)
    assert not taken(machine)
    assert left(machine) == left(finish(loop(300), native=False))


def test_a_short_run_does_not_load_the_library() -> None:
    code = """
import sys
from trs80arm import Rig
rig = Rig()
rig.run_until_waiting(10)
rig.type("FOR I=1 TO 1000:NEXT\\r")
rig.run_until_waiting(60)
print("wasmtime" in sys.modules, "trs80arm.basic.native.lowering" in sys.modules)
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["False", "False"]
