"""Systems of six unknowns a body: as any other method solves them, coupled however they are."""

from __future__ import annotations

import numpy as np
import pytest

from trs80arm.arm.contact.elimination import Eliminated, order
from trs80arm.arm.contact.sixes import Six

CHAIN = {(0, 1), (1, 2), (2, 3)}
RING = {(0, 1), (1, 2), (2, 3), (0, 3)}
STAR = {(0, 4), (1, 4), (2, 4), (3, 4)}


def six(values: object) -> Six:
    a, b, c, d, e, f = (float(value) for value in values)  # type: ignore[attr-defined]
    return a, b, c, d, e, f


@pytest.mark.parametrize("pairs", [set(), CHAIN, RING, STAR, CHAIN | RING | STAR])
def test_unknowns_are_those_of_the_whole_matrix(pairs: set[tuple[int, int]]) -> None:
    count, numbers = 5, np.random.default_rng(1980)
    whole = np.zeros((6 * count, 6 * count))
    for one, other in pairs:
        rows = numbers.normal(size=(8, 6 * count))
        for body in set(range(count)) - {one, other}:
            rows[:, 6 * body : 6 * body + 6] = 0
        whole += rows.T @ rows
    whole += np.diag(numbers.uniform(1, 2, 6 * count))
    right = numbers.normal(size=(count, 6))
    sequence = order(count, pairs)
    rank = {body: k for k, body in enumerate(sequence)}
    lower = np.tril_indices(6)
    blocks = [whole[6 * k : 6 * k + 6, 6 * k : 6 * k + 6][lower].tolist() for k in range(count)]
    beside = {}
    for pair in pairs:
        one, other = sorted(pair, key=rank.__getitem__)
        between = whole[6 * one : 6 * one + 6, 6 * other : 6 * other + 6]
        beside[one, other] = [six(column) for column in between.T]
    found = Eliminated(blocks, beside, sequence).solve(right.tolist())
    assert np.ravel(found) == pytest.approx(np.linalg.solve(whole, right.ravel()), rel=1e-9)


def test_what_everything_leans_on_is_eliminated_last() -> None:
    assert order(5, STAR)[-1] == 4
