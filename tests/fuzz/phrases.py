"""Doors of words: options, commands, lines of the line mode, numbers, names, terminal bytes."""

from __future__ import annotations

import contextlib
import io
import math
import os
import tempfile
from pathlib import Path
from random import Random
from typing import Any

from click.testing import CliRunner

from tests.fuzz import noise
from tests.fuzz.checks import hold, rig_is_whole
from tests.fuzz.machines import SECONDS
from tests.fuzz.target import Case, Target
from trs80arm import paths, settings
from trs80arm.basic import cruncher
from trs80arm.basic.dialogue.input_statement import Items
from trs80arm.basic.errors import BasicError
from trs80arm.basic.kinds import Kind
from trs80arm.basic.numbers import convert, decimal, double, literal, using
from trs80arm.cli.commands import cli
from trs80arm.desk.session import Session
from trs80arm.operator import ScriptError, parse_holds
from trs80arm.plain import PlainMode
from trs80arm.rig import LONGEST_HOLD
from trs80arm.settings import SettingsError
from trs80arm.shown import shown
from trs80arm.ui.terminal.parser import KeyParser

# -- options and commands --------------------------------------------------------------------------


_KEYS = (
    *("speed", "fps", "keys", "theme", "ram", "memory_size", "tapes", "card.base", "card.order"),
    *("card.coil_bits", "driver.close_delay", "driver.keys", "arm.speed_margin", "arm.x", "x.y"),
)
_ODD_VALUES = (
    *("5", "max", "true", "nan", "inf", "-1", "1e400", '""', "[1,2]", "{a=1}", "[[[[[[", "ü", "'"),
    *("\x1b[2J", "a\nb", "1979-05-27", "~nobody-of-that-name/x", "\0", "1+W:0.1 0", "6:1e9"),
)
_LONG_VALUES = ("9" * 5000, "[" * 999, "1:" + "9" * 400)


def _value(rng: Random) -> str:
    value = rng.choice(_LONG_VALUES if rng.random() < 0.02 else _ODD_VALUES)
    return noise.mutated_text(rng, value) if rng.random() < 0.5 else value


def _option(rng: Random) -> Case:
    return [f"{rng.choice(_KEYS)}={_value(rng)}"]


_NO_SETTINGS = Path(os.devnull)


def _play_option(case: Case) -> None:
    try:
        settings.load(_NO_SETTINGS, case, {}).rig()
    except SettingsError as error:
        hold(shown(error).isprintable(), "an error that cannot be shown")


_FLAGS = (
    *("--seconds", "--input", "--set", "--trace-rate", "--ram", "--memory-size", "--option"),
    *("--config", "--bench", "--width", "--host", "--port", "-x", "--screen", "--registers"),
)


def _command(rng: Random) -> Case:
    words = [rng.choice(["run", "run", "run", "figure", "convert", "nothing"])]
    words += rng.choice([["a.bas"], ["a.bas"], [_value(rng)], []])
    for _ in range(rng.randrange(1, 4)):
        words += [rng.choice(_FLAGS), *([_value(rng)] if rng.random() < 0.9 else [])]
    # No system passes a zero on.
    return [word.replace("\0", "") for word in words]


def _play_command(case: Case) -> None:
    """Nothing but output and an exit code comes of a command line, whatever stands on it."""
    here = os.getcwd()
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        try:
            Path("a.bas").write_text('10 INPUT A$:PRINT A$:@SET:PRINT "!"\n')
            done = CliRunner().invoke(cli, case, prog_name="trs80arm")
        finally:
            os.chdir(here)
    if done.exception is not None and not isinstance(done.exception, SystemExit):
        raise done.exception
    hold(done.exit_code in (0, 1, 2), f"exit code {done.exit_code}")


def _lines(rng: Random) -> Case:
    words = [".open x", ".save /dev/full", ".screen", ".pose", ".events", ".registers", ".", ".x"]
    return [
        rng.choice([*words, noise.statement(rng), "@SET", "1+W:0.1 0", "0:0.1", "RUN", "\x1b\0ü"])
        for _ in range(rng.randrange(1, 8))
    ]


def _play_lines(case: Case) -> None:
    """The line mode takes any line, and prints no control codes."""
    out = io.StringIO()
    session = Session()
    plain = PlainMode(session, out, echo=True, speed=None)
    for line in case:
        plain.take(line)
        session.run_for(SECONDS)
    rig_is_whole(session.rig)
    printed = out.getvalue()
    hold(all(sign.isprintable() or sign == "\n" for sign in printed), "a control code is printed")


# -- the language's own ----------------------------------------------------------------------------


def _word(rng: Random) -> Case:
    text = rng.choice([noise.statement(rng), "".join(rng.choices(noise.WORDS, k=3))])
    return noise.mutated_text(rng, text) if rng.random() < 0.5 else text


def _play_words(case: Case) -> None:
    """Any line is crunched and spelled; what is spelled can be crunched again."""
    with contextlib.suppress(BasicError):
        crunched = cruncher.crunch(case.encode("latin-1"))
        spelled = cruncher.spell(crunched.text)
        hold(cruncher.spelling_cost(crunched.text) >= 0, "spelling takes no time")
        cruncher.crunch(spelled)


_SIGNS = "0123456789" * 3 + "..EEDD+-!#% ,$*[&A"
_SUMS = (convert.add, convert.sub, convert.mul, convert.div)


def _number(rng: Random) -> Case:
    def some() -> str:
        if rng.random() < 0.5:
            return noise.number(rng)
        return "".join(rng.choices(_SIGNS, k=rng.randrange(1, 14)))

    field = "".join(rng.choices("###.,$*+-[! %x", k=rng.randrange(1, 12)))
    return [some(), some(), rng.randrange(len(_SUMS)), field]


def _play_numbers(case: Case) -> None:
    """Numbers are read, reckoned with and written; each is one that the machine can hold."""
    first, second, number, picture = case
    with contextlib.suppress(BasicError):
        a, b = (literal.scan(text.encode("ascii")).value for text in (first, second))
        result = _SUMS[number](a, b)
        for value in (a, b, result):
            number_is_whole(value)
            hold(decimal.number_text(value).isascii(), "a number of odd signs")
        format_ = using.UsingFormat(picture)
        format_.literal()
        hold(format_.field(result).isascii(), "a number of odd signs")


def number_is_whole(value: Any) -> None:
    """A number is an integer of 16 bits, a single of 24 or a double of 56."""
    if type(value) is int:
        hold(-32768 <= value <= 32767, f"{value} is an integer")
    elif type(value) is float:
        mantissa, _ = math.frexp(value)
        hold(math.ldexp(mantissa, 24).is_integer(), f"{value!r} has more than 24 bits")
    else:
        hold(isinstance(value, double.Double), f"{value!r} is a number")
        hold(len(double.pack(value)) == 8, "a double of another size")


def _answer(rng: Random) -> Case:
    parts = ["5", " 1E5", "-", '"A,B"', '"', "A B", ",", ",", ":", " ", "X", "1.5D3", "\x80", "&H"]
    answer = "".join(rng.choices(parts, k=rng.randrange(0, 12)))
    return [answer, [str(rng.choice(list(_KINDS))) for _ in range(rng.randrange(1, 5))]]


_KINDS = (Kind.INTEGER, Kind.SINGLE, Kind.DOUBLE, Kind.STRING)


def _play_answer(case: Case) -> None:
    """Any answer to INPUT comes apart into items, each of them in the answer."""
    text, kinds = case
    answer = text.encode("latin-1")
    items = Items(answer)
    with contextlib.suppress(BasicError):
        for kind in map(Kind, kinds):
            if not items.is_next:
                break
            if kind is Kind.STRING:
                hold(items.string() in answer, "a string that nobody has typed")
            else:
                number_is_whole(items.number(kind))
                hold(items.scanning >= 0, "reading a number takes no time")
            if not items.separator():
                break
        hold(items.is_rest in (True, False), "a rest or none")


def _script(rng: Random) -> Case:
    parts = ["6:1.0", "1+W:0.5", "0", "ENTER", "SPACE:2", ":", "+", "1+:5", "Q:1e5", "::", "A:."]
    text = " ".join(rng.choices(parts, k=rng.randrange(0, 6)))
    return noise.mutated_text(rng, text) if rng.random() < 0.5 else text


def _play_script(case: Case) -> None:
    """A script of keys is read, in finite time from now on, or refused in one line."""
    try:
        holds = parse_holds(case)
    except ScriptError as error:
        hold(shown(error).isprintable(), "an error that cannot be shown")
        return
    hold(all(0 <= each.seconds <= LONGEST_HOLD for each in holds), "a key held for too long")
    hold(all(each.keys for each in holds), "no key at all")


# -- names and terminals ---------------------------------------------------------------------------


def _name(rng: Random) -> Case:
    parts = ["~", "~root", "/", "..", ".", "a" * 300, "\0", "\n", "\x1b]0;X\x07", "[/x]", "é", " "]
    parts += ["\ud800", "\u202e", "\U0001f600", "[@click=app.quit]", "a.bas", "/dev", "/proc/self"]
    return "".join(rng.choices(parts, k=rng.randrange(1, 6)))


def _play_name(case: Case) -> None:
    """Any name is looked at without a surprise, and shown without control codes."""
    path = paths.typed_path(case)
    hold(shown(path).isprintable() and shown(case).isprintable(), "a name that cannot be shown")
    if paths.refusal(path):
        hold(shown(paths.refusal(path)).isprintable(), "a refusal that cannot be shown")
    hold(not (paths.is_file(path) and paths.is_folder(path)), "a file that is a folder")


def _keys(rng: Random) -> Case:
    sequences = ["\x1b[97;1:3u", "\x1b[1;2A", "\x1b[<0;5;5M", "\x1b[200~", "\x1b[201~", "\x1bOP"]
    sequences += ["\x1b[?31u", "\x1b[?62;4c", "\x1b[I", "\x1b[97:65;2;65u", "\x1b[48;24;80;0;0t"]
    parts = []
    for _ in range(rng.randrange(1, 4)):
        part = rng.choice([*sequences, chr(rng.randrange(1, 0x3000)), "a"])
        parts.append(mutated_keys(rng, part) if rng.random() < 0.5 else part)
    return parts


def mutated_keys(rng: Random, part: str) -> str:
    """A terminal's sequence with other numbers in it."""
    digits = [place for place, sign in enumerate(part) if sign.isdigit()]
    if not digits:
        return part + chr(rng.randrange(32, 127))
    place = rng.choice(digits)
    number = rng.choice(["0", "1114112", "55296", "99999999", "", "-1", "7;7;7"])
    number = "9" * 300 if rng.random() < 0.01 else number
    return part[:place] + number + part[place + 1 :]


def _play_keys(case: Case) -> None:
    for releases in (False, True):
        parser = KeyParser(releases=releases)
        # Nothing is what Textual is told when the terminal is gone.
        for part in filter(None, case):
            for message in parser.feed(part):
                character = getattr(message, "character", None)
                hold(character is None or character == character.encode().decode(), "half a sign")
        list(parser.tick())


TARGETS = (
    Target("options", _option, _play_option),
    Target("commands", _command, _play_command),
    Target("lines", _lines, _play_lines),
    Target("words", _word, _play_words),
    Target("numbers", _number, _play_numbers),
    Target("answers", _answer, _play_answer),
    Target("scripts", _script, _play_script),
    Target("names", _name, _play_name),
    Target("keys", _keys, _play_keys),
)
