"""All devices of a rig and how they are wired.

`Rig` builds them here, hands them to whoever looks, and takes and gives them back whole in a
snapshot.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from trs80arm.arm.minimover import MiniMover
from trs80arm.arm.settings import ArmSettings
from trs80arm.basic.host import Host
from trs80arm.basic.interpreter import Interpreter
from trs80arm.machine.card import Card, CardSettings
from trs80arm.machine.cassette_line import CassetteLine
from trs80arm.machine.clock import Clock
from trs80arm.machine.console import Console
from trs80arm.machine.display import Display
from trs80arm.machine.driver import Counts, Driver, DriverSettings
from trs80arm.machine.keyboard import KeyboardDriver, Matrix
from trs80arm.machine.keys import KEYBOARD_START, KEYBOARD_STOP, Key
from trs80arm.machine.memory import RAM_SIZES_KIB, Memory
from trs80arm.machine.ports import Ports, SystemPort
from trs80arm.machine.printer import PRINTER_START, PRINTER_STOP, Printer, PrinterDriver
from trs80arm.machine.tape import Tape
from trs80arm.machine.typist import Typist, check_answer
from trs80arm.machine.video import VIDEO_START, VIDEO_STOP, Video
from trs80arm.machine.z80.processor import Processor
from trs80arm.machine.z80.rom import SIZE, Rom, RomArea
from trs80arm.works import rom_driver
from trs80arm.works.rom_language import RomLanguage

if TYPE_CHECKING:
    from trs80arm.serial.controller import Controller

Language = Interpreter | RomLanguage
"""What executes BASIC: this project's own, or a user's ROM."""


@dataclass(frozen=True)
class RigSettings:
    """Everything about a rig that is chosen before it is switched on."""

    ram_kib: int = 16
    """RAM of the machine: 4, 16, 32 or 48."""
    memory_size: str = ""
    """What is typed at MEMORY SIZE? when the machine is switched on."""
    armbasic: bool = True
    """Whether ARMBASIC's five statements are loaded; without it they are ?SN. Under a ROM of one's
    own they are machine code in memory, put there when the machine is switched on."""
    blocks: bool = True
    """Whether statements are compiled in basic blocks (faster) or one by one."""
    native: bool = True
    """Whether hot loops of numbers are made native code, where the extra `fast` is installed."""
    card: CardSettings = field(default_factory=CardSettings)
    driver: DriverSettings = field(default_factory=DriverSettings)
    arm: ArmSettings = field(default_factory=ArmSettings)
    tape_folder: Path | None = None
    """The one folder whose cassettes the machine can reach; None keeps tapes in memory."""
    printer_file: Path | None = None
    """Where the printer's paper goes; None keeps it in memory."""
    rom: Rom | None = None
    """The user's own ROM that runs the machine on its processor; None for this project's BASIC."""
    ghosting: bool = False
    """Whether three keys at the corners of a rectangle of the matrix show a fourth."""
    controller: bool = False
    """Whether the arm has a computer of its own, at the end of a serial line, as the TeachMover.

    The card is then on that computer's bus: the TRS-80 has neither card nor ARMBASIC.
    """

    def __post_init__(self) -> None:
        if self.ram_kib not in RAM_SIZES_KIB:
            raise ValueError(f"ram_kib must be 4, 16, 32 or 48, not {self.ram_kib}")
        check_answer(self.memory_size)
        if self.rom is not None and self.has_armbasic:
            rom_driver.check(self.ram_kib, self.card)

    @property
    def has_armbasic(self) -> bool:
        """Whether the machine has ARMBASIC: not where the arm's own computer has the card."""
        return self.armbasic and not self.controller


@dataclass(order=True)
class KeyEvent:
    """A key that goes down or up at a T-state; events of one T-state keep their order."""

    time: int
    order: int
    key: Key = field(compare=False)
    down: bool = field(compare=False)
    typed: bool = field(default=False, compare=False)
    """Whether it is the typist's, who may be told to stop."""


@dataclass
class Works:
    """All devices of a rig, and what is about to happen to its keys."""

    settings: RigSettings
    """What they were assembled from."""
    clock: Clock
    memory: Memory
    matrix: Matrix
    video: Video
    display: Display
    console: Console
    printer: Printer
    tape: Tape
    ports: Ports
    system_port: SystemPort
    card: Card
    driver: Driver
    arm: MiniMover
    processor: Processor
    basic: Language
    typist: Typist
    controller: Controller | None = None
    """The computer in the arm's base, if it has one; it has the card and the driver then."""
    events: list[KeyEvent] = field(default_factory=list)
    order: int = 0
    asked: int = 0
    """The T-state up to which the machine was asked to run; it may stand a statement later."""
    zero: Counts = (0, 0, 0, 0, 0, 0)
    """Where the rotors stood when the registers were last zeroed."""

    def __getstate__(self) -> dict[str, Any]:
        nowhere = replace(self.settings, tape_folder=None, printer_file=None)
        return self.__dict__ | {"settings": nowhere}

    @property
    def joints(self) -> Counts:
        """Where the joints truly are, in the registers' steps from the same zero.

        The hand's compensation for the elbow is taken out, as the registers do not count it, so an
        arm that lost no step shows the registers' numbers.
        """
        rotors = self.arm.state().rotors
        j1, j2, j3, j4, j5, j6 = (
            rotor - zero for rotor, zero in zip(rotors, self.zero, strict=True)
        )
        return j1, j2, j3, j4, j5, j6 - self.arm.model.hand_per_elbow * j3

    @property
    def registers(self) -> Counts:
        """The six position registers: those of the driver that is at work."""
        place = self._driver_in_memory
        if place is None:
            return self.driver.registers
        return rom_driver.registers(self.memory, place)

    def reset_driver(self) -> None:
        """Motors off and registers zero, as by `@RESET`."""
        self.driver.reset()
        place = self._driver_in_memory
        if place is not None:
            rom_driver.zero(self.memory, place)

    @property
    def _driver_in_memory(self) -> int | None:
        if self.settings.rom is None or self.controller is not None:
            return None
        return rom_driver.origin(self.memory.ram, self.settings.card)

    def name_places(self, own: RigSettings) -> None:
        """Have the folder and the file of other settings in the own ones, and not use them yet."""
        self.settings = replace(
            self.settings, tape_folder=own.tape_folder, printer_file=own.printer_file
        )

    def use_places(self, own: RigSettings) -> None:
        """Take over where cassettes and paper are kept from other settings.

        These are folders and files of the computer that the rig runs on. A snapshot names none.
        """
        self.name_places(own)
        self.printer.path = own.printer_file
        if own.tape_folder is not None:
            self.tape.use_folder(own.tape_folder)


def assemble(settings: RigSettings, arm: MiniMover, old: Works | None = None) -> Works:
    """Build a machine and plug an arm into its card.

    Args:
        settings: the machine's fittings.
        arm: what hangs on the card's cable.
        old: the works whose clock, cassettes and printer go on with the new machine, and the
            computer in the arm's base.
    """
    clock = old.clock if old else Clock()
    memory = Memory(settings.ram_kib)
    matrix = Matrix(ghosting=settings.ghosting)
    video = Video()
    display = Display(clock, memory, video)
    console = Console(display, KeyboardDriver(clock, memory, matrix))
    printer = old.printer if old else Printer(settings.printer_file)
    tape = old.tape if old else Tape(settings.tape_folder)
    hand_per_elbow = arm.model.hand_per_elbow
    controller = old.controller if old else None
    if controller is None:
        card = Card(clock, settings.card, arm)
        driver = Driver(clock, card, matrix, settings.driver, hand_per_elbow)
    if settings.controller and controller is None:
        # Few arms have one, and it takes a while to load.
        from trs80arm.serial.controller import Controller

        controller = Controller(clock.now, card, settings.driver, hand_per_elbow)
    if controller is not None:
        card, driver = controller.card, controller.driver
    ports = Ports()
    if controller is None:
        ports.attach(card)
    line = None if settings.rom is None else CassetteLine(clock, tape)
    system_port = SystemPort(clock, video, line)
    ports.attach(system_port)
    memory.attach(PRINTER_START, PRINTER_STOP, printer)
    memory.attach(KEYBOARD_START, KEYBOARD_STOP, matrix)
    memory.attach(VIDEO_START, VIDEO_STOP, video)
    processor = Processor(clock, memory, matrix, video, ports)
    host = Host(
        clock=clock,
        memory=memory,
        console=console,
        printer=PrinterDriver(clock, memory, printer),
        ports=ports,
        tape=tape,
        arm=driver if settings.has_armbasic else None,
        processor=processor,
    )
    basic: Language
    if settings.rom is None:
        basic = Interpreter(
            host,
            armbasic=settings.has_armbasic,
            blocks=settings.blocks,
            native=settings.native,
        )
    else:
        memory.attach(0, SIZE, RomArea(settings.rom))
        basic = RomLanguage(host, processor, matrix, console, settings.rom, settings.card)
    return Works(
        settings=settings,
        clock=clock,
        memory=memory,
        matrix=matrix,
        video=video,
        display=display,
        console=console,
        printer=printer,
        tape=tape,
        ports=ports,
        system_port=system_port,
        card=card,
        driver=driver,
        arm=arm,
        processor=processor,
        basic=basic,
        typist=Typist(),
        controller=controller,
        zero=old.zero if old and old.controller else arm.state().rotors,
    )
