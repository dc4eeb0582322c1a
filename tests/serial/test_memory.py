"""The memory's rows, and the moves in them."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from trs80arm.serial.memory import MOVE, STEPS, Move, TeachMemory, kind_of, number_of, row_of

words = st.integers(0, 65535)


def test_a_move_as_teachmover_virtual_command_writes_it() -> None:
    # Its convertToQWRITE(3, 240, [258, -1, 0, 1, -256, 515]), worked out by hand.
    row = (3, 15 * 256 + 1, 0xFF02, 0x0100, 0x0300, 0xFF01, 0x0000, 0x02FF)
    move = Move(240, (258, -1, 0, 1, -256, 515))
    assert move.row(3) == row
    assert Move.of(row) == move
    assert (number_of(row), kind_of(row)) == (3, MOVE)


@given(st.integers(0, 255), st.integers(0, 255), st.tuples(*[st.integers(-32768, 32767)] * 6))
def test_a_move_comes_back_from_its_row(number, speed, position) -> None:
    row = Move(speed, position).row(number)
    assert row_of(row) == row
    assert Move.of(row) == Move(speed, position)


@given(st.tuples(*[words] * 8))
def test_any_row_can_be_looked_at_as_a_move(row) -> None:
    move = Move.of(row)
    assert move.row(number_of(row))[2:] == row[2:]


def test_rows_are_in_the_order_of_their_steps_and_one_to_a_step() -> None:
    memory = TeachMemory()
    for number, last in ((2, 0), (53, 0), (1, 0), (2, 9)):
        assert memory.write((number, 0, 0, 0, 0, 0, 0, last))
    assert [row[0] for row in memory] == [1, 2, 53]
    assert memory.read(2) == (2, 0, 0, 0, 0, 0, 0, 9)
    memory.erase(2)
    memory.erase(2)
    assert memory.read(2) is None
    assert len(memory) == 2
    memory.clear()
    assert memory.dump() == []


@given(st.lists(st.tuples(*[words] * 8), max_size=80))
def test_there_are_so_many_steps_and_no_others(rows) -> None:
    memory = TeachMemory()
    for row in rows:
        assert memory.write(row) == (1 <= row[0] & 0xFF <= STEPS)
    assert len(memory) <= STEPS
