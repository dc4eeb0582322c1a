"""Textual's Linux and macOS driver, for terminals as they are.

It asks the terminal itself for its size, ends the program when the terminal goes, and asks for key
releases. For these it pushes its own entry on the terminal's stack of keyboard flags above
Textual's and pops it before Textual stops, so that the terminal is left as it was found and no
release of the quit key reaches the shell. The private hooks it leans on (size, output, start, stop
and the input loop) are pinned by `tests/ui/test_terminal_hooks.py`.
"""

from __future__ import annotations

import contextlib
import os
import selectors
from codecs import getincrementaldecoder
from collections.abc import Callable
from typing import Any, TextIO

from textual._parser import ParseError
from textual._xterm_parser import XTermParser
from textual.app import App
from textual.driver import Driver
from textual.drivers.linux_driver import LinuxDriver

from trs80arm.options import KeyMode
from trs80arm.ui.terminal.messages import TerminalWent
from trs80arm.ui.terminal.parser import KeyParser

PUSH_ALL_FLAGS = "\x1b[>31u"
"""Disambiguate, event types, alternate keys, all keys as escapes, associated text."""
ASK_FLAGS = "\x1b[?u"
ASK_ATTRIBUTES = "\x1b[c"
"""Every terminal answers this one: an answer to it alone means no to the one before."""
POP_FLAGS = "\x1b[<u"
_READ_SIZE = 4096
_POLL_SECONDS = 0.1


class _Output:
    """What is written to the terminal: nothing, when it is gone.

    Textual writes in a thread of its own, and waits for it when much is to be written. A thread
    that ended by an error would be waited for as long as the program is there.
    """

    def __init__(self, file: TextIO) -> None:
        self._file = file

    def write(self, text: str) -> None:
        with contextlib.suppress(OSError):
            self._file.write(text)

    def flush(self) -> None:
        with contextlib.suppress(OSError):
            self._file.flush()

    def fileno(self) -> int:
        return self._file.fileno()


class TerminalDriver(LinuxDriver):
    """The driver of a terminal that is asked itself how large it is, and that may go."""

    def __init__(self, app: App[Any], **options: Any) -> None:
        """Begin as Textual does.

        Args:
            app: the program.
            options: of Textual's driver.
        """
        super().__init__(app, **options)
        self._file: Any = _Output(self._file)

    def _get_terminal_size(self) -> tuple[int, int]:
        """Columns and lines.

        Textual believes the environment first, in which a shell may have left what was so at some
        time, or for another window, and then standard output, which may be a file.
        """
        try:
            columns, lines = os.get_terminal_size(self.fileno)
        except OSError:
            columns = lines = 0
        # Behind a serial line a terminal may not know.
        return (columns, lines) if columns and lines else super()._get_terminal_size()

    def _parser(self) -> XTermParser:
        """What makes messages of what is read."""
        return XTermParser(self._debug)

    def run_input_thread(self) -> None:
        """Read the terminal until told to stop, or until it goes: Textual's loop would go on."""
        parser = self._parser()
        decode = getincrementaldecoder("utf-8")(errors="replace").decode
        with selectors.SelectSelector() as selector:
            selector.register(self.fileno, selectors.EVENT_READ)
            try:
                while not self.exit_event.is_set():
                    if not self._read_once(selector, parser, decode):
                        self.process_message(TerminalWent())
                        return
            finally:
                try:
                    for _ in parser.feed(""):
                        pass
                except (EOFError, ParseError):
                    pass

    def _read_once(
        self, selector: selectors.BaseSelector, parser: XTermParser, decode: Callable[[bytes], str]
    ) -> bool:
        """Read what there is, for a moment; False when there is no terminal any more."""
        for _ in selector.select(_POLL_SECONDS):
            try:
                data = os.read(self.fileno, _READ_SIZE)
            except OSError:
                data = b""
            if not data:
                return False
            text = decode(data)
            for message in parser.feed(text) if text else ():
                self.process_message(message)
        for message in parser.tick():
            self.process_message(message)
        return True


class KeyReleaseDriver(TerminalDriver):
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

    def _parser(self) -> XTermParser:
        return KeyParser(self._debug, releases=self.insist)


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
        return TerminalDriver
    return InsistingDriver if mode is KeyMode.EVENTS else KeyReleaseDriver
