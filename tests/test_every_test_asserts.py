"""A test that asserts nothing cannot fail: there is none."""

from __future__ import annotations

import ast
from pathlib import Path

Functions = dict[str, ast.FunctionDef | ast.AsyncFunctionDef]
CHECKS = {"raises", "fail", "check_golden"}
"""What asserts in another module."""


def functions(tree: ast.Module) -> Functions:
    """The functions of a module, nested ones too."""
    kinds = (ast.FunctionDef, ast.AsyncFunctionDef)
    return {node.name: node for node in ast.walk(tree) if isinstance(node, kinds)}


def asserts(node: ast.AST, known: Functions, seen: frozenset[str] = frozenset()) -> bool:
    """Whether something is asserted, here or in a known function that is called here."""
    for inner in ast.walk(node):
        if isinstance(inner, ast.Assert):
            return True
        if not isinstance(inner, ast.Call):
            continue
        called = inner.func
        name = called.attr if isinstance(called, ast.Attribute) else getattr(called, "id", "")
        if name in CHECKS:
            return True
        if name in known and name not in seen and asserts(known[name], known, seen | {name}):
            return True
    return False


def test_every_test_asserts_something() -> None:
    idle = []
    paths = sorted(Path(__file__).parent.rglob("*.py"))
    everywhere = {path: functions(ast.parse(path.read_text(encoding="utf-8"))) for path in paths}
    shared = {
        name: node
        for known in everywhere.values()
        for name, node in known.items()
        if name.startswith("assert_")
    }
    for path, known in everywhere.items():
        if path.name.startswith("test_"):
            idle += [
                f"{path.name}: {name}"
                for name, node in known.items()
                if name.startswith("test") and not asserts(node, shared | known, frozenset((name,)))
            ]
    assert idle == []
