"""What others' programs make of the files is asked where a developer has installed them."""

from __future__ import annotations

import importlib.util

collect_ignore = [
    file
    for module, file in (("mujoco", "test_mujoco.py"), ("yourdfpy", "test_yourdfpy.py"))
    if importlib.util.find_spec(module) is None
]
