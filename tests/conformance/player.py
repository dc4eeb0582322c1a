"""Playing a case on a rig: typing it, letting time pass, and noting what the machine does.

The cases were recorded with every key handed to the ROM when it asked for one. Here the keys go
down in the matrix, each when the machine waits, so the debounce pause is in the machine's time but
not in that of the segments, which count from the key being taken.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import lru_cache

from tests.conformance.case import Case, Entry
from trs80arm.basic.activity import Waiting
from trs80arm.machine.clock import T_STATES_PER_SECOND
from trs80arm.machine.keys import Key, keys_for
from trs80arm.machine.z80.rom import Rom
from trs80arm.rig import Rig, RigSettings
from trs80arm.works.rom_language import RomLanguage

KEY_TAKEN = 90_930
"""T-states from a key going down to its code being handed over: the debounce pause."""
_LOOK, _LOOKS = 1_000, 2_000
"""T-states after which it is looked whether a ROM has taken a key, and how often."""
_FIRST_LOOK, _FIRST_LOOK_SAVING = 786, 861
"""T-states of the first look at the keyboard, which the cases count to a segment; those of the
routine that EDIT and the pause have for it."""
_MOST_TYPING = 60.0
"""Seconds that the machine may take between two keys of one entry."""
# SYSTEM and MEMORY SIZE? ask with the ROM's routine for INPUT's line.
_ENDS = {
    Waiting.NOTHING: "timeout",
    Waiting.COMMAND: "ready",
    Waiting.INPUT: "input",
    Waiting.EDIT: "edit",
    Waiting.PAUSE: "pause",
    Waiting.AUTO: "auto",
    Waiting.SYSTEM: "input",
    Waiting.MEMORY_SIZE: "input",
}


@dataclass
class Played:
    """What the machine did."""

    end: str = ""
    transcript: str = ""
    times: list[int] = field(default_factory=list)
    """T-states of each segment."""
    screen: list[str] = field(default_factory=list)
    cursor: int = 0
    wide: bool = False
    printer: str = ""
    dump: dict[str, str] = field(default_factory=dict)


@lru_cache(256)
def keys_of(character: str) -> tuple[Key, ...]:
    """The keys that type a code as the cases mean it: small letters are shifted, 10 is down."""
    if character == "\n":
        return (Key.DOWN,)
    if "a" <= character <= "z":
        return (Key.SHIFT, Key(character.upper()))
    keys = keys_for(character)
    if keys is None:
        raise ValueError(f"no key types {character!r}")
    return keys


class Session:
    """A rig without ARMBASIC and the hands that type on it; one at a time.

    Args:
        ram: in K.
        memory_size: the answer to MEMORY SIZE?
        blocks: whether statements are compiled in blocks or one by one.
    """

    def __init__(self, ram: int = 16, memory_size: str = "", *, blocks: bool = True) -> None:
        settings = RigSettings(ram_kib=ram, memory_size=memory_size, armbasic=False, blocks=blocks)
        self._use(Rig(settings))

    def _use(self, rig: Rig) -> None:
        self.rig = rig
        self._codes: list[int] = []
        self.rig.listen(lambda code, is_echo: self._codes.append(code))

    def transcript(self) -> str:
        """Everything displayed so far, as the cases show it, and forget it."""
        shown = "".join(
            "\n" if code == 13 else chr(code) for code in self._codes if code not in (14, 15)
        )
        self._codes.clear()
        return shown

    def wait(self, seconds: float) -> bool:
        """Run until the machine waits for a key; False if it works still after `seconds`."""
        return self.rig.run_until(lambda rig: rig.waiting is not Waiting.NOTHING, seconds)

    def press(self, character: str) -> int:
        """Type one character and let go; the time at which the machine took it.

        The keys are let go at once, but a scan sees that only when the machine looks again.
        """
        rig = self.rig
        keys = keys_of(character)
        # One look more lets the machine see that the keys before were let go.
        rig.run_to(rig.clock.now + 1)
        start = rig.clock.now
        for key in keys:
            rig.press(key)
        rig.run_to(start + 1)
        for key in reversed(keys):
            rig.release(key)
        return start + KEY_TAKEN

    def play(self, entry: Entry, seconds: float) -> int:
        """Type an entry and run until the machine waits again.

        Args:
            entry: what to type.
            seconds: the most virtual time to spend from its last key on.

        Returns:
            T-states from its last key to the wait.
        """
        taken = self.rig.clock.now
        for character in entry.typed:
            if self.rig.waiting is Waiting.NOTHING:
                self.wait(_MOST_TYPING)
            taken = self.press(character)
        end = taken + round(seconds * T_STATES_PER_SECOND)
        self._hold(entry, taken, end)
        self.wait(max(0.0, (end - self.rig.clock.now) / T_STATES_PER_SECOND))
        # With keys at times a segment lasts until the last one was let go.
        return (self.rig.clock.now if entry.keys else self.stands_at) - taken

    @property
    def stands_at(self) -> int:
        """When the machine began to wait, if it does: it has stopped there."""
        return self.rig.clock.now

    def _hold(self, entry: Entry, start: int, end: int) -> None:
        events = []
        for timed in entry.keys:
            for key in timed.keys:
                down = start + round(timed.at * T_STATES_PER_SECOND)
                up = down + round(timed.hold * T_STATES_PER_SECOND)
                events += [(down, True, key), (up, False, key)]
        for time, is_down, key in sorted(events):
            if time >= end:
                return
            self.rig.run_to(max(time, self.rig.clock.now))
            (self.rig.press if is_down else self.rig.release)(Key(key))


class RomSession(Session):
    """A rig whose owner's ROM runs it, and the hands that type on it.

    Args:
        rom: the ROM.
        ram: in K.
        memory_size: the answer to MEMORY SIZE?
    """

    def __init__(self, rom: Rom, ram: int = 16, memory_size: str = "") -> None:
        settings = RigSettings(ram_kib=ram, memory_size=memory_size, armbasic=False, rom=rom)
        self._use(Rig(settings))

    @property
    def _language(self) -> RomLanguage:
        basic = self.rig.basic
        assert isinstance(basic, RomLanguage)
        return basic

    def press(self, character: str) -> int:
        """Type one character; the keys are held until the ROM has taken it."""
        rig = self.rig
        # The keys before go up, and the ROM sees that.
        rig.run_to(rig.clock.now + 1)
        for _ in range(_LOOKS):
            if rig.console.quiet:
                break
            rig.run_to(rig.clock.now + _LOOK)
        start = rig.clock.now
        keys = keys_of(character)
        for key in keys:
            rig.press(key)
        for _ in range(_LOOKS):
            if self._language.key_taken > start:
                break
            rig.run_to(rig.clock.now + _LOOK)
        for key in reversed(keys):
            rig.release(key)
        return self._language.key_taken

    @property
    def stands_at(self) -> int:
        """When the machine began to wait, if it does."""
        waiting = self.rig.waiting
        if waiting is Waiting.NOTHING:
            return self.rig.clock.now
        look = _FIRST_LOOK_SAVING if waiting in (Waiting.EDIT, Waiting.PAUSE) else _FIRST_LOOK
        return self._language.wait_began + look


_PLAYED: dict[tuple[str, Rom | None], Played] = {}


def play_once(case: Case, rom: Rom | None = None) -> Played:
    """Play a whole case, or remember how it went when another test played it."""
    if (case.id, rom) not in _PLAYED:
        _PLAYED[case.id, rom] = play(case, rom=rom)
    return _PLAYED[case.id, rom]


def play(case: Case, *, blocks: bool = True, rom: Rom | None = None) -> Played:
    """Play a whole case, its statements compiled in blocks or one by one, or run by a ROM."""
    session = (
        Session(case.ram, case.memory_size, blocks=blocks)
        if rom is None
        else RomSession(rom, case.ram, case.memory_size)
    )
    rig = session.rig
    for line in case.program:
        session.play(Entry(line + "\r"), _MOST_TYPING)
    session.transcript()
    paper = len(rig.printer.sent)
    played = Played()
    left = case.max_seconds
    for entry in case.script:
        time = session.play(entry, left)
        played.times.append(time)
        left -= time / T_STATES_PER_SECOND
        if rig.waiting is Waiting.NOTHING:
            break
    played.transcript = session.transcript()
    played.end = _ENDS.get(rig.waiting, rig.waiting.value)
    peek = rig.memory.peek
    for line in range(16):
        start = 0x3C00 + 64 * line
        codes = [peek(address) for address in range(start, start + 64)]
        played.screen.append("".join(map(chr, codes)).rstrip(" "))
    played.cursor = (peek(0x4020) | peek(0x4021) << 8) - 0x3C00
    played.wide = rig.video.wide
    played.printer = rig.printer.sent[paper:].decode("latin-1")
    for dump in case.dumps:
        data = (peek(dump.address + place & 0xFFFF) for place in range(dump.length))
        played.dump[dump.name] = bytes(data).hex()
    return played
