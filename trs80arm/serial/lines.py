"""From a stream of bytes to lines, with no more held than a line may have."""

from __future__ import annotations

from collections.abc import Iterator

END = 0x0D
LONGEST = 255
"""Bytes of a line that are held; the longest command of a known client has 60."""
NO_LINE = b""
"""What stands for a line that was longer: no command, as a line without a word."""


class Lines:
    """What has come since the last CR.

    A CR ends a line. A LF that follows it belongs to the next line, where it means as little as a
    blank does.
    """

    def __init__(self) -> None:
        self._held = bytearray()
        self._lost = False

    def __len__(self) -> int:
        return len(self._held)

    def feed(self, data: bytes) -> Iterator[bytes]:
        """Take bytes as they come.

        Returns:
            The lines that they end, without their CR; one too long to be held is `NO_LINE`. They
            have to be taken to the last, or what comes after is lost.
        """
        begin = 0
        while (end := data.find(END, begin)) >= 0:
            self._hold(data[begin : min(end, begin + LONGEST + 1)])
            yield NO_LINE if self._lost else bytes(self._held)
            self.clear()
            begin = end + 1
        self._hold(data[begin : begin + LONGEST + 1])

    def _hold(self, piece: bytes) -> None:
        """Add to the line, as long as it can be one."""
        if len(self._held) + len(piece) > LONGEST:
            self._lost = True
            self._held.clear()
        if not self._lost:
            self._held += piece

    @property
    def possible(self) -> bool:
        """Whether it holds what it can: one from outside may not."""
        return len(self._held) <= LONGEST and END not in self._held

    def clear(self) -> None:
        """Forget what has come of a line."""
        self._held.clear()
        self._lost = False
