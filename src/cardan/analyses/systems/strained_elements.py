"""Forces of strains among those of finite elements, and the energy of the strains."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from ...arrays import Array
from ...errors import ModelError
from ...runtime.models.finite_elements.elements import Elements, State
from ...runtime.models.finite_elements.tables import Table, Tables
from .dynamic_system import Matrix


def refuse_mixed_forces(tables: Tables) -> None:
    """Raises:
    ModelError: an element does more than its strain, or does not tell the energy of that.
    """
    for group in tables.groups:
        if group.kind.strain == "mixed":
            name = group.members[0] if len(group.members) else group.kind.name
            raise ModelError(
                f"by='strain_energy': the strain energy of '{name}' cannot be told apart: it has "
                "a motor torque, carries a load as a beam element, or changes with time or inputs. "
                "Use parameters for these, other beam elements, or coordinates='relative'"
            )


def _loading(group: Table) -> bool:
    return not group.kind.strain


def load_forces(mesh: Elements, at: State) -> Array:
    """Part (nu,) of the balance that strains and constraints have no part in."""
    groups = [group for group in mesh.tables.groups if "balance" in group.kind.functions]
    forces = np.zeros(mesh.tables.nu)
    results = mesh.results("balance", replace(at, lam=None))
    for group, values in zip(groups, results, strict=True):
        if _loading(group):
            np.add.at(forces, mesh.tables.columns(group), values[:, : group.kind.nu])
    return forces


def load_tangent(mesh: Elements, at: State) -> Matrix:
    """Derivative (nu, nu) of :func:`load_forces` along increments."""
    return mesh.tangent(replace(at, lam=None), ("K",), _loading)["K"]


def strain_energy(mesh: Elements, at: State) -> float:
    """Energy of all strains [J]."""
    groups = [group for group in mesh.tables.groups if "energy" in group.kind.functions]
    results = zip(groups, mesh.results("energy", at), strict=True)
    return float(sum(values[:, 1].sum() for group, values in results if group.kind.strain))
