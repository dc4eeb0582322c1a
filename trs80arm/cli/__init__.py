"""The command line: `trs80arm [PROGRAM]` opens the terminal, its subcommands work without one.

Everything heavy is imported inside the commands, and a command, as click itself, when it is asked
for, so that `trs80arm --help` answers at once. Exit codes: 0 ended or limit reached as asked, 1 the
program stopped on a BASIC error, 2 bad usage or an unreadable file, with one line on standard
error.
"""

from trs80arm.cli.entry import main

__all__ = ["main"]
