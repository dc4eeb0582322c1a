"""Textual's Linux and macOS driver, asking the terminal for its size and for key releases as well.

It pushes its own entry on the terminal's stack of keyboard flags above Textual's and pops it before
Textual stops, so that the terminal is left as it was found and no release of the quit key reaches
the shell. The private hooks it leans on (size, start, stop and the input loop) are pinned by
`tests/ui/test_terminal_hooks.py`.
"""

from __future__ import annotations

import os
import selectors
from codecs import getincrementaldecoder
from collections.abc import Callable

from textual._parser import ParseError
from textual.driver import Driver
from textual.drivers.linux_driver import LinuxDriver

from trs80arm.options import KeyMode
from trs80arm.ui.terminal.parser import KeyParser

PUSH_ALL_FLAGS = "\x1b[>31u"
"""Disambiguate, event types, alternate keys, all keys as escapes, associated text."""
ASK_FLAGS = "\x1b[?u"
ASK_ATTRIBUTES = "\x1b[c"
"""Every terminal answers this one: an answer to it alone means no to the one before."""
POP_FLAGS = "\x1b[<u"
_READ_SIZE = 4096
_POLL_SECONDS = 0.1


class OwnSizeDriver(LinuxDriver):
    """The driver of a terminal that is asked itself how large it is.

    Textual believes the environment first, in which a shell may have left what was so at some time,
    or for another window, and then standard output, which may be a file.
    """

    def _get_terminal_size(self) -> tuple[int, int]:
        try:
            columns, lines = os.get_terminal_size(self.fileno)
        except OSError:
            columns = lines = 0
        # Behind a serial line a terminal may not know.
        return (columns, lines) if columns and lines else super()._get_terminal_size()


class KeyReleaseDriver(OwnSizeDriver):
    """The driver of a terminal that is asked for key releases.

    Attributes:
        insist: whether the terminal is taken to report releases whatever it answers.
    """

    insist = False
    _pushed = False

    def start_application_mode(self) -> None:
        """Start as Textual does, then ask for event types."""
        super().start_application_mode()  # type: ignore[no-untyped-call]
        # A process in the background may not touch the terminal, and stock start gave up then.
        if self._writer_thread is None:
            return
        self.write(PUSH_ALL_FLAGS + ASK_FLAGS + ASK_ATTRIBUTES)
        self.flush()
        self._pushed = True

    def stop_application_mode(self) -> None:
        """Take our flags off the stack, then stop as Textual does."""
        if self._pushed:
            self._pushed = False
            self.write(POP_FLAGS)
            self.flush()
        super().stop_application_mode()

    def run_input_thread(self) -> None:
        """Read the terminal until told to stop: Textual's loop with the parser of ours."""
        parser = KeyParser(self._debug, releases=self.insist)
        decode = getincrementaldecoder("utf-8")(errors="replace").decode
        with selectors.SelectSelector() as selector:
            selector.register(self.fileno, selectors.EVENT_READ)
            try:
                while not self.exit_event.is_set():
                    self._read_once(selector, parser, decode)
            finally:
                try:
                    for _ in parser.feed(""):
                        pass
                except (EOFError, ParseError):
                    pass

    def _read_once(
        self, selector: selectors.BaseSelector, parser: KeyParser, decode: Callable[[bytes], str]
    ) -> None:
        for _ in selector.select(_POLL_SECONDS):
            text = decode(os.read(self.fileno, _READ_SIZE))
            for message in parser.feed(text) if text else ():
                self.process_message(message)
        for message in parser.tick():
            self.process_message(message)


class InsistingDriver(KeyReleaseDriver):
    """The same for a terminal that reports releases but answers that it does not."""

    insist = True


def choose_driver(stock: type[Driver], mode: KeyMode) -> type[Driver]:
    """The driver to use: ours in place of the Linux one, any other as it is.

    Args:
        stock: what Textual would take; under textual-serve its web driver.
        mode: what the user wants of the keys; REPEAT asks nothing of the terminal.
    """
    if stock is not LinuxDriver:
        return stock
    if mode is KeyMode.REPEAT:
        return OwnSizeDriver
    return InsistingDriver if mode is KeyMode.EVENTS else KeyReleaseDriver
