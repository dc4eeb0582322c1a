"""Rows of the commands for the machine: pause, single steps, saved states, speed, off and on."""

from __future__ import annotations

from trs80arm.options import Speed
from trs80arm.ui.commands.command import Command

MACHINE: tuple[Command, ...] = (
    Command(
        "pause",
        lambda to: to.machine.pause(),
        "Machine: pause or go on",
        "Stop the machine's clock, or let it go on.",
        "f6",
        "Pause",
        also="freeze hold stop",
    ),
    Command(
        "step_statement",
        lambda to: to.debug.step(),
        "Debugger: stop, then one statement",
        "Stop the program and open the debugger; once stopped, do one statement.",
        "f7",
        "Debug",
        also="single step trace breakpoint",
    ),
    Command(
        "debugger",
        lambda to: to.debug.open(),
        "Debugger: open",
        "Listing with breakpoints, variables, memory, steps on and back.",
        "ctrl+x",
        also="breakpoint variables memory poke let inspect step",
    ),
    Command(
        "processor",
        lambda to: to.debug.open_processor(),
        "Debugger: the processor",
        "Registers, instructions, stack and memory of machine code; steps and breakpoints.",
        also="z80 machine code registers disassembly assembler usr system step breakpoint",
    ),
    Command(
        "watch",
        lambda to: to.debug.watch(),
        "Debugger: watch a variable or a latch",
        "Stop behind each change of a variable, a latch of the card or a byte of memory.",
        also="breakpoint watchpoint memory address",
    ),
    Command(
        "step_back",
        lambda to: to.debug.back(),
        "Debugger: one statement back",
        "Go one statement back in time.",
        "alt+f7",
        also="undo reverse rewind",
    ),
    Command(
        "back_to_stop",
        lambda to: to.debug.back_to_stop(),
        "Debugger: back to the breakpoint before",
        "Go back in time to the last breakpoint that was reached.",
        also="undo reverse step back",
    ),
    Command(
        "states",
        lambda to: to.debug.states(),
        "Machine: saved states",
        "Save the whole machine by name, load one, remove one.",
        also="snapshot save load state restore",
    ),
    Command(
        "quick_save",
        lambda to: to.debug.quick_save(),
        "Machine: save the state quickly",
        "Save the whole machine, to come back to it.",
        "shift+f3,f15,ctrl+f3",
        also="snapshot state store",
    ),
    Command(
        "quick_load",
        lambda to: to.debug.quick_load(),
        "Machine: load the state saved quickly",
        "Come back to the machine that was saved quickly.",
        "shift+f2,f14,ctrl+f2",
        also="snapshot state restore",
    ),
    Command(
        "step_motor",
        lambda to: to.machine.step_motor(),
        "Machine: one motor step",
        "Pause, and go on to the next change of a latch.",
        "shift+f7,ctrl+f7,f19",
        also="single step half-step latch",
    ),
    Command(
        "speed",
        lambda to: to.machine.choose_speed(),
        "Machine: choose the speed",
        "Choose how fast time goes.",
        "f8",
        "Speed",
        also="fast slow",
    ),
    Command(
        "speed_1",
        lambda to: to.machine.set_speed(Speed.ONE),
        "Speed: 1, as it was",
        "As fast as the real machine.",
    ),
    Command("speed_2", lambda to: to.machine.set_speed(Speed.TWO), "Speed: 2", "Twice as fast."),
    Command(
        "speed_5", lambda to: to.machine.set_speed(Speed.FIVE), "Speed: 5", "Five times as fast."
    ),
    Command(
        "speed_20",
        lambda to: to.machine.set_speed(Speed.TWENTY),
        "Speed: 20",
        "Twenty times as fast.",
    ),
    Command(
        "speed_max",
        lambda to: to.machine.set_speed(Speed.FLAT_OUT),
        "Speed: flat out",
        "As fast as this computer can.",
        also="fast turbo",
    ),
    Command(
        "push_reset",
        lambda to: to.machine.push_reset(),
        "Machine: reset button",
        "Out of machine code to READY; the program stays.",
        also="nmi interrupt",
    ),
    Command(
        "reset",
        lambda to: to.machine.reset(),
        "Machine: off and on",
        "Switch the TRS-80 off and on again.",
        also="restart reboot power switch",
    ),
)
