"""Turning in space: what spins freely keeps its energy and its momentum."""

from __future__ import annotations

import pytest

from trs80arm.arm.contact.bodies import Shape
from trs80arm.arm.contact.rotations import (
    IDENTITY,
    apply,
    apply_back,
    inverted,
    matrix,
    oriented,
    spun,
    times,
)
from trs80arm.arm.contact.solids import box
from trs80arm.arm.shapes import dot


def test_an_inverse_undoes_its_matrix() -> None:
    m = (4.0, 1.0, -0.5, 1.0, 3.0, 0.25, -0.5, 0.25, 2.0)
    assert times(m, inverted(m)) == pytest.approx(IDENTITY, abs=1e-15)


def test_what_tumbles_about_no_principal_axis_keeps_its_energy_and_momentum() -> None:
    shape = Shape.of([box((0.2, 1.0, 2.0))], 3.0)
    turn, spin = oriented(20.0, 30.0, 10.0), (3.0, 8.0, 5.0)

    def energy_and_momentum() -> tuple[float, ...]:
        inner = apply_back(matrix(turn), spin)
        momentum = apply(shape.inertia, inner)
        return dot(inner, momentum), *apply(matrix(turn), momentum)

    before, spins = energy_and_momentum(), []
    for _ in range(1000):
        turn, spin = spun(turn, spin, shape.inertia, shape.ease, 0.005)
        spins.append(spin)
    assert energy_and_momentum() == pytest.approx(before, rel=1e-9)
    # Its axis does not stay where it is.
    assert max(x for x, _, _ in spins) - min(x for x, _, _ in spins) > 1
