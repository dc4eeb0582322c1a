"""What tests of every room use."""

from __future__ import annotations

import gc
import importlib
import os
import shutil
import sys
import tempfile
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

import pytest

from tests.in_one_message import tell_in_one_message

if sys.dont_write_bytecode:
    # The program is started by dozens of tests. Where nothing may be written beside its modules
    # they are kept compiled beside pytest's own cache, or each start would compile them all.
    compiled = Path(__file__).parents[1] / ".pytest_cache" / "compiled"
    sys.dont_write_bytecode, sys.pycache_prefix = False, str(compiled)
    os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
    os.environ["PYTHONPYCACHEPREFIX"] = str(compiled)

MEMORY = Path("/dev/shm")
"""Where some systems have a disk in memory."""
if MEMORY.is_dir() and os.access(MEMORY, os.W_OK) and shutil.disk_usage(MEMORY).free > 1 << 30:
    # Thousands of small files are made and removed, and some are to be on the disk at once.
    os.environ.setdefault("PYTEST_DEBUG_TEMPROOT", str(MEMORY))

for finder in sys.meta_path:
    # pytest writes the assertions anew of all that comes with a plug-in, and the whole program
    # comes with one. It would not be what its users run, be slower, and be compiled by each worker.
    marked = getattr(finder, "_must_rewrite", None)
    if isinstance(marked, set) and "trs80arm" in marked:
        marked.remove("trs80arm")
        marked.add("trs80arm.testing")

# Nothing of what is imported and collected goes before the end: there is no garbage to look for.
gc.disable()

NOBODY = 65534
"""A user who owns nothing."""


def pytest_configure(config: pytest.Config) -> None:
    """A busy computer is slow, not wrong: where `CI` is set hypothesis knows it."""
    tell_in_one_message(config)
    # Only now, or it would be imported before there is a place for what is compiled of it.
    from hypothesis import settings

    settings.register_profile("patient", deadline=None)
    if "CI" not in os.environ:
        settings.load_profile("patient")


@pytest.hookimpl(tryfirst=True)
def pytest_collection(session: pytest.Session) -> None:
    """In a fresh checkout each worker compiles other modules of tests, and finds the rest compiled.

    pytest writes assertions anew, which takes longer than to import a module; workers that all went
    through them in the same order would all do all of it.
    """
    worker = getattr(session.config, "workerinput", None)
    here = Path(__file__).parent
    if worker is None or [Path(where).absolute() for where in session.config.args] != [here]:
        return
    modules = sorted(
        path for path in here.rglob("test_*.py") if (path.parent / "__init__.py").is_file()
    )
    own = len(modules) * int(worker["workerid"].removeprefix("gw")) // worker["workercount"]
    for path in modules[own:] + modules[:own]:
        # What is skipped or faulty as a whole is so once more when it is collected.
        with suppress(Exception, pytest.skip.Exception):
            importlib.import_module(".".join(path.relative_to(here.parent).with_suffix("").parts))


def pytest_collection_finish() -> None:
    """What has been imported and collected stays; the garbage collector is to leave it alone.

    A test of the screen makes so many objects that it would look through all of them again and
    again, and for nothing: a fifth of such a test's time.
    """
    gc.freeze()
    gc.enable()
    gc.set_threshold(50_000, 10, 10)


@pytest.hookimpl(trylast=True)
def pytest_sessionfinish(session: pytest.Session) -> None:
    """Who has handed out tests and run none has reports of them all, and among them no garbage."""
    if session.config.getoption("dist", "no") != "no":
        gc.freeze()


@pytest.hookimpl(trylast=True)
def pytest_unconfigure() -> None:
    """When pytest has looked for garbage, it and Python's own end look once more each: for none."""
    gc.freeze()


@pytest.fixture
def unprivileged() -> Iterator[Path]:
    """A folder of a user without special rights, and that user at the keyboard.

    The superuser may write everywhere, so a test of what may not be written would prove nothing.
    """
    folder = Path(tempfile.mkdtemp(prefix="trs80arm-test-"))
    is_root = os.geteuid() == 0
    if is_root:
        os.chown(folder, NOBODY, NOBODY)
        os.seteuid(NOBODY)
    try:
        yield folder
    finally:
        if is_root:
            os.seteuid(0)
        shutil.rmtree(folder)
