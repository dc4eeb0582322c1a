"""The door: the command line run once, and whatever becomes of it told in one line."""

from __future__ import annotations

import sys

import click

from trs80arm.cli.commands import cli
from trs80arm.cli.ending import BROKEN_PIPE, INTERRUPTED, fail, tell
from trs80arm.cli.streams import give_up_output, open_streams


def main() -> None:
    """Run the command line; bad usage is told in one line."""
    open_streams()
    try:
        # Not `cli.main`, which has its own way with a broken pipe.
        with cli.make_context("trs80arm", sys.argv[1:]) as context:
            cli.invoke(context)
        sys.stdout.flush()
    except click.exceptions.Exit as ending:
        sys.exit(ending.exit_code)
    except click.UsageError as error:
        command = error.ctx.command_path if error.ctx else "trs80arm"
        fail(f"{error.format_message().rstrip('.')} ({command} --help tells more)")
    except (click.Abort, KeyboardInterrupt):
        sys.exit(INTERRUPTED)
    except BrokenPipeError:
        give_up_output()
        sys.exit(BROKEN_PIPE)
    except OSError as error:
        from trs80arm.reasons import one_line, reason

        if error.filename:
            fail(one_line(error))
        give_up_output()
        fail(f"standard output: {reason(error)}")
    except Exception as error:
        from trs80arm.desk.last_resort import FAULT, last_words
        from trs80arm.desk.places import state_folder

        tell(last_words(error, state_folder()))
        sys.exit(FAULT)
