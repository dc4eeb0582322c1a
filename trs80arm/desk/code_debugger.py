"""Machine code under the debugger: it stops before an instruction, and goes on by one or over.

The processor runs one instruction at a time while anything is to stop it, and asks before each; the
run is the same to the T-state. Where it stands is told by the debugger of the sitting.
"""

from __future__ import annotations

from collections.abc import Callable

from trs80arm.desk.debugger import LONGEST_WALK, SLICE, Debugger
from trs80arm.machine.clock import T_STATES_PER_SECOND
from trs80arm.machine.z80 import disassembler
from trs80arm.machine.z80.disassembler import Instruction
from trs80arm.rig import Rig

BEFORE = 4
"""Instructions shown in front of the one that is next, where code is known."""
_FLAGS = "SZ5H3PNC"
"""The bits of F, the highest first; 5 and 3 have no meaning."""


class CodeDebugger:
    """Stops machine code of a sitting's machine, and moves it on.

    Args:
        debugger: the sitting's, which stops and tells.

    Attributes:
        breakpoints: the addresses before which it stops.
    """

    def __init__(self, debugger: Debugger) -> None:
        self.debugger = debugger
        self.breakpoints: set[int] = set()
        self._goal: Callable[[int], bool] | None = None
        self._passed: tuple[int, int] | None = None
        self._unstop: Callable[[], None] | None = None
        debugger.session.watch_machine(self._start_afresh)

    @property
    def rig(self) -> Rig:
        """The machine."""
        return self.debugger.session.rig

    def _start_afresh(self) -> None:
        self._goal = None
        self._watch(anew=True)

    def _watch(self, *, anew: bool = False) -> None:
        """Be asked before each instruction while there is something to stop for, and only then."""
        wanted = bool(self.breakpoints) or self._goal is not None
        if self._unstop is not None and (anew or not wanted):
            self._unstop()
            self._unstop = None
        if wanted and self._unstop is None:
            self._unstop = self.rig.stop_code_before(self._asked)

    def _asked(self, address: int) -> bool:
        moment = (self.rig.clock.now, address)
        if moment == self._passed:
            return False
        if address in self.breakpoints:
            why = "Breakpoint at"
        elif self._goal is not None and self._goal(address):
            why = "At"
        else:
            return False
        self._passed = moment
        self._goal = None
        self.debugger.stand_in_code(f"{why} {address:04X}H: {self.instruction(address).text}")
        self._watch()
        return True

    # -- what there is ----------------------------------------------------------------------------

    @property
    def pc(self) -> int:
        """Where the processor stands."""
        return self.rig.processor.registers.pc

    def instruction(self, address: int) -> Instruction:
        """The instruction at an address."""
        return disassembler.disassemble(self.rig.memory.peek, address)

    def listing(self, address: int, count: int) -> list[Instruction]:
        """So many instructions from an address on."""
        return disassembler.listing(self.rig.memory.peek, address, count)

    def row(self, instruction: Instruction) -> str:
        """An instruction in a line: `*` a breakpoint, `>` where the processor stands."""
        mark = "*" if instruction.address in self.breakpoints else " "
        here = ">" if instruction.address == self.pc else " "
        code = instruction.code.hex().upper()
        return f"{mark}{here}{instruction.address:04X} {code:<8} {instruction.text}"

    def registers(self) -> list[str]:
        """The registers in four lines."""
        found = self.rig.processor.registers
        flags = "".join(
            letter if found.f >> 7 - place & 1 else "-" for place, letter in enumerate(_FLAGS)
        )
        state = "halted" if found.halted else f"interrupts {'on' if found.interrupts else 'off'}"
        return [
            f"PC {found.pc:04X}  SP {found.sp:04X}  AF {found.af:04X}  {flags}",
            f"BC {found.bc:04X}  DE {found.de:04X}  HL {found.hl:04X}  IX {found.ix:04X}"
            f"  IY {found.iy:04X}",
            f"BC'{found.bc_:04X}  DE'{found.de_:04X}  HL'{found.hl_:04X}  AF'{found.af_:04X}",
            f"I {found.i:02X}  R {found.r:02X}  {state}",
        ]

    def stack(self, count: int) -> list[int]:
        """The words on top of the stack."""
        processor = self.rig.processor
        return [processor.peek_word(processor.registers.sp + 2 * place) for place in range(count)]

    # -- breakpoints ------------------------------------------------------------------------------

    def toggle(self, address: int) -> bool:
        """Stop before the instruction at an address from now on, or not any more.

        Returns:
            Whether it stops there now.
        """
        self.breakpoints ^= {address}
        self._watch()
        return address in self.breakpoints

    def clear(self) -> None:
        """Stop nowhere any more."""
        self.breakpoints.clear()
        self._watch()

    # -- on ---------------------------------------------------------------------------------------

    def into(self) -> None:
        """Do one instruction; where no code runs, stop before the first one of the next."""
        self._walk(lambda address: True)

    def over(self) -> None:
        """Do one instruction, with all of a call or a repetition."""
        here = self.instruction(self.pc)
        if not here.is_call:
            self.into()
            return
        sp = self.rig.processor.registers.sp
        self._walk(lambda address: address == here.next and self.rig.processor.registers.sp >= sp)

    def out(self) -> None:
        """Go on until the subroutine has returned: a RET that leaves the stack shorter than now."""
        registers = self.rig.processor.registers
        sp, before = registers.sp, self.pc

        def returned(address: int) -> bool:
            nonlocal before
            was, before = before, address
            shorter = 0 < (registers.sp - sp & 0xFFFF) < 0x8000
            return shorter and self.instruction(was).text.startswith("RET")

        self._walk(returned)

    def run_to(self, wanted: int) -> None:
        """Go on until an address is next."""
        self._walk(lambda address: address == wanted)

    def go(self) -> None:
        """Let time go on."""
        self._goal = None
        self._watch()
        self.debugger.go()

    def _walk(self, goal: Callable[[int], bool]) -> None:
        """Go on to a goal; what takes longer is under way when this returns."""
        self.debugger.go()
        self._goal = goal
        self._watch()
        session, clock = self.debugger.session, self.rig.clock
        end = clock.now + LONGEST_WALK
        while self._goal is not None and session.busy and clock.now < end:
            session.run_for(SLICE / T_STATES_PER_SECOND)
