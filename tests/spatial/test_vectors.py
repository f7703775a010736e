"""Vectors and dyadics in frames: algebra, expressing, derivatives, SymPy's counterparts."""

from __future__ import annotations

import numpy as np
import pytest
import sympy
from sympy.physics.vector import ReferenceFrame, dynamicsymbols
from sympy.physics.vector import express as sympy_express

from cardan.errors import ModelError
from cardan.ir.graph import Graph
from cardan.ir.matrix import Matrix
from cardan.spatial.axis import rotation_about, unit
from cardan.spatial.dyadics import Dyadic, dyad
from cardan.spatial.frames import Frame
from cardan.spatial.rotations import parametrization
from cardan.spatial.sympy_vectors import (
    dyadic_from_sympy,
    dyadic_to_sympy,
    vector_from_sympy,
    vector_to_sympy,
)
from cardan.spatial.vectors import Vector
from spatial.numbers_of import block, close, difference, moving, numbers

Q, QDOT, AXIS = [0.3, -1.1, 0.8, 0.45], [0.9, 0.4, -1.6, 2.1], [1.0, 2.0, -2.0]


class Scene:
    """A root, two frames one after the other, and a third beside them."""

    def __init__(self) -> None:
        self.graph = Graph()
        self.q = block(self.graph, "q", 4)
        rate = block(self.graph, "qdot", 4)
        self.rates = dict(zip(self.q.nodes, rate.nodes, strict=True))
        y, z = (Matrix.identity(self.graph, 3).column(k) for k in (1, 2))
        # an input, so that it has length 1 in all digits
        tilted = unit(block(self.graph, "axis", 3))
        self.root = Frame(self.graph, "root")
        self.a = self.root.turned("a", rotation_about(y, self.q[0]), y * rate[0])
        self.b = self.a.turned("b", rotation_about(tilted, self.q[1]))
        self.c = self.root.turned("c", rotation_about(z, self.q[2]))

    def vector(self, frame: Frame) -> Vector:
        return Vector.of(frame, [self.q[3], 2.0, self.q[3] * self.q[0]])

    def value(self, x: object, kind: str = "float", **values: object) -> object:
        return numbers(x, kind, **({"q": Q, "qdot": QDOT, "axis": AXIS} | values))


@pytest.fixture
def scene() -> Scene:
    return Scene()


def test_algebra_is_that_of_numpy(scene: Scene) -> None:
    v, w = scene.vector(scene.a), Vector.of(scene.a, [1.0, scene.q[1], -2.0])
    x, y = scene.value(v.components), scene.value(w.components)
    value = scene.value
    np.testing.assert_allclose(
        value((2 * v - w / 4 + (-v) * scene.q[0]).components), 2 * x - y / 4 - x * Q[0], rtol=1e-15
    )
    np.testing.assert_allclose(value(v.cross(w).components), np.cross(x, y), rtol=1e-14)
    assert value(v.dot(w)) == pytest.approx(x @ y, rel=1e-14)
    assert value(v.length) == pytest.approx(np.linalg.norm(x), rel=1e-15)
    assert value(v[2]) == x[2]
    D, E = dyad(v, w), Dyadic.identity(scene.a) * 3.0 - dyad(w, v) / 2
    d, e = np.outer(x, y), 3 * np.eye(3) - np.outer(y, x) / 2
    np.testing.assert_allclose(value((D + E).components), d + e, rtol=1e-14)
    np.testing.assert_allclose(value((D @ E).components), d @ e, rtol=1e-13)
    np.testing.assert_allclose(value((-D @ v).components), -d @ x, rtol=1e-14)
    np.testing.assert_allclose(value((E.T @ v).components), x @ e, rtol=1e-14)
    assert value(E.trace) == pytest.approx(np.trace(e), rel=1e-14)


def test_expressing_keeps_what_does_not_depend_on_axes(scene: Scene) -> None:
    v, w = scene.vector(scene.b), Vector.of(scene.b, [1.0, -1.0, 0.5])
    D = dyad(v, w)
    there, map_there = v.express(scene.c), D.express(scene.c)
    value = scene.value
    assert value(there.length) == pytest.approx(value(v.length), rel=1e-15)
    assert value(map_there.trace) == pytest.approx(value(D.trace), rel=1e-14)
    wanted = value((D @ v).express(scene.c).components)
    np.testing.assert_allclose(value((map_there @ there).components), wanted, rtol=1e-13)
    back = there.express(scene.b)
    np.testing.assert_allclose(value(back.components), value(v.components), rtol=1e-14)
    assert v.express(scene.b) is v


def test_rotations_follow_the_tree(scene: Scene) -> None:
    R = scene.value(scene.b.rotation_in(scene.c))
    one, two, three = (
        scene.value(rotation) for rotation in (scene.a.rotation, scene.b.rotation, scene.c.rotation)
    )
    np.testing.assert_allclose(R, three.T @ one @ two, atol=1e-15)
    np.testing.assert_allclose(scene.value(scene.c.rotation_in(scene.b)), R.T, atol=1e-15)
    # the common part of the two paths is not walked
    assert scene.b.rotation_in(scene.a).nodes == scene.b.rotation.nodes


@pytest.mark.parametrize("own", ["root", "a", "b", "c"])
@pytest.mark.parametrize("observer", ["root", "a", "b", "c"])
def test_derivative_is_that_of_the_components_seen_there(
    scene: Scene, own: str, observer: str
) -> None:
    """Also with angular velocities that were given, and that were derived."""
    v = scene.vector(getattr(scene, own))
    D = dyad(v, Vector.of(v.frame, [1.0, 2.0, 3.0]))
    seen, path = getattr(scene, observer), moving(Q, QDOT)
    for quantity in (v, D):
        there = quantity.express(seen).components
        wanted = difference(lambda t, x=there: scene.value(x, "mp", q=path(t)))
        found = quantity.derivative(seen, scene.rates).express(seen).components
        assert close(scene.value(found, "mp"), wanted)


def test_angular_velocity_of_a_parametrization() -> None:
    """Derived from the matrix, it is what the parametrization says."""
    graph = Graph()
    q, w = block(graph, "q", 3), block(graph, "w", 3)
    angles = parametrization("ZYX")
    rates = dict(zip(q.nodes, angles.rates(q, w).nodes, strict=True))
    root = Frame(graph, "root")
    turned = root.turned("turned", angles.matrix(q))
    omega = [0.3, -0.2, 0.9]
    found = turned.angular_velocity_in(root, rates)
    assert close(numbers(found, "mp", q=[0.1, 0.7, -2.0], w=omega), omega, 60)
    back = root.angular_velocity_in(turned, rates)
    wanted = numbers(-(angles.matrix(q) @ w), "mp", q=[0.1, 0.7, -2.0], w=omega)
    assert close(numbers(back, "mp", q=[0.1, 0.7, -2.0], w=omega), wanted, 60)


# errors


def test_mixed_frames_name_both(scene: Scene) -> None:
    v, w = scene.vector(scene.a), scene.vector(scene.b)
    D = dyad(v, v)
    mixed = [
        lambda: v + w,
        lambda: v - w,
        lambda: v.dot(w),
        lambda: v.cross(w),
        lambda: dyad(v, w),
        lambda: D @ w,
        lambda: D + dyad(w, w),
    ]
    for operation in mixed:
        with pytest.raises(ModelError, match=r"'a' and 'b' cannot be combined.*express"):
            operation()


def test_frames_without_connection(scene: Scene) -> None:
    other = Frame(scene.graph, "elsewhere")
    with pytest.raises(ModelError, match="'a' and 'elsewhere' are not connected"):
        scene.vector(scene.a).express(other)


def test_bad_shapes_and_names(scene: Scene) -> None:
    with pytest.raises(ModelError, match="frame 'root': a frame it descends from has this name"):
        scene.a.turned("root", Matrix.identity(scene.graph, 3))
    with pytest.raises(ModelError, match="frame 'd': the rotation is 4 x 1; give a 3 x 3"):
        scene.a.turned("d", scene.q)
    with pytest.raises(ModelError, match="frame 'd': the angular velocity must have 3"):
        scene.a.turned("d", Matrix.identity(scene.graph, 3), scene.q)
    with pytest.raises(ModelError, match="vector in frame 'a': components are 4 x 1"):
        Vector(scene.a, scene.q)
    with pytest.raises(ModelError, match="dyadic in frame 'a': components are 4 x 1"):
        Dyadic(scene.a, scene.q)


# SymPy


def test_to_sympy_and_back(scene: Scene) -> None:
    N = ReferenceFrame("N")
    symbols = sympy.symbols("q0:4")
    names = {("q", k): s for k, s in enumerate(symbols)}
    back = dict(zip(symbols, scene.q.nodes, strict=True))
    v = scene.vector(scene.a)
    written = vector_to_sympy(v, N, names)
    assert written == symbols[3] * N.x + 2.0 * N.y + symbols[0] * symbols[3] * N.z
    again = vector_from_sympy(written, scene.a, {N: scene.a}, back)
    assert again.components.nodes == v.components.nodes
    D = dyad(v, v)
    round_trip = dyadic_from_sympy(dyadic_to_sympy(D, N, names), scene.a, {N: scene.a}, back)
    found, wanted = scene.value(round_trip.components), scene.value(D.components)
    np.testing.assert_allclose(found, wanted, rtol=1e-15)


def test_derivatives_and_axes_are_those_of_sympy(scene: Scene) -> None:
    """A vector with parts in two frames of SymPy, differentiated there and here."""
    time = dynamicsymbols._t
    q = dynamicsymbols("q0:4")
    N = ReferenceFrame("N")
    A = N.orientnew("A", "Axis", (q[0], N.y))
    B = A.orientnew("B", "Axis", (q[1], A.x + 2 * A.y - 2 * A.z))
    v = q[3] * B.x + sympy.sin(q[0]) * A.z
    symbols = dict(zip(q, scene.q.nodes, strict=True))
    axes = {N: scene.root, A: scene.a, B: scene.b}
    mine = vector_from_sympy(v, scene.root, axes, symbols)
    found = scene.value(mine.derivative(scene.a, scene.rates).components)
    numeric = {x.diff(time): r for x, r in zip(q, QDOT, strict=True)}
    values = dict(zip(q, Q, strict=True))
    theirs = sympy_express(v.dt(A), N).to_matrix(N).subs(numeric).subs(values)
    np.testing.assert_allclose(found, np.array(theirs.evalf(), float).ravel(), atol=1e-14)


def test_unknown_frames_of_sympy_are_named(scene: Scene) -> None:
    N, M = ReferenceFrame("N"), ReferenceFrame("M")
    with pytest.raises(ModelError, match=r"SymPy frame 'M' stands for no frame.*Known: N"):
        vector_from_sympy(M.x, scene.a, {N: scene.a}, {})
