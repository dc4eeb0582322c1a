"""Where programs get at the arm's serial line: a pseudo-terminal, or a TCP port of this computer.

A port has one other end at a time. Nothing here waits, but `wait`; what is not there yet is asked
for again.
"""

from __future__ import annotations

import contextlib
import os
import select
import socket
import sys
import time
from collections.abc import Sequence
from typing import Protocol

from trs80arm.reasons import reason

LOOPBACK = "127.0.0.1"
NOBODY = 0.1
"""Seconds between two looks whether somebody has opened a pseudo-terminal."""
MOST_UNREAD = 65536
"""Bytes that are taken at most of what nobody has received; a device holds fewer."""
NO_PTY = "this system has no pseudo-terminals; --tcp PORT has the line on a port"


class EndpointError(Exception):
    """The line cannot be had where it was wanted; one clear line."""


class Port(Protocol):
    """The arm's end of a serial line."""

    @property
    def name(self) -> str:
        """What programs open: the path of a device, or an address."""

    @property
    def connected(self) -> bool:
        """Whether somebody is at the other end."""

    def left(self) -> bool:
        """Whether who was there has hung up since this was asked last.

        What they sent before and nobody has received yet is lost then.
        """

    def receive(self, most: int) -> bytes:
        """What has come, so many bytes at most; nothing if nothing has."""

    def send(self, data: bytes) -> int:
        """Send bytes; how many of them were taken, all where nobody is."""

    def wait(self, seconds: float, others: Sequence[int] = (), *, sending: bool = False) -> None:
        """Wait until something has come, here or at other file descriptors, or time is over.

        Args:
            seconds: the longest time.
            others: file descriptors that are looked at too.
            sending: whether bytes that can be sent are waited for as well.
        """

    def close(self) -> None:
        """End it."""


class PseudoTerminal:
    """A device that is opened like a serial port; on POSIX systems.

    Speed and parity that a program sets for it are of no account.

    Raises:
        EndpointError: the system has none, or no more.
    """

    def __init__(self) -> None:
        try:
            import pty
            import tty
        except ImportError:
            raise EndpointError(NO_PTY) from None
        try:
            self._own, other = pty.openpty()
        except OSError as error:
            raise EndpointError(f"no pseudo-terminal can be had: {reason(error)}") from None
        self.name = os.ttyname(other)
        self.connected = False
        self._early = b""
        """What was sent while it was looked whether anybody is there."""
        # No echo, and every byte as it is, for programs that do not ask for that themselves.
        tty.setraw(other)
        os.set_blocking(self._own, False)
        # It is seen that somebody hangs up if nobody else has the device open.
        os.close(other)

    def left(self) -> bool:
        """As in `Port`."""
        before = self.connected
        self.connected = not _shut(self._own)
        if self.connected:
            return False
        self._early = b""
        # Somebody may have come and gone since, and have left something.
        unread = self._take_unread()
        if not (unread or before):
            return False
        if not before and not _shut(self._own):
            # Or has come in this very moment, and it is for them that it is to be answered.
            self.connected = True
            self._early = unread
            return False
        self._clean()
        return True

    def _take_unread(self) -> bytes:
        """What was sent and nobody has received."""
        unread = bytearray()
        # When it is all taken it is an error that nobody is there.
        with contextlib.suppress(OSError):
            while len(unread) < MOST_UNREAD and (some := os.read(self._own, MOST_UNREAD)):
                unread += some
        return bytes(unread)

    def _clean(self) -> None:
        """What was sent and not read is not for who comes next, nor are modes that were set."""
        import termios
        import tty

        with contextlib.suppress(OSError, termios.error):
            other = os.open(self.name, os.O_RDWR | os.O_NOCTTY | os.O_NONBLOCK)
            termios.tcflush(other, termios.TCIOFLUSH)
            # Not when all was sent that nobody is to receive.
            tty.setraw(other, termios.TCSANOW)
            os.close(other)

    def receive(self, most: int) -> bytes:
        """As in `Port`."""
        if self._early:
            early, self._early = self._early[:most], self._early[most:]
            return early
        # Who has come since `left` looked is seen there first, or they would not be answered yet.
        if not self.connected:
            return b""
        # That nobody is there any more is an error, which `left` tells.
        with contextlib.suppress(OSError):
            return os.read(self._own, most)
        return b""

    def send(self, data: bytes) -> int:
        """As in `Port`."""
        if not self.connected:
            return len(data)
        try:
            return os.write(self._own, data)
        except BlockingIOError:
            return 0
        except OSError:
            return len(data)

    def wait(self, seconds: float, others: Sequence[int] = (), *, sending: bool = False) -> None:
        """As in `Port`."""
        # A device that nobody has open is always ready, to say that.
        own = [self._own] if self.connected else []
        longest = seconds if self.connected else min(seconds, NOBODY)
        if self._early:
            longest = 0.0
        _wait([*own, *others], own if sending else [], longest)

    def close(self) -> None:
        """As in `Port`."""
        os.close(self._own)


class TcpPort:
    """A TCP port of this computer that no other computer reaches.

    Args:
        number: of the port; 0 for any that is free.

    Raises:
        EndpointError: it cannot be had.
    """

    def __init__(self, number: int) -> None:
        self._other: socket.socket | None = None
        self._listening = socket.socket(socket.AF_INET, socket.SOCK_STREAM)
        try:
            if sys.platform != "win32":
                # A port that was in use a moment ago; on Windows it would be one that still is.
                self._listening.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            self._listening.bind((LOOPBACK, number))
            self._listening.listen()
        except OSError as error:
            self._listening.close()
            raise EndpointError(f"{LOOPBACK}:{number}: {reason(error)}") from None
        self._listening.setblocking(False)
        self.number: int = self._listening.getsockname()[1]
        self.name = f"{LOOPBACK}:{self.number}"

    @property
    def connected(self) -> bool:
        """As in `Port`."""
        return self._other is not None

    def left(self) -> bool:
        """As in `Port`."""
        if self._other is None or not (_shut(self._other.fileno()) or _ended(self._other)):
            return False
        self._other.close()
        self._other = None
        return True

    def receive(self, most: int) -> bytes:
        """As in `Port`; who comes while somebody is there is sent away."""
        self._accept()
        if self._other is not None:
            # An end of it is told by `left`.
            with contextlib.suppress(OSError):
                return self._other.recv(most)
        return b""

    def _accept(self) -> None:
        with contextlib.suppress(OSError):
            other, _ = self._listening.accept()
            if self._other is not None:
                other.close()
                return
            other.setblocking(False)
            other.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            self._other = other

    def send(self, data: bytes) -> int:
        """As in `Port`."""
        if self._other is None:
            return len(data)
        try:
            return self._other.send(data)
        except (BlockingIOError, InterruptedError):
            return 0
        except OSError:
            return len(data)

    def wait(self, seconds: float, others: Sequence[int] = (), *, sending: bool = False) -> None:
        """As in `Port`."""
        own = [] if self._other is None else [self._other.fileno()]
        reading = [self._listening.fileno(), *own, *others]
        _wait(reading, own if sending else [], seconds)

    def close(self) -> None:
        """As in `Port`."""
        self._listening.close()
        if self._other is not None:
            self._other.close()


def open_port(tcp: int | None) -> PseudoTerminal | TcpPort:
    """The port that was asked for: a TCP port by its number, or else a pseudo-terminal.

    Raises:
        EndpointError: it cannot be had.
    """
    return PseudoTerminal() if tcp is None else TcpPort(tcp)


def _shut(descriptor: int) -> bool:
    """Whether the other end has been shut; False where the system does not tell."""
    if not hasattr(select, "poll"):
        return False
    poll = select.poll()
    ends = select.POLLHUP | getattr(select, "POLLRDHUP", 0)
    poll.register(descriptor, ends)
    return any(event & ends for _, event in poll.poll(0))


def _ended(other: socket.socket) -> bool:
    """Whether all that a socket has sent was received, and it sends no more."""
    try:
        return not other.recv(1, socket.MSG_PEEK)
    except (BlockingIOError, InterruptedError):
        return False
    except OSError:
        return True


def _wait(reading: Sequence[int], writing: Sequence[int], seconds: float) -> None:
    if not reading and not writing:
        # Windows' select wants something to look at.
        time.sleep(seconds)
        return
    select.select(reading, writing, [], seconds)
