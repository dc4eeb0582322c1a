"""The kinds of values that the command line takes: numbers, files, programs, benches."""

from __future__ import annotations

import math
import os
from pathlib import Path
from typing import Any

import click

A_PATH = click.Path(path_type=Path)


class WholeNumber(click.IntRange):
    """A whole number in a range."""

    name = "whole number"

    def get_metavar(self, param: click.Parameter, ctx: click.Context) -> str:
        """What stands for it in the help."""
        return "NUMBER"


class Finite(click.FloatRange):
    """A number in a range; neither infinite nor none at all."""

    name = "number"

    def convert(
        self, value: Any, param: click.Parameter | None, ctx: click.Context | None
    ) -> float:
        """The number that a text says."""
        number = float(super().convert(value, param, ctx))
        if not math.isfinite(number):
            self.fail(f"{value} is not a finite number", param, ctx)
        return number


class Folder(click.Path):
    """A folder that there is."""

    def __init__(self) -> None:
        super().__init__(exists=True, file_okay=False, path_type=Path)

    def convert(
        self,
        value: str | os.PathLike[str],
        param: click.Parameter | None,
        ctx: click.Context | None,
    ) -> str | bytes | os.PathLike[str]:
        """The folder; what is neither file nor folder, as a device, is refused too."""
        from trs80arm.paths import is_folder

        path = super().convert(value, param, ctx)
        if not is_folder(Path(value)):
            self.fail(f"{value} is no folder", param, ctx)
        return path


class Named(click.Path):
    """A program or a bench: a file, or the name of one that comes along."""

    def __init__(self, suffix: str) -> None:
        super().__init__(path_type=Path)
        self._suffix = suffix

    def convert(
        self,
        value: str | os.PathLike[str],
        param: click.Parameter | None,
        ctx: click.Context | None,
    ) -> str | bytes | os.PathLike[str]:
        """The file that is meant."""
        from trs80arm.bundled import named

        return named(Path(value), self._suffix)


A_PROGRAM = Named(".bas")
A_BENCH = Named(".toml")
