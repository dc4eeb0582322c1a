"""The door: the command line run once, and whatever becomes of it told in one line."""

from __future__ import annotations

import sys

from trs80arm.cli.streams import open_streams
from trs80arm.cli.table import front_page


def main() -> None:
    """Run the command line; bad usage is told in one line."""
    open_streams()
    try:
        if sys.argv[1:] in (["--help"], ["-h"]):
            sys.stdout.write(front_page())
        else:
            from trs80arm.cli.commands import invoke

            invoke(sys.argv[1:])
        sys.stdout.flush()
    except (Exception, KeyboardInterrupt) as error:
        from trs80arm.cli.ending import leave

        leave(error)
