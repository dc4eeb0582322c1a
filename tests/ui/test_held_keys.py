"""What the TRS-80 sees of the fingers: minimum holds, order, latch, timer."""

from __future__ import annotations

import itertools

from hypothesis import given, settings
from hypothesis import strategies as st

from trs80arm.machine.keys import Key
from trs80arm.ui.keys.held_keys import GLANCE, HOLD, LIFT, MOST_ALIKE, HeldKeys

FRAME = 1 / 60
Seen = list[tuple[float, Key, bool]]


def watch(
    held: HeldKeys, seconds: float, *, manual: bool = False, ready: bool = True, start: float = 0.0
) -> Seen:
    """Everything that happens to the switches in so many virtual seconds, frame by frame."""
    seen: Seen = []
    for frame in range(round(seconds / FRAME)):
        now = start + frame * FRAME
        for key, down in held.changes(now, now, manual=manual, ready=ready):
            seen.append((now, key, down))
    return seen


def pressed(seen: Seen) -> list[Key]:
    return [key for _, key, down in seen if down]


def times(seen: Seen, key: Key) -> list[tuple[float, bool]]:
    return [(time, down) for time, one, down in seen if one is key]


def test_a_tap_is_down_longer_than_the_debounce_pause() -> None:
    held = HeldKeys()
    held.tap((Key.A,))
    [(down_at, _), (up_at, _)] = times(watch(held, 0.5), Key.A)
    assert 0.051 < up_at - down_at < 0.1


def test_keys_typed_at_once_come_in_order_one_after_the_other() -> None:
    held = HeldKeys()
    for key in (Key.B, Key.A, Key.D, Key.C):
        held.tap((key,))
    seen = watch(held, 1.0)
    assert pressed(seen) == [Key.B, Key.A, Key.D, Key.C]
    starts = [time for time, _, down in seen if down]
    assert all(later - earlier >= HOLD for earlier, later in itertools.pairwise(starts))


def test_a_double_letter_is_let_go_in_between() -> None:
    held = HeldKeys()
    held.tap((Key.L,))
    held.tap((Key.L,))
    marks = times(watch(held, 1.0), Key.L)
    assert [down for _, down in marks] == [True, False, True, False]
    assert marks[2][0] - marks[1][0] >= LIFT


def test_shift_belongs_to_the_newest_key() -> None:
    held = HeldKeys()
    held.key_down("2", (Key.SHIFT, Key.N2))
    watch(held, 0.2)
    held.key_down("a", (Key.A,))
    seen = watch(held, 0.2, start=0.2)
    assert (Key.SHIFT, False) in [(key, down) for _, key, down in seen]
    assert pressed(seen) == [Key.A]


def test_shift_goes_down_before_its_key() -> None:
    held = HeldKeys()
    held.tap((Key.SHIFT, Key.N2))
    assert pressed(watch(held, 0.05)) == [Key.SHIFT, Key.N2]


def test_after_enter_typing_waits_until_the_machine_asks() -> None:
    held = HeldKeys()
    held.tap((Key.ENTER,))
    held.tap((Key.A,))
    seen = watch(held, 0.2, ready=False)
    assert pressed(seen) == [Key.ENTER]
    assert pressed(watch(held, 0.2, ready=True, start=0.2)) == [Key.A]


def test_a_running_program_gets_keys_after_a_glance() -> None:
    held = HeldKeys()
    held.tap((Key.ENTER,))
    held.tap((Key.A,))
    seen = watch(held, 1.0, ready=False)
    assert pressed(seen) == [Key.ENTER, Key.A]
    assert times(seen, Key.A)[0][0] >= GLANCE


def test_in_manual_mode_keys_go_down_together_at_once() -> None:
    held = HeldKeys()
    held.key_down("1", (Key.N1,))
    held.key_down("w", (Key.W,))
    assert held.changes(0.0, 0.0, manual=True, ready=True) == [(Key.N1, True), (Key.W, True)]


def test_a_real_hold_lasts_until_the_release() -> None:
    held = HeldKeys()
    held.key_down("1", (Key.N1,))
    assert times(watch(held, 3.0, manual=True), Key.N1) == [(0.0, True)]
    held.key_up("1")
    assert held.changes(3.0, 3.0, manual=True, ready=True) == [(Key.N1, False)]


def test_a_release_without_a_press_is_nothing() -> None:
    held = HeldKeys()
    held.key_up("13u")
    assert watch(held, 0.1) == []


def test_a_press_and_release_between_two_frames_is_seen() -> None:
    held = HeldKeys()
    held.key_down("1", (Key.N1,))
    held.key_up("1")
    assert pressed(watch(held, 0.2, manual=True)) == [Key.N1]


def test_the_timer_holds_a_tap_for_a_tenth_and_a_repeat_a_little_longer() -> None:
    held = HeldKeys()
    held.hold_a_while((Key.N1,), wall=0.0)
    assert held.changes(0.0, 0.0, manual=True, ready=True) == [(Key.N1, True)]
    assert held.changes(0.09, 0.09, manual=True, ready=True) == []
    held.hold_a_while((Key.N1,), wall=0.09)
    assert held.changes(0.2, 0.2, manual=True, ready=True) == []
    assert held.changes(0.22, 0.22, manual=True, ready=True) == [(Key.N1, False)]


def test_latched_keys_add_up_and_go_all_at_once() -> None:
    held = HeldKeys()
    held.latch((Key.N1,))
    held.latch((Key.W,))
    assert held.changes(0.0, 0.0, manual=True, ready=True) == [(Key.N1, True), (Key.W, True)]
    held.latch((Key.N1,))
    assert held.changes(1.0, 1.0, manual=True, ready=True) == [(Key.N1, False)]
    held.unlatch()
    assert held.changes(2.0, 2.0, manual=True, ready=True) == [(Key.W, False)]


def test_everything_is_let_go_at_once() -> None:
    held = HeldKeys()
    held.key_down("1", (Key.N1,))
    held.latch((Key.W,))
    held.point(Key.E)
    held.hold_a_while((Key.R,), wall=0.0)
    assert len(held.changes(0.0, 0.0, manual=True, ready=True)) == 4
    held.release_all()
    changes = held.changes(0.0, 0.0, manual=True, ready=True)
    assert {key for key, down in changes if not down} == {Key.N1, Key.W, Key.E, Key.R}


def test_what_was_typed_is_typed_though_the_focus_goes() -> None:
    held = HeldKeys()
    held.tap((Key.R,))
    held.tap((Key.U,))
    held.key_down("n", (Key.N,))
    seen = watch(held, 0.01)
    held.release_all()
    seen += watch(held, 1.0, start=0.02)
    assert [(key, down) for _, key, down in seen] == [
        (key, down) for key in (Key.R, Key.U, Key.N) for down in (True, False)
    ]
    assert not held.busy


def test_a_program_may_type_a_listing_at_its_own_pace() -> None:
    held = HeldKeys()
    keys = [Key.A, Key.B, Key.C, Key.C, Key.ENTER] * 40
    for key in keys:
        held.tap((key,))
    assert held.waiting == len(keys)
    assert pressed(watch(held, 30.0)) == keys


def test_auto_repeat_does_not_run_far_ahead_of_the_machine() -> None:
    held = HeldKeys()
    for _ in range(1000):
        held.tap((Key.A,))
    held.tap((Key.B,))
    typed = pressed(watch(held, 30.0))
    assert typed == [Key.A] * MOST_ALIKE + [Key.B]


def test_another_machine_is_not_typed_at() -> None:
    held = HeldKeys()
    for key in (Key.A, Key.B, Key.C):
        held.tap((key,))
    watch(held, 0.03)
    held.start_afresh()
    assert not watch(held, 1.0)


def test_break_overtakes_what_waits() -> None:
    held = HeldKeys()
    for key in (Key.A, Key.B, Key.C):
        held.tap((key,))
    held.tap((Key.BREAK,))
    assert pressed(watch(held, 0.05)) == [Key.BREAK]


LETTERS = st.sampled_from([Key.A, Key.B, Key.C, Key.H, Key.N1, Key.SPACE, Key.COMMA])


@settings(max_examples=60, deadline=None)
@given(st.lists(LETTERS, max_size=12), st.floats(min_value=0.0, max_value=0.2))
def test_no_typed_key_is_lost_or_doubled_whatever_the_pace(keys: list[Key], pause: float) -> None:
    held = HeldKeys()
    seen: Seen = []
    now = 0.0
    for key in keys:
        held.tap((key,))
        seen += watch(held, pause, start=now)
        now += pause
    seen += watch(held, 3.0, start=now)
    assert pressed(seen) == keys
