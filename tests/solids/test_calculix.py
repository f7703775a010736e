"""Matrices and frequencies of CalculiX: committed results, and runs where it is installed."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import numpy as np
import pytest
from scipy.linalg import eigh

import cardan as cd
from cardan import solids as fem
from solids import calculix
from solids.meshes import KINDS, bent, block

FILES = Path(__file__).with_name("files")
E, NU, RHO = 70e9, 0.3, 2700.0
MODES = 10


def eigenvalues(K, M):
    return eigh(K.toarray(), M.toarray(), eigvals_only=True, subset_by_index=(0, MODES - 1))


def solid(mesh) -> fem.Solid:
    return fem.solid(mesh, cd.material(E=E, nu=NU, rho=RHO))


def lug():
    """The lug, its degrees of freedom that are not fixed at the root."""
    mesh = fem.read(FILES / "lug.inp", scale=1e-3)
    fixed = np.zeros((len(mesh.points), 3), bool)
    fixed[mesh.nodes("root")] = True
    return mesh, np.flatnonzero(~fixed.ravel())


def test_frequencies_of_the_lug() -> None:
    """1e-8 of the eigenvalues of stored matrices, and the digits that are printed."""
    results = json.loads((FILES / "lug_calculix.json").read_text())
    mesh, free = lug()
    body = solid(mesh)
    K, M = (A[free][:, free] for A in (body.stiffness(), body.mass(rule="stiffness")))
    ours = eigenvalues(K, M)
    assert ours == pytest.approx(results["eigenvalues"], rel=1e-8)
    assert ours == pytest.approx(results["printed"], rel=5e-7)
    # more points of quadrature change the mass at the order of the error of the mesh
    finer = eigenvalues(K, body.mass()[free][:, free])
    assert finer == pytest.approx(ours, rel=2e-3)
    assert abs(finer[0] / ours[0] - 1) < 1e-5


@pytest.mark.slow
@pytest.mark.external
@pytest.mark.skipif(shutil.which("ccx") is None, reason="CalculiX is not installed")
@pytest.mark.parametrize("kind", KINDS)
def test_matrices_of_curved_cells(kind: str, tmp_path: Path) -> None:
    """Entry by entry, to the digits of its files."""
    mesh = bent(block(kind, size=(0.2, 0.15, 0.1)), lambda x: x + 0.01 * np.sin(20 * x[[1, 2, 0]]))
    job = calculix.run(calculix.deck(mesh, E, NU, RHO), tmp_path)
    M, K, place = calculix.stored(job, mesh.dofs)
    assert len(place) == mesh.dofs
    body = solid(mesh)
    assert abs(body.stiffness() - K).max() < 1e-11 * abs(K).max()
    assert abs(body.mass(rule="stiffness") - M).max() < 1e-11 * abs(M).max()


@pytest.mark.slow
@pytest.mark.external
@pytest.mark.skipif(shutil.which("ccx") is None, reason="CalculiX is not installed")
def test_the_committed_results_are_those_of_a_run(tmp_path: Path) -> None:
    results = json.loads((FILES / "lug_calculix.json").read_text())
    mesh, free = lug()
    deck = [mesh, E, NU, RHO, mesh.nodes("root")]
    M, K, place = calculix.stored(calculix.run(calculix.deck(*deck), tmp_path), mesh.dofs)
    assert place.tolist() == free.tolist()
    run = eigenvalues(K[free][:, free], M[free][:, free])
    assert run == pytest.approx(results["eigenvalues"], rel=1e-8)
    job = calculix.run(calculix.deck(*deck, storage=False), tmp_path)
    assert calculix.printed(job)[:MODES] == pytest.approx(results["printed"], rel=1e-12)
