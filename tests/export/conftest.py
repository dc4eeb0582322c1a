"""What others' programs make of the files is asked where a developer has installed them."""

from __future__ import annotations

import importlib.util
import shutil

from tests.export.validator import MODULE

collect_ignore = [
    file
    for module, file in (("mujoco", "test_mujoco.py"), ("yourdfpy", "test_yourdfpy.py"))
    if importlib.util.find_spec(module) is None
]
if shutil.which("node") is None or not MODULE.is_dir():
    collect_ignore.append("test_validator.py")
