"""One statement's Python text, as the compiler writes it, lowered to WebAssembly text.

The text is what the statement means, its costs included: nothing of the language is known here, but
the Python that the compiler uses for numbers, loops and subroutines. Singles are f64 and rounded by
the same operations in the same order, integers and truth values are i32. Where the text calls for
what is not here, an error too, the code leaves for the statement's edge with nothing done.
"""

from __future__ import annotations

import ast
from collections.abc import Callable
from typing import Final, NamedTuple

from trs80arm.basic import costs, room
from trs80arm.basic.compiler.emitter import Emitter
from trs80arm.basic.compiler.scope import Assumptions
from trs80arm.basic.control import GosubFrame
from trs80arm.basic.native import module
from trs80arm.basic.native.module import FLOAT, INTEGER, TYPES
from trs80arm.basic.variables import Key, Scalar, Variables

_OPERATIONS: Final = {ast.Add: "add", ast.Sub: "sub", ast.Mult: "mul", ast.Div: "div"}
_LOGICAL: Final = {ast.BitAnd: "and", ast.BitOr: "or"}
_ORDER: Final = {ast.Lt: "lt", ast.LtE: "le", ast.Gt: "gt", ast.GtE: "ge"}
_SAME: Final = {ast.Eq: "eq", ast.NotEq: "ne", ast.Is: "eq", ast.IsNot: "ne"}
_RELATIONS: Final[dict[type[ast.cmpop], str]] = {**_ORDER, **_SAME}
_ZERO: Final = "(f64.const 0)"


class Unlowerable(Exception):  # noqa: N818 - the statement, or one of its ways, stays Python's
    """There is no native form."""


class Value(NamedTuple):
    """WebAssembly text that puts a value on the stack.

    Attributes:
        type: FLOAT, or INTEGER, also for truth values and for addresses of frames.
        code: the text.
    """

    type: str
    code: str

    def as_(self, type_: str) -> str:
        """Text that gives it, a whole number where an integer is wanted, as another type."""
        if self.type == type_:
            return self.code
        if type_ == INTEGER:
            return f"(i32.trunc_sat_f64_s {self.code})"
        if self.code.startswith("(i32.const "):
            return self.code.replace("i32", "f64")
        return f"(f64.convert_i32_s {self.code})"

    @property
    def test(self) -> str:
        """Text that gives whether it is not zero."""
        return self.code if self.type == INTEGER else f"(f64.ne {self.code} {_ZERO})"


class Lowering:
    """One statement, lowered.

    Args:
        out: its Python text, and what its constants stand for.
        assumptions: what that takes for granted about variables.
        variables: the program's.

    Attributes:
        assumptions: the same.
        reach: the last address of the program that it depends on.
        code: what it came to.
        goes_to: where it may go on: an address, round the loop of a variable, back (None).
        opens: the variable, or None, and the target of each frame that it makes.
        cost: T-states that it takes at most.
        locals: types of locals by their names, beside those of variables.
        scalars: the locals of the simple variables that it uses.
        arrays: the names of the arrays that it uses, and where their elements begin.
        stored: those of both that it changes.
    """

    def __init__(self, out: Emitter, assumptions: Assumptions, variables: Variables) -> None:
        self.assumptions = assumptions
        self.reach = out.reach
        self.code = ""
        self.goes_to: set[int | Key | None] = set()
        self.opens: set[tuple[Key | None, int]] = set()
        self.cost = 0
        self.locals: dict[str, str] = {}
        self.scalars: set[str] = set()
        self.arrays: dict[str, int] = {}
        self.stored: set[str] = set()
        self._names = out.constants
        self._variables = variables
        self._types: dict[str, str] = {}
        self._effects: set[str] = set()
        self._saved: set[str] = set()
        """The locals changed so far, and those that a way out must have as they were."""

    def lower(self, address: int, source: str) -> None:
        """Lower the statement's function, that stands in one that declares its cells.

        Raises:
            Unlowerable: every way through it is Python's.
        """
        _, inner = (e for e in ast.walk(ast.parse(source)) if isinstance(e, ast.FunctionDef))
        self._block(inner.body)
        saved = sorted(self._saved)
        if saved:
            types = {"now": "i64", "sp": INTEGER}
            self.locals |= {f"old_{name}": types.get(name) or TYPES[name[-1]] for name in saved}
            save = "".join(f"(local.set $old_{name} (local.get ${name}))" for name in saved)
            undo = "".join(f"(local.set ${name} (local.get $old_{name}))" for name in saved)
            self.code = f"{save}(block $undo {self.code}){undo}(br $done)"
        late = "(br_if $done (i64.ge_s (local.get $now) (local.get $soft)))"
        self.code = f"(local.set $at (i32.const {address})){late}{self.code}"

    def _out(self) -> str:
        """The way out: to the statement's edge, as if it had not begun."""
        if "array" in self._effects:
            raise Unlowerable
        self._saved |= self._effects
        return "(br $undo)" if self._effects else "(br $done)"

    def _kept(self, name: str, value: Value) -> Value:
        """A value that is kept under a name."""
        self._types[name] = value.type
        self.locals[f"{name}_{value.type}"] = value.type
        return Value(value.type, f"(local.tee ${name}_{value.type} {value.code})")

    def _twice(self, value: Value) -> tuple[Value, Value]:
        """A value that is computed, and the same again."""
        name = f"x{len(self.locals)}"
        return self._kept(name, value), Value(value.type, f"(local.get ${name}_{value.type})")

    # -- statements ---------------------------------------------------------------------------

    def _block(self, body: list[ast.stmt], *, one_of_two: bool = False) -> bool:
        """Lower statements; whether control never comes to their end."""
        for node in body:
            before = self.code
            try:
                if self._statement(node):
                    return True
            except Unlowerable:
                if not one_of_two:
                    raise
                self.code = before + self._out()
                return True
            one_of_two |= isinstance(node, ast.If)  # Behind it not every way comes by.
        return False

    def _statement(self, node: ast.stmt) -> bool:
        match node:
            case ast.Nonlocal():
                pass
            case ast.AugAssign(value=ast.Constant(value=int() as cost)):  # Of the clock.
                self.code += self._take(cost)
                self.cost += cost
            case ast.Assign(value=ast.Subscript(value=ast.Name(id=kept))) if kept in self._names:
                pass  # A loop's frame kept for its next beginning: here each is made anew.
            case ast.Assign(targets=[target, *others], value=expression):
                value = self._value(expression)
                for other in others:
                    value = self._kept(_name(other), value)
                self._assign(target, value)
            case ast.If(orelse=[*_, ast.Assign(value=ast.Call() as opening)]):
                self._do(opening)  # No kept frame will do.
            case ast.If():
                return self._if(node)
            case ast.Return(value=ast.Constant(value=int() as address)):
                self.goes_to.add(address)
                self.code += module.jump(f"(i32.const {address})")
                return True
            case ast.Return(value=ast.Attribute(value=frame, attr=attribute)):
                self.goes_to |= {None} if attribute == "back" else set()
                self.code += module.jump(f"(i32.load offset=4 {self._value(frame).code})")
                return True
            case ast.Expr(value=ast.Call() as call):
                self._do(call)
            case _:
                raise Unlowerable
        return False

    def _take(self, time: int) -> str:
        self._effects.add("now")
        return f"(local.set $now (i64.add (local.get $now) (i64.const {time})))"

    def _assign(self, target: ast.expr, value: Value) -> None:
        name = _name(target.value if isinstance(target, ast.Subscript) else target)
        if name[:2] not in ("v_", "a_"):
            self.code += f"(drop {self._kept(name, value).code})"
            return
        if TYPES.get(name[-1]) != value.type:
            raise Unlowerable
        self.stored.add(name)
        if isinstance(target, ast.Subscript):
            self.code += f"(f64.store {self._place(name, target.slice)} {value.as_(FLOAT)})"
        else:
            self.scalars.add(name)
            self.code += f"(local.set ${name} {value.code})"
        self._effects.add(name if name[0] == "v" else "array")

    def _if(self, node: ast.If) -> bool:
        test = self._value(node.test).test
        outer, cost, most, before = self.code, self.cost, self.cost, self._effects
        after, branches, ends = set[str](), [], []
        for branch in (node.body, node.orelse):
            self.code, self.cost, self._effects = "", cost, set(before)
            ends.append(self._block(branch, one_of_two=True))
            branches.append(self.code)
            most = max(most, self.cost)
            after |= set() if ends[-1] else self._effects
        self.cost, self._effects = most, after
        self.code = f"{outer}(if {test} (then {branches[0]}) (else {branches[1]}))"
        return all(ends)

    def _do(self, call: ast.Call) -> None:
        """A call for what it does to the frames."""
        about = self._names.get(_name(call.args[0])) if call.args else None
        match call.func:
            case ast.Attribute(attr="append") if isinstance(about, GosubFrame):
                self._open(None, about.back, about.line)
            case ast.Name(id="open_loop"):
                limit, step = (self._value(each).as_(FLOAT) for each in call.args[1:3])
                few = f"(i32.lt_s {module.DEPTH} (i32.const {room.FEW}))"
                self.code += f"(if {few} (then) (else {self._out()}))"
                target, line = map(ast.literal_eval, call.args[3:])
                self._open(about, target, line, limit, step)
            case ast.Attribute(attr="pop"):
                self.code += f"(local.set $sp {module.TOP})"
            case ast.Name(id="drop_loop"):
                scalar = f"(i32.const {module.identity_of(about)})"
                self.code += f"(local.set $sp (call $drop (local.get $sp) {scalar}))"
            case _:
                raise Unlowerable
        self._effects.add("sp")

    def _open(
        self, scalar: Scalar | None, target: int, line: int, limit: str = _ZERO, step: str = _ZERO
    ) -> None:
        """Open a loop or a subroutine."""
        self.opens.add(((scalar.name, scalar.kind) if scalar else None, target))
        integers = (f"(i32.const {each})" for each in (module.identity_of(scalar), target, line))
        for place, field in zip((0, 4, 8, 16, 24), (*integers, limit, step), strict=True):
            type_ = INTEGER if place < 16 else FLOAT
            self.code += f"({type_}.store offset={place} (local.get $sp) {field})"
        self.code += f"(local.set $sp (i32.add (local.get $sp) (i32.const {module.FRAME_BYTES})))"

    # -- values -------------------------------------------------------------------------------

    def _perhaps(self, node: ast.expr) -> Value | None:
        """A value that is not always wanted; None where it is Python's."""
        try:
            return self._value(node)
        except Unlowerable:
            return None

    def _value(self, node: ast.expr) -> Value:
        match node:
            case ast.Constant(value=int() as number):
                return Value(INTEGER, f"(i32.const {int(number)})")
            case ast.Constant(value=float() as number):
                return Value(FLOAT, f"(f64.const {number!r})")
            case ast.Name(id=name) if name in self._types:
                return Value(self._types[name], f"(local.get ${name}_{self._types[name]})")
            case ast.Name(id=name) if name.startswith("v_") and name[-1] in TYPES:
                self.scalars.add(name)
                return Value(TYPES[name[-1]], f"(local.get ${name})")
            case ast.NamedExpr(target=ast.Name(id=name), value=expression):
                return self._kept(name, self._value(expression))
            case ast.Subscript(value=ast.Name(id="frames")):
                return Value(INTEGER, module.TOP)
            case ast.Subscript(value=ast.Name(id=name)) if name[:2] == "a_" and name[-1] in TYPES:
                element = Value(FLOAT, f"(f64.load {self._place(name, node.slice)})")
                return Value(TYPES[name[-1]], element.as_(TYPES[name[-1]]))
            case ast.Attribute(attr="plenty"):
                return Value(INTEGER, "(i32.const 1)")  # Else the loop would not run in here.
            case ast.Attribute(value=frame, attr=("limit" | "step" | "up" | "top") as field):
                return _field(self._value(frame), field)
            case ast.Compare(left=ast.Attribute(value=frame, attr="scalar"), comparators=[wanted]):
                scalar = self._names.get(_name(wanted))
                self.goes_to |= {(scalar.name, scalar.kind)} if scalar else set()
                left = Value(INTEGER, f"(i32.load {self._value(frame).code})")
                right = Value(INTEGER, f"(i32.const {module.identity_of(scalar)})")
                return self._relation(left, node.ops, [right])
            case ast.Compare(left=first, ops=ops, comparators=rest):
                return self._relation(self._value(first), ops, [*map(self._value, rest)])
            case ast.BinOp(left=one, right=other):
                return self._operation(type(node.op), self._value(one), self._value(other))
            case ast.BoolOp(op=junction, values=[first, *rest]):
                others = ast.BoolOp(junction, rest) if rest[1:] else rest[0]
                if isinstance(junction, ast.And):
                    return self._choice(self._value(first).test, others, ast.Constant(0))
                return self._choice(self._value(first).test, ast.Constant(1), others)
            case ast.UnaryOp(op=ast.Not(), operand=operand):
                return Value(INTEGER, f"(i32.eqz {self._value(operand).test})")
            case ast.UnaryOp(op=(ast.Invert() | ast.USub()) as sign, operand=operand):
                type_, code = self._value(operand)
                less = 0 if isinstance(sign, ast.USub) else -1
                return Value(type_, f"({type_}.sub ({type_}.const {less}) {code})")
            case ast.IfExp(test=condition, body=one, orelse=other):
                return self._choice(self._value(condition).test, one, other)
            case ast.Call(func=ast.Name(id="len")):
                return Value(INTEGER, module.DEPTH)
            case ast.Call(func=ast.Name(id=name), args=arguments) if name in _ROUTINES:
                return _ROUTINES[name](self, *map(self._value, arguments))
        raise Unlowerable

    def _place(self, name: str, index: ast.expr) -> str:
        """Text that gives the address of an element."""
        array = self._variables.arrays[module.key_of(name)]
        self.arrays[name] = module.ARRAYS + 8 * array.offset
        return f"offset={self.arrays[name]} (i32.shl {self._value(index).code} (i32.const 3))"

    def _operation(self, kind: type[ast.operator], left: Value, right: Value) -> Value:
        if kind in _LOGICAL:
            return Value(INTEGER, f"(i32.{_LOGICAL[kind]} {left.code} {right.code})")
        if kind is ast.FloorDiv and left.type == FLOAT and right.code == "(f64.const 1.0)":
            return Value(FLOAT, f"(f64.floor {left.code})")
        if kind not in _OPERATIONS:
            raise Unlowerable
        type_ = FLOAT if kind is ast.Div or FLOAT in (left.type, right.type) else INTEGER
        return Value(type_, f"({type_}.{_OPERATIONS[kind]} {left.as_(type_)} {right.as_(type_)})")

    def _relation(self, left: Value, operators: list[ast.cmpop], rest: list[Value]) -> Value:
        code = ""
        for operator, right in zip(operators, rest, strict=True):
            right, again = self._twice(right) if right is not rest[-1] else (right, right)
            type_ = FLOAT if FLOAT in (left.type, right.type) else INTEGER
            name = _RELATIONS[type(operator)]
            name += "_s" if type_ == INTEGER and name not in ("eq", "ne") else ""
            test = f"({type_}.{name} {left.as_(type_)} {right.as_(type_)})"
            code, left = f"(i32.and {code} {test})" if code else test, again
        return Value(INTEGER, code)

    def _choice(self, test: str, *nodes: ast.expr) -> Value:
        choices = [self._perhaps(each) for each in nodes]
        types = {value.type for value in choices if value}
        if not types:
            raise Unlowerable
        type_ = FLOAT if FLOAT in types else INTEGER
        a, b = (value.as_(type_) if value else self._out() for value in choices)
        return Value(type_, f"(if (result {type_}) {test} (then {a}) (else {b}))")

    # -- routines that the text calls ---------------------------------------------------------

    def _arithmetic(self, name: str, left: Value, right: Value) -> Value:
        """An operation on singles where the short way does not do."""
        (first, a), (second, b) = (
            self._twice(Value(FLOAT, value.as_(FLOAT))) for value in (left, right)
        )
        exact, ratio = f"(f64.{name} {first.code} {second.code})", f"(f64.div {a.code} {b.code})"
        call = f"$product {exact}"
        if name in ("add", "sub"):
            call = f"$sum {exact} {ratio if name == 'add' else f'(f64.neg {ratio})'}"
        call_, result = self._twice(Value(FLOAT, f"(call {call})"))
        code = f"(if (f64.ne {call_.code} {result.code}) (then {self._out()}))"
        less = {"mul": costs.PRODUCT_OF_ZERO, "div": costs.QUOTIENT_OF_ZERO}.get(name)
        if less:
            zero = f"(f64.eq (f64.mul {a.code} {b.code}) {_ZERO})"
            code += f"(if {zero} (then {self._take(-less)}))"
        return Value(FLOAT, f"(block (result f64) {code} {result.code})")

    def _small(self, code: str, least: int = -0x8000, most: int = 0x7FFF) -> Value:
        """An integer between bounds; outside of them it is Python's."""
        first, again = self._twice(Value(INTEGER, code))
        fits = f"(i32.ge_s {first.code} (i32.const {least}))"
        fits = f"(i32.and {fits} (i32.le_s {again.code} (i32.const {most})))"
        leave = f"(if (i32.eqz {fits}) (then {self._out()}))"
        return Value(INTEGER, f"(block (result i32) {leave} {again.code})")

    def _integer(self, name: str, left: Value, right: Value) -> Value:
        """An operation on integers."""
        if FLOAT in (left.type, right.type):
            raise Unlowerable
        return self._small(f"(i32.{name} {left.code} {right.code})")

    def _sign(self, value: Value) -> Value:
        up, down = (each.as_(FLOAT) for each in self._twice(value))
        return Value(INTEGER, f"(i32.sub (f64.gt {up} {_ZERO}) (f64.lt {down} {_ZERO}))")

    def _goes_on(self, value: Value, frame: Value) -> Value:
        """Whether a loop goes on, by the sign of its step."""
        value, again = self._twice(Value(FLOAT, value.as_(FLOAT)))
        limit, step = (_field(frame, field).code for field in ("limit", "step"))
        inside = f"(f64.ge (f64.mul (f64.sub {limit} {value.code}) {step}) {_ZERO})"
        still = f"(f64.ne {again.code} {limit})"
        return Value(INTEGER, f"(select {inside} {still} (f64.ne {step} {_ZERO}))")


def _name(node: ast.expr) -> str:
    return node.id if isinstance(node, ast.Name) else ""


def _field(frame: Value, name: str) -> Value:
    """A loop's limit or step, `up`, which has the sign of the step, or `top`."""
    limit, step = (f"(f64.load offset={place} {frame.code})" for place in (16, 24))
    usual = f"(i32.and (f64.ge {step} (f64.const 1e-30)) (f64.le {step} (f64.const 1e30)))"
    top = f"(select {limit} (f64.const {-(2.0**128)!r}) {usual})"
    return Value(FLOAT, {"limit": limit, "top": top}.get(name, step))


def _named(routine: Callable[..., Value], name: str) -> Callable[..., Value]:
    return lambda lowering, *values: routine(lowering, name, *values)


def _of_float(form: str) -> Callable[..., Value]:
    """What leaves an integer as it is."""
    return lambda _, value: Value(FLOAT, form % value.code) if value.type == FLOAT else value


_ROUTINES: Final[dict[str, Callable[..., Value]]] = {
    **{name: _named(Lowering._arithmetic, name) for name in ("add", "sub", "mul", "div")},
    **{f"integer_{name}": _named(Lowering._integer, name) for name in ("add", "sub", "mul")},
    **{f"any_{name}": _named(Lowering._integer, name) for name in ("add", "sub", "mul")},
    "integer_step": lambda low, *pair: low._small(
        f"(i32.add {pair[0].code} {pair[1].as_(INTEGER)})"
    ),
    "int": lambda _, value: Value(INTEGER, value.as_(INTEGER)),
    "float": lambda _, value: Value(FLOAT, value.as_(FLOAT)),
    "to_single": lambda _, value: Value(FLOAT, value.as_(FLOAT)),
    "byte": lambda low, value: low._small(value.as_(INTEGER), 0, 255),
    "sign": Lowering._sign,
    "floor": lambda low, value: low._small(_of_float("(f64.floor %s)")(low, value).as_(INTEGER)),
    "abs": _of_float("(f64.abs %s)"),
    "absolute": lambda low, it: low._small(f"(i32.trunc_sat_f64_s (f64.abs {it.as_(FLOAT)}))"),
    "negate": lambda low, value: low._integer("sub", Value(INTEGER, "(i32.const 0)"), value),
    "any_floor": _of_float("(f64.floor %s)"),
    "fix": _of_float(f"(f64.add (f64.trunc %s) {_ZERO})"),  # A zero has no sign.
    "goes_on": Lowering._goes_on,
}
"""What the text calls, by its names in `runtime.environment`."""
