"""The terminal program in a browser, by textual-serve: for a classroom or a look from elsewhere.

The browser's terminal reports no key releases, so there keys are held by the timer, the latch or
the mouse; nothing else is missing. Who does not have the address that is printed at the start, with
the token in it, sees nothing; what a visitor can ask for is in `ui.visitors`.
"""

from __future__ import annotations

import sys
from pathlib import Path

from trs80arm.files import FileFormatError, load_program
from trs80arm.reasons import one_line

LOOPBACK = ("127.0.0.1", "localhost", "::1")
LIMITS = """\
Serving on {address}  (Ctrl+C ends it)
Only this address opens it. In a browser: no key releases (hold with the mouse, or latch with
Ctrl+D), one machine for each visitor, and {files}."""
OWN_FILES = "a folder of one's own that goes when this ends"
ALL_FILES = "files are those of this computer"
OPEN_TO_OTHERS = """\
Careful: {host} is not this computer alone. Whoever has the address can use the machine."""
FILES_OPEN_TO_OTHERS = """\
Careful: {host} is not this computer alone. Whoever has the address can read and write the files
that you can, through the open and save dialogs."""


class ServeError(Exception):
    """The terminal cannot be served; one clear line."""


def serve_terminal(
    host: str, port: int, program: Path | None, *, allow_files: bool = False
) -> None:
    """Serve the terminal until Ctrl+C.

    Args:
        host: the address to listen at.
        port: the port.
        program: a program for every visitor to begin with.
        allow_files: whether visitors reach the files of this computer, with the settings and
            cassettes of whoever serves; otherwise each has a folder of his own.

    Raises:
        ServeError: the extra is not installed, the program is none, or the port cannot be had.
    """
    try:
        import textual_serve.server  # type: ignore[import-not-found, unused-ignore]  # noqa: F401

        from trs80arm.ui.visitors import Visitors
    except ImportError:
        raise ServeError("serve needs the extra: pip install 'trs80arm[web]'") from None
    words = [sys.executable, "-m", "trs80arm", "terminal", "--keys", "repeat"]
    if program is not None:
        try:
            load_program(program)
        except (FileFormatError, OSError) as error:
            raise ServeError(one_line(error)) from None
        words.append(str(program.resolve()))
    server = Visitors(words, host, port, allow_files=allow_files)
    files = ALL_FILES if allow_files else OWN_FILES
    print(LIMITS.format(address=server.address, files=files), flush=True)
    if host not in LOOPBACK:
        warning = FILES_OPEN_TO_OTHERS if allow_files else OPEN_TO_OTHERS
        print(warning.format(host=host), flush=True)
    try:
        server.serve()
    except OSError as error:
        raise ServeError(f"{host}:{port}: {error.strerror or error}") from None
    finally:
        server.forget_visitors()
