"""Other BASICs, where they are installed, and how a listing is spelled for each.

Nothing that is rewritten changes how many statements are executed, but for an ELSE that has to be
unfolded. Only what the thirteen listings have is rewritten.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import tempfile
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

from benchmarks.rows import process_cost

Lines = Sequence[str]
TIMEOUT = 120.0
THROUGH = b"ALL DONE"
"""What is printed at the end: a peer that stops on an error has not been timed."""


@dataclass(frozen=True)
class Peer:
    """Another BASIC.

    Attributes:
        name: as people call it.
        program: its executable, as found on the path.
        options: what makes it run a file and leave.
        spell: turns a listing into its dialect.
        suffix: of its programs.
    """

    name: str
    program: str
    options: tuple[str, ...]
    spell: Callable[[Lines], Lines]
    suffix: str = ".bas"

    def seconds(self, listing: Lines) -> float:
        """Seconds of the processor of one run, its start included.

        Raises:
            subprocess.SubprocessError: it failed, stopped on an error, or took too long.
        """
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / f"listing{self.suffix}"
            path.write_text("\n".join(self.spell(listing)) + "\n", encoding="ascii")
            command = [self.program, *self.options, str(path)]
            with (Path(folder) / "output").open("w+b") as output:
                taken = process_cost(command, TIMEOUT, output)
                output.seek(0)
                if THROUGH not in output.read():
                    raise subprocess.SubprocessError(f"{self.name} did not come to the end")
            return taken


def installed() -> list[Peer]:
    """Those of the peers that are on the path."""
    return [peer for peer in PEERS if shutil.which(peer.program)]


def _outside_quotes(lines: Lines, *pairs: tuple[str, str]) -> list[str]:
    """The lines with regular expressions replaced where no string stands."""
    done = []
    for line in lines:
        parts = line.split('"')
        for index in range(0, len(parts), 2):
            for pattern, new in pairs:
                parts[index] = re.sub(pattern, new, parts[index])
        done.append('"'.join(parts))
    return done


def _common(lines: Lines, end: str) -> list[str]:
    """What no other BASIC has: `[` for a power, RND(0), CLEAR of string space, `'` for REM."""
    lines = [re.sub(r"^(\d+) '", r"\1 REM ", line) for line in lines]
    lines = [re.sub(r"CLEAR \d+:?", "", line) for line in lines]
    lines = [line for line in lines if not line.strip().isdigit()]
    lines = _outside_quotes(
        lines, (r"\[", "^"), (r"\bRND\(0\)", "RND(1)"), (r"\bEND$", "GOTO 9998")
    )
    return [*lines, f'9998 PRINT "{THROUGH.decode()}"', f"9999 {end}"]


def _split(lines: Lines) -> list[str]:
    """One statement a line, but behind IF."""
    done = []
    for line in lines:
        number, text = line.split(" ", 1)
        if '"' in text or text.startswith(("REM", "IF")):
            done.append(line)
            continue
        done += [f"{int(number) + index} {each}" for index, each in enumerate(text.split(":"))]
    return done


def _without_else(lines: Lines) -> list[str]:
    """IF..THEN..ELSE as jumps, in the lines between this and the next."""
    done = []
    for line in lines:
        found = re.match(r"(\d+) IF (\w+)=(.+?) THEN (.+) ELSE (.+)$", line)
        if found is None:
            done.append(line)
            continue
        number, left, right, then, other = int(found[1]), *found.groups()[1:]
        done.append(f"{number} IF {left}<>{right} THEN {number + 3}")
        done += [f"{number + 1} {then}", f"{number + 2} GOTO {number + 5}"]
        done += [f"{number + 3} {other}", f"{number + 5} REM"]
    return done


def _gw(lines: Lines) -> Lines:
    return _common(lines, "SYSTEM")


def _bwbasic(lines: Lines) -> Lines:
    lines = _split(_common(lines, "QUIT"))
    return [re.sub(r"^(\d+ IF .+?) (?:THEN )?GOTO (\d+)$", r"\1 THEN \2", line) for line in lines]


def _bbc(lines: Lines) -> Lines:
    """BBC BASIC: its own names begin with what it has as a word."""
    names = ((r"\bLOG\(", "LN("), (r"\bPI\b", "PQ"), (r"\bRR\b", "RQ"))
    return _outside_quotes(_split(_common(lines, "QUIT")), *names)


def _yabasic(lines: Lines) -> Lines:
    names = (
        *((r"\bRND\(1\)", "ran(1)"), (r"\bSQR\(", "sqrt("), (r"\bATN\(", "atan(")),
        *((r"\bSGN\(", "sig("), (r"\bPI\b", "PQ")),
    )
    lines = _outside_quotes(_common(_without_else(_split(lines)), "exit"), *names)
    lines = [re.sub(r"(IF .+?) (?:THEN |GOTO )+(\d+)$", r"\1 GOTO \2", line) for line in lines]
    # Its THEN wants an ENDIF.
    return [re.sub(r"(IF .+?) THEN ", r"\1 ", line) for line in lines]


def _cbm(lines: Lines) -> Lines:
    return _common(_without_else(lines), "END")


def _minimal(lines: Lines) -> Lines:
    """ECMA-55: LET, names of a letter and a digit, no AND and OR, one END as the last line."""
    names = ((r"\bRND\(1\)", "RND"), (r"\bRR\b", "R9"), (r"\bLL\b", "L9"), (r"\bPI\b", "P9"))
    done = []
    for line in _outside_quotes(_common(_without_else(_split(lines)), "STOP"), *names)[:-1]:
        number, text = line.split(" ", 1)
        either = re.match(r"IF (.+) OR (.+) (?:GOTO|THEN) (\d+)", text)
        if either is not None:
            done.append(f"{number} IF {either[1]} THEN {either[3]}")
            done.append(f"{int(number) + 1} IF {either[2]} THEN {either[3]}")
            continue
        text = re.sub(r"^(IF .+?) GOTO (\d+)$", r"\1 THEN \2", text)
        text = re.sub(r"(?<![\d.])\.(\d)", r"0.\1", text)
        let = "LET " if re.match(r"[A-Z]\d?(\(.+?\))?=", text) else ""
        done.append(f"{number} {let}{text}")
    return [*done, "9999 END"]


PEERS = (
    Peer("PC-BASIC", "pcbasic", ("-n", "-q"), _gw),
    Peer("bwbasic", "bwbasic", (), _bwbasic),
    Peer("cbmbasic", "cbmbasic", (), _cbm),
    Peer("yabasic", "yabasic", (), _yabasic, ".yab"),
    Peer("brandy", "brandy", ("-quit",), _bbc),
    Peer("bas55", "bas55", (), _minimal),
)
