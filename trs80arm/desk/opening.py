"""Opens a sitting as the command line wants it: the machine, its bench, its program.

The screen and the line mode both begin here, and say in the same line why they cannot.
"""

from __future__ import annotations

from trs80arm.arm.bench import BenchError
from trs80arm.benches import bench_for
from trs80arm.desk import recording
from trs80arm.desk.session import Session
from trs80arm.files import FileFormatError
from trs80arm.options import TerminalOptions

UNUSABLE = (OSError, BenchError, FileFormatError, recording.RecordingError, ValueError)
"""What `open_session` raises when a file or an option cannot be used."""
USAGE_ERROR = 2
"""The exit code that says so."""


def open_session(options: TerminalOptions) -> Session:
    """The desk as the options want it: machine, bench, program; a recording kept, or played.

    Raises:
        OSError: a file cannot be read or written.
        BenchError: the bench file is none.
        FileFormatError: the program file is none.
        RecordingError: the recording is none.
        ValueError: a fitting of the machine cannot be.
    """
    program, bench = options.program, bench_for(options.program, options.bench)
    rom = None if options.rig is None else options.rig.rom
    started_with = (program, options.replay, rom)
    watched = options.demo or options.plain or options.serves_line
    greeting = not watched and all(choice is None for choice in started_with)
    session = Session(options.rig, bench, options.record, greeting=greeting)
    if options.replay is not None:
        session.play(recording.load(options.replay))
    elif program is not None:
        session.load(program)
    return session
