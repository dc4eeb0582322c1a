"""What the record of the MiniMover 5 leaves open, decided in one place.

Every field is a choice that neither the article nor the fact sheet settles, or a tolerance of
the model; what they do settle is data in `models/`. `MiniMover` and its
`Bench` read these and nothing else. Lengths in inches, weights in ounces, forces in pounds.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from trs80arm.arm.model import ArmModel
from trs80arm.arm.models import model_named

_RANGES: dict[str, tuple[float, float]] = {
    "speed_margin": (0.1, 100),
    "pull_out_lag": (1, 4),
    "pad_friction": (0, 10),
    "table_friction": (0.01, 10),
    "base_front": (0, 4),
    "base_rear": (0, 10),
    "base_width": (1, 10),
    "base_height": (0, 4),
    "body_radius": (0, 3),
    "body_top": (0, 7),
    "events_kept": (1, 1_000_000),
}
"""From where to where each setting is that of an arm of this sort."""


@dataclass(frozen=True, slots=True)
class ArmSettings:
    """The open choices about arm and hand.

    Attributes:
        model: name of the make of arm, one of those that `--help` lists at `--arm`.
        speed_margin: a motor keeps up to this multiple of Table 1's speed. The article's own
            program drives the shoulder 10 % above the speed listed (facts 8), so the list
            cannot be the limit.
        pull_out_lag: half-steps that a rotor may be behind its field before it drops out of
            step; beyond half a ring the field pulls it backwards (facts 1).
        pad_friction: coefficient between finger pads and a part; two pads hold
            2 x friction x force. With it the squeeze of 30 steps in Table 4 carries the 16 oz
            of Table 1.
        table_friction: coefficient between a part and what it stands on. A part pushed higher
            up than its depth over this number (halved) falls over.
        base_front, base_rear: edges of the base plate ahead of and behind the base axis
            (facts 6: 1 5/8 and 6.9 in.).
        base_width: full width of the base plate.
        base_height: height of the base plate; the later manual's reach test (facts 11.7)
            lets the hand pass above 1.25 in.
        body_radius: half width of the body that carries the motors.
        body_top: height of the body; the shoulder axis lies above it.
        events_kept: number of events that the arm remembers.

    Raises:
        ValueError: a value that no arm of this sort could have; the message has the range.
    """

    model: str = "minimover5"
    speed_margin: float = 1.0
    pull_out_lag: int = 4
    pad_friction: float = 0.75
    table_friction: float = 0.5
    base_front: float = 1.625
    base_rear: float = 6.9
    base_width: float = 6.0
    base_height: float = 1.25
    body_radius: float = 1.5
    body_top: float = 6.5
    events_kept: int = 2000

    def __post_init__(self) -> None:
        model_named(self.model)
        for name, (low, high) in _RANGES.items():
            value = getattr(self, name)
            if not (math.isfinite(value) and low <= value <= high):
                raise ValueError(f"{name} must be {low:g} to {high:g}, not {value:g}")

    @property
    def arm_model(self) -> ArmModel:
        """The make of arm."""
        return model_named(self.model)
