"""Whoever is attached to a rig stays attached, whatever becomes of the machine."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from tests.machine.bench_top import Analyser
from trs80arm import Rig, RigSettings
from trs80arm.arm.bench import Bench
from trs80arm.rig import Input
from trs80arm.trace import PoseTrace, Trace

PROGRAM = "10 PRINT 7:@STEP 50,3\n20 @RESET\n"


class Statements:
    """Hears the lines of statements."""

    def __init__(self, heard: list[object]) -> None:
        self.heard = heard

    def statement(self, line: int, address: int) -> None:
        self.heard.append(line)


class Latches(Analyser):
    """Hears writes to the card."""

    def __init__(self, heard: list[object]) -> None:
        super().__init__()
        self.writes = heard  # type: ignore[assignment]


def listen(rig: Rig, heard: list[object]) -> Callable[[], None]:
    return rig.listen(lambda code, is_echo: heard.append(code))


def statements(rig: Rig, heard: list[object]) -> Callable[[], None]:
    return rig.watch_statements(Statements(heard))


def latches(rig: Rig, heard: list[object]) -> Callable[[], None]:
    return rig.watch_latches(Latches(heard))


def resets(rig: Rig, heard: list[object]) -> Callable[[], None]:
    return rig.watch_resets(lambda: heard.append("reset"))


def recorder(rig: Rig, heard: list[object]) -> Callable[[], None]:
    return rig.record(heard.append)


def nothing(rig: Rig) -> None:
    """Nothing happens to the rig."""


def switch_off_and_on(rig: Rig) -> None:
    rig.reset()


def go_back(rig: Rig) -> None:
    rig.restore(rig.snapshot())


def go_to_another_machine(rig: Rig) -> None:
    rig.restore(Rig(RigSettings(ram_kib=4)).snapshot())


def another_bench(rig: Rig) -> None:
    rig.set_bench(Bench.standard())


def all_of_it(rig: Rig) -> None:
    for happens in (go_to_another_machine, another_bench, switch_off_and_on, go_back):
        happens(rig)


def run(rig: Rig) -> None:
    rig.load_text(PROGRAM)
    rig.type("RUN\r")
    rig.run_until_waiting()


@pytest.mark.parametrize("attach", [listen, statements, latches, resets, recorder])
@pytest.mark.parametrize(
    "happens",
    [nothing, switch_off_and_on, go_back, go_to_another_machine, another_bench, all_of_it],
)
def test_every_kind_of_observer_stays_attached(
    attach: Callable[[Rig, list[object]], Callable[[], None]], happens: Callable[[Rig], None]
) -> None:
    rig = Rig()
    heard: list[object] = []
    end = attach(rig, heard)
    happens(rig)
    heard.clear()
    run(rig)
    once = list(heard)
    assert once
    end()
    end()
    happens(rig)
    run(rig)
    assert heard == once


def test_an_observer_hears_each_thing_once_after_many_restores() -> None:
    rig = Rig()
    analyser = Analyser()
    rig.watch_latches(analyser)
    for _ in range(3):
        all_of_it(rig)
    analyser.writes.clear()
    rig.type("@STEP 50,3\r")
    rig.run_until_waiting()
    assert len(analyser.writes) == 3


def test_true_joints_are_counted_from_zero_after_all_of_it() -> None:
    rig = Rig()
    rig.type("@STEP 50,40\r")
    rig.run_until_waiting()
    all_of_it(rig)
    rig.type("@RESET:@STEP 50,3\r")
    rig.run_until_waiting()
    assert rig.registers == rig.joints == (3, 0, 0, 0, 0, 0)


def test_traces_go_on_through_all_of_it(tmp_path) -> None:
    rig = Rig()
    with Trace(rig, tmp_path / "a.csv"), PoseTrace(rig, tmp_path / "b.csv"):
        all_of_it(rig)
        run(rig)
    for name in ("a.csv", "b.csv"):
        last = (tmp_path / name).read_text().splitlines()[-1]
        assert int(last.split(",")[0]) > rig.clock.now - 200_000
    assert rig.card.observers == []


def test_a_recording_goes_on_through_a_reset() -> None:
    rig = Rig()
    log: list[Input] = []
    rig.record(log.append)
    rig.reset()
    run(rig)
    again = Rig()
    again.replay(log)
    again.run_to(rig.clock.now)
    assert (again.screen(), again.registers) == (rig.screen(), rig.registers)
