from __future__ import annotations

import pickle
from pathlib import Path

from trs80arm.machine.memory import Memory
from trs80arm.machine.ports import Ports, SystemPort
from trs80arm.machine.printer import PRINTER_START, PRINTER_STOP, Printer
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
    ports.attach(SystemPort(video))
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
