"""The programs that come with trs80arm, the article's tables and their benches, and their names.

In a checkout they stand beside the package, in an installed one in its environment's shared folder.
They open by name from anywhere, unless there is a file of that name where one is.
"""

from __future__ import annotations

import re
from pathlib import Path

from trs80arm.paths import is_file

PROGRAM_SUFFIX = ".bas"
BENCH_SUFFIX = ".toml"
_LISTED = re.compile(r"\| `([\w-]+)\.bas` \| (.*) \|")
"""A line of the list in `programs/README.md`."""


def programs_folder(module: Path = Path(__file__)) -> Path | None:
    """The folder with `table4.bas` and the others; None where they were not installed.

    Args:
        module: this module's file, by which the package is found: the shared folder is some folders
            above it, of an environment, of the user or of a folder that was installed into.
    """
    above = module.parents[1:]
    places = [above[0] / "programs", *(folder / "share/trs80arm/programs" for folder in above[:4])]
    return next((place for place in places if (place / "table4.bas").is_file()), None)


def along(name: str) -> Path:
    """A file that comes along, by its whole name; no file where they were not installed."""
    return (programs_folder() or Path("programs")) / name


def comes_along(path: Path) -> bool:
    """Whether a file is one of those that come along."""
    folder = programs_folder()
    return folder is not None and path.resolve().parent == folder.resolve()


def named(path: Path, suffix: str) -> Path:
    """The file that somebody means by a name.

    Args:
        path: what was typed.
        suffix: what the name of such a file ends with, where it was left out.

    Returns:
        The file of that name; else of that name with the suffix; else of the program or bench of
        that name that comes along. The path as it was typed if there is none of these.
    """
    names = [path, *([path.with_name(path.name + suffix)] if path.name else [])]
    places = list(names)
    folder = programs_folder()
    if folder is not None and path.name == str(path):
        places += [folder / name for name in names]
    return next((place for place in places if is_file(place)), path)


def described() -> list[tuple[str, str]]:
    """The names of the programs that come along, and what each is."""
    folder = programs_folder()
    if folder is None:
        return []
    text = (folder / "README.md").read_text(encoding="utf-8")
    return [(name, words.replace("`", "")) for name, words in _LISTED.findall(text)]
