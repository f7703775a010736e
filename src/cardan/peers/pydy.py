"""PyDy: equations by SymPy's KanesMethod, compiled by it, called from Python as it has to be.

Source: G. Gede, D. Peterson, A. Nanjangud, J. Moore, M. Hubbard, Constrained Multibody Dynamics
with Python, ASME IDETC 2013.
"""

from __future__ import annotations

import importlib.metadata
import tempfile
import warnings
from collections.abc import Callable, Sequence
from contextlib import chdir
from time import perf_counter
from typing import TYPE_CHECKING

import numpy as np

from ..api.comparison import Scene
from ..arrays import Array
from . import coordinates
from .peer import Contender, Peer, States, installed
from .tree import central, directions

if TYPE_CHECKING:
    import sympy

# bodies that it derives and builds in seconds
MOST = 5
# a factor on gravity: its generator wants one constant at least
PULL = "pull"


def missing() -> str:
    """Reason why it cannot be called, "" where there is none."""
    return installed("pydy", "pydy") or installed("Cython", "cython")


def refusal(scene: Scene, joints: Sequence[str]) -> str:
    """It takes small trees of hinges and slides."""
    if len(scene.parents) > MOST:
        return f"more than {MOST} bodies, whose derivation takes minutes"
    for name, kind in zip(joints, scene.kinds, strict=True):
        if kind not in ("revolute", "prismatic"):
            return f"joint '{name}' is {kind}"
    return coordinates.refusal(scene, joints)


def _kane(scene: Scene) -> tuple[sympy.Expr, list[sympy.Expr], list[sympy.Expr], list[sympy.Expr]]:
    """KanesMethod of a tree, its coordinates, speeds and forces."""
    from sympy import Matrix, Symbol
    from sympy.physics import mechanics as me

    n, count = scene.numbers, len(scene.parents)
    (com, inertia), axes = central(scene), directions(scene)
    q, u, tau = (
        [me.dynamicsymbols(f"{letter}{i}") for i in range(count)] for letter in ("q", "u", "tau")
    )
    ground, origin = me.ReferenceFrame("N"), me.Point("O")
    origin.set_vel(ground, 0)
    frames, points, bodies, loads = [ground], [origin], [], []

    def vector(frame: sympy.Expr, numbers: Array) -> sympy.Expr:
        along = zip(numbers, (frame.x, frame.y, frame.z), strict=True)
        return sum((_plain(x) * e for x, e in along), me.Vector(0))

    for i, parent in enumerate(scene.parents):
        base, at = frames[parent + 1], points[parent + 1]
        side, body_frame = me.ReferenceFrame(f"J{i}"), me.ReferenceFrame(f"B{i}")
        side.orient_dcm(base, Matrix(3, 3, [_plain(x) for x in n["rotation"][i].T.flat]))
        axis = vector(side, axes[i])
        point = at.locatenew(f"P{i}", vector(base, n["position"][i]))
        point.v2pt_theory(at, ground, base)
        force = tau[i] * axis
        if scene.kinds[i] == "revolute":
            body_frame.orient_axis(side, axis, q[i])
            body_frame.set_ang_vel(side, u[i] * axis)
            loads += [(body_frame, force), (base, -force)]
        else:
            body_frame.orient_axis(side, axis, 0)
            moved = point.locatenew(f"Q{i}", q[i] * axis)
            moved.set_vel(
                ground, point.vel(ground) + u[i] * axis + base.ang_vel_in(ground) ^ (q[i] * axis)
            )
            loads += [(moved, force), (point, -force)]
            point = moved
        center = point.locatenew(f"C{i}", vector(body_frame, com[i]))
        center.v2pt_theory(point, ground, body_frame)
        i_xx, i_yy, i_zz = (_plain(inertia[i][k, k]) for k in range(3))
        i_xy, i_yz, i_zx = (_plain(inertia[i][a, b]) for a, b in ((0, 1), (1, 2), (2, 0)))
        tensor = me.inertia(body_frame, i_xx, i_yy, i_zz, i_xy, i_yz, i_zx)
        mass = _plain(n["mass"][i])
        bodies.append(me.RigidBody(f"b{i}", center, body_frame, mass, (tensor, center)))
        loads.append((center, mass * Symbol(PULL) * vector(ground, n["gravity"])))
        frames.append(body_frame)
        points.append(point)
    rates = [a.diff() - b for a, b in zip(q, u, strict=True)]
    kane = me.KanesMethod(ground, q_ind=q, u_ind=u, kd_eqs=rates)
    kane.kanes_equations(bodies, loads)
    return kane, q, u, tau


def _plain(x: float) -> sympy.Expr:
    """0 and +-1 as integers, so that SymPy drops them."""
    return int(x) if x in (0.0, 1.0, -1.0) else float(x)


def contender(scene: Scene) -> Contender:
    """PyDy on a small tree."""
    from pydy.codegen.ode_function_generators import generate_ode_function
    from sympy import Matrix, Symbol

    kane, q, u, tau = _kane(scene)
    # it builds beside the working directory and speaks of every step
    with tempfile.TemporaryDirectory() as folder, chdir(folder), warnings.catch_warnings():
        warnings.simplefilter("ignore")
        rhs = generate_ode_function(
            kane.forcing, q, u, mass_matrix=kane.mass_matrix, specifieds=tau,
            coordinate_derivatives=Matrix(u), constants=[Symbol(PULL)], generator="cython",
        )  # fmt: skip
    place, pull = [scene.q[i][0] for i in range(len(q))], np.ones(1)

    def rows(states: States) -> tuple[Array, Array]:
        x = np.ascontiguousarray(np.hstack([states.q[:, place], states.u[:, place]]))
        return x, np.ascontiguousarray(states.third[:, place])

    def start(function: str, states: States) -> Callable[[int], float]:
        x, forces = rows(states)

        def run(repeats: int) -> float:
            began = perf_counter()
            for _ in range(repeats):
                for a, b in zip(x, forces, strict=True):
                    rhs(a, 0.0, b, pull)
            return (perf_counter() - began) / repeats / len(x)

        return run

    def results(function: str, states: States) -> Array:
        x, forces = rows(states)
        accelerations = np.empty_like(states.u)
        # it returns the same array every time
        both = zip(x, forces, strict=True)
        accelerations[:, place] = [rhs(a, 0.0, b, pull)[len(q) :].copy() for a, b in both]
        return accelerations

    title = f"PyDy {importlib.metadata.version('pydy')}, called from Python"
    return Contender(title, ("forward_dynamics",), start, results)


PEER = Peer("PyDy", "pydy", missing, refusal, contender)
