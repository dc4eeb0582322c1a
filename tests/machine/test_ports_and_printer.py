from __future__ import annotations

import pickle
from pathlib import Path

import pytest

from trs80arm.machine.clock import Clock
from trs80arm.machine.memory import Memory
from trs80arm.machine.ports import Ports, SystemPort
from trs80arm.machine.printer import (
    LINES_PER_PAGE,
    LINES_PRINTED,
    PRINTER_START,
    PRINTER_STOP,
    Printer,
    PrinterDriver,
)
from trs80arm.machine.video import Video


class Echo:
    """A device at port 5 that gives back what it got."""

    def __init__(self) -> None:
        self.value = 0

    def owns(self, port: int) -> bool:
        return port == 5

    def read(self, port: int) -> int:
        return self.value

    def write(self, port: int, value: int) -> None:
        self.value = value


def test_a_port_without_a_device_reads_255() -> None:
    ports = Ports()
    ports.write(7, 1)
    assert ports.read(7) == 255


def test_a_device_answers_at_its_ports() -> None:
    ports = Ports()
    ports.attach(Echo())
    ports.write(5, 42)
    ports.write(6, 43)
    assert (ports.read(5), ports.read(6)) == (42, 255)


def test_port_255_switches_the_tube_and_tells_its_state() -> None:
    video = Video()
    ports = Ports()
    ports.attach(SystemPort(Clock(), video))
    assert ports.read(255) == 127
    ports.write(255, 8)
    assert video.wide
    assert ports.read(255) == 63
    ports.write(255, 0)
    assert not video.wide


def print_text(printer: Printer, text: str) -> None:
    for code in text.encode("latin-1"):
        printer.put(code)


def test_paper_in_memory_shows_all_that_was_printed() -> None:
    printer = Printer()
    print_text(printer, "HELLO\rWORLD")
    assert printer.text == "HELLO\nWORLD"
    assert printer.sent == b"HELLO\rWORLD"


def test_a_line_goes_to_the_file_when_it_ends(tmp_path: Path) -> None:
    paper = tmp_path / "paper.txt"
    paper.write_text("BEFORE\n")
    printer = Printer(paper)
    print_text(printer, "HELLO\rWOR")
    assert paper.read_text() == "BEFORE\nHELLO\n"
    print_text(printer, "LD\r")
    printer.flush()
    assert paper.read_text() == "BEFORE\nHELLO\nWORLD\n"


def test_tearing_off_the_paper_brings_the_line_under_the_head(tmp_path: Path) -> None:
    printer = Printer(tmp_path / "paper.txt")
    print_text(printer, "HALF")
    printer.flush()
    print_text(printer, " DONE\r")
    assert (tmp_path / "paper.txt").read_text() == "HALF DONE\n"


def test_a_file_that_cannot_be_written_is_no_error_of_the_machine(tmp_path: Path) -> None:
    printer = Printer(tmp_path / "nowhere" / "paper.txt")
    print_text(printer, "A\r")
    assert printer.fault is not None
    assert printer.text == "A\n"


def test_the_printer_is_ready_at_its_address_and_prints_what_is_stored_there() -> None:
    memory, printer = Memory(16), Printer()
    memory.attach(PRINTER_START, PRINTER_STOP, printer)
    assert memory.peek(14312) & 240 == 48
    memory.poke(14312, 65)
    assert printer.text == "A"
    assert memory.peek(14311) == memory.peek(14316) == 255


def test_a_pickled_printer_goes_on_with_its_line() -> None:
    printer = Printer()
    print_text(printer, "AB")
    copy = pickle.loads(pickle.dumps(printer))
    print_text(copy, "C\r")
    assert copy.text == "ABC\n"


@pytest.mark.parametrize(
    ("page", "line", "code", "sent", "line_after", "t_states"),
    [
        (67, 5, 65, b"A", 5, 723),
        (67, 5, 0, b"", 5, 619),
        (67, 5, 13, b"\r", 6, 777),
        (67, 5, 10, b"\r", 6, 783),
        (67, 66, 13, b"\r", 0, 800),
        (67, 5, 11, b"\n" * 62, 0, 6502),
        (67, 5, 12, b"\n" * 62, 0, 6492),
        (3, 5, 12, b"\n" * 254, 0, 24540),
        (0, 0, 11, b"\n" * 256, 0, 24738),
        (0, 0, 12, b"\0", 0, 704),
    ],
)
def test_the_driver_does_with_each_code_what_the_rom_does(
    page: int, line: int, code: int, sent: bytes, line_after: int, t_states: int
) -> None:
    # Recorded from the ROM's output routine.
    clock, memory, printer = Clock(), Memory(16), Printer()
    driver = PrinterDriver(clock, memory, printer)
    memory.poke(LINES_PER_PAGE, page)
    memory.poke(LINES_PRINTED, line)
    driver.put(code)
    assert printer.sent == sent
    assert memory.peek(LINES_PRINTED) == line_after
    assert clock.now == t_states


def test_a_page_has_67_lines_at_power_on() -> None:
    memory = Memory(16)
    PrinterDriver(Clock(), memory, Printer())
    assert (memory.peek(16424), memory.peek(16425)) == (67, 0)
