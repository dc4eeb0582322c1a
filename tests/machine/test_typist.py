from __future__ import annotations

import heapq
import pickle

import pytest
from hypothesis import given
from hypothesis import strategies as st

from trs80arm.machine.clock import T_STATES_PER_SECOND, Clock
from trs80arm.machine.keyboard import KeyboardDriver, Matrix
from trs80arm.machine.keys import Key
from trs80arm.machine.memory import Memory
from trs80arm.machine.typist import GLANCE, Typist

MS = T_STATES_PER_SECOND // 1000


class Desk:
    """A typist at a machine that reads lines, and works for a while after each."""

    def __init__(self, work: int = 0, echo: int = 1 * MS) -> None:
        self.clock = Clock()
        self.matrix = Matrix()
        self.driver = KeyboardDriver(self.clock, Memory(16), self.matrix)
        self.typist = Typist()
        self.work = work
        self.echo = echo
        self.events: list[tuple[int, int, Key, bool]] = []
        self.order = 0
        self.read: list[int] = []

    def run(self, ready: bool = True, until: int | None = None) -> str:
        """Let the machine read until there is nothing more to come, or until a time."""
        while True:
            for time, key, down in self.typist.due(self.clock.now, ready):
                self.order += 1
                heapq.heappush(self.events, (time, self.order, key, down))
            while self.events and self.events[0][0] <= self.clock.now:
                _, _, key, down = heapq.heappop(self.events)
                (self.matrix.press if down else self.matrix.release)(key)
            code = self.driver.scan()
            if code:
                self.read.append(code)
                self.clock.now += self.work if code == 13 else self.echo
            elif self.events:
                self.clock.now = max(self.clock.now, self.events[0][0])
            elif until is None or self.clock.now >= until:
                return bytes(self.read).decode("latin-1")
            else:
                self.clock.now += 10 * MS


def test_a_line_arrives_as_it_was_typed() -> None:
    desk = Desk()
    desk.typist.add('10 PRINT "A=";A*2\r')
    assert desk.run() == '10 PRINT "A=";A*2\r'
    assert desk.matrix.held == frozenset()


def test_a_listing_in_small_letters_comes_in_as_capitals() -> None:
    desk = Desk()
    assert desk.typist.add("for i=1 to 3\n") == ""
    assert desk.run() == "FOR I=1 TO 3\r"


@given(
    st.text("ABCXYZ0189 !\"#'()*+<=>?@:;,-./\r\x08\x1f", max_size=40),
    st.integers(0, 5000),
    st.integers(0, 35),
)
def test_no_key_is_lost_however_slow_the_machine(text: str, work: int, echo: int) -> None:
    desk = Desk(work=work * MS, echo=echo * MS)
    desk.typist.add(text)
    assert desk.run() == text


def test_the_same_letter_twice_is_two_keys() -> None:
    desk = Desk(echo=35 * MS)
    desk.typist.add("AAAA  BB")
    assert desk.run() == "AAAA  BB"


def test_both_line_ends_in_a_row_are_one_enter() -> None:
    desk = Desk()
    desk.typist.add("A\r\nB\r\n")
    assert desk.run() == "A\rB\r"


def test_the_next_line_waits_for_the_machine() -> None:
    desk = Desk()
    desk.typist.add("RUN\rX")
    assert desk.run(ready=True, until=0) == "RUN\rX"
    desk = Desk()
    desk.typist.add("RUN\rX")
    assert desk.run(ready=False, until=20 * T_STATES_PER_SECOND) == "RUN\r"
    assert desk.typist.pending
    assert desk.run(ready=True) == "RUN\rX"


def test_a_key_added_later_does_not_wait() -> None:
    # So that a program that polls INKEY$, and waits for nobody, gets its keys.
    desk = Desk()
    desk.typist.add("RUN\r")
    assert desk.run(ready=False) == "RUN\r"
    desk.typist.add("Y")
    before = desk.clock.now
    assert desk.run(ready=False) == "RUN\rY"
    assert desk.clock.now - before < GLANCE + T_STATES_PER_SECOND // 5


def test_what_no_key_types_is_told() -> None:
    typist = Typist()
    assert typist.add("A{é}B") == "{é}"


def test_cleared_text_is_not_typed() -> None:
    desk = Desk()
    desk.typist.add("ABC")
    desk.typist.clear(0)
    assert desk.run() == ""
    assert not desk.typist.pending


@pytest.mark.parametrize("slice_ms", [1, 7, 1000])
def test_the_events_do_not_depend_on_how_often_the_typist_is_asked(slice_ms: int) -> None:
    typist = Typist()
    typist.add("AB")
    events = []
    for now in range(0, 2000 * MS, slice_ms * MS):
        events += typist.due(now, True)
    assert events == [
        (0, Key.A, True),
        (60 * MS, Key.A, False),
        (100 * MS, Key.B, True),
        (160 * MS, Key.B, False),
    ]


def test_a_pickled_typist_goes_on() -> None:
    desk = Desk()
    desk.typist.add("RUN\rX\r")
    desk.run(ready=False)
    copy = pickle.loads(pickle.dumps(desk))
    assert copy.run() == desk.run() == "RUN\rX\r"
