"""The WebAssembly module of one loop: its statements, its memory, what singles need.

Statements are cases of one switch, found by their addresses; variables are locals while it runs. In
memory lie what it is called with, open loops and subroutines, variables on their way, and arrays.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from trs80arm.basic.compiler import rounding
from trs80arm.basic.kinds import Kind
from trs80arm.basic.variables import Key, Scalar

if TYPE_CHECKING:
    from trs80arm.basic.native.lowering import Lowering

FLOAT, INTEGER = "f64", "i32"
TYPES: Final = {"s": FLOAT, "i": INTEGER}
"""Types by the kinds of numbers, with which the compiler's names end."""
FRAME_BYTES: Final = 32
"""A frame: variable, target and line (i32), limit and step (f64, from 16)."""
TIME, PLACE, STACK, FRAMES, SCALARS, ARRAYS = 0, 8, 12, 64, 0x1000, 0x8000
"""Addresses: the time to go and then the time taken (i64), the statement to begin with and then the
one to go on with, the end of the frames (i32), the frames, the values of simple variables and of
arrays, eight bytes each (f64)."""
MEMORY: Final = ARRAYS + 8 * 0xC000
"""Bytes, for arrays as far apart as in the largest machine, their bytes taken eightfold."""
TOP: Final = f"(i32.sub (local.get $sp) (i32.const {FRAME_BYTES}))"
DEPTH = f"(i32.div_u (i32.sub (local.get $sp) (i32.const {FRAMES})) (i32.const {FRAME_BYTES}))"
"""Text of the address of the innermost frame, and of how many there are."""
_ROUTINES: Final = f"""
(func $drop (param $sp i32) (param $scalar i32) (result i32) (local $at i32) (local $is i32)
 (local.set $at (local.get $sp))
 (loop $down (local.set $at (i32.sub (local.get $at) (i32.const {FRAME_BYTES})))
  (if (i32.eqz (local.tee $is (i32.load (local.get $at)))) (then (return (local.get $sp))))
  (br_if $down (i32.ne (local.get $is) (local.get $scalar))))
 (local.get $at))
(func $round (param $x f64) (result f64) (local $c f64)
 (local.set $c (f64.mul (local.get $x) (f64.const {rounding.SPLIT!r})))
 (f64.sub (local.get $c) (f64.sub (local.get $c) (local.get $x))))
(func $in (param $least f64) (param $x f64) (param $most f64) (result i32)
 (i32.and (f64.le (local.get $least) (local.get $x)) (f64.le (local.get $x) (local.get $most))))
(func $usual (param $x f64) (param $r f64) (result f64)
 (select (local.get $r) (f64.const nan)
  (call $in (f64.const 1e-37) (f64.abs (local.get $x)) (f64.const 1e37))))
(func $sum (param $s f64) (param $q f64) (result f64) (local $r f64)
 (if (f64.eq (local.get $s) (f64.const 0)) (then (return (f64.const 0))))
 (local.set $r (call $round (f64.mul (local.get $s) (f64.const {rounding.AWAY!r}))))
 (call $usual (local.get $r) (select (local.get $r) (f64.const nan) (i32.or
  (i32.or (f64.eq (local.get $r) (local.get $s)) (f64.gt (local.get $q) (f64.const 0))) (i32.or
   (call $in (f64.const -256) (local.get $q) (f64.const {-(2.0**-8)!r})) (i32.and
    (call $in (f64.const {-(2.0**24)!r}) (local.get $q) (f64.const {-(2.0**-24)!r}))
    (f64.eq (local.get $r) (call $round (f64.mul (local.get $s)
     (f64.const {1.0 + 2.0**-30!r}))))))))))
(func $product (param $x f64) (result f64)
 (local.set $x (f64.mul (local.get $x) (f64.const {rounding.AWAY!r})))
 (if (f64.eq (local.get $x) (f64.const 0)) (then (return (f64.const 0))))
 (call $usual (local.get $x) (call $round (local.get $x))))
"""
"""FOR's look for a loop of the same variable. Rounding where the short way does not do: of a sum,
with the ratio of its operands, and of a product or quotient; no number where it is Python's."""


def key_of(name: str) -> Key:
    """The key of the variable or array that a name of the compiler's text stands for."""
    _, letters, kind = name.split("_")
    return letters, Kind(kind)


def identity_of(scalar: Scalar | None) -> int:
    """The number that stands for a loop's variable in a frame; 0 in that of a subroutine."""
    return 0 if scalar is None else int.from_bytes(f"{scalar.kind}{scalar.name}".encode())


def jump(address: str) -> str:
    """To a statement, in the loop or not, whose address some text gives."""
    return f"(local.set $at {address})(br $go)"


def text(statements: dict[int, Lowering], scalars: dict[str, bool]) -> str:
    """The module's text.

    Args:
        statements: by their addresses, in order.
        scalars: the locals of simple variables, and whether each is changed.
    """
    first, last = min(statements), max(statements)
    labels = " ".join(f"$s{a}" if a in statements else "$done" for a in range(first, last + 1))
    opened = "".join(f"(block $s{address} " for address in reversed(statements))
    cases = "".join(
        f")\n{each.code.removesuffix(jump(f'(i32.const {following})'))}"
        for each, following in zip(statements.values(), [*statements, -1][1:], strict=True)
    )
    declared = {name: TYPES[name[-1]] for name in scalars}
    declared |= {name: of for each in statements.values() for name, of in each.locals.items()}
    take = give = ""
    for place, (name, changed) in enumerate(scalars.items()):
        at, get = f"(i32.const {SCALARS + 8 * place})", f"(local.get ${name})"
        load = f"(f64.load {at})"
        if declared[name] == INTEGER:
            load, get = f"(i32.trunc_sat_f64_s {load})", f"(f64.convert_i32_s {get})"
        take += f"(local.set ${name} {load})"
        give += f"(f64.store {at} {get})" if changed else ""
    return f"""(module (memory (export "memory") {-(-MEMORY // 0x10000)})
{_ROUTINES}
(func (export "run") (local $soft i64) (local $now i64) (local $at i32) (local $sp i32)
 {"".join(f"(local ${name} {type_})" for name, type_ in declared.items())}
 (local.set $soft (i64.load (i32.const {TIME})))
 (local.set $at (i32.load (i32.const {PLACE})))
 (local.set $sp (i32.load (i32.const {STACK})))
 {take}
 (block $done (loop $go {opened}
 (br_table {labels} $done (i32.sub (local.get $at) (i32.const {first})))
{cases}
 (unreachable)))
 (i64.store (i32.const {TIME}) (local.get $now))
 (i32.store (i32.const {PLACE}) (local.get $at))
 (i32.store (i32.const {STACK}) (local.get $sp))
 {give}))"""
