"""A bench on which the hand stands round a block, open."""

from __future__ import annotations

BLOCK = """
[arm]
at = [6, 0, 0.3]
opening = 0.9
[[part]]
name = "block"
at = [6, 0]
size = [0.5, 0.4, 0.8]
weight = 1
"""
