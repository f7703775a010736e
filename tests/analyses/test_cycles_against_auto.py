"""The forced response of Duffing's equation against AUTO-07p, by orthogonal collocation.

Source: E. J. Doedel et al., AUTO-07P: Continuation and Bifurcation Software for Ordinary
Differential Equations (2012). Where it is not installed this is left out.
"""

from __future__ import annotations

import os
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sp

from cardan.arrays import Array
from cycle_scenes import duffing

AUTO = shutil.which("auto-07p") or shutil.which("auto")
pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(
        AUTO is None or shutil.which("gfortran") is None, reason="AUTO-07p is not installed"
    ),
]
# the force is the first entry of an oscillator that is cos(w t), sin(w t)
EQUATIONS = """
subroutine func(ndim, u, icp, par, ijac, f, dfdu, dfdp)
  implicit none
  integer, intent(in) :: ndim, icp(*), ijac
  double precision, intent(in) :: u(ndim), par(*)
  double precision, intent(out) :: f(ndim)
  double precision, intent(inout) :: dfdu(ndim,ndim), dfdp(ndim,*)
  double precision :: r
  r = u(3)**2 + u(4)**2
  f(1) = u(2)
  f(2) = -0.1d0*u(2) - u(1) - u(1)**3 + 0.5d0*u(3)
  f(3) = u(3) - par(1)*u(4) - u(3)*r
  f(4) = par(1)*u(3) + u(4) - u(4)*r
end subroutine
subroutine stpnt(ndim, u, par, t)
  implicit none
  integer, intent(in) :: ndim
  double precision, intent(inout) :: u(ndim), par(*)
  double precision, intent(in) :: t
end subroutine
subroutine bcnd
end subroutine
subroutine icnd
end subroutine
subroutine fopt
end subroutine
subroutine pvls
end subroutine
"""
CONSTANTS = """
dat='start.dat'
NDIM=4, IPS=2, IRS=0, ILP=1
ICP=[1, 11]
NTST=80, NCOL=7, IAD=3, ISP=2, ISW=1, IPLT=0, NBC=0, NINT=0
NMX=400, NPR=1000, MXBF=0, IID=2, ITMX=8, ITNW=7, NWTN=3, JAC=0
EPSL=1e-11, EPSU=1e-11, EPSS=1e-7
DS=0.02, DSMIN=1e-5, DSMAX=0.2, IADS=1
THL={11: 0.0}, THU={}
UZR={1: [1.0, 1.5, 2.0, 2.9]}
UZSTOP={1: [0.5, 3.0]}
"""
FOLD, MARKED = 5, -4  # types of AUTO's solutions


@dataclass(frozen=True)
class Solution:
    """A periodic solution as AUTO writes it.

    Attributes:
        kind: Its type.
        rows: Parts of the period, and states (n, 5).
        omega, period: Its parameters.
    """

    kind: int
    rows: Array
    omega: float
    period: float


def solutions(path: Path) -> list[Solution]:
    """Solutions in a file: a line of counts, rows, directions and parameters."""
    lines, found, at = path.read_text().splitlines(), list[Solution](), 0
    while at < len(lines):
        counts = [int(word) for word in lines[at].split()]
        kind, rows, columns, follow, parameters = (counts[k] for k in (2, 6, 7, 8, 11))
        body = lines[at + 1 : at + 1 + follow]
        words = " ".join(body).split()
        numbers = [float(word) for word in words]
        table = np.array(numbers[: rows * columns]).reshape(rows, columns)
        values = numbers[-parameters:]
        found.append(Solution(kind, table, values[0], values[10]))
        at += 1 + follow
    return found


@pytest.fixture(scope="module")
def start() -> Any:
    model, omega = duffing()
    return model.cycle(
        {"x": 0.6}, period=2 * sp.pi / omega, parameters={"omega": 0.7}, settle=20, check=True
    )


@pytest.fixture(scope="module")
def by_auto(tmp_path_factory: pytest.TempPathFactory, start: Any) -> list[Solution]:
    folder = tmp_path_factory.mktemp("auto")
    times = np.linspace(0, start.period, 401)
    states = start.motion.at(times)
    table = np.c_[times, states, np.cos(0.7 * times), np.sin(0.7 * times)]
    np.savetxt(folder / "start.dat", table)
    (folder / "duffing.f90").write_text(EQUATIONS)
    (folder / "c.duffing").write_text(CONSTANTS + f"PAR={{1: 0.7, 11: {start.period!r}}}\n")
    (folder / "run.auto").write_text("save(run(e='duffing', c='duffing'), 'duffing')\n")
    subprocess.run(
        [str(AUTO), "run.auto"],
        cwd=folder,
        env={**os.environ, "OMP_NUM_THREADS": "1"},
        check=True,
        capture_output=True,
        timeout=300,
    )
    return solutions(folder / "s.duffing")


def states_at(cycle: Any, solution: Solution) -> Array:
    """States of a cycle where the force of a solution has its phases."""
    angles = np.arctan2(solution.rows[:, 4], solution.rows[:, 3])
    return np.array(cycle.motion.at(np.mod(angles, 2 * np.pi) / solution.omega))


def test_forced_response(start: Any, by_auto: list[Solution]) -> None:
    """States to 1e-8, through both folds; the frequencies at the folds to 1e-8."""
    path = start.model.continuation(omega=(0.7, 3.0), of="cycles", start=start)
    folds = [point.values["omega"] for point in path.points if point.kind == "fold"]
    theirs = [solution.omega for solution in by_auto if solution.kind == FOLD]
    assert len(theirs) == 2
    np.testing.assert_allclose(folds, theirs, atol=1e-8)
    marked = [solution for solution in by_auto if solution.kind == MARKED]
    unstable = 0
    for solution in marked:
        # of the rows of the path next to this frequency the one with the nearest amplitude
        amplitude = solution.rows[:, 1].max()
        off = np.hypot(path["omega"] - solution.omega, path["x.max"] - amplitude)
        row = path[int(off.argmin())]
        cycle = start.model.cycle(
            row.state,
            period=2 * np.pi / solution.omega,
            parameters={"omega": solution.omega},
            check=True,
        )
        unstable += not cycle.stable
        assert solution.period == pytest.approx(cycle.period, abs=1e-8)
        np.testing.assert_allclose(states_at(cycle, solution), solution.rows[:, 1:3], atol=1e-8)
    # three cycles at 1.5 and 2.0, one of which no run finds
    omegas = sorted(round(solution.omega, 6) for solution in marked)
    assert omegas == [1.0, 1.5, 1.5, 1.5, 2.0, 2.0, 2.0, 2.9, 3.0]
    assert unstable == 2
