"""The doors, each with noise for it and what must hold: one `Target` a door.

`make` gives a case as JSON, `play` does it and raises whatever is wrong: any exception that is not
the door's own.
"""

from __future__ import annotations

import contextlib
import io
import os
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from random import Random
from typing import Any

from tests.fuzz import noise
from tests.fuzz.checks import hold, rig_is_whole
from trs80arm import Rig, RigSettings, files, settings
from trs80arm.arm import benchfile
from trs80arm.arm.bench import Bench, BenchError
from trs80arm.desk import recording
from trs80arm.files import FileFormatError, Kind
from trs80arm.machine import cassette
from trs80arm.machine.clock import T_STATES_PER_SECOND
from trs80arm.machine.keys import Key
from trs80arm.operator import ScriptError, parse_holds
from trs80arm.plain import PlainMode
from trs80arm.rig import SnapshotError
from trs80arm.settings import SettingsError
from trs80arm.shown import shown
from trs80arm.ui.terminal.parser import KeyParser

Case = Any
"""What JSON can hold."""
SECONDS = 1.5
"""Virtual seconds for which a program may run."""


@dataclass(frozen=True)
class Target:
    """One door."""

    name: str
    make: Callable[[Random], Case]
    play: Callable[[Case], None]


def _one_line(error: Exception) -> None:
    hold("\n" not in str(error), "an error of more than one line")


def _quiet(rig: Rig) -> None:
    """Break off, and see that the machine listens."""
    rig.stop_typing()
    rig.release_all()
    before = rig.clock.now
    rig.hold(["BREAK"], 0.1)
    rig.run_to(before + T_STATES_PER_SECOND // 3)
    hold(rig.clock.now > before, "time stands still")
    rig_is_whole(rig)


def _settings(case: Case) -> RigSettings:
    return RigSettings(ram_kib=case["ram"], blocks=case.get("blocks", True))


# -- programs --------------------------------------------------------------------------------------


def _program(rng: Random) -> Case:
    return {"ram": rng.choice([4, 16, 48]), "lines": noise.listing(rng), "typed": noise.typed(rng)}


def _run(case: Case, *, blocks: bool, slices: int) -> Rig:
    rig = Rig(RigSettings(ram_kib=case["ram"], blocks=blocks))
    with contextlib.suppress(FileFormatError):
        rig.load_text("\n".join(case["lines"]))
    rig.type("RUN\r")
    for _ in range(slices):
        rig.run_for(SECONDS / slices)
    rig.type(case["typed"])
    for _ in range(slices):
        rig.run_for(SECONDS / slices)
    return rig


def _play_program(case: Case) -> None:
    """In blocks and by statements, whole and sliced: the same; registers move by commands only."""
    whole = _run(case, blocks=True, slices=1)
    rig_is_whole(whole)
    sliced = _run(case, blocks=True, slices=24)
    hold(whole.snapshot() == sliced.snapshot(), "sliced is another run than whole")
    single = _run(case, blocks=False, slices=1)
    hold(single.screen() == whole.screen(), "blocks show another screen than statements")
    hold(bytes(single.memory.ram) == bytes(whole.memory.ram), "blocks leave another memory")
    hold(single.clock.now == whole.clock.now, "blocks take another time")
    if not any("@" in text for text in (*case["lines"], case["typed"])):
        hold(whole.registers == (0,) * 6, "a register moved without a command")
    twin = Rig()
    twin.restore(whole.snapshot())
    hold(twin.snapshot() == whole.snapshot(), "a restored rig is another one")
    for rig in (whole, twin):
        rig.run_for(0.5)
    hold(twin.snapshot() == whole.snapshot(), "a restored rig goes on another way")
    _quiet(whole)


def _crunched(rng: Random) -> Case:
    lines = {
        rng.randrange(65530): bytes(
            rng.choice([rng.randrange(1, 256), rng.randrange(32, 91), rng.randrange(128, 252)])
            for _ in range(rng.randrange(1, 40))
        ).hex()
        for _ in range(rng.randrange(1, 10))
    }
    return {"ram": rng.choice([4, 16, 48]), "lines": sorted(lines.items())}


def _play_crunched(case: Case) -> None:
    rig = Rig(_settings(case))
    rig.load_lines([(number, bytes.fromhex(text)) for number, text in case["lines"]])
    rig.type("RUN\r")
    rig.run_for(SECONDS)
    rig.type("\x01LIST\r")
    rig.run_for(SECONDS)
    _quiet(rig)


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
    return {"ram": rng.choice([4, 16, 48]), "begin": ['A$="A"+"":B$="X":DIM A(3)'], "then": parts}


def _play_pokes(case: Case) -> None:
    for direct in (False, True):
        rig = Rig(_settings(case))
        parts = [*case["begin"], *case["then"]]
        if direct:
            rig.type("".join(f"{part}\r" for part in parts))
            rig.run_for(4 * len(parts))
        else:
            lines = [f"{(place + 1) * 10} {part}" for place, part in enumerate(parts)]
            rig.load_text("\n".join([*lines, "900 DATA 1,,X"]))
            rig.type("RUN\rX\r")
            rig.run_for(SECONDS)
        _quiet(rig)


def _typing(rng: Random) -> Case:
    return {"ram": rng.choice([4, 16, 48]), "typed": [noise.typed(rng) for _ in range(3)]}


def _play_typing(case: Case) -> None:
    rig = Rig(_settings(case))
    for text in case["typed"]:
        rig.type(text)
        rig.run_for(SECONDS)
    _quiet(rig)


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
                getattr(rig, action)(*arguments)
        rig_is_whole(rig)
        ends.append(rig.snapshot())
    hold(ends[0] == ends[1], "sliced is another run than whole")


# -- files -----------------------------------------------------------------------------------------


def _bytes(*seeds: bytes) -> Callable[[Random], Case]:
    def make(rng: Random) -> Case:
        data = rng.choice(seeds) if rng.random() < 0.9 else rng.randbytes(rng.randrange(300))
        return noise.mutated(rng, data).hex()

    return make


def _text_seeds() -> list[bytes]:
    return [text.encode("latin-1") for text in noise.PROGRAMS]


def _play_program_file(case: Case) -> None:
    data = bytes.fromhex(case)
    for keep_good in (False, True):
        try:
            lines = files.parse_program(data, keep_good=keep_good)
        except FileFormatError as error:
            _one_line(error)
            continue
        for kind in Kind:
            try:
                written = files.encode_program(lines, kind)
            except FileFormatError as error:
                _one_line(error)
                continue
            hold(files.parse_program(written) == lines, f"{kind} does not read back")
        with contextlib.suppress(FileFormatError):
            cassette.parse(data, keep_good=keep_good)


def _play_tape(case: Case) -> None:
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "A.cas").write_bytes(bytes.fromhex(case))
        rig = Rig(RigSettings(tape_folder=Path(folder)))
        rig.type("CLOAD\r")
        rig.run_for(30)
        rig.type('\x01RUN\r\x01SYSTEM\rA\r/\r\x01INPUT#-1,A$,B\r\x01CSAVE"A"\r')
        rig.run_for(60)
        _quiet(rig)
        hold(not [name for name in os.listdir(folder) if name.startswith(".")], "leftovers")


def _play_bench(case: Case) -> None:
    text = bytes.fromhex(case).decode("utf-8", "replace")
    try:
        bench = benchfile.parse(text)
    except BenchError as error:
        _one_line(error)
        return
    rig = Rig(bench=bench)
    rig.type("@STEP 10,90,-90,90,20,-20,-90:@CLOSE\r")
    rig.run_for(3)
    rig_is_whole(rig)


def _bench_seeds() -> list[bytes]:
    folder = Path(__file__).parents[2] / "programs"
    return [path.read_bytes() for path in sorted(folder.glob("*.toml"))]


def _play_settings(case: Case) -> None:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "settings.toml")
        path.write_bytes(bytes.fromhex(case))
        before = None
        try:
            before = settings.load(path, environment={})
        except SettingsError as error:
            _one_line(error)
        try:
            settings.remember(path, "theme", "paper")
        except SettingsError as error:
            _one_line(error)
            return
        if before is not None:
            after = settings.load(path, environment={})
            hold(after.terminal.theme == "paper", "a choice is not remembered")
            hold(after.machine == before.machine, "remembering changed another table")


SETTINGS_SEEDS = [
    b'# mine\n[terminal]\ntheme = "green"\nfps = 20\n[machine]\nram = 32\n',
    b'terminal.theme = "amber"\r\n[card]\r\nbase = 0x40\r\n',
    b'terminal = {theme = "amber"}\n[driver.keys]\nleave = "0"\n',
    b'["terminal"]\n"theme" = """\namber"""\n[arm]\nspeed_margin = 1.5\n',
]


def _recording_seed() -> bytes:
    rig = Rig()
    journal = recording.Journal(rig, None)
    rig.load_text("10 @SET\n")
    rig.type("RUN\r")
    rig.run_for(1)
    rig.hold(["1", "W"], 0.2)
    rig.move_joint("base", 5)
    rig.set_bench(Bench.standard())
    rig.reset()
    rig.refill()
    with tempfile.TemporaryDirectory() as folder:
        journal.save(Path(folder, "a"))
        return Path(folder, "a").read_bytes()


def _play_recording(case: Case) -> None:
    try:
        recording.parse(bytes.fromhex(case))
    except recording.RecordingError as error:
        _one_line(error)


def _snapshot_seed() -> bytes:
    rig = Rig(RigSettings(ram_kib=4))
    rig.type("@STEP 50,100,-50\r")
    rig.run_for(1.5)
    return rig.snapshot()


def _forged(rng: Random) -> Case:
    """Half of them have the right length and checksum for what was changed."""
    import hashlib

    text = noise.mutated(rng, _SNAPSHOT.partition(b"\n")[2])
    if rng.random() < 0.5:
        return (_SNAPSHOT.partition(b"\n")[0] + b"\n" + text).hex()
    digest = hashlib.sha256(text).hexdigest()
    return (b"trs80arm snapshot 1 %d %s\n" % (len(text), digest.encode()) + text).hex()


def _play_snapshot(case: Case) -> None:
    rig = Rig()
    try:
        rig.restore(bytes.fromhex(case))
    except SnapshotError as error:
        _one_line(error)
    rig.run_for(0.1)


_SNAPSHOT = _snapshot_seed()
_RECORDING = _recording_seed()


# -- words -----------------------------------------------------------------------------------------


_KEYS = (
    *("speed", "fps", "keys", "theme", "ram", "memory_size", "tapes", "card.base", "card.order"),
    *("card.coil_bits", "driver.close_delay", "driver.keys", "arm.speed_margin", "arm.x", "x.y"),
)
_ODD_VALUES = (
    *("5", "max", "true", "nan", "inf", "-1", "1e400", '""', "[1,2]", "{a=1}", "[" * 999, "ü", "'"),
    *("9" * 5000, "\x1b[2J", "a\nb", "1979-05-27", "~nobody-of-that-name/x", "\0"),
)


def _option(rng: Random) -> Case:
    value = rng.choice(_ODD_VALUES)
    value = noise.mutated_text(rng, value) if rng.random() < 0.5 else value
    return [f"{rng.choice(_KEYS)}={value}"]


def _play_option(case: Case) -> None:
    try:
        settings.load(Path("/dev/null"), case, {}).rig()
    except SettingsError as error:
        hold(shown(error).isprintable(), "an error that cannot be shown")
    try:
        parse_holds(case[0])
    except ScriptError as error:
        _one_line(error)


def _keys(rng: Random) -> Case:
    sequences = ["\x1b[97;1:3u", "\x1b[1;2A", "\x1b[<0;5;5M", "\x1b[200~", "\x1b[201~", "\x1bOP"]
    sequences += ["\x1b[?31u", "\x1b[?62;4c", "\x1b[I", "\x1b[97:65;2;65u", "\x1b[48;24;80;0;0t"]
    parts = []
    for _ in range(rng.randrange(1, 12)):
        part = rng.choice([*sequences, chr(rng.randrange(1, 0x3000)), "a"])
        parts.append(mutated_keys(rng, part) if rng.random() < 0.5 else part)
    return parts


def mutated_keys(rng: Random, part: str) -> str:
    """A terminal's sequence with other numbers in it."""
    digits = [place for place, sign in enumerate(part) if sign.isdigit()]
    if not digits:
        return part + chr(rng.randrange(32, 127))
    place = rng.choice(digits)
    number = rng.choice(["0", "1114112", "55296", "99999999", "9" * 300, "", "-1", "7;7;7"])
    return part[:place] + number + part[place + 1 :]


def _play_keys(case: Case) -> None:
    for releases in (False, True):
        parser = KeyParser(releases=releases)
        # Nothing is what Textual is told when the terminal is gone.
        for part in filter(None, case):
            for message in parser.feed(part):
                character = getattr(message, "character", None)
                hold(character is None or character == character.encode().decode(), "half a sign")
        list(parser.tick())


def _lines(rng: Random) -> Case:
    words = [".open x", ".save /dev/full", ".screen", ".pose", ".events", ".registers", ".", ".x"]
    return [
        rng.choice([*words, noise.statement(rng), "@SET", "1+W:0.1 0", "0:0.1", "RUN", "\x1b\0ü"])
        for _ in range(rng.randrange(1, 8))
    ]


def _play_lines(case: Case) -> None:
    """The line mode takes any line, and prints no control codes."""
    from trs80arm.desk.session import Session

    out = io.StringIO()
    session = Session()
    plain = PlainMode(session, out, echo=True, speed=None)
    for line in case:
        plain.take(line)
        session.run_for(SECONDS)
    rig_is_whole(session.rig)
    printed = out.getvalue()
    hold(all(sign.isprintable() or sign == "\n" for sign in printed), "a control code is printed")


TARGETS = {
    target.name: target
    for target in (
        Target("programs", _program, _play_program),
        Target("crunched", _crunched, _play_crunched),
        Target("pokes", _pokes, _play_pokes),
        Target("typing", _typing, _play_typing),
        Target("hands", _hands, _play_hands),
        Target(
            "program-files",
            _bytes(
                *_text_seeds(),
                files.encode_program(files.parse_program(_text_seeds()[0]), Kind.CRUNCHED),
                files.encode_program(files.parse_program(_text_seeds()[-1]), Kind.CASSETTE),
            ),
            _play_program_file,
        ),
        Target(
            "tapes",
            _bytes(
                files.encode_program([(10, b"\xb2 1"), (20, b"\x8d 10")], Kind.CASSETTE),
                cassette.encode_data(b"1,ABC\r"),
                cassette.encode_system(
                    cassette.SystemRecording(b"A     ", ((0x5000, b"ABC"),), 0x1A19)
                ),
            ),
            _play_tape,
        ),
        Target("benches", _bytes(*_bench_seeds()), _play_bench),
        Target("settings", _bytes(*SETTINGS_SEEDS), _play_settings),
        Target("recordings", _bytes(_RECORDING), _play_recording),
        Target("snapshots", _forged, _play_snapshot),
        Target("options", _option, _play_option),
        Target("keys", _keys, _play_keys),
        Target("lines", _lines, _play_lines),
    )
}
"""Every door by its name."""
