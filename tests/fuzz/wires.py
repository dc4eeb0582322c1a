"""The door of the arm's own computer: what comes over its serial line, and the pendant's keys."""

from __future__ import annotations

from random import Random
from typing import Any

from tests.fuzz import noise
from tests.fuzz.checks import hold, rig_is_whole
from tests.fuzz.target import Case, Target
from trs80arm import Rig, RigSettings
from trs80arm.arm import benchfile
from trs80arm.arm.settings import ArmSettings
from trs80arm.serial.pendant_keys import FunctionKey, JointKey

LINES = 40
"""Lines of a case."""
HIGH = "[arm]\nat = [9, 0, 9]\npitch = 0\nopening = 2\n"
"""A bare table with the arm well above it: what presses on a table takes long to compute."""
HIGH_SHARE = 0.8
"""How many of the cases have that."""
PAUSE = 0.5
"""Virtual seconds after each piece."""
SENT = [
    b"@STEP 220, 10, -20, 30, -4, 5, -60",
    b"@STE 235,100,0,0,0,0,-100,885465860",
    b"@STEP 240,884.0,1255.77,-37.12,0,0,0,0",
    b"@STEP 232,1, 2 ,3, 4,5, 6,",
    *(b"@READ", b"@READ, ", b"@READ \n", b"@RESET, 0", b"@CLOSE", b"@CLO 221", b"@SET235,"),
    *(b"@QDUMP", b"@QWRITE 1,3841,2,3,4,5,6,65535\n", b"@RUN", b"@ARM # ", b"#ARM @", b"@DELAY 1"),
    *(b"", b"\n", b"@", b"@STOP ", b"@STEP", b"@QWRITE 300,1"),
]
"""What known clients send, and near it."""
KEYS = [*FunctionKey.__members__, *JointKey.__members__]


def _line(rng: Random) -> bytes:
    """A line without its end."""
    pick = rng.random()
    if pick < 0.4:
        return rng.choice(SENT)
    if pick < 0.7:
        return noise.mutated(rng, rng.choice(SENT)).replace(b"\r", b"\n")
    if pick < 0.9:
        word = rng.choice([b"STEP", b"STE", b"QWRITE", b"CLOSE", b"SET", b"DELAY", b"RUN", b"ARM"])
        numbers = [str(rng.choice([rng.randrange(-300, 300), rng.choice(noise.ODD_JSON[4:13])]))]
        numbers += [str(rng.randrange(-300, 300)) for _ in range(rng.randrange(9))]
        return b"@" + word + b" " + ",".join(numbers).encode()
    return rng.randbytes(rng.randrange(400)).replace(b"\r", b"")


def _storm(rng: Random) -> Case:
    data = b"".join(_line(rng) + b"\r" for _ in range(LINES))
    pieces: list[Any] = []
    while data:
        end = rng.choice([1, 7, 30, 200, 2000])
        pieces.append({"hex": data[:end].hex()})
        data = data[end:]
        if rng.random() < 0.1:
            pieces.append(rng.choice([*KEYS, "STOP", "STOP"]))
    return {"high": rng.random() < HIGH_SHARE, "pieces": pieces}


def _play(case: Case) -> None:
    settings = RigSettings(controller=True, arm=ArmSettings(model="teachmover"))
    rig = Rig(settings, benchfile.parse(HIGH, "bench") if case["high"] else None)
    controller = rig.controller
    assert controller is not None
    answers: list[bytes] = []
    rig.watch_answers(answers.append)
    lines = 0
    for piece in case["pieces"]:
        if isinstance(piece, str):
            rig.press_pendant(piece)
        else:
            data = bytes.fromhex(piece["hex"])
            lines += data.count(b"\r")
            rig.receive(data)
        rig.run_for(PAUSE)
    if controller.busy:
        rig.press_pendant("STOP")
        rig.run_until(lambda rig: not controller.busy, 60 + LINES)
    hold(not controller.busy, "the arm is still at work")
    hold(len(answers) == lines, f"{len(answers)} answers to {lines} lines")
    for answer in answers:
        hold(answer[:2] in (b"0\r", b"1\r", b"2\r"), f"an answer of {answer!r}")
        hold(answer.endswith(b"\r"), f"an answer of {answer!r}")
    rig_is_whole(rig)


TARGETS = [Target("wires", _storm, _play)]
