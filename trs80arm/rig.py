"""The rig: one TRS-80, one interface card, one MiniMover 5 and its bench, wired together.

This is the public door of the project. The terminal, the command line and tests all drive the same
`Rig`: they type, hold keys, let virtual time pass and look. It never sleeps and never looks at the
wall clock, so the same inputs at the same virtual times give the same run to the last bit, however
the time is sliced.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from trs80arm import files
from trs80arm.arm.bench import Bench
from trs80arm.arm.by_hand import TURNED_BY_HAND
from trs80arm.arm.cell.inputs import Answer
from trs80arm.arm.events import ArmEvent
from trs80arm.arm.fixtures import Part
from trs80arm.arm.goals import Score
from trs80arm.arm.loads import Loads
from trs80arm.arm.minimover import MiniMover
from trs80arm.arm.model import Pose
from trs80arm.arm.state import ArmState
from trs80arm.basic import cruncher
from trs80arm.basic.activity import Waiting
from trs80arm.basic.errors import BasicError
from trs80arm.basic.outcome import Outcome
from trs80arm.basic.state import Listener as StatementListener
from trs80arm.machine.card import MOTORS, Card, Latch, Observer
from trs80arm.machine.clock import T_STATES_PER_SECOND, Clock
from trs80arm.machine.console import Console
from trs80arm.machine.driver import Counts, Driver
from trs80arm.machine.keys import Key
from trs80arm.machine.memory import Memory
from trs80arm.machine.ports import LineListener
from trs80arm.machine.printer import Printer
from trs80arm.machine.tape import Tape
from trs80arm.machine.video import Video
from trs80arm.machine.z80.processor import Processor
from trs80arm.serial.pendant_keys import key_named
from trs80arm.snapshot_error import SnapshotError
from trs80arm.works.beginnings import copied, switch_on, switched_on
from trs80arm.works.devices import Language, RigSettings, Works, assemble
from trs80arm.works.inputs import Input, ReplayError, replay
from trs80arm.works.key_events import KeyEvents
from trs80arm.works.named_variables import NamedVariables
from trs80arm.works.observers import Observers, attach
from trs80arm.works.running import Running
from trs80arm.works.trial import try_out, use_up

if TYPE_CHECKING:
    from trs80arm.serial.controller import Controller
    from trs80arm.serial.controller import Listener as SerialListener

__all__ = [
    "TURNED_BY_HAND",
    "ChangeError",
    "Counts",
    "Input",
    "Key",
    "Loads",
    "NoControllerError",
    "Pose",
    "ReplayError",
    "Rig",
    "RigSettings",
    "Score",
    "SnapshotError",
    "Waiting",
]

LONGEST_HOLD = 86_400.0
"""Seconds for which a key can be held, a day."""


class ChangeError(ValueError):
    """What somebody wanted to change cannot be; the machine's error or one line that says why."""


class NoControllerError(ValueError):
    """An arm without a computer of its own was to be reached over a serial line."""


class Rig:
    """A TRS-80 Level II with ARMBASIC, its interface card, a MiniMover 5 and a bench.

    Args:
        settings: the machine's fittings.
        bench: what stands on the table; the default is a table with one part.

    The machine is switched on and answers MEMORY SIZE? by itself; it stands at `READY` afterwards.
    """

    def __init__(self, settings: RigSettings | None = None, bench: Bench | None = None) -> None:
        chosen = settings or RigSettings()
        self._observers = Observers()
        self._observers.resets.append(self._zero)
        self._use(switched_on(chosen, bench))

    def _use(self, works: Works) -> None:
        self._works = works
        self._keys = KeyEvents(works)
        self._running = Running(works, self._keys, self._observers)
        self._observers.connect(works)

    @property
    def settings(self) -> RigSettings:
        """The machine's fittings."""
        return self._works.settings

    # -- time ---------------------------------------------------------------------------------

    @property
    def clock(self) -> Clock:
        """The one clock of the rig, in T-states."""
        return self._works.clock

    @property
    def time(self) -> float:
        """Virtual seconds since power-on."""
        return self._works.clock.now / T_STATES_PER_SECOND

    def run_for(self, seconds: float) -> bool:
        """Let `seconds` of virtual time pass.

        A statement of BASIC is never cut, so the clock may come to stand a statement later; the
        next call then has that much less to do, and many short calls come to where one long one
        does (but for `seconds`, which are rounded to T-states).

        Returns:
            Whether they have passed: not if the machine was stopped (`stop_before`).

        Raises:
            ValueError: that is no time, or after `END_OF_TIME`.
        """
        return self._running.run_for(seconds)

    def run_to(self, target: int) -> bool:
        """Run until the clock shows at least `target` T-states.

        Returns:
            Whether it does: not if the machine was stopped before a statement (`stop_before`).

        Raises:
            ValueError: that is after `END_OF_TIME`.
        """
        return self._running.run_to(target)

    def run_until(self, condition: Callable[[Rig], bool], seconds: float = 60.0) -> bool:
        """Run until `condition(rig)` holds, looking each time the machine begins to wait, too.

        Args:
            condition: looked at each sixtieth of a virtual second, and when a wait begins.
            seconds: the most virtual time to spend.

        Returns:
            Whether the condition holds.
        """
        return self._running.run_until(lambda: condition(self), seconds)

    def run_until_line(self, line: int, seconds: float = 60.0) -> bool:
        """Run until the program is about to execute the first statement of a line.

        The machine stops at the very T-state, before the statement, and goes on with it. A machine
        that stands at the line already goes on to where it comes to the line again.

        Args:
            line: its number.
            seconds: the most virtual time to spend.

        Returns:
            Whether it got there. A program that has ended, waits for its operator, or has no such
            line uses up the time.
        """
        return self._running.run_until_line(line, seconds)

    def run_until_text(self, text: str, seconds: float = 60.0) -> bool:
        r"""Run until the machine has printed a text since this call, or what was typed shows it.

        Looked at each sixtieth of a virtual second. It does not matter whether it is still on
        the tube by then; the end of a line is `\n`.

        Args:
            text: as it is sent to the display.
            seconds: the most virtual time to spend.

        Returns:
            Whether it was printed.
        """
        return self._running.run_until_text(text, seconds)

    def run_until_waiting(self, seconds: float = 60.0) -> Waiting:
        """Run until everything typed is in and the machine waits for the operator again.

        Returns:
            What it waits for; NOTHING if it still works after that many virtual seconds.
        """
        return self._running.run_until_waiting(seconds)

    def step_statement(self) -> int | None:
        """Let the machine do one statement of BASIC, or of what it does instead.

        A statement that begins a motion of the arm is done when the motion has ended, or when the
        operator is asked for something. Key events that are due are applied first.

        Returns:
            The number of the line that is next; None when no program runs.
        """
        self._record("step_statement")
        return self._running.step_statement()

    # -- the operator's hands -----------------------------------------------------------------

    def _record(self, action: str, *arguments: Any) -> None:
        if self._observers.inputs:
            done = Input(self.clock.now, action, arguments)
            for recorder in self._observers.inputs:
                recorder(done)

    def record(self, recorder: Callable[[Input], None]) -> Callable[[], None]:
        """Call `recorder` with everything the operator does from now on.

        Returns:
            A function that ends the recording.
        """
        return attach(self._observers.inputs, recorder)

    def replay(self, inputs: Iterable[Input]) -> None:
        """Do again what was recorded, each thing at its own virtual time.

        Raises:
            ReplayError: something recorded cannot be done, as moving the arm by hand to where
                something stands. What comes before it is done.
        """
        replay(self, inputs)

    def press(self, key: Key | str) -> None:
        """Hold a key down from now on.

        Raises:
            ValueError: the TRS-80 has no such key.
        """
        if not isinstance(key, Key):
            key = Key(key)
        self._record("press", str(key))
        self._keys.add(self._works.clock.now, key, True)

    def release(self, key: Key | str) -> None:
        """Let a key go. A key that is not held is left alone.

        Raises:
            ValueError: the TRS-80 has no such key.
        """
        if not isinstance(key, Key):
            key = Key(key)
        self._record("release", str(key))
        self._keys.add(self._works.clock.now, key, False)

    def release_all(self) -> None:
        """Let every key go, also those that were still to be pressed."""
        self._record("release_all")
        self._keys.release_all()

    def hold(self, keys: Iterable[Key | str], seconds: float) -> None:
        """Press keys together now and let them go after `seconds` of virtual time.

        Raises:
            ValueError: the TRS-80 has no such key, or it is no time from 0 to `LONGEST_HOLD`.
        """
        if not 0 <= seconds <= LONGEST_HOLD:
            raise ValueError(f"keys can be held for 0 to {LONGEST_HOLD:.0f} seconds")
        held = [Key(key) for key in keys]
        self._record("hold", [str(key) for key in held], seconds)
        self._keys.hold(held, seconds)

    def type(self, text: str) -> None:
        r"""Type text on the keyboard, `\r` or `\n` for ENTER.

        Each character is a key held down in the matrix as long as the machine needs to see it;
        after ENTER the typist waits until the machine waits again. Returns at once: the keys go
        down as virtual time passes.
        """
        self._record("type", text)
        self._works.typist.add(text)

    def stop_typing(self) -> None:
        """Forget what is still to be typed, in the middle of a line too."""
        self._record("stop_typing")
        self._keys.stop_typing()

    def load_text(self, text: str) -> None:
        """Put the program of a listing into memory at once, as CLOAD would.

        Raises:
            FileFormatError: a line of it is no program line.
        """
        self.load_bytes(text.encode("latin-1", errors="replace"))

    def load(self, path: Path | str) -> None:
        """Load a program file of any of the known formats, told apart by content.

        Raises:
            FileFormatError: the file is damaged or no program.
            OSError: the file cannot be read.
        """
        self.load_lines(files.load_program(Path(path)))

    def load_bytes(self, data: bytes) -> None:
        """Load the content of a program file.

        Raises:
            FileFormatError: the content is damaged or no program.
        """
        self.load_lines(files.parse_program(data))

    def load_lines(self, lines: Iterable[tuple[int, bytes]]) -> None:
        """Put a program of crunched lines, each with its number, into memory."""
        lines = list(lines)
        self._record("load_lines", lines)
        self._works.basic.load_lines(lines)

    def save(self, path: Path | str) -> None:
        """Save the program in memory in the format of the file's suffix, whole or not at all.

        Raises:
            FileFormatError: a line holds what a file of that kind cannot.
            OSError: the file cannot be written; an older one is then untouched.
        """
        files.save_program(Path(path), self._works.basic.program.lines())

    def reset(self) -> None:
        """Switch the machine off and on again. The arm, unpowered, and its bench stay as they are.

        The clock goes on, so that everything that happens has a time of its own. An arm with a
        computer of its own (`RigSettings.controller`) goes on with what it does.
        """
        self._record("reset")
        old = self._works
        if old.controller is None:
            old.driver.reset()
            old.card.write_latch(Latch.AUXILIARY, 0)
        self._use(assemble(self.settings, old.arm, old))
        switch_on(self._works, self._running)

    def push_reset(self) -> None:
        """Push the button at the machine's back: out of machine code to READY, program kept.

        It is the Z-80's non-maskable interrupt. BASIC itself is broken off with BREAK; while it
        is at work the button does nothing.
        """
        self._record("push_reset")
        self._works.basic.push_reset()

    def set_bench(self, bench: Bench) -> None:
        """Clear the table and set up another bench.

        The arm goes to where that bench wants it, motors off and registers zero as by `@RESET`.

        Raises:
            BenchError: the arm cannot stand there; all stays as it is.
        """
        works = self._works
        world = works.arm.prepare(copied(bench))
        self._record("set_bench", bench)
        if works.controller is not None:
            works.controller.stop()
        works.reset_driver()
        works.arm.work_at(world)
        self._zero()

    def _zero(self) -> None:
        """The registers stand at zero from now on, with the rotors where they are."""
        self._works.zero = self._works.arm.state().rotors
        self._works.arm.forget_peaks()

    def refill(self) -> None:
        """Put every part of the bench back to where it was at the start.

        Raises:
            InTheWay: the arm stands where one of them was; all are left as they are.
        """
        self._works.arm.refill()
        self._record("refill")

    def move_joint(self, joint: str, value: float) -> None:
        """Turn one joint by hand, as the operator can while the motors are off.

        Args:
            joint: "base", "shoulder", "elbow", "pitch" or "roll" with `value` in degrees, or "hand"
                with `value` in inches.
            value: where to.

        Raises:
            MotorsOn: the motors hold the arm.
            InTheWay: something on the bench is there.
            ValueError: the joint does not go that far.
        """
        self._works.arm.move_joint(joint, value)
        self._record("move_joint", joint, value)

    def change(self, statement: str) -> None:
        """Do an assignment or a POKE beside the program, in no time.

        The machine itself does it, so that it is checked as a typed one is.

        Args:
            statement: as it would be typed, `A$="X"` or `POKE 15360,65`.

        Raises:
            ChangeError: the machine's error, as `?OV Error`, or why it is no such statement. Then
                nothing is changed.
        """
        before = self.snapshot()
        try:
            crunched, _ = cruncher.crunch(statement.encode("latin-1"))
            self._works.basic.aside(crunched)
        except BasicError as error:
            self.go_back(before)
            raise ChangeError(f"?{error.code.letters} Error") from None
        except UnicodeEncodeError:
            raise ChangeError("the machine has no such characters") from None
        except ValueError as error:
            raise ChangeError(str(error)) from None
        self._record("change", statement)

    def pull(self, x: float, y: float, z: float) -> None:
        """Pull at the hand until `let_go`, or push: ounces along x, y and z, at the fingertip.

        With their current on the motors hold against it as well as they can; without current the
        joints give way to what is more than the friction of their gears.

        Raises:
            ValueError: it is more than any hand, or no number.
        """
        self._works.arm.pull((x, y, z))
        self._record("pull", x, y, z)

    def let_go(self) -> None:
        """Do not pull at the hand any more."""
        self._record("let_go")
        self._works.arm.pull(None)

    def move_to(self, pose: Pose) -> None:
        """Put the hand by hand to a pose, as the operator can while the motors are off.

        Raises:
            MotorsOn: the motors hold the arm.
            OutOfReach: the arm cannot take that pose.
            InTheWay: something on the bench is there.
            ValueError: a joint or the hand does not go that far.
        """
        self._works.arm.move_to(pose)
        self._record("move_to", pose)

    # -- the serial line and the pendant -------------------------------------------------------

    def receive(self, data: bytes) -> None:
        """Let bytes come over the serial line to the computer in the arm's base, now.

        Raises:
            NoControllerError: the arm has none (`RigSettings.controller`).
        """
        self._controller.receive(data)
        self._record("receive", data)

    def hang_up(self) -> None:
        """Leave the other end of the serial line: the arm stops, what was asked is forgotten.

        Raises:
            NoControllerError: the arm has no computer of its own.
        """
        self._controller.hang_up()
        self._record("hang_up")

    def press_pendant(self, name: str) -> None:
        """Hold a key of the arm's teach pendant down from now on.

        Args:
            name: a function key, as `STOP` (`FunctionKey`), or one that moves the arm, as
                `BASE_PLUS` (`JointKey`).

        Raises:
            NoControllerError: the arm has no computer of its own, and so no pendant.
            ValueError: the pendant has no such key.
        """
        self._controller.press(key_named(name))
        self._record("press_pendant", name)

    def release_pendant(self, name: str) -> None:
        """Let a key of the teach pendant go. A key that is not held is left alone.

        Raises:
            NoControllerError: the arm has no computer of its own, and so no pendant.
            ValueError: the pendant has no such key.
        """
        self._controller.release(key_named(name))
        self._record("release_pendant", name)

    @property
    def controller(self) -> Controller | None:
        """The computer in the arm's base, for looking at; None for an arm without one."""
        return self._works.controller

    @property
    def _controller(self) -> Controller:
        controller = self._works.controller
        if controller is None:
            raise NoControllerError("the arm has no computer of its own, and no serial line")
        return controller

    # -- recorder and printer -----------------------------------------------------------------

    def insert_cassette(self, name: str, content: bytes | None = None) -> None:
        """Put a cassette into the recorder, rewound; a new one if there is none of that name.

        Args:
            name: of the cassette.
            content: what is on it; None takes it from the shelf. A recording of the session has
                it, so that it is played again with the same cassette.

        Raises:
            BadCassetteName: the name cannot be one.
        """
        tape = self.tape
        tape.insert(name, content)
        self._record("insert_cassette", tape.cassette, tape.content)

    def rewind_cassette(self) -> None:
        """Rewind the cassette in the recorder."""
        self._record("rewind_cassette")
        self.tape.rewind()

    def eject_cassette(self) -> None:
        """Take the cassette out; the recorder then helps itself to what a statement needs."""
        self._record("eject_cassette")
        self.tape.eject()

    def tear_off_paper(self) -> None:
        """Take the printed paper away; the printer's file has it, if there is one."""
        self._record("tear_off_paper")
        self.printer.tear_off()

    # -- what there is to see -----------------------------------------------------------------

    @property
    def waiting(self) -> Waiting:
        """What the machine waits for."""
        return self._works.basic.waiting

    @property
    def typing(self) -> bool:
        """Whether typed text is still on its way into the machine."""
        return self._works.typist.pending or bool(self._works.events)

    @property
    def to_type(self) -> int:
        """How many characters of a text are still to be typed."""
        return self._works.typist.left + self._keys.typed

    @property
    def outcome(self) -> Outcome | None:
        """How the last program ended; None while one runs."""
        return self._works.basic.outcome

    @property
    def basic(self) -> Language:
        """The language, for looking at: its program, variables and state."""
        return self._works.basic

    @property
    def variables(self) -> NamedVariables:
        """The program's variables by name: `rig.variables["A1"]`, to be read and written."""
        return NamedVariables(self._works.basic, self.change)

    @property
    def processor(self) -> Processor:
        """The Z-80 and its registers."""
        return self._works.processor

    @property
    def memory(self) -> Memory:
        """The memory map."""
        return self._works.memory

    @property
    def video(self) -> Video:
        """The video memory."""
        return self._works.video

    @property
    def card(self) -> Card:
        """The interface card."""
        return self._works.card

    @property
    def driver(self) -> Driver:
        """The ARMBASIC driver."""
        return self._works.driver

    @property
    def arm(self) -> MiniMover:
        """The arm with its bench."""
        return self._works.arm

    @property
    def tape(self) -> Tape:
        """The cassette recorder."""
        return self._works.tape

    @property
    def printer(self) -> Printer:
        """The line printer."""
        return self._works.printer

    @property
    def console(self) -> Console:
        """The ROM's display and keyboard drivers."""
        return self._works.console

    @property
    def cursor(self) -> int | None:
        """The cell of the tube, 0 to 1023, where the cursor stands; None while it is off."""
        return self._works.console.cursor_shown

    @property
    def held(self) -> frozenset[Key]:
        """The keys that are down in the matrix."""
        return self._works.matrix.held

    def screen(self) -> list[str]:
        """The sixteen lines of the tube as text, trailing blanks removed."""
        return [line.rstrip() for line in self._works.video.lines()]

    @property
    def registers(self) -> Counts:
        """The six position registers: what was commanded since `@RESET`."""
        return self._works.registers

    @property
    def joint_names(self) -> tuple[str, ...]:
        """What J1 to J6 are called."""
        return self._works.arm.model.motor_names[: len(MOTORS)]

    @property
    def joints(self) -> Counts:
        """Where the joints truly are, in the registers' steps from the same zero.

        The hand's compensation for the elbow is taken out, as the registers do not count it, so an
        arm that lost no step shows the registers' numbers.
        """
        return self._works.joints

    @property
    def state(self) -> ArmState:
        """Rotors, angles, pose, force, switch and coils of the arm at this moment."""
        return self._works.arm.state()

    @property
    def loads(self) -> Loads:
        """What motors and hand bear at this moment and what they have to bear it with."""
        return self._works.arm.loads(self._works.clock.now)

    @property
    def pose(self) -> Pose:
        """Where the fingertips truly are."""
        return self._works.arm.state().pose

    @property
    def sensors(self) -> dict[str, Answer]:
        """What the bench's sensors say at this moment, by name, in whatever bank they are."""
        return {answer.name: answer for answer in self._works.arm.answers(self.clock.now)}

    @property
    def devices(self) -> dict[str, str]:
        """What the devices on the auxiliary latch do at this moment, by what they are called."""
        self._works.arm.advance(self.clock.now)
        return {each.title: each.state for each in self._works.arm.bench.cell.devices}

    @property
    def parts(self) -> dict[str, Part]:
        """The parts on the bench as they are at this moment, by name.

        A part says its `origin` (x, y, z of its middle, inches), `turn`, `upwards`, `weight`
        (ounces), whether it is `held`, and the names of what it is `touching`. Look, do not touch.
        """
        self._works.arm.advance(self.clock.now)
        return dict(self._works.arm.bench.parts)

    @property
    def events(self) -> list[ArmEvent]:
        """What happened to arm and bench, the latest `arm.events_kept` of it, in order.

        An event says `kind`, `text`, when it began and last went on in T-states (`time`, `until`),
        and for a slip the `motor`, the half-steps lost (`steps`) and the `reason`.
        """
        return list(self._works.arm.events)

    def score(self) -> Score:
        """How well the goals of the bench are done at this moment, from where its parts truly are.

        A bench without goals has a score without marks.
        """
        return self._works.arm.bench.score()

    # -- who looks on -------------------------------------------------------------------------
    #
    # Whoever is attached stays attached, whatever becomes of the machine: `reset`, `restore` and
    # `set_bench` do not end it. A snapshot knows nothing of observers.

    def listen(self, listener: Callable[[int, bool], None]) -> Callable[[], None]:
        """Call `listener(code, is_echo)` for every character sent to the display.

        Returns:
            A function that ends the listening.
        """
        return attach(self._observers.codes, listener)

    def watch_statements(self, listener: StatementListener) -> Callable[[], None]:
        """Tell `listener` every statement before it is executed.

        Returns:
            A function that ends the watching.
        """
        return attach(self._observers.statements, listener)

    def stop_before(self, condition: Callable[[int], bool]) -> Callable[[], None]:
        """Stop the machine before each statement for which `condition` holds.

        The condition is given the address of the statement's separator. It is asked in `run_to`
        and `run_for` alone, which then come back early, at the very T-state at which the statement
        would have begun; the next run goes on with it, asking again. Stopped or not, a program
        gives the same run at the same times.

        Returns:
            A function that ends it.
        """
        return attach(self._observers.stops.conditions, condition)

    def stop_code_before(self, condition: Callable[[int], bool]) -> Callable[[], None]:
        """Stop the machine before each instruction of machine code for which `condition` holds.

        The condition is given the instruction's address. It is asked in `run_to` and `run_for`
        alone, which then come back early; the next run goes on with the instruction, asking again.

        Returns:
            A function that ends it.
        """
        return attach(self._observers.code_stops.conditions, condition)

    def watch_latches(self, observer: Observer) -> Callable[[], None]:
        """Clip a logic analyser on the card.

        Returns:
            A function that takes it off.
        """
        return attach(self._observers.latches, observer)

    def watch_line(self, listener: LineListener) -> Callable[[], None]:
        """Listen at the line to the recorder, on which programs make sound by OUT 255.

        Args:
            listener: is given the T-state and the level, 0 to 3, at each change.

        Returns:
            A function that ends the listening.
        """
        return attach(self._observers.line, listener)

    def watch_answers(self, listener: SerialListener) -> Callable[[], None]:
        """Listen to what the computer in the arm's base answers over its serial line.

        Args:
            listener: is given the bytes of each answer when the last of them has gone out.

        Returns:
            A function that ends the listening.
        """
        return attach(self._observers.answers, listener)

    def watch_resets(self, observer: Callable[[], None]) -> Callable[[], None]:
        """Call `observer` after each `@RESET`, and when the machine is switched off.

        Returns:
            A function that ends the watching.
        """
        return attach(self._observers.resets, observer)

    # -- all of it ----------------------------------------------------------------------------

    def snapshot(self) -> bytes:
        """The complete state of machine, arm and bench, with the settings.

        It names no file or folder of this computer: what is on the cassettes of a tape folder and
        on paper in a file is not in it, but the cassette in the recorder is. The bytes are those
        of `trs80arm.snapshots`; equal machines have equal ones.
        """
        from trs80arm import snapshots

        return snapshots.encode(self._works)

    def restore(self, snapshot: bytes) -> None:
        """Go back to a state that `snapshot` gave, here or elsewhere.

        The rig is then the one of the snapshot, fittings and all; only its own tape folder and its
        printer's file stay, and whoever looks on.

        Raises:
            SnapshotError: the bytes are no snapshot of this version, or of a machine that no
                program could have brought about; the rig stays as it is.
        """
        works = self._works_of(snapshot)
        if works.settings.rom is None:
            try_out(works)
        else:
            # Its processor is a chip with a state of its own, which no copy has.
            use_up(self._works_of(snapshot))
        works.use_places(self.settings)
        self._use(works)

    def _works_of(self, snapshot: bytes) -> Works:
        # All that may stand in a snapshot takes a while to load.
        from trs80arm import snapshots

        return snapshots.decode(snapshot, self.settings.rom)

    def go_back(self, snapshot: bytes) -> None:
        """Go back to a state that this rig's own `snapshot` gave: `restore` without the trial."""
        works = self._works_of(snapshot)
        works.use_places(self.settings)
        self._use(works)

    def past(self, snapshot: bytes, recorded: int) -> Rig:
        """Another rig as this one was once, with nobody looking on.

        It changes no file: what it records and prints is in memory. Cassettes of a tape folder are
        as they were then.

        Args:
            snapshot: one of this rig's own.
            recorded: how many recordings of `recordings` there were then.
        """
        rig = object.__new__(Rig)
        rig._observers = Observers()
        rig._use(self._works_of(snapshot))
        rig._observers.resets.append(rig._zero)
        if self.settings.tape_folder is not None:
            rig.tape.use_past(self.settings.tape_folder, dict(reversed(self.recordings[recorded:])))
        return rig

    @property
    def recordings(self) -> list[tuple[str, bytes]]:
        """The cassettes of the tape folder that were recorded on, with what they held before."""
        return self._observers.replaced

    def become(self, other: Rig) -> None:
        """Take over the machine of another rig, which is not to be used any more.

        Whoever looks at this rig looks on. The machine's cassettes and paper stay where they were
        in the other rig until `use_places`.
        """
        works = other._works
        works.name_places(self.settings)
        self._use(works)

    def use_places(self) -> None:
        """Cassettes and paper are in the settings' folder and file from now on."""
        self._works.use_places(self.settings)
