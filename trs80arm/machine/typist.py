"""The typist: turns text into keys going down and up at virtual times.

It types a line at a pace at which the ROM's scan with its debounce pause loses nothing, and after
ENTER looks up until the machine is ready for the next line. The rig gives its key events to the
matrix when they are due.
"""

from __future__ import annotations

from collections import deque

from trs80arm.machine.clock import T_STATES_PER_SECOND
from trs80arm.machine.keys import Key, keys_for

KeyEvent = tuple[int, Key, bool]
"""When, in T-states; which key; whether it goes down."""

_MS = T_STATES_PER_SECOND // 1000
HOLD = 60 * _MS
"""How long a key is down: longer than the debounce pause of 51 ms."""
PERIOD = 100 * _MS
"""From one key down to the next. The ROM has 40 ms to see the last key up, and together with the
next key's 60 ms time for the echo of a line that scrolls, CLEAR, or the L of EDIT."""
GLANCE = 250 * _MS
"""After ENTER, how long a typist with nothing more to type is not yet at the next line."""
LONGEST_ANSWER = 16
"""Characters of an answer that is given by itself, as that to MEMORY SIZE?"""
_LINE_ENDS = frozenset((Key.ENTER, Key.BREAK))


def check_answer(text: str) -> None:
    """Refuse what nobody would answer to MEMORY SIZE?

    Raises:
        ValueError: it is long, or no plain characters.
    """
    if len(text) > LONGEST_ANSWER or not (text.isascii() and text.isprintable()):
        raise ValueError(f"memory_size must be at most {LONGEST_ANSWER} plain characters")


class Typist:
    """Text on its way to the keyboard.

    Text given in one go, or while earlier text is still pending, is typed line by line: after
    ENTER or BREAK the next line begins when the machine waits for the operator. Text given when
    nothing is pending is typed at once, so that a program that polls INKEY$ gets its keys.
    """

    def __init__(self) -> None:
        self._queue: deque[tuple[Key, ...]] = deque()
        self._free = 0
        self._line_end: int | None = None
        self._unasked = False

    @property
    def pending(self) -> bool:
        """Whether there is text whose key events were not yet given out."""
        return bool(self._queue)

    @property
    def looks_up(self) -> bool:
        """Whether it watches for the machine to become ready after a line."""
        return self._line_end is not None

    @property
    def next_look(self) -> int | None:
        """The T-state at which it first looks up after a line; None if there was none.

        A machine that is not ready then is looked at when it begins to wait.
        """
        return None if self._line_end is None else self._line_end + HOLD

    def add(self, text: str) -> str:
        r"""Append text to what is to be typed; `\r`, `\n` or both in a row are one ENTER.

        Returns:
            The characters that no key of the TRS-80 types; they are left out.
        """
        was_idle = not self._queue
        unknown = []
        for character in text.replace("\r\n", "\r"):
            keys = keys_for(character)
            if keys is None:
                unknown.append(character)
            else:
                self._queue.append(keys)
        if was_idle:
            self._unasked = bool(self._queue)
        return "".join(unknown)

    def clear(self, now: int) -> None:
        """Forget what is still to be typed, also of the line whose key events were given out.

        Args:
            now: T-states since power-on; a key that went down before goes up as it was told.
        """
        self._queue.clear()
        self._unasked = False
        self._free = min(self._free, now + PERIOD)
        if self._line_end is not None and self._line_end > now:
            self._line_end = None

    @property
    def left(self) -> int:
        """How many characters are still to be typed, those that were given out left out."""
        return len(self._queue)

    def due(self, now: int, ready: bool) -> list[KeyEvent]:
        """The key events of the next line, if it may begin; times are not before `now`.

        Args:
            now: T-states since power-on.
            ready: whether the machine waits for the operator.
        """
        if self._line_end is not None and ready and now >= self._line_end + HOLD:
            self._line_end = None
            if self._queue and not self._unasked:
                # The machine has not looked since ENTER went down: let it see the key up.
                self._free = max(self._free, now + PERIOD - HOLD)
        if not self._queue:
            return []
        start = max(now, self._free)
        if self._line_end is not None:
            if not self._unasked:
                return []
            start = max(start, self._line_end + GLANCE)
        self._unasked = False
        self._line_end = None
        events: list[KeyEvent] = []
        while self._queue and self._line_end is None:
            keys = self._queue.popleft()
            events += [(start, key, True) for key in keys]
            events += [(start + HOLD, key, False) for key in reversed(keys)]
            if not _LINE_ENDS.isdisjoint(keys):
                self._line_end = start
            start += PERIOD
        self._free = start
        return events
