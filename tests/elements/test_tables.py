"""Interpolation tables against SciPy, and their way through SymPy into C expressions."""

from __future__ import annotations

import pickle
import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest
import sympy
from scipy import interpolate

import cardan as cd
from cardan.ir.forms.sympy_bridge import from_sympy
from cardan.ir.function import Block, Function, Output
from cardan.ir.graph import Graph
from cardan.ir.interpreter import evaluate
from cardan.ir.numbers import FLOATS
from table import each

X = [-1.0, 0.0, 0.5, 2.0, 3.0, 4.5]
Y = [0.3, 1.0, -0.7, 0.4, 2.0, 1.9]
SCIPY = {
    "akima": interpolate.Akima1DInterpolator(X, Y, extrapolate=True),
    "cubic": interpolate.CubicSpline(X, Y),
    "pchip": interpolate.PchipInterpolator(X, Y),
    "linear": interpolate.make_interp_spline(X, Y, k=1),
}
# outside, at the breaks and between them
AT = np.array([-1.7, *X, -0.3, 0.2, 1.234, 2.7, 4.4, 5.0])


@pytest.mark.parametrize("kind", SCIPY)
def test_values_are_those_of_scipy(kind: str) -> None:
    curve = cd.table(X, Y, kind)
    np.testing.assert_allclose(curve(AT), SCIPY[kind](AT), rtol=1e-13, atol=1e-13)
    np.testing.assert_allclose([curve(x) for x in X], Y, rtol=1e-14)
    assert curve(AT.reshape(1, -1)).shape == (1, len(AT))
    assert isinstance(curve(0.3), float)


@pytest.mark.parametrize("kind", SCIPY)
def test_integrals_are_those_of_scipy(kind: str) -> None:
    """From 0 on, inside and beyond the ends; differentiated, the curve itself."""
    curve = cd.table(X, Y, kind)
    for shift in (0.0, 20.0, -20.0):
        # 0 lies inside, before and behind the points
        breaks = tuple(x + shift for x in X)
        moved = replace(curve.data, breaks=breaks)
        integral = moved.integral()
        exact = interpolate.PPoly(np.transpose(moved.coefficients), breaks).antiderivative()
        for x in (*AT + shift, X[0] + shift - 0.7, X[-1] + shift + 0.7):
            area = float(exact(x) - exact(0.0))
            largest = abs(float(exact(0.0))) + abs(float(exact(x)))
            assert FLOATS.table(integral, 0, x) == pytest.approx(area, abs=1e-14 * largest)
            assert FLOATS.table(integral, 1, x) == pytest.approx(
                FLOATS.table(moved, 0, x), rel=1e-13, abs=1e-13
            )


def test_a_periodic_table_ends_as_it_begins() -> None:
    y = [*Y[:-1], Y[0]]
    curve, x = cd.table(X, y, "periodic"), sympy.Symbol("x")
    np.testing.assert_allclose([curve(at) for at in X], y, rtol=0, atol=1e-14)
    for order in (0, 1, 2):
        ends = [float(sympy.diff(curve(x), x, order).subs(x, at)) for at in (X[0], X[-1])]
        assert ends[0] == pytest.approx(ends[1], abs=1e-12)
    with pytest.raises(cd.ModelError, match=r"y begins with 0.3 and ends with 1.9; a periodic"):
        cd.table(X, Y, "periodic")


@each("kind", SCIPY)
@each("order", [0, 1, 2, 3, 4])
def test_expressions_and_their_derivatives(kind: str, order: int) -> None:
    """The SymPy expression, differentiated, as ir expression at many points."""
    x = sympy.Symbol("x")
    expression = sympy.diff(3 * cd.table(X, Y, kind)(x), x, order)
    graph = Graph()
    node = from_sympy(graph, expression, {x: graph.var("q", 0)})
    block = Block("q", ("x",), ("",))
    function = Function("f", graph, (block,), (Output("y", (1,), (node,)),))
    # at breaks the higher derivatives jump; SciPy evaluates those pieces alike
    inside = AT if kind != "linear" else AT[~np.isin(AT, X)]
    found = [evaluate(function, {"q": [at]})["y"][0] for at in inside]
    wanted = 3 * SCIPY[kind](inside, order) if order < 4 else np.zeros(len(inside))
    np.testing.assert_allclose(found, wanted, rtol=1e-12, atol=1e-11)


def test_numbers_that_come_in_as_sympy() -> None:
    curve = cd.table(X, Y)
    x = sympy.Symbol("x")
    assert curve(sympy.Rational(1, 4)) == pytest.approx(curve(0.25), rel=1e-15)
    assert float((curve(x) ** 2).subs(x, 0.25)) == pytest.approx(curve(0.25) ** 2, rel=1e-15)


def test_equal_tables_are_equal() -> None:
    x = sympy.Symbol("x")
    assert cd.table(X, Y)(x) - cd.table(list(X), tuple(Y))(x) == 0
    assert cd.table(X, Y)(x) != cd.table(X, Y[::-1])(x)
    assert cd.table(X, Y)(x) != cd.table(X, Y, "pchip")(x)


@pytest.mark.parametrize("kind", SCIPY)
def test_two_points_make_a_straight_line(kind: str) -> None:
    line = cd.table([1.0, 3.0], [2.0, -2.0], kind)
    np.testing.assert_allclose(line(np.array([0.0, 2.0, 4.0])), [4.0, 0.0, -4.0], atol=1e-15)


@each(
    ("x", "y", "message"),
    [
        ([0, 1, 2], [0, 1], r"x has 3 entries and y has 2.*one y for every x"),
        ([0], [1], r"1 points make no curve; give at least 2"),
        ([0, 2, 2], [0, 1, 2], r"x\[2\] = 2.0 does not exceed x\[1\] = 2.0; sort"),
        ([0, 2, 1], [0, 1, 2], r"x\[2\] = 1.0 does not exceed"),
        ([0, 1, float("inf")], [0, 1, 2], r"x\[2\] is inf; give finite"),
        ([0, 1, 2], [0, float("nan"), 2], r"y\[1\] is nan; give finite"),
        (3.0, [1, 2], r"x must be a sequence of numbers"),
        ([0, 1], ["a", "b"], r"y must be a sequence of numbers"),
    ],
)
def test_bad_data_are_named(x: object, y: object, message: str) -> None:
    with pytest.raises(cd.ModelError, match=message):
        cd.table(x, y)


def test_an_unknown_kind_is_told_the_near_one() -> None:
    with pytest.raises(cd.ModelError, match=r"'cubik' does not exist.*Did you mean 'cubic'"):
        cd.table([0, 1], [0, 1], "cubik")


def test_sympy_is_loaded_by_expressions_only() -> None:
    program = (
        "import sys, cardan as cd; print(cd.table([0, 1, 2], [0, 1, 0])(0.5)); "
        "sys.exit('sympy' in sys.modules)"
    )
    assert subprocess.run([sys.executable, "-c", program], check=False).returncode == 0


def test_a_table_as_joint_torque_in_c() -> None:
    """A body of inertia 1: the acceleration is the measured torque, outside the points too."""
    scene, curve = cd.Scene("muscle"), cd.table(X, Y)
    limb = scene.body("limb", mass=1.0, inertia=(1.0, 1.0, 1.0))
    scene.joint("knee", cd.Revolute("y"), scene.ground, limb)
    scene.force("muscle", cd.JointForce("knee", curve(scene.q("knee"))))
    model = cd.compile(scene)
    found = model.forward_dynamics(AT[:, None], np.zeros((len(AT), 1)))
    np.testing.assert_allclose(found[:, 0], curve(AT), rtol=1e-14, atol=1e-15)


def test_equations_with_tables_are_pickled() -> None:
    scene = cd.Scene("cam")
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("mass", mass=1.0))
    law = cd.table([0.0, 0.4, 1.0, 1.5], [0.0, 1.0, -1.0, 0.5])(scene.q("x"))
    scene.force("law", cd.JointForce("x", law + law.diff(scene.q("x"))))
    equations = cd.derive(scene)
    # in another process, where nobody made such a table before
    code = "import sys, pickle, cardan as cd; e = pickle.load(sys.stdin.buffer); "
    code += "print(cd.compile(e).forward_dynamics([0.3], [0.0])[0].hex())"
    told = subprocess.run(
        [sys.executable, "-c", code], input=pickle.dumps(equations), capture_output=True, check=True
    )
    expected = cd.compile(equations).forward_dynamics([0.3], [0.0])[0]
    assert told.stdout.decode().strip() == float(expected).hex()
