"""Doors of files: programs, listings, tapes, benches, settings, recordings, snapshots."""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path
from random import Random

from tests.fuzz import noise
from tests.fuzz.checks import hold, rig_is_whole
from tests.fuzz.machines import quiet
from tests.fuzz.target import Case, Target, one_line
from trs80arm import Rig, RigSettings, files, program_text, settings
from trs80arm.arm import benchfile
from trs80arm.arm.bench import Bench, BenchError
from trs80arm.basic import cruncher
from trs80arm.desk import recording
from trs80arm.files import FileFormatError, Kind
from trs80arm.machine import cassette
from trs80arm.machine.clock import T_STATES_PER_SECOND
from trs80arm.rig import ReplayError, SnapshotError
from trs80arm.settings import SettingsError

PROGRAMS = Path(__file__).parents[2] / "programs"


def _bytes(*seeds: bytes) -> Callable[[Random], Case]:
    def make(rng: Random) -> Case:
        data = rng.choice(seeds) if rng.random() < 0.9 else rng.randbytes(rng.randrange(300))
        return noise.mutated(rng, data).hex()

    return make


# -- programs --------------------------------------------------------------------------------------


def _program_seeds() -> list[bytes]:
    """Programs of every kind, long and short."""
    seeds = []
    for text in noise.PROGRAMS:
        lines = files.parse_program(text.encode("latin-1"))
        for some in (lines[:4], lines[4:10], lines):
            seeds += [files.encode_program(some, kind) for kind in Kind]
    return [seed for seed in seeds if len(seed) < 1500]


def _play_program_file(case: Case) -> None:
    data = bytes.fromhex(case)
    for keep_good in (False, True):
        try:
            lines = files.parse_program(data, keep_good=keep_good)
        except FileFormatError as error:
            one_line(error)
            continue
        for kind in Kind:
            try:
                written = files.encode_program(lines, kind)
            except FileFormatError as error:
                one_line(error)
                continue
            hold(files.parse_program(written) == lines, f"{kind} does not read back")
        with contextlib.suppress(FileFormatError):
            cassette.parse(data, keep_good=keep_good)


def _listing(rng: Random) -> Case:
    lines = [f"{rng.randrange(70000)} {noise.statement(rng)}" for _ in range(rng.randrange(1, 3))]
    text = rng.choice(["\n", "\r", "\r\n"]).join(lines)
    return noise.mutated_text(rng, text) if rng.random() < 0.7 else text


def _play_listing(case: Case) -> None:
    """A listing is read, written and read to the same lines, or refused in one line."""
    try:
        lines = program_text.parse(case.encode("utf-8", "surrogatepass"))
        hold(program_text.parse(program_text.encode(lines)) == lines, "it does not read back")
    except FileFormatError as error:
        one_line(error)


def _play_cassette(case: Case) -> None:
    """Any bytes are recordings, which are written to the same bytes again, or one error."""
    data = bytes.fromhex(case)
    for keep_good in (False, True):
        try:
            found = cassette.parse(data, keep_good=keep_good)
        except FileFormatError as error:
            one_line(error)
            continue
        for each in found:
            if isinstance(each, cassette.SystemRecording):
                again = cassette.encode_system(each)
                hold(cassette.parse(again) == [each], "it does not read back")


def _play_tape(case: Case) -> None:
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "A.cas").write_bytes(bytes.fromhex(case))
        rig = Rig(RigSettings(tape_folder=Path(folder)))
        rig.type("CLOAD\r")
        rig.run_for(30)
        rig.type('\x01RUN\r\x01SYSTEM\rA\r/\r\x01INPUT#-1,A$,B\r\x01CSAVE"A"\r')
        rig.run_for(60)
        quiet(rig)
        hold(not [name for name in os.listdir(folder) if name.startswith(".")], "leftovers")


_TAPES: tuple[bytes, ...] = (
    files.encode_program([(10, b"\xb2 1"), (20, b"\x8d 10")], Kind.CASSETTE),
    cassette.encode_data(b"1,ABC\r"),
    cassette.encode_system(cassette.SystemRecording(b"A     ", ((0x5000, b"ABC"),), 0x1A19)),
)

_TAPES_TOGETHER = (b"".join(_TAPES), b"".join(reversed(_TAPES)))


# -- benches and settings --------------------------------------------------------------------------


def _play_bench(case: Case) -> None:
    text = bytes.fromhex(case).decode("utf-8", "replace")
    try:
        bench = benchfile.parse(text)
    except BenchError as error:
        one_line(error)
        return
    rig = Rig(bench=bench)
    rig.basic.execute_direct(_MOTION)
    rig.run_for(3)
    rig_is_whole(rig)


_MOTION = cruncher.crunch(b"@STEP 10,90,-90,90,20,-20,-90:@CLOSE").text


def _play_settings(case: Case) -> None:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "settings.toml")
        path.write_bytes(bytes.fromhex(case))
        before = None
        try:
            before = settings.load(path, environment={})
        except SettingsError as error:
            one_line(error)
        try:
            settings.remember(path, "theme", "paper")
        except SettingsError as error:
            one_line(error)
            return
        if before is not None:
            after = settings.load(path, environment={})
            hold(after.terminal.theme == "paper", "a choice is not remembered")
            hold(after.machine == before.machine, "remembering changed another table")


_SETTINGS = (
    b'# mine\n[terminal]\ntheme = "green"\nfps = 20\n[machine]\nram = 32\n',
    b'terminal.theme = "amber"\r\n[card]\r\nbase = 0x40\r\n',
    b'terminal = {theme = "amber"}\n[driver.keys]\nleave = "0"\n',
    b'["terminal"]\n"theme" = """\namber"""\n[arm]\nspeed_margin = 1.5\n',
)


# -- recordings ------------------------------------------------------------------------------------


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


_RECORDING = _recording_seed()


_ENTRIES = list(map(json.loads, _RECORDING.splitlines()))


def _recording(rng: Random) -> Case:
    """Half of them are JSON still, with odd values in it."""
    if rng.random() < 0.5:
        return noise.mutated(rng, _RECORDING).hex()
    entries = noise.with_changes(_ENTRIES, noise.odd_changes(rng, _ENTRIES))
    return "\n".join(map(json.dumps, entries if isinstance(entries, list) else [])).encode().hex()


def _play_recording(case: Case) -> None:
    """One that is read can be played, as far as the first seconds go."""
    try:
        played = recording.parse(bytes.fromhex(case))
    except recording.RecordingError as error:
        one_line(error)
        return
    rig = played.rig()
    soon = rig.clock.now + 3 * T_STATES_PER_SECOND
    try:
        rig.replay(done for done in played.inputs if done.time < soon)
    except ReplayError as error:
        one_line(error)
    rig_is_whole(rig)


# -- snapshots -------------------------------------------------------------------------------------


_SESSION = """10 DIM A(3),B$(2):A$="X"+"Y":B#=1/3:I%=7:FOR I=1 TO 3:GOSUB 100
20 NEXT
100 ON ERROR GOTO 30:@STEP 50,100,-50:INPUT "N";N,M$
30 @CLOSE:@SET:PRINT#-1,5"""


def _moments() -> list[bytes]:
    """Snapshots of moments in which different things are in the works."""
    rig = Rig(RigSettings(ram_kib=4))
    rig.load_text(_SESSION)
    found = []
    for typed, seconds in (
        *(("RUN\r", 1.5), ("5,A\r", 3.0), ("", 3.0), ("0", 2.0), ("\x01EDIT 10\rIX", 1.0)),
        *(("\x1bQAUTO\r", 0.5), ('\x01CSAVE"A"\r', 1.0), ("\x01CLOAD\r", 1.0), ("\x01LIST\r", 0.1)),
        ("\x01SYSTEM\rX\r", 1.0),
    ):
        rig.type(typed)
        rig.run_for(seconds)
        found.append(rig.snapshot())
    return [*found, *_moments_of_a_controller()]


def _moments_of_a_controller() -> Iterator[bytes]:
    """Snapshots of moments of the computer in an arm's base."""
    rig = Rig(RigSettings(ram_kib=4, controller=True))
    rig.receive(b"@QWRITE 1,3841,5,0,0,0,0,0\r@QWRITE 2,1028,0,0,0,0,0,0\r")
    rig.run_for(0.5)
    for sent, keys in (
        (b"@STEP 200,300\r@CLOSE\r@READ\r@ST", ()),
        (b"", ("STOP",)),
        (b"@SET 200\r", ("ELBOW_PLUS", "ROLL_PLUS")),
        (b"@RUN\r@QDUMP\r", ("FREE",)),
        (b"", ("STOP", "TRAIN", "JUMP", "MOVE")),
        (b"", ("STOP", "RUN")),
    ):
        rig.receive(sent)
        for key in keys:
            rig.press_pendant(key)
            rig.run_for(0.1)
        rig.run_for(0.3)
        yield rig.snapshot()


_MOMENTS = _moments()
_TEXTS = [moment.partition(b"\n")[2] for moment in _MOMENTS]
_STATES = list(map(json.loads, _TEXTS))


def _forged(rng: Random) -> Case:
    """Most of them have the right length and checksum for what was changed."""
    pick, moment = rng.random(), rng.randrange(len(_MOMENTS))
    if pick < 0.7:
        return {"moment": moment, "changes": noise.odd_changes(rng, _STATES[moment])}
    changes = noise.splices(rng, _TEXTS[moment])
    return {"moment": moment, "splices": changes, "sealed": pick < 0.95}


def _snapshot(case: Case) -> bytes:
    """The snapshot of a case."""
    moment = case["moment"]
    if "changes" in case:
        text = json.dumps(noise.with_changes(_STATES[moment], case["changes"])).encode()
    else:
        text = noise.spliced(_TEXTS[moment], case["splices"])
    if not case.get("sealed", True):
        return _MOMENTS[moment].partition(b"\n")[0] + b"\n" + text
    digest = hashlib.sha256(text).hexdigest()
    return b"trs80arm snapshot 1 %d %s\n" % (len(text), digest.encode()) + text


def _play_snapshot(case: Case) -> None:
    rig = Rig()
    try:
        rig.restore(_snapshot(case))
    except SnapshotError as error:
        one_line(error)
    rig.run_for(0.1)
    quiet(rig)


TARGETS = (
    Target("program-files", _bytes(*_program_seeds()), _play_program_file),
    Target("listings", _listing, _play_listing),
    Target("cassettes", _bytes(*_TAPES, *_TAPES_TOGETHER), _play_cassette),
    Target("tapes", _bytes(*_TAPES), _play_tape),
    Target(
        "benches",
        _bytes(*(path.read_bytes() for path in sorted(PROGRAMS.glob("*.toml")))),
        _play_bench,
    ),
    Target("settings", _bytes(*_SETTINGS), _play_settings),
    Target("recordings", _recording, _play_recording),
    Target("snapshots", _forged, _play_snapshot),
)
