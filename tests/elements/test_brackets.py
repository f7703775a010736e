"""What displacements do to the speeds of joints, against the commutator of the columns of N."""

from __future__ import annotations

import numpy as np
import pytest

from cardan.equations.kinematics.kinematics import Kinematics
from cardan.ir.derivative import forward
from cardan.ir.function import Function, Output
from cardan.ir.interpreter import evaluate
from cardan.ir.matrix import Matrix
from laws.cases import derived, states, values
from mechanisms import ZOO
from spread import some

# members with joints whose speeds are not rates of coordinates, and some without
TURNING = ("spherical", "free", "point_on", "backwards")
NAMES = [name for name in ZOO if name.startswith((*TURNING, "universal", "planar", "distance"))]


def rates(k: Kinematics, i: int, u: Matrix) -> Matrix:
    """N u of a joint."""
    return k.system.joints[i].element.rates(k.coordinates[i], u, **k.data[i])


def change(k: Kinematics, i: int, x: Matrix, u: Matrix) -> Matrix:
    """Derivative of an expression in the coordinates of a joint along its speeds."""
    seeds = dict(zip(k.coordinates[i].nodes, rates(k, i, u).nodes, strict=True))
    return Matrix(k.graph, x.rows, 1, forward(k.graph, x.nodes, seeds))


def gap(k: Kinematics, i: int) -> Matrix:
    """d/dt (N v) - d(N u) along v - N bracket(u, v) at fixed u and v = udot."""
    joint = k.system.joints[i]
    u, v = (k.block(letter, joint.u, len(joint.element.speeds)) for letter in ("u", "udot"))
    apart = change(k, i, rates(k, i, v), u) - change(k, i, rates(k, i, u), v)
    return apart - rates(k, i, joint.element.bracket(u, v))


@pytest.mark.parametrize("name", some(NAMES, 4))
def test_commutators(name: str) -> None:
    e = derived(name, "newton_euler")
    k = Kinematics(e.system)
    own = [i for i, joint in enumerate(e.system.joints) if joint.u >= 0]
    found = Matrix.vstack(*(gap(k, i) for i in own))
    outputs = (Output("gap", (found.rows,), found.nodes),)
    function = Function("gap", k.graph, tuple(e.blocks.values()), outputs, (), "")
    q, u = states(name)
    given = values(e, q=q, u=u, udot=np.random.default_rng(3).uniform(-2, 2, u.shape))
    # differences of products of a few numbers of size 1
    assert np.abs(evaluate(function, given, arithmetic="numpy")["gap"]).max() < 1e-12


@pytest.mark.parametrize("name", [name for name in NAMES if name.startswith(TURNING)][::6])
def test_angular_velocities_have_them(name: str) -> None:
    k = Kinematics(derived(name, "newton_euler").system)
    turning = 0
    for joint in k.system.joints:
        if joint.u >= 0:
            n = len(joint.element.speeds)
            u, v = k.block("u", joint.u, n), k.block("udot", joint.u, n)
            turning += not joint.element.bracket(u, v).is_zero
    assert turning
