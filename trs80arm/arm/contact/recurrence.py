"""What was found for the very same before: an arm that repeats a motion repeats its contacts.

Rotors are whole numbers, ticks begin with a motion, and parts are given where the last ones were.
So a program that goes round asks the same questions over and over, the same to the last bit. What
answers a question by computing alone, from numbers that are all said in it, is asked once; the
answer is the one that computing it again would have, so it does not matter what is still known and
what is not any more.
"""

from __future__ import annotations

import marshal
from collections.abc import Hashable
from hashlib import blake2b
from typing import Any, Generic, TypeVar

_PLAIN = 2
"""Version of `marshal` in which equal values are equal bytes, whoever else refers to them."""

Answer = TypeVar("Answer")


def question(*numbers: Any) -> bytes:
    """Numbers in tuples and lists, to the last bit; 0.0 and -0.0 are not the same."""
    return marshal.dumps(numbers, _PLAIN)


def brief(*numbers: Any) -> bytes:
    """The same in sixteen bytes, for many numbers that are part of many questions."""
    return blake2b(question(*numbers), digest_size=16).digest()


class Recurrence(Generic[Answer]):
    """Answers by question. Whoever is given one leaves it as it is.

    Args:
        most: answers known at once.
    """

    def __init__(self, most: int) -> None:
        self._most = most
        self._answers: dict[Hashable, Answer] = {}

    def get(self, question: Hashable) -> Answer | None:
        """The answer, if the question was asked lately."""
        return self._answers.get(question)

    def keep(self, question: Hashable, answer: Answer) -> Answer:
        """Know an answer from now on; the one known longest is forgotten for it.

        Returns:
            The answer.
        """
        answers = self._answers
        if len(answers) >= self._most:
            del answers[next(iter(answers))]
        answers[question] = answer
        return answer
