"""Machine code under the debugger: stops, steps, registers."""

from __future__ import annotations

import pytest

from trs80arm.desk.code_debugger import CodeDebugger
from trs80arm.desk.debugger import Debugger, Reason
from trs80arm.desk.session import Session

pytest.importorskip("z80", reason="the extra z80 is not installed")

CODE = bytes.fromhex(
    "3E05"  # 7000 LD A,5
    "CD0A70"  # 7002 CALL 700AH
    "3D"  # 7005 DEC A
    "20FA"  # 7006 JR NZ,7002H
    "C9"  # 7008 RET
    "00"  # 7009
    "C5"  # 700A PUSH BC
    "0C"  # 700B INC C
    "C1"  # 700C POP BC
    "C9"  # 700D RET
)
PROGRAM = (
    f"10 FOR I=0 TO {len(CODE) - 1}:READ A:POKE 28672+I,A:NEXT\n"
    "20 POKE 16526,0:POKE 16527,112\n30 X=USR(0):Y=1\n40 GOTO 40\n"
    f"50 DATA {','.join(map(str, CODE))}\n"
)


class Desk:
    def __init__(self) -> None:
        self.session = Session()
        self.debugger = Debugger(self.session)
        self.code = CodeDebugger(self.debugger)
        self.session.rig.load_text(PROGRAM)

    def run(self, seconds: float = 4.0) -> Desk:
        self.session.rig.type("RUN\r")
        return self.pass_time(seconds)

    def pass_time(self, seconds: float) -> Desk:
        for _ in range(round(seconds * 50)):
            self.session.run_for(0.02)
            self.debugger.new_stop()
        return self

    @property
    def told(self) -> str:
        stop = self.debugger.stop
        assert stop is not None
        assert stop.reason is Reason.CODE
        return stop.text


@pytest.fixture
def desk() -> Desk:
    return Desk()


def test_a_breakpoint_stops_before_its_instruction_each_time(desk: Desk) -> None:
    desk.code.toggle(0x7005)
    desk.run()
    for left in (5, 4, 3, 2, 1):
        assert desk.told == "Breakpoint at 7005H: DEC A"
        assert desk.session.rig.processor.registers.a == left
        desk.code.go()
        desk.pass_time(0.1)
    assert desk.debugger.stop is None


def test_steps_go_into_over_and_out_of_calls(desk: Desk) -> None:
    desk.code.toggle(0x7002)
    desk.run()
    desk.code.toggle(0x7002)
    places = []
    for step in (desk.code.into, desk.code.into, desk.code.out, desk.code.into, desk.code.into):
        step()
        places.append(desk.code.pc)
    desk.code.over()
    places.append(desk.code.pc)
    # The POP makes the stack shorter, too, and is no return.
    assert places == [0x700A, 0x700B, 0x7005, 0x7006, 0x7002, 0x7005]


def test_a_stopped_program_has_the_run_of_one_that_was_not() -> None:
    stopped, other = Desk(), Desk()
    stopped.code.toggle(0x700C)
    stopped.run()
    for _ in range(5):
        stopped.code.go()
        stopped.pass_time(0.02)
    other.run(6)
    rig = stopped.session.rig
    stopped.session.run_for(6 - rig.time)
    while rig.clock.now < other.session.rig.clock.now:
        stopped.session.run_for(0.02)
    while other.session.rig.clock.now < rig.clock.now:
        other.session.run_for(0.001)
    assert rig.memory.ram == other.session.rig.memory.ram


def test_the_first_instruction_of_the_next_code_is_waited_for(desk: Desk) -> None:
    desk.code.into()
    assert desk.debugger.stop is None
    desk.run()
    assert desk.told == "At 7000H: LD A,05H"
    assert desk.code.row(desk.code.instruction(0x7000)) == " >7000 3E05     LD A,05H"
    assert desk.code.registers()[0].startswith("PC 7000  SP ")


def test_breakpoints_outlive_the_machine(desk: Desk) -> None:
    desk.code.toggle(0x7008)
    desk.session.rig.reset()
    desk.session.rig.load_text(PROGRAM)
    desk.run()
    assert desk.told == "Breakpoint at 7008H: RET"
