"""Hash of everything that the C of a system depends on: the key of the cache."""

from __future__ import annotations

import hashlib
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from ..equations.finite_elements.record import FiniteElementRecord
from ..equations.record import EquationRecord
from ..errors import lasting
from ..ir.routine import Routine
from ..version import VERSION, source_state
from .finite_elements import model_folder

if TYPE_CHECKING:
    from ..topology.system import System


def fingerprint(equations: EquationRecord | FiniteElementRecord, loops: bool | None = None) -> str:
    """Hash of everything the C of a system depends on; ``loops`` as in :func:`compile`."""
    system: System = equations.system
    system = replace(system, notes=tuple(lasting(system.notes)))
    digest = hashlib.sha256()
    for part in (
        VERSION,
        source_state(),
        *_choices(equations),
        loops,
        system.graph.nodes,
        system.graph.tables,
        system,
        system.frames,
        system.parameters,
        system.atoms,
    ):
        digest.update(repr(part).encode())
    return digest.hexdigest()


def _choices(equations: EquationRecord | FiniteElementRecord) -> tuple[Any, ...]:
    """Options of the derivation, besides the system."""
    if isinstance(equations, FiniteElementRecord):
        planes = [kind.plane for kind in equations.places.kinds]
        every = (f for kind in equations.kinds for f in kind.functions.values())
        # what these compute does not show in the system
        routines = [(f.name, f.call, f.sizes, f.constants) for f in every if isinstance(f, Routine)]
        contents = model_folder.files(equations).values()
        hashes = [hashlib.sha256(content).hexdigest() for content in contents]
        return "absolute", planes, hashes, routines
    return equations.method, equations.rewrites, equations.chosen, equations.treatment
