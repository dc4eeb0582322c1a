"""What comes from outside, made fit to be shown.

Names of files, keys of a bench file and messages about them may hold anything: codes that move a
terminal's cursor or set its title, signs that turn the direction of writing around, half of a
character. Every line that the program prints or shows of such things goes through `shown`.
"""

from __future__ import annotations

LONGEST = 1000
"""Characters of a message; more of it nobody reads."""


def shown(text: object) -> str:
    r"""A text as one line without control codes; what cannot be shown stands as `\x1b` or so."""
    line = str(text)
    if line.isprintable():
        return line
    return "".join(sign if sign.isprintable() else _escaped(sign) for sign in line)


def message(text: object) -> str:
    """What a person is told: `shown`, and of what is longer than any message its two ends."""
    line = shown(text)
    if len(line) <= LONGEST:
        return line
    half = LONGEST // 2
    return f"{line[:half]} ... {line[-half:]}"


def _escaped(sign: str) -> str:
    # `repr` knows the short forms and leaves what is printable, which a sign here is not.
    return repr(sign)[1:-1]
