"""Runs of CalculiX: matrices that it stores, frequencies that it prints."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import numpy as np
from scipy.sparse import coo_matrix

NAMES = {"tet4": "C3D4", "tet10": "C3D10", "hex8": "C3D8", "hex20": "C3D20"}
PER_LINE = 10


def deck(mesh, E, nu, rho, fixed=(), storage=True, modes=12) -> str:
    """An input deck for the frequencies of a mesh; lengths in meters."""
    lines = ["*NODE"]
    # fields of at most 20 characters
    lines += [f"{k}, " + ", ".join(f"{x:.12e}" for x in p) for k, p in enumerate(mesh.points, 1)]
    label = 0
    for kind, cells in mesh.cells.items():
        lines.append(f"*ELEMENT, TYPE={NAMES[kind]}, ELSET=EALL")
        for nodes in cells:
            label += 1
            entries = [str(x) for x in (label, *(nodes + 1))]
            rows = [entries[k : k + PER_LINE] for k in range(0, len(entries), PER_LINE)]
            lines += [", ".join(row) + "," * (row is not rows[-1]) for row in rows]
    lines += ["*MATERIAL, NAME=M", "*ELASTIC", f"{E!r}, {nu!r}", "*DENSITY", f"{rho!r}"]
    lines += ["*SOLID SECTION, ELSET=EALL, MATERIAL=M"]
    if len(fixed):
        lines += ["*BOUNDARY", *(f"{node + 1}, 1, 3" for node in fixed)]
    lines.append("*STEP")
    lines += ["*FREQUENCY, SOLVER=MATRIXSTORAGE"] if storage else ["*FREQUENCY", f"{modes}"]
    return "\n".join([*lines, "*END STEP", ""])


def run(text: str, folder: Path) -> Path:
    """Run a deck; the path of its results, without ending."""
    (folder / "job.inp").write_text(text)
    subprocess.run(["ccx", "job"], cwd=folder, check=True, capture_output=True)
    return folder / "job"


def stored(job: Path, dofs: int):
    """Mass and stiffness, at the degrees of freedom of the mesh; those left out are empty."""
    names = [line.split()[0] for line in job.with_suffix(".dof").read_text().splitlines()]
    place = np.array([3 * (int(n.split(".")[0]) - 1) + int(n.split(".")[1][0]) - 1 for n in names])
    result = []
    for ending in (".mas", ".sti"):
        row, column, value = np.loadtxt(job.with_suffix(ending), unpack=True)
        i, j = place[row.astype(int) - 1], place[column.astype(int) - 1]
        upper = coo_matrix((value, (i, j)), (dofs, dofs)).tocsr()
        mirrored = upper + upper.T
        mirrored.setdiag(upper.diagonal())
        result.append(mirrored)
    return (*result, np.sort(place))


def printed(job: Path) -> np.ndarray:
    """Squares of the circular frequencies in the table of results."""
    table = job.with_suffix(".dat").read_text().split("P A R T I C I P A T I O N")[0]
    rows = re.findall(r"^\s+\d+\s+(\S+E\S+)\s+\S+E\S+\s+\S+E", table, re.M)
    return np.array([float(x) for x in rows])
