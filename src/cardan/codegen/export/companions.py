"""Companions of exported C: files of ``kernels/``, and functions that runs call."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path

from ...schema import kernel_files
from ...schema.integrators import KERNELS
from ...topology.system import System
from .. import flat_scene, layout
from ..writing import generate
from . import linkage

# integrators by their files
INTEGRATORS = {name: method for name, method in KERNELS.items() if not method.elements}
# what a run calls beside rhs: of a closed system, of one with events
CLOSING = (
    *("close_position", "close_velocity", "constraint_jacobian"),
    # what a start is judged by
    *("constraints", "constraint_rates", "assembly_signs", "integrate", "difference", "qdot"),
)
EVENT_FUNCTIONS = ("events", "transition")


def needed(integrators: Iterable[str], states: bool) -> dict[str, None]:
    """Functions of the model that integrators call beside rhs.

    Args:
        integrators: By their files.
        states: Whether the model has internal states.
    """
    called = (INTEGRATORS[one].called(elements=False, states=states) for one in integrators)
    return dict.fromkeys(name for names in called for name in names)


def add_time_jumps(folder: Path, system: System) -> tuple[str, ...]:
    """Add what runs ask for the times at which a scene jumps; returns its name, if it has any."""
    jumps = flat_scene.time_jumps(system)
    if jumps is None:
        return ()
    layout.add_functions(folder, [(generate(jumps, system.name), jumps)])
    return (jumps.name,)


def kernels(
    integrators: tuple[str, ...], elements: bool, sweeps: Sequence[str] = ()
) -> dict[str, str]:
    """Texts of the files that an export needs, by name.

    Args:
        integrators: Its methods.
        elements: Whether it consists of elements in tables.
        sweeps: Files of gradients.
    """
    roots = ["export.c", *(["mesh_export.c", "mesh_events.c"] if elements else [])]
    roots += ["simulate.c", *(f"{one}.c" for one in integrators)] if integrators else []
    roots += sweeps
    return {name: kernel_files.text(name) for name in linkage.closure(roots)}
