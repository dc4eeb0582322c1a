"""The line mode: the same machine for screen readers, braille displays and pipes.

What the machine prints is printed; a line typed here is typed there. Lines that begin with a point
are the program's own commands: `table.py` has them all. In manual mode a line says which keys are
held, and for how long. Under it is the same desk as under the screen.
"""

from trs80arm.plain.mode import PlainMode, run_plain

__all__ = ["PlainMode", "run_plain"]
