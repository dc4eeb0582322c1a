"""Programs tested like software: what `pytest` finds when trs80arm is installed beside it.

`plugin.py` is the pytest plugin; it loads the rest when a test wants a rig. The assertion helpers
and `ProgramRig` are looked up here on first use, so that `import trs80arm.testing` costs nothing.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from trs80arm.testing.assertions import (
        assert_at,
        assert_no_slip,
        assert_part_at,
        assert_registers,
    )
    from trs80arm.testing.portraits import portrait
    from trs80arm.testing.program_rig import ProgramRig

__all__ = [
    "ProgramRig",
    "assert_at",
    "assert_no_slip",
    "assert_part_at",
    "assert_registers",
    "portrait",
]


def __getattr__(name: str) -> Any:
    """Load what is asked for (PEP 562)."""
    if name.startswith("assert_") and name in __all__:
        from trs80arm.testing import assertions

        return getattr(assertions, name)
    if name == "ProgramRig":
        from trs80arm.testing.program_rig import ProgramRig

        return ProgramRig
    if name == "portrait":
        from trs80arm.testing.portraits import portrait

        return portrait
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
