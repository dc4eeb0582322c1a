"""A monospaced font that is there whatever the system has: the one that matplotlib brings."""

from __future__ import annotations

from pathlib import Path

import matplotlib

FONT = Path(matplotlib.get_data_path(), "fonts", "ttf", "DejaVuSansMono.ttf")
