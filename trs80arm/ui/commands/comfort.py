"""The commands that make a machine of 1980 pleasant to sit at: turbo for what takes long, sound."""

from __future__ import annotations

from trs80arm.desk.asking import Asking, Choice, ListQuestion, Say
from trs80arm.desk.pacing import Pacer
from trs80arm.desk.remembered import Remembered
from trs80arm.desk.sound import LineSound
from trs80arm.options import Sound

SOUND_NOTES = {
    Sound.OFF: "nothing is heard",
    Sound.BELL: "the terminal's bell, once where a sound begins",
    Sound.SAMPLES: "as it was, through the loudspeaker (extra `sound`)",
}


class ComfortCommands:
    """Turns turbo and sound on and off.

    Args:
        pacer: how fast the machine's time goes.
        sound: what is heard.
        remembered: keeps the choices for the next time.
        ask: a way to ask.
        say: a way to say something.
    """

    def __init__(
        self, pacer: Pacer, sound: LineSound, remembered: Remembered, ask: Asking, say: Say
    ) -> None:
        self._pacer = pacer
        self._sound = sound
        self._remembered = remembered
        self._ask = ask
        self._say = say

    def switch_turbo(self) -> None:
        """Flat out while a tape goes by or a paste is typed, or at the speed set."""
        self._pacer.hurries = not self._pacer.hurries
        self._remembered.choose("turbo", self._pacer.hurries)
        told = "flat out, then at the speed set" if self._pacer.hurries else "at the speed set"
        self._say(f"Tapes and pastes go {told}.")

    def choose_sound(self) -> None:
        """Choose how programs are heard that make sound."""
        choices = tuple(Choice(sound.value, sound.value, SOUND_NOTES[sound]) for sound in Sound)
        question = ListQuestion("Sound of OUT 255", choices, self._sound.sound.value)
        self._ask.choose(question, self._use_sound)

    def _use_sound(self, value: str) -> None:
        self._sound.use(Sound(value))
        self._remembered.choose("sound", value)
        self._say(f"Sound: {SOUND_NOTES[Sound(value)]}.")
