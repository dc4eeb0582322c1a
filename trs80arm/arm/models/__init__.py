"""The makes of arm that can hang on the card's cable, by name.

A new arm is a module here and a row in `MODELS`.
"""

from __future__ import annotations

from trs80arm.arm.model import ArmModel
from trs80arm.arm.models.minimover5 import MINIMOVER5
from trs80arm.arm.models.teachmover import TEACHMOVER

MODELS: dict[str, ArmModel] = {model.name: model for model in (MINIMOVER5, TEACHMOVER)}


def model_named(name: str) -> ArmModel:
    """The arm of a name.

    Raises:
        ValueError: there is none; the message lists those that there are.
    """
    try:
        return MODELS[name]
    except KeyError:
        raise ValueError(f"no arm {name}: there are {', '.join(MODELS)}") from None
