"""Which wire an arm is plugged in by, and how fast and far it may be driven there."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class PlugSettings:
    """The table `[plug]`: what holds for a real arm on a wire.

    Attributes:
        speed: half-steps a second that any of its motors may be asked for.
        range: half-steps that any of its motors may go from where it stood when it was plugged in.
        play: half-steps by which the hand may close farther, or less far, than in the model.
    """

    speed: int = 600
    range: int = 4000
    play: int = 40

    def __post_init__(self) -> None:
        if not 1 <= self.speed <= 10_000:
            raise ValueError(f"speed must be 1 to 10000 half-steps a second, not {self.speed}")
        if not 1 <= self.range <= 30_000:
            raise ValueError(f"range must be 1 to 30000 half-steps, not {self.range}")
        if not 0 <= self.play <= 2000:
            raise ValueError(f"play must be 0 to 2000 half-steps, not {self.play}")


@dataclass(frozen=True)
class Plugging:
    """A wire to be plugged in.

    Attributes:
        path: of the port.
        settings: how fast and far the arm may go.
        allowed: whether the operator has said already that it may move.
    """

    path: str
    settings: PlugSettings = PlugSettings()
    allowed: bool = False
