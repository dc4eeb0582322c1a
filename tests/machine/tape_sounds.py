"""Sounds of cassettes, and what time and bad recorders do to them."""

from __future__ import annotations

from dataclasses import dataclass
from math import prod

import numpy as np
from hypothesis import strategies as st
from numpy.typing import NDArray

from trs80arm.machine import cassette
from trs80arm.machine.audio import wav, waveform

Samples = NDArray[np.float32]

FINE = 88_200
"""Samples a second of a sound before it is digitised."""
LEADER = 20
"""Bytes of leader, for short tests; the ROM records 255."""

bodies = st.binary(min_size=1, max_size=30).map(lambda body: body.replace(b"\0", b" "))
programs = st.dictionaries(st.integers(0, 65529), bodies, min_size=1, max_size=4).map(
    lambda lines: cassette.encode_program(ord("A"), sorted(lines.items()))
)


def with_short_leader(content: bytes) -> bytes:
    return content[len(cassette.LEADER) - LEADER :]


@dataclass(frozen=True)
class Damage:
    """What happens to a sound on its way, in this order; the pulses are 0.5 high."""

    dull: bool = False
    speed: float = 1.0
    wow: float = 0.0
    wow_rate: float = 1.0
    upside_down: bool = False
    fade: float = 1.0
    dips: tuple[tuple[float, float, float], ...] = ()
    hum: float = 0.0
    hum_rate: int = 50
    noise: float = 0.0
    constant: float = 0.0
    clip: float = 10.0

    def done_to(self, samples: Samples, rate: int) -> Samples:
        if self.dull:
            samples = blurred(samples, rate / 7000)
        if not len(samples):
            return samples
        times = np.arange(int(len(samples) / self.speed * 1.02)) / rate
        swing = self.wow / (2 * np.pi * self.wow_rate)
        played = times * self.speed + swing * np.sin(2 * np.pi * self.wow_rate * times)
        known = np.arange(len(samples)) / rate
        sound = np.interp(played, known, samples, right=0.0)
        loudness = 0.5 / max(1e-9, float(np.abs(sound).max()))
        sound *= -loudness if self.upside_down else loudness
        sound *= np.linspace(1.0, self.fade, len(sound))
        for place, width, depth in self.dips:
            off = (times - place * times[-1]) / width
            sound *= 1 - (1 - depth) * np.exp(-off * off)
        sound += self.hum * np.sin(2 * np.pi * self.hum_rate * times + 1)
        sound += self.noise * np.random.default_rng(1).standard_normal(len(sound))
        sound += self.constant
        return np.clip(sound, -self.clip, self.clip).astype(np.float32)


def blurred(samples: Samples, width: float) -> Samples:
    reach = int(np.ceil(2 * width))
    kernel = np.exp(-((np.arange(-reach, reach + 1) / width) ** 2))
    return np.convolve(samples, kernel / kernel.sum(), "same").astype(np.float32)


def digitised(samples: Samples, form: wav.Form) -> bytes:
    """A WAV file of a sound; below half its rate nothing is lost, and nothing above is left."""
    ratio = FINE / form.rate
    if ratio > 1:
        reach = int(16 * ratio)
        places = np.arange(-reach, reach + 1)
        kernel = np.sinc(places * 0.9 / ratio) * np.hanning(len(places))
        samples = np.convolve(samples, kernel / kernel.sum(), "same").astype(np.float32)
    places = np.arange(int(len(samples) / ratio)) * ratio
    slow = np.interp(places, np.arange(len(samples)), samples)
    loudest = max(1.0, float(np.abs(slow).max()))
    return wav.write((slow / loudest).astype(np.float32), form)


def sound_file(content: bytes, damage: Damage | None = None, form: wav.Form | None = None) -> bytes:
    form = form or wav.Form(22_050)
    samples = waveform.cassette_sound(content, FINE)
    return digitised((damage or Damage()).done_to(samples, FINE), form)


forms = st.builds(
    lambda rate, channels, stored: wav.Form(rate, channels, *stored),
    st.sampled_from([8_000, 11_025, 16_000, 22_050, 32_000, 44_100, 48_000, 96_000]),
    st.integers(1, 2),
    st.sampled_from([(1, False), (2, False), (3, False), (4, False), (4, True), (8, True)]),
)
damages = st.builds(
    Damage,
    dull=st.booleans(),
    speed=st.floats(0.93, 1.07),
    wow=st.floats(0, 0.02),
    wow_rate=st.floats(0.5, 6),
    upside_down=st.booleans(),
    fade=st.floats(0.15, 1),
    dips=st.lists(
        st.tuples(st.floats(0.05, 0.95), st.floats(0.01, 0.1), st.floats(0.25, 1)), max_size=3
    )
    # A tenth of the volume is heard through, also where all of them are at one place.
    .filter(lambda dips: prod(depth for _, _, depth in dips) >= 0.1)
    .map(tuple),
    hum=st.floats(0, 0.4),
    hum_rate=st.sampled_from([50, 60]),
    noise=st.floats(0, 0.008),
    constant=st.floats(-0.3, 0.3),
)
