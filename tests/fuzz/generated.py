"""What generated code may consist of: a list of Python's kinds of node, names, calls, constants.

Compiled statements are Python functions. Whatever stands in a program, their text holds nothing
but what is listed here: no import, no name of Python's own beside three, no call of anything that
is not the language's routine, no attribute but a few of a few things, no text that came from the
program as Python.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from typing import Final
from unittest.mock import patch

from tests.fuzz.checks import hold
from trs80arm import Rig
from trs80arm.basic.compiler.emitter import Emitter

FRAME: Final = (ast.Module, ast.FunctionDef, ast.arguments, ast.Nonlocal, ast.Return, ast.Expr)
STATEMENTS: Final = (
    *(ast.Assign, ast.AugAssign, ast.If, ast.While, ast.Continue, ast.Break, ast.Pass),
    *(ast.Try, ast.ExceptHandler),
)
EXPRESSIONS: Final = (
    *(ast.Name, ast.Constant, ast.Attribute, ast.Call, ast.Subscript, ast.Tuple, ast.NamedExpr),
    *(ast.BinOp, ast.UnaryOp, ast.BoolOp, ast.Compare, ast.IfExp),
    *(ast.Load, ast.Store, ast.operator, ast.unaryop, ast.boolop, ast.cmpop),
)
KINDS: Final = FRAME + STATEMENTS + EXPRESSIONS
CONSTANTS: Final = (int, float, bytes, bool, type(None))
OWN_NAMES: Final = re.compile(
    r"cells|statement|[cfst]|now|soft|around|last|data|error|registers|[tk]\d+|[av]_[A-Z][A-Z0-9]?_[isdt]"
)
"""Names that a function gives itself: temporaries, constants, variables, arrays."""
READ: Final = {
    "now": r"clock",
    "soft": r"pace",
    "plenty": r"memory_room",
    "append": r"frames",
    "pop": r"frames",
    **dict.fromkeys(
        ("scalar", "body", "limit", "step", "top", "up", "back"), r"f|frames\[-1\]|around|t\d+"
    ),
    "mantissa": r".*",
}
"""Attributes, and what they may be of."""
CALLED: Final = ("append", "pop")
"""Attributes that may be called."""
PYTHON: Final = {"abs", "float", "int", "len", "BasicError"}
"""Python's own names, and the error that a tape statement holds back."""


@cache
def known_names() -> frozenset[str]:
    """The routines that the language gives to its statements."""
    names = set(Rig().basic.state.engine.environment) - {"__builtins__"}
    hold(not any(name.startswith("_") for name in names), "a hidden name")
    return frozenset(names)


def look_at(text: str) -> None:
    """See that a text of Python is one that the compiler may make.

    Raises:
        BrokenError: it holds anything else.
    """
    tree = ast.parse(text)
    hold(len(tree.body) == 1 and isinstance(tree.body[0], ast.FunctionDef), "not one function")
    for node in ast.walk(tree):
        hold(isinstance(node, KINDS), f"{type(node).__name__} in generated code")
        match node:
            case ast.Constant(value):
                hold(type(value) in CONSTANTS, f"{value!r} in generated code")
            case ast.Name(name):
                known = OWN_NAMES.fullmatch(name) or name in known_names()
                hold(bool(known), f"{name} in generated code")
            case ast.Attribute(value, attribute):
                of = READ.get(attribute)
                hold(of is not None, f".{attribute} in generated code")
                fits = of is not None and re.fullmatch(of, ast.unparse(value))
                hold(bool(fits), f"{ast.unparse(node)} in generated code")
            case ast.Call(function, _, keywords):
                name = function.id if isinstance(function, ast.Name) else ""
                method = function.attr if isinstance(function, ast.Attribute) else ""
                fits = name in known_names() or method in CALLED
                hold(fits and not keywords, f"{ast.unparse(function)}() in generated code")
            case ast.FunctionDef(name, arguments):
                plain = name in ("cells", "statement") and not ast.unparse(arguments)
                hold(plain and not node.decorator_list, f"def {name} in generated code")
            case ast.ExceptHandler(kind):
                hold(ast.unparse(kind or ast.Tuple()) == "BasicError", "an exception is caught")


@contextmanager
def watched() -> Iterator[None]:
    """Whatever is compiled in the meantime is looked at."""
    source = Emitter.source

    def looked_at(emitter: Emitter) -> str:
        text = source(emitter)
        try:
            look_at(text)
        except (SyntaxError, RecursionError, MemoryError):
            # Python does not read it either, and it is written another way.
            hold(not emitter.flat, "a flat text that Python cannot read")
        return text

    with patch.object(Emitter, "source", looked_at):
        yield
