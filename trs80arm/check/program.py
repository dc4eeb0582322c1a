"""One program read without running it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from trs80arm.arm.bench import Bench, BenchError
from trs80arm.arm.model import ArmModel
from trs80arm.arm.settings import ArmSettings
from trs80arm.basic.errors import Code
from trs80arm.basic.proofreader import Misprint, misprints
from trs80arm.benches import BenchFile, bench_beside
from trs80arm.check.allowed import Allowed
from trs80arm.check.expressions import Variable
from trs80arm.check.findings import Finding, Rule
from trs80arm.check.flow import Flow, Unreached, never_set
from trs80arm.check.following import Follower
from trs80arm.check.names import Clash, clashes
from trs80arm.check.statements import UNREAD, Statement, Statements
from trs80arm.check.values import Items
from trs80arm.files import FileFormatError, Kind, kind_of, parse_program, read_program
from trs80arm.machine.cassette import ProgramLine
from trs80arm.program_text import WrittenLine, spell, written_lines
from trs80arm.rig import Rig, RigSettings

_LARGEST_KIB: Final = 48
_RULES: Final = {
    Code.SN: Rule.SYNTAX,
    Code.MO: Rule.SYNTAX,
    Code.UL: Rule.MISSING_LINE,
    Code.TM: Rule.TYPE,
    Code.L3: Rule.DISK_BASIC,
}


@dataclass(frozen=True)
class _Listing:
    """The lines of a file by what they are in the machine."""

    file: Path
    lines: dict[int, bytes]
    places: dict[int, int]
    """By line number, which line of the file it is."""
    written: dict[int, str]
    """By line number, how it stands in the file, where that is a text."""

    def finding(self, rule: Rule, text: str, number: int, position: int) -> Finding:
        """What was found behind so many bytes of a line's crunched text."""
        crunched = self.lines[number]
        as_listed = f"{number} {spell(crunched)}"
        column = None
        if self.written.get(number, "").rstrip() == as_listed.rstrip():
            column = len(f"{number} {spell(crunched[:position])}") + 1
        return Finding(self.file, self.places[number], rule, text, number, column)

    def at(self, statement: Statement, rule: Rule, text: str) -> Finding:
        """What was found of a statement."""
        return self.finding(rule, text, statement.line, statement.position)


def check_program(
    path: Path, *, armbasic: bool = True, arm: ArmModel | None = None
) -> list[Finding]:
    """What is wrong in a program, as far as reading it tells for certain.

    Args:
        path: the program: text, crunched or a cassette; a bench beside it has the arm's start.
        armbasic: whether ARMBASIC is loaded; without it its words are errors.
        arm: the make of arm; None for the bench's, or the MiniMover 5.

    Returns:
        The findings in the order of the file, those left out that its remarks allow.

    Raises:
        FileFormatError: the file is damaged or no program.
        OSError: it cannot be read.
    """
    data = read_program(path)
    try:
        bench = bench_at(bench_beside(path))
        return check_bytes(path, data, armbasic=armbasic, bench=bench, arm=arm)
    except FileFormatError as error:
        raise FileFormatError(f"{path}: {error}") from None


def bench_at(path: Path | None) -> Bench | None:
    """The bench of a file, if it is one; what is wrong with it is a run's concern."""
    try:
        return None if path is None else BenchFile.read(path).bench
    except BenchError:
        return None


def check_bytes(
    path: Path,
    data: bytes,
    *,
    armbasic: bool = True,
    bench: Bench | None = None,
    arm: ArmModel | None = None,
) -> list[Finding]:
    """The same of what stands in a file.

    Args:
        path: what it is called.
        data: its content.
        armbasic: whether ARMBASIC is loaded.
        bench: on which the arm begins where the program wants it; without one that is not known.
        arm: the make of arm; None for the bench's, or the MiniMover 5.

    Raises:
        FileFormatError: it is damaged or no program.
    """
    findings: list[Finding] = []
    if data and kind_of(data) is Kind.TEXT:
        listing = _of_text(path, list(written_lines(data)), findings)
    else:
        listing = _of_lines(path, parse_program(data))
    return _of_listing(listing, findings, armbasic, bench, arm)


def check_lines(
    lines: Sequence[ProgramLine],
    *,
    armbasic: bool = True,
    bench: Bench | None = None,
    arm: ArmModel | None = None,
) -> list[Finding]:
    """The same of a program in memory.

    Args:
        lines: line numbers and crunched texts.
        armbasic: whether ARMBASIC is loaded.
        bench: on which the arm begins where the program wants it; without one that is not known.
        arm: the make of arm; None for the bench's, or the MiniMover 5.
    """
    return _of_listing(_of_lines(Path("memory"), lines), [], armbasic, bench, arm)


def _of_listing(
    listing: _Listing,
    findings: list[Finding],
    armbasic: bool,
    bench: Bench | None,
    arm: ArmModel | None,
) -> list[Finding]:
    """The findings in a listing, and those that there are already, in its order."""
    lines = sorted(listing.lines.items())
    program = Statements.read(lines)
    allowed = Allowed.by(program.all)
    for statement, name in allowed.unknown:
        text = f"there is no rule {name}"
        findings.append(listing.at(statement, Rule.UNKNOWN_RULE, text))
    findings += _of_text_alone(listing, lines, armbasic)
    if Rule.MEMORY not in {each.rule for each in findings}:
        findings += _of_ways(listing, program, findings)
        findings += _of_data(listing, program, bench, arm)
    told = [each for each in findings if not allowed.has(each.rule, each.number)]
    return sorted(told, key=lambda each: (each.place, each.column or 0))


def _of_lines(path: Path, lines: Sequence[ProgramLine]) -> _Listing:
    places = {number: place for place, (number, _) in enumerate(lines, start=1)}
    return _Listing(path, dict(lines), places, {})


def _of_text(path: Path, written: list[WrittenLine], findings: list[Finding]) -> _Listing:
    listing = _Listing(path, {}, {}, {})
    for line in written:
        if line.fault:
            text = f"this line {line.fault}"
            findings.append(Finding(path, line.place, Rule.NO_LINE, text))
            continue
        number = line.number
        before = listing.places.get(number)
        if before is not None and line.crunched:
            text = f"line {number} stands here again: that of line {before} of the file is lost"
            findings.append(Finding(path, line.place, Rule.LINE_TWICE, text, number))
        if not line.crunched:
            listing.lines.pop(number, None)
            continue
        listing.lines[number] = line.crunched
        listing.places[number] = line.place
        listing.written[number] = line.text
    return listing


def _of_text_alone(
    listing: _Listing, lines: list[ProgramLine], armbasic: bool
) -> Iterator[Finding]:
    """What every statement shows by itself, and every name."""
    rig = Rig(RigSettings(ram_kib=_LARGEST_KIB, armbasic=armbasic))
    rig.load_lines(lines)
    state = rig.basic.state
    if len(state.program) < len(lines):
        number = lines[len(state.program)][0]
        text = f"the program fits into {_LARGEST_KIB}K up to here (?OM)"
        yield listing.finding(Rule.MEMORY, text, number, 0)
        return
    for misprint in misprints(state):
        rule = Rule.STEP_VALUES if misprint.too_many else _RULES.get(misprint.code, Rule.OTHER)
        text = f"{_told(misprint, listing.lines[misprint.line])} (?{misprint.code.letters})"
        yield listing.finding(rule, text, misprint.line, misprint.position)
    for clash in clashes(lines):
        yield listing.finding(Rule.SAME_VARIABLE, _clash(clash), clash.line, clash.position)


def _of_ways(listing: _Listing, program: Statements, findings: list[Finding]) -> Iterator[Finding]:
    """What shows where the program goes; nothing while statements cannot be read."""
    if any(each.word == UNREAD and not each.arm for each in program.all):
        return
    flow = Flow(program)
    for statement in flow.nexts_without_for():
        yield listing.at(statement, Rule.NEXT_WITHOUT_FOR, "this NEXT is in no loop (?NF)")
    for statement in flow.loops_without_next():
        name = _name(statement.sets[0])
        yield listing.at(statement, Rule.FOR_WITHOUT_NEXT, f"FOR {name} comes to no NEXT")
    for statement, target in flow.calls_without_return():
        text = f"no RETURN follows in line {target} and behind it"
        yield listing.at(statement, Rule.NO_RETURN, text)
    if Rule.MISSING_LINE not in {each.rule for each in findings}:
        for row in flow.unreached():
            yield listing.at(row.first, Rule.UNREACHED, _unreached(row))
    for statement, variable in never_set(program):
        value = "the empty string" if variable.kind == "$" else "0"
        text = f"nothing sets {_name(variable)}: it is {value}"
        yield listing.finding(Rule.NEVER_SET, text, statement.line, variable.position)


def _of_data(
    listing: _Listing, program: Statements, bench: Bench | None, arm: ArmModel | None
) -> Iterator[Finding]:
    """What READ makes of the DATA, and where they send the arm."""
    model = arm or (ArmSettings() if bench is None else bench.settings).arm_model
    start = None if bench is None else bench.start or model.start
    follower = Follower(program, model, start)
    follower.follow()
    for point, why in follower.out_of_reach.items():
        items = [follower.items[each] for each in sorted(point)]
        values = ", ".join(each.text.decode("latin-1").strip() for each in items)
        text = f"{values} ({_taken(follower, point)}) is out of reach: {why}"
        yield listing.finding(Rule.OUT_OF_REACH, text, items[0].line, items[0].position)
    for place in follower.unreadable:
        item = follower.items[place]
        taken = _taken(follower, frozenset((place,)))
        text = f"{item.text.decode('latin-1')!r} is no number ({taken}) (?SN)"
        yield listing.finding(Rule.DATA_TYPE, text, item.line, item.position)
    if follower.short is not None:
        yield listing.at(follower.short, Rule.OUT_OF_DATA, "no DATA are left for this READ (?OD)")


def _taken(follower: Follower, items: Items) -> str:
    """Which variables of which READ take some items."""
    taken = [follower.read_by[each] for each in sorted(items)]
    names = ", ".join(_name(read.sets[place]) for read, place in taken)
    return f"{names} of line {taken[0][0].line}"


def _told(misprint: Misprint, crunched: bytes) -> str:
    """What is wrong, in words."""
    if misprint.too_many:
        return "@STEP takes a delay and six joints, here is one value more"
    match misprint.code:
        case Code.UL if misprint.target is None:
            return "a line number is missing"
        case Code.UL:
            return f"there is no line {misprint.target}"
        case Code.TM:
            return "a number and a string do not go together"
        case Code.MO:
            return "an operand is missing"
        case Code.L3:
            return "a word of Disk BASIC"
        case Code.SN:
            rest = spell(crunched[misprint.position :]).strip()
            return f"syntax error before {rest[:30]!r}" if rest else "syntax error at the end"
        case _:
            return "an error whatever the variables hold"


def _clash(clash: Clash) -> str:
    return (
        f"{clash.name} is the same variable as {clash.other} in line {clash.other_line}: "
        f"only {clash.name[:2]} counts"
    )


def _unreached(row: Unreached) -> str:
    if row.first is row.last:
        return "nothing leads to this statement"
    if row.first.line == row.last.line:
        return "nothing leads to these statements"
    return f"nothing leads here and up to line {row.last.line}"


def _name(variable: Variable) -> str:
    return variable.name + variable.kind + ("" if variable.subscripts is None else "()")
