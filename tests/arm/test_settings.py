"""The choices about the arm that are left to the user: what they may be."""

from __future__ import annotations

from dataclasses import fields

import pytest

from trs80arm.arm.settings import ArmSettings


@pytest.mark.parametrize(
    "name", [field.name for field in fields(ArmSettings) if field.type != "str"]
)
@pytest.mark.parametrize("value", [-1, float("nan"), float("inf"), 1e9])
def test_a_setting_that_no_arm_could_have_is_refused_with_its_range(
    name: str, value: float
) -> None:
    with pytest.raises(ValueError, match=f"^{name} must be .* to .*, not"):
        ArmSettings(**{name: value})


def test_half_a_ring_is_the_farthest_that_a_rotor_can_be_behind() -> None:
    with pytest.raises(ValueError, match="pull_out_lag must be 1 to 4, not 5"):
        ArmSettings(pull_out_lag=5)


def test_an_arm_that_is_not_known_is_refused_with_those_that_are() -> None:
    with pytest.raises(ValueError, match="no arm armdroid: there are minimover5, teachmover"):
        ArmSettings(model="armdroid")
