"""The command: run the cases of a folder and say which pass."""

from __future__ import annotations

import argparse
import sys
from collections import Counter
from pathlib import Path

from tests.conformance import case, player, timing, verdict
from trs80arm.machine.z80.rom import Rom


def main(arguments: list[str] | None = None) -> int:
    """Run; 0 when every case passes, 1 when some do not, 2 when there is nothing to run."""
    parser = argparse.ArgumentParser(
        prog="python -m tests.conformance",
        description="Run cases recorded from the Level II ROM on a rig.",
    )
    parser.add_argument("folder", type=Path, help="a folder of .json files of cases")
    parser.add_argument("--group", help="only the cases of this group")
    parser.add_argument("--id", help="only the case of this id")
    parser.add_argument("--show", action="store_true", help="show what differs")
    parser.add_argument("--timing", action="store_true", help="compare the times as well")
    parser.add_argument("--rom", type=Path, help="a Level II ROM to play them on")
    options = parser.parse_args(arguments)
    passed: Counter[str] = Counter()
    total: Counter[str] = Counter()
    segments: list[timing.Segment] = []
    try:
        cases = [
            one
            for one in case.load(options.folder)
            if options.group in (None, one.group) and options.id in (None, one.id)
        ]
        rom = None if options.rom is None else Rom.read(options.rom)
    except (OSError, ValueError) as error:
        print(error, file=sys.stderr)
        return 2
    if rom is not None:
        print(rom.told)
    if not cases:
        print(f"{options.folder}: no such cases", file=sys.stderr)
        return 2
    for one in cases:
        total[one.group] += 1
        try:
            played = player.play(one, rom=rom)
        except Exception as error:  # A machine that fails is a case that fails.
            played = player.Played(end=f"{type(error).__name__}: {error}")
        differences = verdict.compare(one, played)
        passed[one.group] += not differences
        if options.show and differences:
            print(one.id)
            for difference in differences:
                print(f"  {difference}")
        for expected, here in zip(one.expected["segments"], played.times, strict=False):
            segments.append(
                timing.Segment(one.id, one.group, str(expected["in"]), expected["t"], here)
            )
    for group in total:
        print(f"{group} {passed[group]}/{total[group]}")
    if options.timing:
        for line in timing.report(segments):
            print(line)
    failed = total.total() - passed.total()
    print(f"{passed.total()} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
