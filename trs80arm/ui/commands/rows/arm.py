"""Rows of the commands for the arm and its bench."""

from __future__ import annotations

from trs80arm.ui.commands.command import Command

ARM: tuple[Command, ...] = (
    Command(
        "teach",
        lambda to: to.arm.teach(),
        "Arm: teach pendant",
        "The teach pendant: jog the arm, teach points, play them, write the program.",
        "f12",
        "Teach",
        also="jog positions points lesson program world tool joint teachmover train memory",
    ),
    Command(
        "teach_here",
        lambda to: to.arm.teach_here(),
        "Arm: teach this position",
        "Teach the position where the arm is.",
        "ctrl+t,alt+t",
        also="record position point",
    ),
    Command(
        "hand_move",
        lambda to: to.arm.move_by_hand(),
        "Arm: move by hand",
        "Move the arm by hand, while the motors are off.",
        "ctrl+g",
        also="drag joints manual",
    ),
    Command(
        "come_back",
        lambda to: to.arm.come_back(),
        "Arm: come back after a slip",
        "What a motor lost and why; arm, parts and registers back to the start.",
        "ctrl+r",
        also="recover home reset lost steps slipped",
    ),
    Command(
        "bench",
        lambda to: to.arm.choose_bench(),
        "Bench: choose",
        "Set up another bench.",
        "ctrl+b",
        also="table parts setup",
    ),
    Command(
        "refill",
        lambda to: to.arm.refill(),
        "Bench: put the parts back",
        "Every part to where it was at the start.",
        also="reset parts restore home",
    ),
    Command(
        "score",
        lambda to: to.arm.score(),
        "Bench: score",
        "How well the goals of the bench are met, and how far each part is from its place.",
        also="goals error placement met",
    ),
    Command(
        "stop_arm",
        lambda to: to.served.stop(),
        "Arm: stop key of its pendant",
        "Stop the arm that a program moves over the serial line.",
        also="halt emergency serial client teachmover",
    ),
    Command(
        "serial_line",
        lambda to: to.served.show_lines(),
        "Arm: serial line",
        "What went over the arm's serial line lately, both ways.",
        also="log client teachmover rs232 commands answers",
    ),
)
