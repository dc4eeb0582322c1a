"""Khronos's validator of glTF, where `npm install gltf-validator` was done in the checkout."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path
from typing import Any

MODULE = Path(__file__).parents[2] / "node_modules/gltf-validator"
SCRIPT = """
const [module, file] = process.argv.slice(1);
require(module).validateBytes(new Uint8Array(require("fs").readFileSync(file)))
  .then(report => console.log(JSON.stringify(report.issues)));
"""


def issues(path: Path) -> dict[str, Any]:
    """What it says of a file: counts of each severity, and messages."""
    command = ["node", "-e", SCRIPT, str(MODULE), str(path)]
    done = subprocess.run(command, capture_output=True, text=True, check=True, timeout=60)
    found: dict[str, Any] = json.loads(done.stdout)
    return found
