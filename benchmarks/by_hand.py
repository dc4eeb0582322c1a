"""The thirteen listings translated by hand into Python, every result rounded to 24 bits in line.

They check no range, keep no clock and have no string space: the most that CPython could give. Each
does all that its listing does, and returns what that leaves in its variables. In a function here
`r(...)` stands for that rounding; `in_line` writes it out where it stands, as anybody would who
wanted speed, so that no call is left. Functions of Level II are those of `math`.
"""

from __future__ import annotations

import ast
import inspect
import math
import textwrap
from collections.abc import Callable
from typing import Any

Left = dict[str, float | str]
"""Variables of a listing and what it leaves in them."""

SPLIT = 2.0**29 + 1.0
"""Veltkamp's constant for 24 bits of 53."""
AWAY = 1.0 + 2.0**-52
"""Turns a tie into something just above it."""
MULTIPLIER, INCREMENT, SEEDS = 4253261, 372837, 2**24
"""The ROM's generator of random numbers."""


def r(value: float) -> float:
    """The value rounded to 24 bits, half away from zero; written in line by `in_line`."""
    x = value * AWAY
    c = x * SPLIT
    return c - (c - x)


class _Rounding(ast.NodeTransformer):
    """Puts `c - (c - x)` for `r(value)`."""

    _template = ast.parse(f"(c := (x := VALUE * {AWAY!r}) * {SPLIT!r}) - (c - x)", mode="eval").body

    def visit_Call(self, node: ast.Call) -> ast.AST:
        """A call of `r` in line, its argument first."""
        self.generic_visit(node)
        if not (isinstance(node.func, ast.Name) and node.func.id == "r"):
            return node

        class Fill(ast.NodeTransformer):
            def visit_Name(self, name: ast.Name) -> ast.AST:
                return node.args[0] if name.id == "VALUE" else name

        filled = Fill().visit(ast.parse(ast.unparse(self._template), mode="eval"))
        assert isinstance(filled, ast.Expression)
        return filled.body


def in_line(function: Callable[[], Left]) -> Callable[[], Left]:
    """The same function without calls of `r`."""
    tree = ast.parse(textwrap.dedent(inspect.getsource(function)))
    definition = tree.body[0]
    assert isinstance(definition, ast.FunctionDef)
    definition.decorator_list = []
    tree = ast.fix_missing_locations(_Rounding().visit(tree))
    names: dict[str, Any] = {}
    exec(compile(tree, __file__, "exec"), globals(), names)
    result: Callable[[], Left] = names[function.__name__]
    return result


@in_line
def empty_loop() -> Left:
    """`bm1`."""
    k = 1.0
    while k <= 1000.0:
        k = r(k + 1.0)
    return {"K": k}


@in_line
def counter() -> Left:
    """`bm2`."""
    k = 0.0
    while True:
        k = r(k + 1.0)
        if not k < 1000.0:
            return {"K": k}


@in_line
def variables() -> Left:
    """`bm3`."""
    k = 0.0
    while True:
        k = r(k + 1.0)
        a = r(r(r(r(k / k) * k) + k) - k)
        if not k < 1000.0:
            return {"K": k, "A": a}


@in_line
def constants() -> Left:
    """`bm4`."""
    k = 0.0
    while True:
        k = r(k + 1.0)
        a = r(r(r(r(k / 2.0) * 3.0) + 4.0) - 5.0)
        if not k < 1000.0:
            return {"K": k, "A": a}


def _subroutine() -> None:
    """`820 RETURN`."""


@in_line
def subroutine() -> Left:
    """`bm5`."""
    k = 0.0
    while True:
        k = r(k + 1.0)
        a = r(r(r(r(k / 2.0) * 3.0) + 4.0) - 5.0)
        _subroutine()
        if not k < 1000.0:
            return {"K": k, "A": a}


@in_line
def inner_loop() -> Left:
    """`bm6`."""
    k = 0.0
    while True:
        k = r(k + 1.0)
        a = r(r(r(r(k / 2.0) * 3.0) + 4.0) - 5.0)
        _subroutine()
        l_ = 1.0
        while l_ <= 5.0:
            l_ = r(l_ + 1.0)
        if not k < 1000.0:
            return {"K": k, "A": a, "L": l_}


@in_line
def array() -> Left:
    """`bm7`."""
    m = [0.0] * 6
    k = 0.0
    while True:
        k = r(k + 1.0)
        a = r(r(r(r(k / 2.0) * 3.0) + 4.0) - 5.0)
        _subroutine()
        l_ = 1.0
        while l_ <= 5.0:
            m[int(l_)] = a
            l_ = r(l_ + 1.0)
        if not k < 1000.0:
            return {"K": k, "A": a, "L": l_}


@in_line
def functions() -> Left:
    """`bm8`."""
    log, sin = math.log, math.sin
    k = 0.0
    while True:
        k = r(k + 1.0)
        a = r(k**2.0)
        b = r(log(k))
        c_ = r(sin(k))
        if not k < 100.0:
            return {"K": k, "A": a, "B": b, "C": c_}


@in_line
def ahl() -> Left:
    """`ahl`."""
    sqrt = math.sqrt
    seed, total, s = 1, 0.0, 0.0
    n = 1.0
    while n <= 100.0:
        a = n
        i = 1.0
        while i <= 10.0:
            a = r(sqrt(a))
            seed = (seed * MULTIPLIER + INCREMENT) % SEEDS
            total = r(total + seed / SEEDS)
            i = r(i + 1.0)
        i = 1.0
        while i <= 10.0:
            a = r(a**2.0)
            seed = (seed * MULTIPLIER + INCREMENT) % SEEDS
            total = r(total + seed / SEEDS)
            i = r(i + 1.0)
        s = r(s + a)
        n = r(n + 1.0)
    return {"S": s, "N": n}


@in_line
def sieve() -> Left:
    """`sieve`."""
    f = [0.0] * 7002
    count = 0.0
    i = 0.0
    while i <= 7000.0:
        f[int(i)] = 1.0
        i = r(i + 1.0)
    i = 0.0
    while i <= 7000.0:
        if f[int(i)] != 0.0:
            p = r(r(i + i) + 3.0)
            k = r(i + p)
            while not k > 7000.0:
                f[int(k)] = 0.0
                k = r(k + p)
            count = r(count + 1.0)
        i = r(i + 1.0)
    return {"C": count, "I": i}


@in_line
def nested_loops() -> Left:
    """`nestfor`."""
    n, s = 10.0, 0.0
    i = 1.0
    while i <= n:
        j = 1.0
        while j <= 50.0:
            k = 1.0
            while k <= 20.0:
                s = r(r(s + r(j * k)) - i)
                k = r(k + 1.0)
            j = r(j + 1.0)
        i = r(i + 1.0)
    return {"S": s, "I": i}


@in_line
def strings() -> Left:
    """`strings`."""
    i = 1.0
    a = b = ""
    while i <= 200.0:
        a = "HELLO WORLD"[:5] + "GOOD BYE"[2:4] + f" {i:g}"
        b = a[-3:]
        if len(b) > 5:
            break
        i = r(i + 1.0)
    return {"A$": a, "B$": b, "I": i}


@in_line
def arm_solution() -> Left:
    """`ik`: the article's own, lines 5000 to 5230, and the loop around it."""
    cos, sin, atan, sqrt = math.cos, math.sin, math.atan, math.sqrt
    h, l_, ll, pi = 8.1, 7.0, 3.5, 3.14159
    degrees = r(180.0 / pi)
    r1, s, t1 = 1.0, 0.0, 0.0
    i = 1.0
    while i <= 100.0:
        x_ = 8.0
        y = r(r(i - r(float(int(r(i / 10.0))) * 10.0)) - 5.0)
        z, pitch, roll = 1.5, -90.0, r(y * 9.0)
        pitch, roll = r(pitch / degrees), r(roll / degrees)
        rr = r(sqrt(r(r(x_ * x_) + r(y * y))))
        if rr < 0.25:
            return {}
        t1 = r(r(((y > 0.0) - (y < 0.0)) * pi) / 2.0) if x_ == 0.0 else r(atan(r(y / x_)))
        if x_ < 0.0:
            return {}
        t4 = r(r(pitch + roll) + r(r1 * t1))
        t5 = r(r(pitch - roll) - r(r1 * t1))
        if t4 < r(-270.0 / degrees) or t4 > r(270.0 / degrees):
            return {}
        if t5 < r(-270.0 / degrees) or t5 > r(270.0 / degrees):
            return {}
        r0 = r(rr - r(ll * r(cos(pitch))))
        z0 = r(r(z - r(ll * r(sin(pitch)))) - h)
        if r0 < 0.25:
            return {}
        g = r(r(((z0 > 0.0) - (z0 < 0.0)) * pi) / 2.0) if r0 == 0.0 else r(atan(r(z0 / r0)))
        a = r(r(r0 * r0) + r(z0 * z0))
        a = r(r(r(r(4.0 * l_) * l_) / a) - 1.0)
        if a < 0.0:
            return {}
        a = r(atan(r(sqrt(a))))
        t2 = r(a + g)
        t3 = r(g - a)
        if t2 > r(144.0 / degrees) or t2 < r(-127.0 / degrees):
            return {}
        if r(t2 - t3) < 0.0 or r(t2 - t3) > r(149.0 / degrees):
            return {}
        s = r(r(r(r(r(s + t1) + t2) + t3) + t4) + t5)
        i = r(i + 1.0)
    return {"S": s, "I": i}


BY_HAND: dict[str, Callable[[], Left]] = {
    "bm1": empty_loop,
    "bm2": counter,
    "bm3": variables,
    "bm4": constants,
    "bm5": subroutine,
    "bm6": inner_loop,
    "bm7": array,
    "bm8": functions,
    "ahl": ahl,
    "sieve": sieve,
    "nestfor": nested_loops,
    "strings": strings,
    "ik": arm_solution,
}
"""Listing to function."""
