"""The door for machine code: random bytes, and bytes that call what the ROM would answer."""

from __future__ import annotations

from importlib.util import find_spec
from random import Random

from tests.fuzz.checks import hold, rig_is_whole
from tests.fuzz.target import Case, Target
from trs80arm import Rig
from trs80arm.basic.dialogue.rom_entries import ENTRIES
from trs80arm.rig import Waiting

_START = 0x7000
_LONGEST = 2000
_CALL, _JUMP = 0xCD, 0xC3


def _code(rng: Random) -> Case:
    code = bytearray(rng.randbytes(rng.randint(1, _LONGEST)))
    addresses = sorted(ENTRIES)
    for _ in range(rng.choice((0, 3, 30))):
        place = rng.randrange(len(code))
        address = rng.choice((rng.choice(addresses), rng.randrange(0x10000)))
        code[place : place + 3] = bytes((rng.choice((_CALL, _JUMP)), address & 255, address >> 8))
    return {
        "code": code.hex(),
        "by": rng.choice(("usr", "system")),
        "typed": rng.choice(("", "A", "12\r")),
        "seconds": round(rng.uniform(0.01, 0.5), 3),
    }


def _begun(case: Case) -> Rig:
    rig = Rig()
    rig.memory.write(_START, bytes.fromhex(case["code"]))
    if case["by"] == "usr":
        rig.load_text('10 POKE 16526,0:POKE 16527,112:PRINT "X";USR(7)')
        rig.type("RUN\r")
        rig.run_for(1.0)
    else:
        rig.type(f"SYSTEM\r/{_START}\r")
        rig.run_for(2.0)
    rig.type(case["typed"])
    return rig


def _play_code(case: Case) -> None:
    """Sliced is whole, and BREAK and switching it off and on get the machine back."""
    whole, sliced = _begun(case), _begun(case)
    begun, length = whole.clock.now, round(case["seconds"] * 1_774_080)
    whole.run_to(begun + length)
    for part in range(1, 8):
        sliced.run_to(begun + length * part // 7)
    hold(sliced.snapshot() == whole.snapshot(), "sliced is another run")
    rig_is_whole(whole)
    whole.stop_typing()
    whole.release_all()
    whole.run_for(0.1)
    whole.hold(["BREAK"], 1.5)
    whole.run_for(1.7)
    hold(whole.waiting is not Waiting.NOTHING, "BREAK does not end it")
    rig_is_whole(whole)
    whole.reset()
    hold(whole.waiting is Waiting.COMMAND, "a machine that is switched on again is not at READY")


TARGETS = (Target("machine-code", _code, _play_code),) if find_spec("z80") else ()
