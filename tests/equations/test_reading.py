"""Equations for people: long ones, their names, their counts, SymPy's own records."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from functools import cache
from itertools import product
from typing import Any

import numpy as np
import pytest
import sympy as sp
from sympy.physics import mechanics as me

import cardan as cd
from cardan.equations.reading.formula import latex
from cardan.equations.reading.notation import notation
from cardan.ir.forms.fourier import PRODUCTS, TERMS, Budget
from cardan.ir.forms.readable import STEPS, TooLong, readable
from cardan.ir.forms.sympy_bridge import to_sympy
from equations.classical import CLASSICAL
from mechanisms import ZOO
from spread import some
from table import each


def chain(n: int, planar: bool = True) -> cd.Scene:
    scene = cd.Scene("chain", gravity=(0, 0, -9.81))
    m, l = scene.parameter("m", 1.0, unit="kg"), scene.parameter("l", 0.5, unit="m")
    place = scene.ground
    for k in range(n):
        inertia = cd.inertia.rod(m, l, axis="z")
        link = scene.body(f"link{k}", mass=m, com=(0, 0, -l / 2), inertia=inertia)
        axis = "y" if planar or k % 2 else "x"
        scene.joint(f"joint{k}", cd.Revolute(axis), place, link)
        place = link.at(0, 0, -l)
    return scene


@cache
def spatial() -> Any:
    """Equations that are too long to be read."""
    return cd.derive(chain(6, planar=False))


class Counting(Budget):
    """Writes down the largest step and the sum of all."""

    largest = 0
    paid = 0

    def spend(self, steps: int) -> bool:
        allowed = super().spend(steps)
        self.largest = max(self.largest, steps if allowed else 0)
        self.paid += steps if allowed else 0
        return allowed


@pytest.mark.parametrize(
    ("planar", "name", "steps"),
    some(product((True, False), ("mass_matrix", "bias"), (STEPS, 20_000)), 5),
)
def test_budget_on_twelve_bodies(planar: bool, name: str, steps: int) -> None:
    function = cd.derive(chain(12, planar)).function(name)
    budget = Counting(steps)
    # it returns or says that the result is too long
    with suppress(TooLong):
        assert readable(function, budget=budget).shape[0] == 12
    # between two looks at the budget lies one bounded piece of work
    assert budget.paid <= steps
    assert budget.largest <= max(PRODUCTS, TERMS**2)


def test_mass_matrix_of_twelve_bodies_can_be_read() -> None:
    found = cd.derive(chain(12)).mass_matrix
    m, l = sp.symbols("m l")
    assert found[11, 11] == m * l**2 / 3
    assert (
        sp.expand(found[11, 10] - m * l**2 * (sp.cos(sp.Symbol("joint11")) / 2 + sp.Rational(1, 3)))
        == 0
    )


def test_too_long_names_the_next_call() -> None:
    equations = spatial()
    with pytest.raises(cd.DerivationError, match=r"equations\.symbolic\('bias'\)"):
        _ = equations.bias
    replacements, h = equations.symbolic("bias")
    assert len(replacements) > 100
    assert h.shape == (6, 1)


@pytest.mark.parametrize("name", some(sorted(ZOO), 6))
def test_never_worse_and_equal(name: str) -> None:
    equations = cd.derive(ZOO[name].build())
    for function in map(equations.function, ("mass_matrix", "bias", "applied_forces", "qdot")):
        if len(function.live()) > 150:
            # evaluating what is written out takes longer than writing it
            continue
        try:
            found = readable(function, equations.symbols, Budget(100_000))
        except TooLong:
            continue
        before = to_sympy(function, equations.symbols)
        for ours, given in zip(found, before, strict=True):
            if ours.count_ops() > given.count_ops():
                assert terms(ours) < terms(given)
        check_equal(found, before)


def terms(entry: sp.Expr) -> int:
    return len(sp.Add.make_args(sp.expand(entry)))


def table(number: int) -> Callable[[Any], Any]:
    return lambda x: np.exp((1 + 0.2 * number) * x)


# of up to three tables and their derivatives
TABLES = {
    f"table{k}{order}": table(3 * k + n)
    for k in range(3)
    for n, order in enumerate(("", "_d1", "_d2"))
}


def check_equal(a: sp.Matrix, b: sp.Matrix) -> None:
    """Equal at random values, to what the sums of their terms lose; a table is any function."""
    symbols = sorted(a.free_symbols | b.free_symbols, key=str)
    values = np.random.default_rng(5).uniform(0.2, 0.8, len(symbols))
    first, second = (
        np.array(sp.lambdify(symbols, m, [TABLES, "numpy"])(*values), dtype=float) for m in (a, b)
    )
    np.testing.assert_allclose(first, second, rtol=1e-9, atol=1e-9)


def test_functions_of_joints_and_frames() -> None:
    """The pin of a pendulum at rest bears the weight; the same by shared intermediates."""
    scene = cd.Scene("rest", gravity=(0, 0, -9.81))
    bob = scene.body("bob", mass=2.0, com=(0, 0, -0.5))
    scene.joint("pin", cd.Revolute("y"), scene.ground, bob)
    equations = cd.derive(scene)
    reaction = equations.written("reaction", of="pin")
    replacements, shared = equations.symbolic("reaction", of="pin")
    for symbol, expression in reversed(replacements):
        shared = shared.subs(symbol, expression)
    model = cd.compile(scene)
    for q, u in ((0.0, 0.0), (0.7, 1.3)):
        state = {"pin": q, "pin.u": u, **model.parameters}
        at = {s: state.get(str(s), 0.0) for s in reaction.free_symbols | shared.free_symbols}
        expected = model.reaction("pin", [q], [u])
        for form in (reaction, shared):
            assert np.array(form.subs(at), float).ravel() == pytest.approx(expected, abs=1e-12)
    assert model.reaction("pin", [0.0], [0.0])[5] == pytest.approx(2 * 9.81)
    with pytest.raises(cd.DerivationError, match="'reaction' needs a joint: name it with of="):
        equations.written("reaction")
    with pytest.raises(cd.DerivationError, match="'pine'"):
        equations.written("reaction", of="pine")


def test_intermediates_have_the_names_of_bodies() -> None:
    equations = cd.derive(CLASSICAL["arm"].scene())
    replacements, h = equations.symbolic("bias")
    names = [symbol.name for symbol, _ in replacements]
    assert len(names) == len(set(names))
    assert {"second.whole_mass", "second.first_moment_x", "second.omega_z", "q2.cos"} <= set(names)
    # put together again they are the matrix itself
    whole = h
    for symbol, value in reversed(replacements):
        whole = whole.subs(symbol, value)
    assert (whole - equations.bias).applyfunc(sp.simplify).is_zero_matrix


def test_a_parameter_keeps_its_name_among_intermediates() -> None:
    scene = CLASSICAL["arm"].scene()
    scene.parameter("second.mass", 1.0)
    names = [symbol.name for symbol, _ in cd.derive(scene).symbolic("bias")[0]]
    assert len(names) == len(set(names))


def test_counts_by_owner() -> None:
    equations = cd.derive(CLASSICAL["arm"].scene(), rewrites=())
    model = cd.compile(equations)
    model.forward_dynamics([0.1, 0.2], [0.3, 0.4])
    for name, counts in equations.operations.items():
        assert sum(sum(own.values()) for own in counts.blocks.values()) == counts.total
        assert {"first", "second"} <= set(counts.blocks)
        if name in model.operations:
            assert model.operations[name] == counts
    fewer = cd.derive(CLASSICAL["arm"].scene()).operations
    assert all(fewer[name].total <= equations.operations[name].total for name in fewer)
    assert fewer["bias"].rewrites
    assert fewer["bias"].prepared > 0


def test_one_screen() -> None:
    text = str(cd.derive(chain(40)))
    assert len(text.splitlines()) <= 24
    assert max(map(len, text.splitlines())) <= 120


@each(
    ("name", "tex"),
    [
        ("theta1", r"\theta_{1}"),
        ("m", "m"),
        ("elbow", r"\mathrm{elbow}"),
        ("body_12", r"\mathrm{body}_{12}"),
        ("l_c", "l_{c}"),
        ("a$b%{", r"\mathrm{a\$b\%\{}"),
        ("x\\input{y}", r"\mathrm{x\backslash{}input\{y\}}"),
        ("upper.mass", r"m_{\mathrm{upper}}"),
        ("gravity.z", "g_{z}"),
        ("θ", "θ"),
    ],
)
def test_names_in_tex(name: str, tex: str) -> None:
    assert notation(name).latex() == tex


def test_latex() -> None:
    text = cd.derive(CLASSICAL["double"].scene())._repr_latex_()
    assert text.startswith("$")
    assert text.endswith("$")
    assert r"\ddot{\theta}_{1}" in text
    assert r"\sin{\left(\theta_{1} + \theta_{2} \right)}" in text
    assert text.count("{") == text.count("}")


def test_latex_of_what_is_too_long_says_the_form() -> None:
    assert latex(spatial()) == r"M(q)\,\dot u + h(q, u) = f + \tau"


def test_latex_of_quaternions_shows_the_kinematics() -> None:
    scene = cd.Scene("ball")
    ball = scene.body("ball", mass=1.0, inertia=(1.0, 2.0, 2.5))
    scene.joint("joint", cd.Spherical(), scene.ground, ball)
    text = latex(cd.derive(scene))
    assert r"\dot q &=" in text
    assert r"\begin{aligned}" in text


def kane_pendulum() -> tuple[me.KanesMethod, cd.Scene]:
    """A pendulum on a cart in SymPy, and the same scene."""
    M, m, l, g = sp.symbols("M m l g")
    x, th, v, w = me.dynamicsymbols("x theta v w")
    N = me.ReferenceFrame("N")
    B = N.orientnew("B", "Axis", (th, -N.y))
    O = me.Point("O")
    O.set_vel(N, 0)
    C = O.locatenew("C", x * N.x)
    C.set_vel(N, v * N.x)
    B.set_ang_vel(N, -w * N.y)
    P = C.locatenew("P", -l * B.z)
    P.v2pt_theory(C, N, B)
    kane = me.KanesMethod(N, [x, th], [v, w], [x.diff() - v, th.diff() - w])
    bodies = [me.Particle("cart", C, M), me.Particle("bob", P, m)]
    kane.kanes_equations(bodies, [(P, -m * g * N.z)])
    return kane, CLASSICAL["cart"].scene()


def kane_arm() -> tuple[me.KanesMethod, cd.Scene]:
    """A double pendulum with torque on the elbow in SymPy, and the same scene."""
    m1, m2, l1, l2, g, k = sp.symbols("m1 m2 l1 l2 g k")
    a, b, u, v = me.dynamicsymbols("a b u v")
    N = me.ReferenceFrame("N")
    A, B = N.orientnew("A", "Axis", (a, N.y)), N.orientnew("B", "Axis", (a + b, N.y))
    A.set_ang_vel(N, u * N.y)
    B.set_ang_vel(N, (u + v) * N.y)
    O = me.Point("O")
    O.set_vel(N, 0)
    P = O.locatenew("P", -l1 * A.z)
    P.v2pt_theory(O, N, A)
    Q = P.locatenew("Q", -l2 * B.z)
    Q.v2pt_theory(P, N, B)
    kane = me.KanesMethod(N, [a, b], [u, v], [a.diff() - u, b.diff() - v])
    loads = [(P, -m1 * g * N.z), (Q, -m2 * g * N.z), (B, -k * b * N.y), (A, k * b * N.y)]
    kane.kanes_equations([me.Particle("p", P, m1), me.Particle("q", Q, m2)], loads)
    scene = CLASSICAL["double"].scene()
    stiffness = scene.parameter("k", 3.0, unit="N*m/rad")
    scene.force("spring", cd.JointForce("theta2", -stiffness * scene.q("theta2")))
    return kane, scene


@pytest.mark.parametrize("made", some([kane_pendulum, kane_arm], 2))
def test_like_kanes_method(made) -> None:
    kane, scene = made()
    ours = cd.derive(scene).to_sympy()
    same = dict(zip([*kane.q, *kane.u], [*ours.q, *ours.u], strict=True))
    for theirs, found in (
        (kane.mass_matrix, ours.mass_matrix),
        (kane.forcing, ours.forcing),
        (kane.mass_matrix_full, ours.mass_matrix_full),
        (kane.forcing_full, ours.forcing_full),
        (sp.Matrix(list(kane.kindiffdict().values())), ours.kinematics),
    ):
        assert (theirs.xreplace(same) - found).applyfunc(sp.simplify).is_zero_matrix
    assert ours.kindiffdict() == dict(zip(ours.q.diff(ours.t), ours.kinematics, strict=True))
    assert ours.t == me.dynamicsymbols._t
    assert {s.name for s in ours.parameters} == set(cd.derive(scene).parameters)
    # as users of that package make functions of numbers
    values = [*ours.q, *ours.u, *ours.parameters]
    numbers = [0.3, 0.5, -0.2, 0.4, *ours.parameters.values()]
    full = sp.lambdify(values, [ours.mass_matrix_full, ours.forcing_full])
    M, f = full(*numbers)
    udot = cd.compile(scene).forward_dynamics([0.3, 0.5], [-0.2, 0.4])
    np.testing.assert_allclose(np.linalg.solve(M, f)[2:, 0], udot, rtol=1e-12)
    np.testing.assert_allclose(
        np.array(sp.lambdify(values, ours.rhs())(*numbers), dtype=float)[2:, 0], udot, rtol=1e-12
    )
