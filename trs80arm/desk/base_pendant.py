"""The TeachMover's own teach pendant in its operator's hands, where the arm has one.

What is pressed here is pressed on the rig, at its virtual time; what the keys do is the pendant's
own affair (`serial/pendant.py`).
"""

from __future__ import annotations

from trs80arm.desk.session import Session
from trs80arm.serial import pendant_words
from trs80arm.serial.controller import Controller
from trs80arm.serial.pendant import DIGITS
from trs80arm.serial.pendant_keys import FunctionKey, JointKey

AXES = ("BASE", "SHOULDER", "ELBOW", "PITCH", "ROLL", "GRIP")
"""The pairs of joint keys, in order."""
SIGNS = {1: "PLUS", -1: "MINUS"}
NONE = "This arm has no computer, and no pendant, of its own."
_OF_DIGIT = {str(digit): key for key, digit in DIGITS.items()}


class BasePendant:
    """The pendant on the arm's cable.

    Args:
        session: the machine with the arm.
    """

    def __init__(self, session: Session) -> None:
        self._session = session

    @property
    def _base(self) -> Controller | None:
        return self._session.rig.controller

    @property
    def there(self) -> bool:
        """Whether the arm has a computer of its own, and so a pendant."""
        return self._base is not None

    # -- keys -------------------------------------------------------------------------------------

    def press(self, axis: int, way: int) -> None:
        """A joint key goes down.

        Args:
            axis: 0 base, to 5 grip.
            way: 1 or -1.
        """
        if self.there:
            self._session.rig.press_pendant(f"{AXES[axis]}_{SIGNS[way]}")

    def hold(self, axis: int, way: int) -> None:
        """It is still down: it was pressed already."""

    def release(self, axis: int, way: int) -> None:
        """It goes up."""
        if self.there:
            self._session.rig.release_pendant(f"{AXES[axis]}_{SIGNS[way]}")

    def let_go(self) -> None:
        """All hands off."""
        base = self._base
        if base is not None:
            for key in list(base.held):
                self._session.rig.release_pendant(key.name)

    def push(self, key: FunctionKey) -> None:
        """A function key goes down and up."""
        if self.there:
            self._session.rig.press_pendant(key.name)
            self._session.rig.release_pendant(key.name)

    def type_digit(self, digit: str) -> None:
        """The function key that is a digit while a number is asked for."""
        self.push(_OF_DIGIT[digit])

    # -- what it shows ----------------------------------------------------------------------------

    @property
    def asks(self) -> bool:
        """Whether a number, or a yes, is asked for."""
        return self._base is not None and self._base.pendant.asks is not None

    @property
    def busy(self) -> bool:
        """Whether the arm does something for the pendant or the line."""
        return self._base is not None and self._base.busy

    @property
    def down(self) -> frozenset[JointKey]:
        """The joint keys that are down."""
        return frozenset() if self._base is None else frozenset(self._base.held)

    @property
    def state(self) -> str:
        """Mode, pointer, speed, and what the arm does, in a line."""
        base = self._base
        return pendant_words.state(base) if base is not None else NONE

    @property
    def message(self) -> str:
        """What is asked for, or what there is to say of the last key."""
        base = self._base
        return pendant_words.message(base) if base is not None else ""

    def program(self, rows: int) -> list[str]:
        """The steps in the memory, so many lines around the one at the pointer."""
        base = self._base
        return pendant_words.program(base, rows) if base is not None else []
