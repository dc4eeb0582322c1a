"""The line mode: the same machine for screen readers, braille displays and pipes.

What the machine prints is printed; a line typed here is typed there. Lines that begin with a point
are the program's own commands. In manual mode a line says which keys are held, and for how long.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TextIO

from trs80arm.bundled import PROGRAM_SUFFIX, named
from trs80arm.desk.last_resort import FAULT, last_words
from trs80arm.desk.opening import UNUSABLE, USAGE_ERROR, open_session
from trs80arm.desk.places import state_folder
from trs80arm.desk.reach import ALL_FILES, Reach
from trs80arm.desk.session import Session
from trs80arm.files import FileFormatError
from trs80arm.operator import ScriptError, parse_holds
from trs80arm.options import TerminalOptions
from trs80arm.reasons import one_line
from trs80arm.rig import Waiting
from trs80arm.shown import shown
from trs80arm.teletype import Teletype

SLICE = 0.05
"""Virtual seconds between two looks at the wall's clock and at Ctrl+C."""
HELP = """\
A line is typed into the TRS-80, with ENTER. Ctrl+C is BREAK. Lines with a point:
.open FILE   load a program          .save FILE   save the program
.run         type RUN                .screen      read the tube
.registers   counted and true steps  .pose        where the hand is
.events      what happened last      .quit        leave
In @SET: KEYS:SECONDS with keys joined by +, several of them, and 0 to end, as 6:1 1+W:0.5 0"""


class PlainMode:
    """One conversation with the machine.

    Args:
        session: the machine.
        out: where everything is printed.
        echo: whether what is typed is printed as well, for a transcript.
        speed: virtual seconds per second of the wall; None is flat out.
        reach: which files can be named.
        sleep: waits for so many seconds of the wall.
    """

    def __init__(
        self,
        session: Session,
        out: TextIO,
        *,
        echo: bool,
        speed: float | None,
        reach: Reach = ALL_FILES,
        sleep: Callable[[float], None] = time.sleep,
    ) -> None:
        self.session = session
        self._out = out
        self._echo = echo
        self._speed = speed
        self._reach = reach
        self._sleep = sleep
        self._teletype = Teletype(out)
        self._stop = session.rig.listen(self._printed)
        self._left = False

    def _printed(self, code: int, is_echo: bool) -> None:
        if self._echo or not is_echo or code < 32:
            self._teletype(code)

    def _tell(self, text: object) -> None:
        """Say something that the machine did not, on a line of its own."""
        self._teletype.end_line()
        print("\n".join(map(shown, str(text).split("\n"))), file=self._out)

    def talk(self, lines: Iterator[str]) -> int:
        """Take lines until `.quit` or the last one.

        Returns:
            The exit code, 0.
        """
        print("\n".join(line for line in self.session.rig.screen() if line), file=self._out)
        print("Type .help for help.", file=self._out, flush=True)
        while not self._left:
            self._work()
            try:
                line = next(lines, None)
            except KeyboardInterrupt:
                self._press_break()
                continue
            if line is None:
                break
            self.take(line.rstrip("\r\n"))
        self._teletype.end_line()
        return 0

    def take(self, line: str) -> None:
        """Do what one line says."""
        if line.startswith("."):
            self._command(line[1:].strip())
        elif self.session.rig.waiting is Waiting.SET:
            self._hold(line)
        else:
            self.session.rig.type(line + "\r")

    def _work(self) -> None:
        """Let the machine work, or a recording play, until the operator is wanted."""
        session = self.session
        try:
            while session.typing or session.waiting is Waiting.NOTHING:
                session.run_for(SLICE)
                self._out.flush()
                if self._speed is not None and session.waiting is Waiting.NOTHING:
                    self._sleep(SLICE / self._speed)
        except KeyboardInterrupt:
            session.stop_playing()
            self._press_break()
        for fault in session.new_faults():
            self._tell(fault)
        if session.waiting is Waiting.SET:
            self._tell("@SET: which keys? (.help)")
        self._out.flush()

    def _press_break(self) -> None:
        rig = self.session.rig
        rig.stop_typing()
        rig.hold(["BREAK"], 0.1)
        rig.run_for(0.3)

    def _hold(self, line: str) -> None:
        try:
            holds = parse_holds(line)
        except ScriptError as error:
            self._tell(error)
            return
        rig = self.session.rig
        for hold in holds:
            rig.hold(hold.keys, hold.seconds)
            rig.run_for(hold.seconds + SLICE)
        self._registers()

    def _command(self, text: str) -> None:
        word, _, rest = text.partition(" ")
        commands: dict[str, Callable[[], None]] = {
            "help": lambda: self._tell(HELP),
            "run": lambda: self.session.rig.type("RUN\r"),
            "screen": lambda: self._tell("\n".join(self.session.rig.screen())),
            "registers": self._registers,
            "pose": self._pose,
            "events": self._events,
            "quit": self._leave,
            "open": lambda: self._file(self._open, rest, "loaded", to_write=False),
            "save": lambda: self._file(self.session.save, rest, "saved", to_write=True),
        }
        do = commands.get(word)
        if do is None:
            self._tell(f"There is no .{word}; .help lists what there is.")
        else:
            do()

    def _open(self, path: Path) -> None:
        self.session.load(named(path, PROGRAM_SUFFIX))

    def _file(self, do: Callable[[Path], None], name: str, done: str, *, to_write: bool) -> None:
        if not name.strip():
            self._tell("Which file?")
            return
        path = self._reach.typed(name)
        if outside := self._reach.refusal(path, to_write=to_write):
            self._tell(outside)
            return
        try:
            do(path)
        except FileFormatError as error:
            self._tell(error)
        except OSError as error:
            self._tell(f"{path}: {error.strerror or error}")
        else:
            self._tell(f"{path.name} is {done}.")

    def _registers(self) -> None:
        rig = self.session.rig
        for name, register, true in zip(rig.joint_names, rig.registers, rig.joints, strict=True):
            lost = "" if register == true else f", {register - true} lost"
            self._tell(f"{name}: {register}, true {true}{lost}")

    def _pose(self) -> None:
        pose = self.session.rig.pose
        self._tell(
            f"X {pose.x:.2f}, Y {pose.y:.2f}, Z {pose.z:.2f} inches, pitch {pose.pitch:.1f}, "
            f"roll {pose.roll:.1f} degrees, hand open {pose.opening:.2f} inches"
        )

    def _events(self) -> None:
        for event in self.session.rig.arm.events[-5:]:
            self._tell(event.text)

    def _leave(self) -> None:
        self._left = True


def _typed_lines(stream: TextIO) -> Iterator[str]:
    """The lines of a terminal or a pipe; unlike a file's own iterator it survives Ctrl+C."""
    return iter(stream.readline, "")


def run_plain(options: TerminalOptions) -> int:
    """Open the line mode on standard input and output.

    Returns:
        The exit code: 0, or 2 when a file of the options cannot be used.
    """
    try:
        session = open_session(options)
    except UNUSABLE as error:
        print(f"trs80arm: {one_line(error)}", file=sys.stderr)
        return USAGE_ERROR
    plain = PlainMode(
        session,
        sys.stdout,
        echo=not sys.stdin.isatty(),
        speed=options.speed.factor,
        reach=Reach(options.own_folder),
    )
    if options.run:
        session.rig.type("RUN\r")
    try:
        return plain.talk(_typed_lines(sys.stdin))
    except OSError:
        raise  # Of the streams.
    except Exception as error:
        print(f"trs80arm: {last_words(error, state_folder(), session)}", file=sys.stderr)
        return FAULT
