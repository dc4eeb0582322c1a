"""Doors of the machine itself: programs, keys, POKEs, ports, hands, moments."""

from __future__ import annotations

import contextlib
from random import Random
from typing import Any

from tests.fuzz import generated, noise
from tests.fuzz.checks import hold, rig_is_whole
from tests.fuzz.elsewhere import elsewhere
from tests.fuzz.target import Case, Target
from trs80arm import Rig, RigSettings
from trs80arm.arm import InTheWay
from trs80arm.basic import cruncher
from trs80arm.basic.errors import BasicError
from trs80arm.files import FileFormatError
from trs80arm.machine.clock import T_STATES_PER_SECOND
from trs80arm.machine.keys import Key

SECONDS = 1.5
"""Virtual seconds for which a program may run."""


def quiet(rig: Rig) -> None:
    """Break off, and see that the machine listens."""
    rig.stop_typing()
    rig.release_all()
    before = rig.clock.now
    rig.hold(["BREAK"], 0.1)
    rig.run_to(before + T_STATES_PER_SECOND // 3)
    hold(rig.clock.now > before, "time stands still")
    rig_is_whole(rig)


def _built(case: Case, *, blocks: bool = True) -> Rig:
    return Rig(RigSettings(ram_kib=case["ram"], blocks=blocks))


def _ram(rng: Random) -> int:
    return rng.choice([4, 16, 48])


class Commanded:
    """Watches statements, and sees that registers move by commands of ARMBASIC only."""

    def __init__(self, rig: Rig) -> None:
        self._rig = rig
        self._before = rig.registers
        self._commanded = False
        rig.watch_statements(self)

    def statement(self, line: int, address: int) -> None:
        """A statement begins: what did the one before it do?"""
        now = self._rig.registers
        hold(self._commanded or now == self._before, "a register moved without a command")
        ram = self._rig.memory.ram
        start = address + (1 if ram[address] else 5)
        end = ram.find(0, start)
        self._before, self._commanded = now, b"@" in ram[start : end if end >= 0 else None]


# -- programs --------------------------------------------------------------------------------------


def _program(rng: Random) -> Case:
    return {"ram": _ram(rng), "lines": noise.listing(rng), "typed": noise.typed(rng)}


def _run(case: Case, *, blocks: bool, slices: int) -> Rig:
    rig = _built(case, blocks=blocks)
    with contextlib.suppress(FileFormatError):
        rig.load_text("\n".join(case["lines"]))
    if not blocks:
        Commanded(rig)
    rig.type("RUN\r")
    for _ in range(slices):
        rig.run_for(SECONDS / slices)
    rig.type(case["typed"])
    for _ in range(slices):
        rig.run_for(SECONDS / slices)
    return rig


def _essence(rig: Rig) -> dict[str, Any]:
    """What a run has come to, as far as it can be compared without a snapshot."""
    state = rig.state
    return {
        "time": rig.clock.now,
        "memory": bytes(rig.memory.ram),
        "screen": rig.screen(),
        "wait": rig.waiting,
        "registers": rig.registers,
        "rotors": state.rotors,
        "pose": state.pose,
        "paper": bytes(rig.printer.sent),
    }


def _same(one: Rig, other: Rig, who: str) -> None:
    first, second = _essence(one), _essence(other)
    for what, value in first.items():
        hold(second[what] == value, f"{who}: another {what}")


def _play_program(case: Case) -> None:
    """In blocks and by statements, whole and sliced: the same; registers move by commands only."""
    whole = _run(case, blocks=True, slices=1)
    rig_is_whole(whole)
    _same(whole, _run(case, blocks=True, slices=24), "sliced")
    _same(whole, _run(case, blocks=False, slices=1), "by statements")
    if not any("@" in text for text in (*case["lines"], case["typed"])):
        hold(whole.registers == (0,) * 6, "a register moved without a command")
    quiet(whole)


def _play_moment(case: Case) -> None:
    """A snapshot is the same however time was sliced, here and in another process."""
    whole = _run(case, blocks=True, slices=1)
    moment = whole.snapshot()
    hold(_run(case, blocks=True, slices=24).snapshot() == moment, "sliced is another run")
    twin = Rig()
    twin.restore(moment)
    hold(twin.snapshot() == moment, "a restored rig is another one")
    restored, gone_on = elsewhere().gone_on(moment)
    hold(restored == moment, "a rig restored in another process is another one")
    for rig in (whole, twin):
        rig.run_for(0.5)
    hold(twin.snapshot() == whole.snapshot(), "a restored rig goes on another way")
    hold(gone_on == whole.snapshot(), "a rig restored elsewhere goes on another way")


def _statement(rng: Random) -> Case:
    text = noise.statement(rng)
    return {"ram": _ram(rng), "line": noise.mutated_text(rng, text) if rng.random() < 0.1 else text}


def _play_statement(case: Case) -> None:
    """One line at the prompt, compiled of nothing but what generated code may hold."""
    rig = _built(case)
    with contextlib.suppress(BasicError), generated.watched():
        rig.basic.execute_direct(cruncher.crunch(case["line"].encode("latin-1")[:240]).text)
        rig.run_for(0.2)
    rig_is_whole(rig)


def _crunched(rng: Random) -> Case:
    lines = {
        rng.randrange(65530): bytes(
            rng.choice([rng.randrange(1, 256), rng.randrange(32, 91), rng.randrange(128, 252)])
            for _ in range(rng.randrange(1, 40))
        ).hex()
        for _ in range(rng.randrange(1, 10))
    }
    return {"ram": _ram(rng), "lines": sorted(lines.items())}


def _play_crunched(case: Case) -> None:
    rig = _built(case)
    rig.load_lines([(number, bytes.fromhex(text)) for number, text in case["lines"]])
    with generated.watched():
        rig.type("RUN\r")
        rig.run_for(SECONDS)
    rig.type("\x01LIST\r")
    rig.run_for(SECONDS)
    quiet(rig)


# -- memory and ports ------------------------------------------------------------------------------


def _pokes(rng: Random) -> Case:
    pokes = [
        f"POKE {noise.address(rng)},{rng.choice([0, 1, 9, 44, 255, rng.randrange(256)])}"
        for _ in range(rng.randrange(1, 12))
    ]
    pointers = rng.choice(["A", "A$", "B$", "A(1)", "A#"])
    more = [
        f"V=VARPTR({pointers}):POKE V+{rng.randrange(4)},{rng.choice([0, 1, 9, 255])}"
        for _ in range(rng.randrange(4))
    ]
    looks = ["PRINT PEEK(-1);MEM", 'B$=A$+"":PRINT B$', "READ A$,B,A", "INPUT A$", "PRINT FRE(A$)"]
    parts = [*pokes, *more, *rng.sample(looks, 3), noise.statement(rng), "LIST"]
    rng.shuffle(parts)
    return {
        "ram": _ram(rng),
        "typed": rng.random() < 0.3,
        "begin": ['A$="A"+"":B$="X":DIM A(3)'],
        "then": parts,
    }


def _play_pokes(case: Case) -> None:
    rig = _built(case)
    parts = [*case["begin"], *case["then"]]
    if case.get("typed", True):
        rig.type("".join(f"{part}\r" for part in parts))
        rig.run_for(2 * len(parts))
    else:
        lines = [f"{(place + 1) * 10} {part}" for place, part in enumerate(parts)]
        rig.load_text("\n".join([*lines, "900 DATA 1,,X"]))
        rig.type("RUN\rX\r")
        rig.run_for(SECONDS)
    quiet(rig)


def _storm(rng: Random) -> Case:
    """A program that POKEs and OUTs by the hundred."""

    def gust() -> str:
        value = rng.choice(["I", "RND(256)-1", "I*7AND255", str(rng.randrange(256))])
        start = noise.address(rng)
        stride = rng.choice([1, 1, 2, 7, 257])
        count = rng.choice([3, 16, 64, 200])
        ports = rng.choice([(152, 159), (152, 157), (0, 255), (254, 255), (158, 158)])
        port = f"{ports[0]}+RND({ports[1] - ports[0] + 1})-1"
        return rng.choice(
            [
                f"FORI=0TO{count}:POKE{start}+I*{stride},{value}:NEXT",
                f"FORI=0TO{count}:POKERND(65535)-32768,{value}:NEXT",
                f"FORI=0TO{count}:OUT{port},{value}:NEXT",
                f"FORI=0TO{count}:OUT{port},{value}:A=INP(RND(256)-1):NEXT",
                f"OUT{rng.randrange(256)},{rng.randrange(256)}:POKE{start},{rng.randrange(256)}",
                f"A=PEEK({start}):A=INP({rng.randrange(256)}):PRINTA;",
                noise.statement(rng),
            ]
        )

    lines = [f"{10 * place} {gust()}" for place in range(1, rng.randrange(2, 8))]
    return {"ram": _ram(rng), "lines": [*lines, f"{10 * len(lines) + 10} GOTO 10"]}


def _play_storm(case: Case) -> None:
    rig = _built(case)
    with contextlib.suppress(FileFormatError):
        rig.load_text("\n".join(case["lines"]))
    Commanded(rig)
    rig.type("RUN\r")
    rig.run_for(SECONDS)
    quiet(rig)


# -- keys ------------------------------------------------------------------------------------------


def _typing(rng: Random) -> Case:
    return {"ram": _ram(rng), "typed": [noise.typed(rng)]}


def _play_typing(case: Case) -> None:
    rig = _built(case)
    for text in case["typed"]:
        rig.type(text)
        rig.run_for(SECONDS)
    quiet(rig)


def _editing(rng: Random) -> Case:
    lines = [f"{10 * place} {noise.statement(rng)}" for place in range(1, rng.randrange(2, 5))]
    keys = "".join(noise.edit_keys(rng) for _ in range(rng.randrange(1, 4)))
    return {"ram": _ram(rng), "lines": lines, "typed": keys}


def _play_editing(case: Case) -> None:
    """Whatever is done in EDIT, the program stays one: lines in order, links that lead on."""
    rig = _built(case)
    with contextlib.suppress(FileFormatError):
        rig.load_text("\n".join(case["lines"]))
    rig.type(case["typed"])
    rig.run_for(2 + 0.05 * len(case["typed"]))
    quiet(rig)
    program_is_whole(rig)


def program_is_whole(rig: Rig) -> None:
    """The lines of the program in memory stand in order, each where the one before it says."""
    ram, program = rig.memory.ram, rig.basic.program
    numbers = [number for number, _ in program.lines()]
    hold(numbers == sorted(set(numbers)), "lines out of order")
    place = program.start
    for number, text in program.lines():
        link = ram[place] | ram[place + 1] << 8
        hold(ram[place + 2] | ram[place + 3] << 8 == number, "a line with another number")
        hold(link == place + 5 + len(text), f"line {number} leads elsewhere")
        place = link
    hold(not ram[place] and not ram[place + 1], "the program has no end")


def _hands(rng: Random) -> Case:
    deeds: list[Any] = []
    for _ in range(rng.randrange(1, 12)):
        deeds.append(
            rng.choice(
                [
                    ["type", noise.typed(rng)],
                    ["type", "@SET\r"],
                    ["press", str(rng.choice(list(Key)))],
                    ["release", str(rng.choice(list(Key)))],
                    ["hold", [str(rng.choice(list(Key))) for _ in range(3)], rng.random()],
                    ["release_all"],
                    ["stop_typing"],
                    ["refill"],
                    ["reset"],
                ]
            )
        )
        deeds.append(["run_for", rng.choice([0.0625, 0.125, 0.5, 1.0])])
    return deeds


def _play_hands(case: Case) -> None:
    """What the operator does is the same run however it is sliced, and played from a recording."""
    ends = []
    for slices in (1, 16):
        rig = Rig()
        for action, *arguments in case:
            if action == "run_for":
                for _ in range(slices):
                    rig.run_for(arguments[0] / slices)
            else:
                with contextlib.suppress(InTheWay):
                    getattr(rig, action)(*arguments)
        rig_is_whole(rig)
        ends.append(rig.snapshot())
    hold(ends[0] == ends[1], "sliced is another run than whole")


TARGETS = (
    Target("programs", _program, _play_program),
    Target("moments", _program, _play_moment),
    Target("statements", _statement, _play_statement),
    Target("crunched", _crunched, _play_crunched),
    Target("pokes", _pokes, _play_pokes),
    Target("storms", _storm, _play_storm),
    Target("typing", _typing, _play_typing),
    Target("editing", _editing, _play_editing),
    Target("hands", _hands, _play_hands),
)
