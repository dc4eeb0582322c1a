"""What is on the desk: the machine, where its program came from, what is unsaved, what is played.

All of the desk comes here. It also is what the pacer paces: while a recording plays, the recorded
keys go down in it at their own virtual times.
"""

from __future__ import annotations

import re
from collections import deque
from collections.abc import Callable, Sequence
from itertools import takewhile
from pathlib import Path

from trs80arm.arm import benchfile
from trs80arm.arm.bench import Bench, BenchError
from trs80arm.arm.events import ArmEvent, EventKind
from trs80arm.arm.motors import RING
from trs80arm.benches import BenchFile
from trs80arm.desk.greeting import greet
from trs80arm.desk.keepsakes import Keepsakes
from trs80arm.desk.recording import Journal, Recording
from trs80arm.desk.timeline import Timeline
from trs80arm.files import (
    Kind,
    MachineCodeError,
    load_program,
    parse_program,
    save_program,
)
from trs80arm.machine.clock import T_STATES_PER_SECOND
from trs80arm.machine.jog_keys import JogKeys
from trs80arm.machine.tape import is_cassette_name
from trs80arm.rig import Input, Key, ReplayError, Rig, RigSettings, Score, Waiting

_NUMBERS = re.compile(r"^[ \t]*(\d+)", re.MULTILINE)
ProgramLines = tuple[tuple[int, bytes], ...]
_CASSETTE = "tape"
"""What a cassette is called whose file has no name for one."""
TRIES = 4
"""How often the operator tries to get the prompt before the machine is switched off."""
LEAVING = {Waiting.EDIT: "\x1bQ", Waiting.MEMORY_SIZE: "\r"}
"""What is typed where BREAK does not help: an insertion is ended, the editor quit."""
LONGEST_MOTION = 60.0
"""Virtual seconds for which a motion may go on after BREAK."""
GLANCE = 0.0004
"""Virtual seconds, a third of the shortest half-step, between two looks while keys are typed."""
LONGEST_STEP = 1.0
"""Virtual seconds after which waiting for a motor's next step is given up."""


class Session:
    """A rig with what a person at it would remember.

    Args:
        settings: the machine's fittings.
        bench: the bench file to set up, None for the standard bench.
        record: a file to which everything is written as it happens.
        greeting: whether the tube says what to type next.

    Attributes:
        rig: the machine; another one after a recording was begun.
        timeline: its past, and what it will do again after one went back.
        halted: whether it stands before a statement, so that no time passes.
        held_back: asked before time passes whether it must not, for now.
        broken_off: how the program ended that `ready` broke off last.
        keepsakes: its cassettes and paper, as far as they are in memory only.
        path: the file that the program came from or went to.
        system_name: what SYSTEM calls the machine code that `load` put into the recorder instead of
            a program; None if it did not.
        bench_path: the bench file, None for the standard bench.
        greeted: whether the tube said at first what to type next.

    Raises:
        OSError: the recording cannot be written.
        BenchError: the bench file cannot be read or is none.
    """

    def __init__(
        self,
        settings: RigSettings | None = None,
        bench: Path | None = None,
        record: Path | None = None,
        *,
        greeting: bool = False,
    ) -> None:
        self._settings = settings or RigSettings()
        file = BenchFile.read(bench) if bench else None
        self.bench_path = bench
        self.path: Path | None = None
        self.system_name: str | None = None
        self._observers: list[Callable[[], None]] = []
        self._played: deque[Input] = deque()
        self._play_end = 0
        self._play_fault: str | None = None
        self._told_faults: set[str] = set()
        self._pasting = False
        self.keepsakes = Keepsakes(lambda: self.rig)
        self.greeted = greeting

        def begin() -> Rig:
            rig = Rig(self._settings, file.bench if file else None)
            if greeting:
                greet(rig.console)
            return rig

        rig = begin()
        self.halted = False
        self.held_back: Callable[[], bool] = lambda: False
        self.broken_off: object = None
        timeline = self._timeline(rig, begin)
        journal = Journal(rig, file.text if file else None, record, greeting=greeting)
        self._use(rig, timeline, journal)

    def _timeline(self, rig: Rig, begin: Callable[[], Rig] | None = None) -> Timeline:
        """Keep a rig's past from now on; to be told of inputs before a journal is.

        Args:
            rig: the machine.
            begin: makes another that is as it is now.
        """
        # To switch on a machine with a ROM of its own takes longer than to keep it.
        beginning = begin if rig.settings.rom is None else None
        return Timeline(rig, lambda count: self._journal.cut(count), beginning)

    def _use(self, rig: Rig, timeline: Timeline, journal: Journal) -> None:
        self.rig = rig
        self.timeline = timeline
        self._journal = journal
        self.halted = False
        self._safe: ProgramLines = ()
        self.path = None
        self.keepsakes.forget()
        self._told_slip = False
        self._scored: object = rig.outcome
        self._last_event = -1
        self._tell_of_new_machine()

    def watch_machine(self, observer: Callable[[], None]) -> None:
        """Call `observer` whenever the machine was switched off and on, or is another one."""
        self._observers.append(observer)

    def _tell_of_new_machine(self) -> None:
        for observer in self._observers:
            observer()

    @property
    def jog_keys(self) -> JogKeys:
        """The keys of manual mode."""
        return self.rig.settings.driver.keys

    # -- time -------------------------------------------------------------------------------------

    @property
    def time(self) -> float:
        """Virtual seconds since power-on."""
        return self.rig.time

    @property
    def waiting(self) -> Waiting:
        """What the machine waits for: nothing while what was done is being done again."""
        again = self.playing or self.timeline.behind
        return Waiting.NOTHING if again else self.rig.waiting

    @property
    def typing(self) -> bool:
        """Whether typed text is still on its way into the machine."""
        return self.rig.typing

    @property
    def busy(self) -> bool:
        """Whether the machine works by itself, or its arm, instead of waiting for its operator."""
        controller = self.rig.controller
        arm_works = controller is not None and controller.works_alone
        return arm_works or self.typing or self.waiting is Waiting.NOTHING

    def paste(self, text: str) -> None:
        """Type a text that is there already, so that nobody wants to wait for it."""
        self.rig.type(text)
        self._pasting = True

    @property
    def hurried(self) -> bool:
        """Whether something goes on that takes long, and that nobody watches for its own sake.

        That is a paste being typed, and a tape going by; not a tape at its silent end.
        """
        self._pasting = self._pasting and self.typing
        return self._pasting or (self.rig.tape.passes and not self.playing)

    def run_for(self, seconds: float) -> None:
        """Let virtual time pass, and do what a recording that plays says meanwhile."""
        self._run_to(self.rig.clock.now + round(seconds * T_STATES_PER_SECOND))

    def _run_to(self, target: int) -> None:
        rig = self.rig
        if self.halted or self.held_back():
            return
        while self._played and self._played[0].time <= target:
            if not self.timeline.run_to(self._played[0].time):
                return
            done = self._played.popleft()
            try:
                rig.replay([done])
            except ReplayError as error:
                self.stop_playing()
                self._play_fault = f"it ends here, for {error}"
            else:
                self._note_program(done)
        self.timeline.run_to(target)

    def new_faults(self) -> list[str]:
        """What has gone wrong with cassette, paper and recordings, one line each, told once."""
        found = (
            ("cassette", self.rig.tape.fault),
            ("printer", self.rig.printer.fault),
            ("recording", self._journal.fault),
            ("recording", self._play_fault),
        )
        faults = {f"{what}: {fault}" for what, fault in found if fault is not None}
        new = faults - self._told_faults
        self._told_faults = faults
        return sorted(new)

    def _note_program(self, done: Input) -> None:
        if done.action == "load_lines":
            self._safe = self.program

    def step_motor(self) -> bool:
        """Go on to the next change of a latch.

        Returns:
            Whether there was one within `LONGEST_STEP`.
        """
        rig = self.rig
        self.halted = False
        before = list(rig.card.latches)
        end = rig.clock.now + round(LONGEST_STEP * T_STATES_PER_SECOND)

        def changed(_: int) -> bool:
            return rig.card.latches != before

        # A program may write to the card by itself: it stops behind the statement, or instruction.
        stops = rig.stop_before(changed), rig.stop_code_before(changed)
        try:
            while rig.clock.now < end and not self.halted:
                self._run_to(min(end, self._next_step()))
                if rig.card.latches != before:
                    return True
        finally:
            for stop in stops:
                stop()
        return False

    def _next_step(self) -> int:
        """The T-state up to which the driver changes no latch more than once."""
        rig = self.rig
        tick = rig.driver.next_tick
        if tick is not None:
            return tick + 1
        busy = rig.typing or bool(self._played) or rig.waiting is Waiting.NOTHING
        return rig.clock.now + round((GLANCE if busy else LONGEST_STEP) * T_STATES_PER_SECOND)

    # -- the program ------------------------------------------------------------------------------

    @property
    def program(self) -> ProgramLines:
        """The program in memory, crunched, line by line."""
        return self.rig.basic.program.lines()

    @property
    def unsaved(self) -> bool:
        """Whether the program in memory is neither empty nor what was loaded or saved last."""
        program = self.program
        return bool(program) and program != self._safe

    @property
    def title(self) -> str:
        """The program's file, and whether it is changed; empty without a program."""
        program = self.program
        if not program:
            return ""
        if self.path is None:
            return "new program"
        return self.path.name if program == self._safe else f"{self.path.name}, changed"

    def load(self, path: Path) -> None:
        """Put a program file into memory, or a cassette of machine code into the recorder.

        Such a cassette leaves the machine and its program as they are; `system_name` says what to
        load it by.

        Raises:
            FileFormatError: it is neither; the message begins with its path.
            OSError: it cannot be read.
        """
        self.system_name = None
        try:
            lines = load_program(path)
        except MachineCodeError as tape:
            name = path.stem if is_cassette_name(path.stem) else _CASSETTE
            self.rig.insert_cassette(name, tape.cassette)
            self.keepsakes.know(name)
            self.system_name = tape.name
            return
        self.ready()
        self.rig.load_lines(lines)
        self.path = path
        self._safe = self.program

    def load_bytes(self, data: bytes) -> None:
        """Put a listing into memory that no file holds yet.

        Raises:
            FileFormatError: it is no program.
        """
        lines = parse_program(data)
        self.ready()
        self.rig.load_lines(lines)

    def enter(self, listing: str) -> int:
        """Enter the lines of a listing at once, as if they had been typed at the prompt.

        A line takes the place of the one with its number; a number alone takes that line away.

        Returns:
            How many lines were entered.

        Raises:
            FileFormatError: one is no line of a program; then none is entered.
        """
        entered = dict(parse_program(listing.encode("utf-8")))
        numbers = [int(number) for number in _NUMBERS.findall(listing)]
        kept = {number: line for number, line in self.program if number not in set(numbers)}
        self.rig.load_lines(sorted((kept | entered).items()))
        return len(numbers)

    def ready(self) -> None:
        """Bring the machine back to its prompt as an operator would, or else by switching it off.

        A motion under way comes to its end first. A machine that stood before a statement goes on.
        """
        rig = self.rig
        self.halted = False
        rig.stop_typing()
        for _ in range(TRIES):
            if rig.waiting is Waiting.COMMAND:
                self.broken_off = rig.outcome
                return
            if rig.waiting in LEAVING:
                rig.type(LEAVING[rig.waiting])
                rig.run_until(lambda rig: rig.waiting is Waiting.COMMAND, LONGEST_MOTION)
            else:
                # Held, for a machine that looks for BREAK when a motion has ended.
                rig.press(Key.BREAK)
                rig.run_until(lambda rig: rig.waiting is Waiting.COMMAND, LONGEST_MOTION)
                rig.release(Key.BREAK)
        rig.reset()
        self._tell_of_new_machine()

    def save(self, path: Path, kind: Kind | None = None) -> None:
        """Save the program in memory, whole or not at all.

        Raises:
            FileFormatError: it cannot be written in that kind of file.
            OSError: the file cannot be written.
        """
        save_program(path, self.program, kind)
        self.path = path
        self._safe = self.program

    def reset(self) -> None:
        """Switch the machine off and on."""
        self.halted = False
        self.rig.reset()
        self._safe = ()
        self.path = None
        self._tell_of_new_machine()

    # -- bench and arm ----------------------------------------------------------------------------

    def set_bench(self, path: Path | None) -> None:
        """Set up another bench, None for the standard one.

        Raises:
            BenchError: the file cannot be read, is no bench, or none for this arm; all stays.
        """
        file = BenchFile.read(path) if path else None
        before = self._journal.bench_text
        self._journal.bench_text = file.text if file else None
        try:
            self.rig.set_bench(file.bench if file else Bench.standard())
        except BenchError:
            self._journal.bench_text = before
            raise
        self.bench_path = path

    def go_home(self) -> None:
        """Stop the program, put arm and parts back to where the bench has them, count from zero."""
        self.ready()
        text = self._journal.bench_text
        self.rig.set_bench(benchfile.parse(text, "bench") if text else Bench.standard())
        self._note_events()

    def new_slip(self) -> ArmEvent | None:
        """The slip by which the arm ceased to be where its registers say, told once; else None."""
        slip = self.slip
        if slip is None:
            self._note_events()
        told, self._told_slip = self._told_slip, slip is not None
        return None if told else slip

    @property
    def slip(self) -> ArmEvent | None:
        """The first slip since the arm was where its registers say; None while it is there."""
        new = takewhile(
            lambda event: event.number > self._last_event, reversed(self.rig.arm.events)
        )
        slips = [event for event in new if event.kind is EventKind.SLIP]
        if not slips or not any(abs(steps) >= RING for steps in self.rig.state.slipped):
            return None
        return slips[-1]

    def new_score(self) -> Score | None:
        """The score of a program that has ended on a bench with goals, told once; else None."""
        outcome = self.rig.outcome
        told, self._scored = outcome is self._scored, outcome
        if told or outcome is None or outcome.line is None or outcome.ending.value != "end":
            return None
        score = self.rig.score()
        again = self.playing or self.timeline.behind
        return score if score.total and not again else None

    def _note_events(self) -> None:
        """All that has happened so far has been made good."""
        events = self.rig.arm.events
        self._last_event = events[-1].number if events else -1

    # -- recordings -------------------------------------------------------------------------------

    @property
    def playing(self) -> bool:
        """Whether a recording plays."""
        return bool(self._played) or self.rig.clock.now < self._play_end

    def save_recording(self, path: Path) -> None:
        """Write everything that was done since the machine was switched on.

        Raises:
            OSError: the file cannot be written.
        """
        self._journal.save(path)

    @property
    def recorded(self) -> Sequence[str]:
        """Everything that was done since the machine was switched on, as lines of a recording."""
        return self._journal.lines

    def take_up(self, snapshot: bytes, recorded: Sequence[str]) -> None:
        """Put the machine of a snapshot on the desk.

        Args:
            snapshot: the machine.
            recorded: what brought it there, as lines of a recording; its head first.

        Raises:
            SnapshotError: it is none; the machine stays as it is.
        """
        self.rig.restore(snapshot)
        self.stop_playing()
        self.timeline.close()
        self.timeline = self._timeline(self.rig)
        # Who is told of inputs first is the timeline, then the journal.
        self._journal.take_up(recorded)
        self.halted = False
        self._note_events()
        self._tell_of_new_machine()

    def play(self, recording: Recording) -> None:
        """Put the recorded machine on the desk and let the recording play as time passes."""
        self._journal.close()
        self.timeline.close()
        rig = recording.rig()
        timeline = self._timeline(rig, recording.rig)
        self._use(rig, timeline, Journal(rig, recording.bench, greeting=recording.greeting))
        self._play_fault = None
        self._played = deque(recording.inputs)
        self._play_end = recording.end

    def stop_playing(self) -> None:
        """Leave the rest of a recording out; the machine stays as it is."""
        self._played.clear()
        self._play_end = 0

    def close(self) -> None:
        """Clear the desk."""
        self._journal.close()
