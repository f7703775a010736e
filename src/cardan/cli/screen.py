"""The screen of ``cardan demo``."""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping
from pathlib import Path
from textwrap import shorten
from typing import TYPE_CHECKING

from ..errors import counted
from .terminal import console

if TYPE_CHECKING:
    from .tour import Tour


def display(tour: Tour, path: Path, q: Mapping[str, float]) -> None:
    """Print a tour: graph, derivation, C, speed beside error, motion, files, the Python for it."""
    out = console()
    out.print(tour.graph, soft_wrap=True)
    out.print()
    checked = (
        "checked (no compiler: Python evaluates them)" if tour.python else "compiled and checked"
    )
    out.print(
        f"derived {counted(tour.bodies, 'body', 'bodies')} in {tour.derived * 1e3:.1f} ms, "
        f"{counted(tour.operations, 'operation')}, {checked} in {tour.compiled:.2f} s",
        soft_wrap=True,
    )
    for line in tour.lines:
        out.print(f"    {line}", style="cyan", soft_wrap=True)
    peer = (
        f"Pinocchio agrees to {tour.peer:.1e}"
        if tour.peer is not None
        else "Pinocchio is not installed"
    )
    out.print(
        f"{tour.call * 1e9:.0f} ns per call, {tour.state * 1e9:.0f} ns per state of a batch, "
        f"worst error {tour.error:.1e} against 40 digits, {peer}",
        soft_wrap=True,
    )
    out.print(
        f"10 s simulated in {tour.simulated * 1e3:.1f} ms ({tour.steps} steps), "
        f"energy residual {tour.energy_residual:.1e} of the largest kinetic energy",
        soft_wrap=True,
    )
    for note in tour.notes[:3]:
        out.print(f"note: {shorten(note, 100, placeholder=' ...')}", style="dim", soft_wrap=True)
    for file in tour.files:
        out.print(f"wrote {short_path(file)}", soft_wrap=True)
    out.print()
    for line in program(path, q):
        out.print(f"    {line}", style="green", soft_wrap=True)
    out.print()
    python = short_path(Path(sys.executable))
    out.print(f"see it move:  {python} -m webbrowser {short_path(tour.page)}", soft_wrap=True)


def short_path(path: Path) -> str:
    """A path as short as it can be said from here."""
    relative = os.path.relpath(path)
    return str(path) if relative.startswith("..") else relative


def program(path: Path, q: Mapping[str, float]) -> tuple[str, ...]:
    """The five lines of Python that did it."""
    return (
        "import cardan as cd",
        f'scene = cd.load("{short_path(path)}", limits="stop", friction=True)',
        "model = cd.compile(scene)",
        f"motion = model.simulate(10.0, q={dict(q)}, rtol=1e-10, atol=1e-12)",
        'motion.animate("motion.html")',
    )
