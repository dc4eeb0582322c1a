"""The conversation of the line mode: what the machine prints, and what is typed into it."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, TextIO

from trs80arm.deck import Deck
from trs80arm.desk.code_debugger import CodeDebugger
from trs80arm.desk.debugger import Debugger
from trs80arm.desk.files import SessionFiles
from trs80arm.desk.happenings import Happenings
from trs80arm.desk.last_resort import FAULT, last_words
from trs80arm.desk.leaving import Leaving
from trs80arm.desk.opening import UNUSABLE, USAGE_ERROR, open_session
from trs80arm.desk.pendant import Pendant
from trs80arm.desk.peripherals import Peripherals
from trs80arm.desk.places import STATES, RecentFiles, sitting_name, state_folder
from trs80arm.desk.plugged import Plugged, plug_in
from trs80arm.desk.proof import Proof
from trs80arm.desk.reach import ALL_FILES, Reach
from trs80arm.desk.recovery import Recovery
from trs80arm.desk.session import Session
from trs80arm.desk.sound import LineSound
from trs80arm.desk.states import States
from trs80arm.desk.teach import Lesson
from trs80arm.desk.tour import FILE as TOUR_FILE
from trs80arm.desk.tour import Step, Tour
from trs80arm.desk.workbench import Workbench
from trs80arm.operator import ScriptError, parse_holds
from trs80arm.options import Sound, TerminalOptions
from trs80arm.plain.arm import show_registers
from trs80arm.plain.asking import LineAsking
from trs80arm.plain.command import Sitting
from trs80arm.plain.debugging import tell_stop
from trs80arm.plain.table import do_command, is_command
from trs80arm.plain.teaching import show_positions
from trs80arm.reasons import one_line
from trs80arm.rig import Rig, Waiting
from trs80arm.serial.wire import WireError
from trs80arm.shown import shown
from trs80arm.teletype import Teletype

if TYPE_CHECKING:
    from trs80arm.serial.courier import Courier
    from trs80arm.serial.limits import Plugging

SLICE = 0.05
"""Virtual seconds between two looks at the wall's clock and at Ctrl+C."""
MARK_EVERY = 200
"""Slices between two snapshots to which one can go back, while something runs."""


class PlainMode:
    """One conversation with the machine.

    Args:
        session: the machine.
        out: where everything is printed.
        echo: whether what is typed is printed as well, for a transcript; nobody is then there to
            be asked before something is lost.
        speed: virtual seconds per second of the wall; None is flat out.
        reach: which files can be named.
        sleep: waits for so many seconds of the wall.
        turbo: whether the machine goes flat out while a tape goes by.
        sound: how programs are heard that make sound.
        courier: takes orders to the real arm that is plugged in, if one is.
        plugging: by which wire.
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
        turbo: bool = True,
        sound: Sound = Sound.OFF,
        courier: Courier | None = None,
        plugging: Plugging | None = None,
    ) -> None:
        self.session = session
        self._out = out
        self._echo = echo
        self._speed = speed
        self._sleep = sleep
        self._turbo = turbo
        self._teletype = Teletype(out)
        self._heard: Rig | None = None
        self._listen()
        session.watch_machine(self._listen)
        self._happenings = Happenings(session)
        self._left = False
        self._tape = ""
        self._step: Step | None = None
        self._slices = 0
        self._sitting = self._sit_down(reach)
        self._plugged = Plugged(session, courier, plugging, self._sitting.ask, self._say)
        self._sound = LineSound(session, self._ring, self._say, sound)

    def _listen(self) -> None:
        """Print what the machine prints from now on; it may be another one."""
        if self._heard is not self.session.rig:
            self._heard = self.session.rig
            self._heard.listen(self._printed)

    def _sit_down(self, reach: Reach) -> Sitting:
        """The desk with everything on it."""
        session, lesson, say = self.session, Lesson(), self._say
        state = state_folder()
        self._recovery = Recovery(session, lesson, state, sitting_name(), say)
        ask = LineAsking(say, reach, careful=not self._echo)
        recent = RecentFiles(state / "recent.json")
        files = SessionFiles(session, self._recovery, recent, ask, say, reach, "RUN")

        def show() -> None:
            show_positions(self._sitting, "")

        leaving = Leaving(session, lesson, self._recovery, files, ask, show, self._end)
        self._pendant = Pendant(session, lesson, self._tell_typed)
        debugger = Debugger(session)
        return Sitting(
            session=session,
            files=files,
            proof=Proof(session, ask, say),
            workbench=Workbench(session, files, ask, say),
            peripherals=Peripherals(session, ask, say),
            lesson=lesson,
            tour=Tour(session, lesson, files, state / TOUR_FILE, ask, say),
            pendant=self._pendant,
            debugger=debugger,
            code=CodeDebugger(debugger),
            states=States(state / STATES),
            ask=ask,
            tell=self._tell,
            reach=reach,
            leave=leaving.leave,
        )

    def _end(self) -> None:
        self._left = True

    def _printed(self, code: int, is_echo: bool) -> None:
        if self._echo or not is_echo or code < 32:
            self._teletype(code)

    def _ring(self) -> None:
        """The bell of the terminal; a file has none."""
        if self._out.isatty():
            self._out.write("\a")

    def _tell_typed(self, command: str) -> None:
        """What the pendant types, unless all that is typed is seen anyway."""
        if not self._echo:
            self._tell(f">{command}")

    def _tell(self, text: object) -> None:
        """Say something that the machine did not, on a line of its own."""
        self._teletype.end_line()
        print("\n".join(map(shown, str(text).split("\n"))), file=self._out)

    def _say(self, text: str, *, error: bool = False) -> None:
        self._tell(text)

    def begin_tour(self) -> None:
        """Begin the tour, or go on with it."""
        self._sitting.tour.begin()

    def talk(self, lines: Iterator[str]) -> int:
        """Take lines until `.quit` or the last one.

        Returns:
            The exit code, 0.
        """
        print("\n".join(line for line in self.session.rig.screen() if line), file=self._out)
        rom = self.session.rig.settings.rom
        if rom is not None:
            print(rom.told, file=self._out)
        if self.session.system_name is not None:
            self._sitting.files.tell_of_machine_code(self.session.system_name)
        print("Type .help for help.", file=self._out, flush=True)
        self._plugged.begin()
        while not self._left:
            self._work()
            try:
                line = next(lines, None)
            except KeyboardInterrupt:
                self._press_break()
                continue
            if line is not None:
                self.take(line.rstrip("\r\n"))
            elif not self._asks_at_the_end():
                break
        self._plugged.close()
        for what, path in self._recovery.kept():
            self._tell(f"{what} in {path}")
        self._recovery.let_go()
        self._teletype.end_line()
        return 0

    def _asks_at_the_end(self) -> bool:
        """The lines end. A person, who pressed Ctrl+D, is asked what `.quit` asks, and once.

        Returns:
            Whether an answer is to come; if not, copies are kept of what is unsaved.
        """
        if self._echo:
            return False
        if self._sitting.ask.waits:
            self._recovery.keep()
            return False
        self._sitting.leave()
        if self._sitting.ask.waits:
            self._tell("Ctrl+D again leaves and keeps a recovery copy.")
        return self._sitting.ask.waits

    def take(self, line: str) -> None:
        """Do what one line says."""
        if self._sitting.ask.waits and not is_command(line):
            self._sitting.ask.answer(line)
        elif line.startswith("."):
            self._sitting.ask.drop()
            do_command(self._sitting, line[1:].strip())
        elif self.session.halted:
            self._tell("The machine stands: .go lets it go on, .help says what else there is.")
        elif self.session.rig.waiting is Waiting.SET:
            self._hold(line)
        else:
            self.session.rig.type(line + "\r")

    def _work(self) -> None:
        """Let the machine work, or a recording play, until the operator is wanted."""
        session = self.session
        plugged = self._plugged
        plugged.go_on()
        try:
            session.timeline.mark()
            while (session.busy or self._pendant.busy) and not (session.halted or plugged.asks):
                self._pendant.go_on()
                session.run_for(SLICE)
                plugged.deliver()
                self._slices += 1
                if self._slices % MARK_EVERY == 0:
                    session.timeline.mark()
                self._tell_happenings()
                self._tell_of_tape()
                self._tell_of_tour()
                self._sound.go_on()
                self._out.flush()
                hurried = self._turbo and session.hurried
                if self._speed is not None and session.waiting is Waiting.NOTHING and not hurried:
                    self._sleep(SLICE / self._speed)
            plugged.finish()
        except KeyboardInterrupt:
            session.stop_playing()
            if self._pendant.busy:
                self._pendant.stop()
            else:
                self._press_break()
        self._tell_happenings()
        self._tell_of_tour()
        if self._pendant.message:
            self._tell(self._pendant.message)
            self._pendant.message = ""
        for fault in session.new_faults():
            self._tell(fault)
        if (score := session.new_score()) is not None:
            self._tell(f"* {score.headline}. .score says more.")
        stands = tell_stop(self._sitting)
        if session.waiting is Waiting.SET and not self._sitting.ask.waits and not stands:
            self._tell("@SET: which keys? (.help)")
        self._out.flush()

    def _tell_of_tour(self) -> None:
        """Go on in the tour, and say what comes next; each step is said once."""
        tour = self._sitting.tour
        tour.go_on()
        if tour.step is not None and tour.step is not self._step:
            self._tell(f"Tour {tour.place}, {tour.step.title}. {tour.step.plain}")
        self._step = tour.step

    def _tell_of_tape(self) -> None:
        """What the recorder does, whenever that is something else."""
        rig = self.session.rig
        doing = Deck.of(rig).doing if rig.tape.running else ""
        if doing and doing != self._tape:
            self._tell(f"* {doing}")
        self._tape = doing

    def _tell_happenings(self) -> None:
        """What became of parts and motors since the last look."""
        for event in self._happenings.new():
            self._tell(f"* {event.text}")
            if event.steps and self.session.new_slip() is not None:
                self._tell(".recover says what is lost and takes the arm back.")

    def _press_break(self) -> None:
        self._plugged.stop()
        rig = self.session.rig
        self.session.halted = False
        rig.stop_typing()
        rig.hold(["BREAK"], 0.1)
        rig.run_for(0.3)

    def _hold(self, line: str) -> None:
        try:
            holds = parse_holds(line)
        except ScriptError as error:
            self._tell(error)
            return
        session = self.session
        for hold in holds:
            if session.halted:
                break
            session.rig.hold(hold.keys, hold.seconds)
            session.run_for(hold.seconds + SLICE)
        self._tell_happenings()
        show_registers(self._sitting, "")


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
        courier = plug_in(session, options.plug)
    except (*UNUSABLE, WireError) as error:
        print(f"trs80arm: {one_line(error)}", file=sys.stderr)
        return USAGE_ERROR
    plain = PlainMode(
        session,
        sys.stdout,
        echo=not sys.stdin.isatty(),
        speed=options.speed.factor,
        reach=Reach(options.own_folder),
        turbo=options.turbo,
        sound=options.sound,
        courier=courier,
        plugging=options.plug,
    )
    if options.tour:
        plain.begin_tour()
    if options.run:
        session.rig.type("RUN\r")
    try:
        return plain.talk(_typed_lines(sys.stdin))
    except OSError:
        raise  # Of the streams.
    except Exception as error:
        print(f"trs80arm: {last_words(error, state_folder(), session)}", file=sys.stderr)
        return FAULT
