"""The TRS-80, ARMBASIC and the MiniMover 5, wired together: `Rig` is the public door.

`from trs80arm import Rig` gives the whole machine without a screen. The name is looked up on first
use, so that `import trs80arm` costs nothing and loads neither Textual nor numpy.
"""

from __future__ import annotations

# As `typing` has it, which takes longer to load than all that the help needs.
TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

    from trs80arm.rig import Rig, RigSettings

__all__ = ["Rig", "RigSettings", "__version__"]
__version__ = "0.1.0"


def __getattr__(name: str) -> Any:
    """Load the rig when it is first asked for (PEP 562)."""
    if name in ("Rig", "RigSettings"):
        from trs80arm import rig

        return getattr(rig, name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
