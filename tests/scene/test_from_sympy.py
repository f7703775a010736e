"""Equations derived with SymPy's mechanics package, through the same pipeline."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sm
from sympy.physics import mechanics as me
from tests.mechanisms import ZOO
from tests.scene import mechanics
from tests.spread import some

import cardan as cd

REFERENCES = Path(__file__).parents[1] / "references"
T = me.dynamicsymbols._t
SLOW = ("bicycle", "disc_auxiliary", "disc_dependent", "disc_lagrange", "disc_multipliers")


def cases() -> list[Any]:
    """All examples; those that SymPy takes long for are slow."""
    marks = {name: [pytest.mark.slow] for name in SLOW}
    return [
        pytest.param(make, id=make.__name__, marks=marks.get(make.__name__, []))
        for make in mechanics.EXAMPLES
    ]


def closed(model: cd.CompiledModel, seed: int) -> tuple[np.ndarray, np.ndarray]:
    """A random state on the constraints."""
    rng = np.random.default_rng(seed)
    q, u = rng.uniform(0.2, 1.1, model.nq), rng.uniform(-1, 1, model.nu)
    if not model.manifest["multipliers"]:
        return q, u
    for _ in range(40):
        g = model.constraints(q)
        if np.abs(g).max(initial=0.0) < 1e-14:
            break
        q = model.integrate(q, -np.linalg.pinv(model.constraint_jacobian(q)[: len(g)]) @ g)
    rates = model.constraint_rates(q, u)
    return q, u - np.linalg.pinv(model.constraint_jacobian(q)) @ rates


def numbers(expressions: Any, names: dict[Any, float]) -> np.ndarray:
    """A SymPy matrix by SymPy's own lambdify."""
    plain = {x: sm.Dummy() for x in names}
    swapped = sm.Matrix(expressions).xreplace(plain)
    found = sm.lambdify(list(plain.values()), swapped, modules="numpy", cse=True)(*names.values())
    return np.array(found, dtype=np.float64)


def values_at(
    equations: Any, parameters: dict[Any, float], q: np.ndarray, u: np.ndarray
) -> dict[Any, float]:
    """What SymPy's symbols are at a state; inputs are 0.3."""
    known: dict[Any, float] = {sm.Symbol(name): value for name, value in parameters.items()}
    known |= dict(zip(equations.q, q, strict=True)) | dict(zip(equations.u, u, strict=True))
    if isinstance(equations, me.KanesMethod):
        known |= dict.fromkeys(equations._uaux, 0.0)
        kinematics = equations.kindiffdict()
        rates = numbers([*kinematics.values()], known)
        known |= dict(zip(kinematics, rates[:, 0], strict=True))
    return known | dict.fromkeys(me.find_dynamicsymbols(equations.forcing) - set(known), 0.3)


@pytest.mark.parametrize("make", cases())
@pytest.mark.parametrize("seed", some([0, 1], every=2))
def test_right_hand_sides_are_those_of_sympy(make, seed: int) -> None:
    equations, parameters = make()
    model = cd.compile(cd.from_sympy(equations, parameters=parameters, name=make.__name__))
    q, u = closed(model, seed)
    known = values_at(equations, parameters, q, u)
    pushing = {str(x.func): v for x, v in known.items() if x.args and str(x.func) in model.inputs}
    M = numbers(equations.mass_matrix_full, known)
    f = numbers(equations.forcing_full, known)
    expected = np.linalg.solve(M, f)[: model.nq + model.nu, 0]
    xdot = model.rhs(0.0, np.concatenate([q, u]), pushing)
    np.testing.assert_allclose(xdot, expected, rtol=1e-10, atol=1e-10 * np.abs(expected).max())
    # what SymPy was told to hold is held
    if getattr(equations, "_f_nh", None):
        held = [*equations._f_h, *(equations._k_nh * equations.u + equations._f_nh)]
        assert np.abs(numbers(held, known)).max() < 1e-12
    assert model.verify().worst < 1e-12


def test_multipliers_are_those_of_lagrange_with_the_other_sign() -> None:
    lagrange, parameters = mechanics.pendulum_lagrange()
    model = cd.compile(cd.from_sympy(lagrange, parameters=parameters))
    q, u = closed(model, 0)
    known = values_at(lagrange, parameters, q, u)
    theirs = numbers(lagrange.solve_multipliers(sol_type="Matrix"), known)
    assert cd.derive(cd.from_sympy(lagrange, parameters=parameters)).multipliers == ("holonomic1",)
    np.testing.assert_allclose(model.multipliers(q, u), -theirs[:, 0], rtol=1e-12)


def test_a_lagrangian_tells_energy_and_power() -> None:
    q = me.dynamicsymbols("q")
    m, g, length, c = sm.symbols("m g l c")
    ground = me.ReferenceFrame("N")
    turned = ground.orientnew("A", "Axis", [q, ground.z])
    lagrangian = m * length**2 * q.diff() ** 2 / 2 + m * g * length * sm.cos(q)
    lagrange = me.LagrangesMethod(
        lagrangian, [q], forcelist=[(turned, -c * q.diff() * ground.z)], frame=ground
    )
    lagrange.form_lagranges_equations()
    values = {m: 2.0, g: 9.81, length: 0.5, c: 0.3}
    model = cd.compile(cd.from_sympy(lagrange, parameters=values))
    found = model.energy([0.4], [1.5])
    assert found.kinetic == pytest.approx(0.5 * 2.0 * 0.25 * 1.5**2, rel=1e-14)
    assert found.potential == pytest.approx(-2.0 * 9.81 * 0.5 * np.cos(0.4), rel=1e-14)
    np.testing.assert_allclose(model.power([0.4], [1.5]), [-0.3 * 1.5**2], rtol=1e-14)
    motion = model.simulate(2.0, q={"q": 1.0}, rtol=1e-10, atol=1e-12)
    assert np.abs(motion.energy_residual).max() < 1e-8
    assert motion.work["written"][-1] < -0.1


def test_a_potential_beside_plain_equations_gives_the_ledger() -> None:
    """Rod on a sliding mass: M depends on q, one force is spent, one is stored."""
    q, u = me.dynamicsymbols("x a"), me.dynamicsymbols("v w")
    force = me.dynamicsymbols("F")
    m, length, g = sm.symbols("m l g")
    c, s = sm.cos(q[1]), sm.sin(q[1])
    M = sm.Matrix([[2 * m, m * length * c], [m * length * c, m * length**2]])
    f = sm.Matrix([force - 0.2 * u[0] + m * length * u[1] ** 2 * s, -m * g * length * s])
    scene = cd.from_sympy(
        (q, u, M, f),
        parameters={"m": 1.2, "l": 0.8, "g": 9.81},
        potential=-m * g * length * c,
        outputs={"tip": q[0] + length * s, "speed": q[0].diff()},
    )
    model = cd.compile(scene)
    q0, u0 = np.array([0.1, 0.7]), np.array([0.6, -1.1])
    spent = (0.5 - 0.2 * 0.6) * 0.6
    np.testing.assert_allclose(model.power(q0, u0, r={"F": 0.5}), [spent], rtol=1e-12)
    np.testing.assert_allclose(model.outputs(q0, u0), [0.1 + 0.8 * np.sin(0.7), 0.6], rtol=1e-14)
    motion = model.simulate(
        2.0, q={"a": 1.0}, inputs={"F": lambda t, x: np.sin(3 * t)}, rtol=1e-10, atol=1e-12
    )
    assert np.abs(motion.energy_residual).max() < 1e-8


def bicycle() -> cd.CompiledModel:
    kane, parameters = mechanics.bicycle()
    return cd.compile(cd.from_sympy(kane, parameters=parameters, name="bicycle"))


@pytest.mark.slow
def test_the_bicycle_has_the_eigenvalues_of_the_benchmark() -> None:
    kane, parameters = mechanics.bicycle()
    model = cd.compile(cd.from_sympy(kane, parameters=parameters, name="bicycle"))
    data = json.loads((REFERENCES / "bicycle_linear.json").read_text())
    upright = dict.fromkeys(("q1", "q2", "q4", "q5"), 0.0)
    for speed, expected in data["reference"]["eigenvalues_by_speed"].items():
        rolling = {"u3": float(speed) / 0.3, "u6": float(speed) / 0.35}
        found = model.linearize(q=upright, u=rolling).eigenvalues
        for real, imaginary in expected:
            value = complex(real, imaginary)
            assert np.abs(found - value).min() < 1e-9 * abs(value)


def test_kinematics_are_regular_where_sympy_divides_by_zero() -> None:
    """A free body by Euler angles: its own solution for q' has a pivot that vanishes at rest."""
    q, u = me.dynamicsymbols("a b c"), me.dynamicsymbols("w1:4")
    inertia = sm.symbols("I1:4")
    ground, center = me.ReferenceFrame("N"), me.Point("C")
    center.set_vel(ground, 0)
    body = ground.orientnew("B", "Body", q, "ZYX")
    spin = sum((w * e for w, e in zip(u, body, strict=True)), 0 * body.x)
    kinematics = [me.dot(body.ang_vel_in(ground) - spin, e) for e in body]
    body.set_ang_vel(ground, spin)
    solid = me.RigidBody("b", center, body, 1, (me.inertia(body, *inertia), center))
    kane = me.KanesMethod(ground, q, u, kinematics)
    kane.kanes_equations([solid])
    at = dict.fromkeys(q, 0) | dict(zip(u, (1, 2, 3), strict=True))
    assert sm.nan in [rate.subs(at) for rate in kane.kindiffdict().values()]
    model = cd.compile(cd.from_sympy(kane, parameters=dict(zip(inertia, (1, 2, 4), strict=True))))
    found = model.rhs(0.0, [0, 0, 0, 1, 2, 3])
    np.testing.assert_allclose(found, [3, 2, 1, -12, 4.5, -0.5], rtol=1e-14)
    assert model.verify().worst < 1e-13


# forms of input


def test_speeds_may_be_other_than_rates() -> None:
    """A point by polar coordinates with its velocity along and across; one coordinate rests."""
    r, a, b = me.dynamicsymbols("r a b")
    v, w = me.dynamicsymbols("v w")
    m, k = sm.symbols("m k")
    kinematics = [v, w / r, w / r]
    f = [m * w**2 / r - k * r, -m * v * w / r]
    model = cd.compile(
        cd.from_sympy(([r, a, b], [v, w], kinematics, m * sm.eye(2), f), parameters={m: 2, k: 3})
    )
    assert (model.nq, model.nu) == (3, 2)
    q, u = np.array([0.8, 0.3, -0.2]), np.array([0.5, 1.2])
    xdot = model.rhs(0.0, np.concatenate([q, u]))
    expected = [0.5, 1.5, 1.5, 1.2**2 / 0.8 - 1.5 * 0.8, -0.5 * 1.2 / 0.8]
    np.testing.assert_allclose(xdot, expected, rtol=1e-14)
    du = np.array([1e-2, -2e-2])
    np.testing.assert_allclose(model.difference(q, model.integrate(q, du)), du, atol=1e-15)
    with pytest.raises(cd.ModelError, match=r"GeneralizedAlpha.*q' themselves"):
        model.simulate(1.0, q={"r": 1.0}, method="GeneralizedAlpha")


def test_a_matrix_that_is_no_mass_matrix_is_solved_for_accelerations() -> None:
    kane, parameters = mechanics.pendulum_kane()
    plain = cd.compile(cd.from_sympy(kane, parameters=parameters))
    q, u = closed(plain, 3)
    rates = [kane.kindiffdict()[x.diff(T)] for x in kane.q]
    stacked = (kane.q, kane.u, rates, kane.mass_matrix, kane.forcing)
    # the length stands in the constraint alone, which M of this form has eliminated
    left = {key: value for key, value in parameters.items() if str(key) != "L"}
    scene = cd.from_sympy(stacked, parameters=left)
    assert "solved for the accelerations" in str(scene)
    model = cd.compile(scene)
    x = np.concatenate([q, u])
    np.testing.assert_allclose(model.rhs(0.0, x), plain.rhs(0.0, x), rtol=1e-11)
    np.testing.assert_array_equal(model.mass_matrix(q), np.eye(2))
    with pytest.raises(cd.ModelError, match="not symmetric"):
        cd.from_sympy((*stacked, kane._f_h), parameters=parameters)


def test_constraints_by_name_and_moved_by_inputs() -> None:
    """A bead on a line whose height is an input: value, rate and acceleration enter."""
    x, y = me.dynamicsymbols("x y")
    h = me.dynamicsymbols("h")
    m = sm.Symbol("m")
    u = [x.diff(), y.diff()]
    scene = cd.from_sympy(
        ([x, y], u, u, m * sm.eye(2), [h.diff(), -9.81 * m], {"rail": y - h}), parameters={m: 2}
    )
    model = cd.compile(scene)
    assert model.inputs == ("h", "h.rate", "h.acceleration")
    assert model.speeds == ("x.u", "y.u")
    found = model.forward_dynamics([0.0, 0.5], [1.0, 0.2], r=[0.5, 0.2, 0.7])
    np.testing.assert_allclose(found, [0.1, 0.7], rtol=1e-14)
    lam = model.multipliers([0.0, 0.5], [1.0, 0.2], r=[0.5, 0.2, 0.7])
    np.testing.assert_allclose(lam, [2 * (0.7 + 9.81)], rtol=1e-14)


def test_functions_with_cases() -> None:
    q, u = me.dynamicsymbols("q u")
    k, c = sm.symbols("k c", positive=True)
    f = -k * sm.Piecewise((q - 1, q > 1), (0, True)) - c * sm.sign(u) * sm.Abs(u) ** 1.5
    f += sm.Heaviside(-q, 0.5) + sm.Max(u, q)
    model = cd.compile(cd.from_sympy(([q], [u], [[1]], [f]), parameters={k: 5, "c": 0.2}))
    for at, v in ((1.4, -0.5), (-0.3, 0.9)):
        expected = -5 * max(at - 1, 0) - 0.2 * np.sign(v) * abs(v) ** 1.5 + (at < 0) + max(v, at)
        np.testing.assert_allclose(model.forward_dynamics([at], [v]), [expected], rtol=1e-14)


def test_a_system_object_gives_its_method() -> None:
    wall, rod = me.RigidBody("wall"), me.RigidBody("rod")
    system = me.System.from_newtonian(wall)
    system.add_joints(me.PinJoint("hinge", wall, rod))
    with pytest.raises(cd.ModelError, match="form_eoms"):
        cd.from_sympy(system)
    system.form_eoms()
    model = cd.compile(cd.from_sympy(system, parameters={"rod_ixx": 2.0}))
    assert (model.coordinates, model.speeds) == (("q_hinge",), ("u_hinge",))
    np.testing.assert_array_equal(model.mass_matrix([0.3]), [[2.0]])


ROUND = ("pendulum", "cart_pole", "spherical_quaternion", "universal", "free_quaternion", "crane")


@pytest.mark.parametrize("name", some(ROUND, every=3))
def test_round_trip_through_sympy(name: str) -> None:
    scene = ZOO[name].build()
    told = cd.derive(scene).to_sympy()
    ours, theirs = cd.compile(scene), cd.compile(cd.from_sympy(told))
    x = np.concatenate(ours.split(ours.random_state(1)))
    r = np.linspace(0.2, 0.5, ours.nr)
    np.testing.assert_allclose(theirs.rhs(0.3, x, r), ours.rhs(0.3, x, r), rtol=1e-11, atol=1e-12)


def test_round_trip_with_constraints() -> None:
    scene = cd.from_sympy(mechanics.disc_multipliers()[0], parameters=mechanics.DISC)
    told = cd.derive(scene).to_sympy()
    assert list(told.constraints) == ["holonomic1"]
    assert list(told.velocity_constraints) == ["nonholonomic1", "nonholonomic2"]
    ours, theirs = cd.compile(scene), cd.compile(cd.from_sympy(told))
    x = np.concatenate(closed(ours, 2))
    np.testing.assert_allclose(theirs.rhs(0.0, x), ours.rhs(0.0, x), rtol=1e-11, atol=1e-12)


# what a build is judged by


def test_a_wrong_build_is_refused() -> None:
    kane, parameters = mechanics.cart(1)
    model = cd.compile(cd.from_sympy(kane, parameters=parameters, name="judged"))
    model.rhs(0.0, np.zeros(4))
    model.manifest["scene"]["samples"][0]["right"][1] += 1e-3
    with pytest.raises(cd.BuildError, match="rhs differs from the numbers of SymPy"):
        model.verify()


def test_numbers_that_are_built_in_are_judged_if_they_are_the_same() -> None:
    kane, parameters = mechanics.cart(1)
    scene = cd.from_sympy(kane, parameters=parameters)
    same, other = cd.compile(scene, specialize=True), cd.compile(scene, specialize={"m0": 7.0})
    x = np.array([0.1, 0.3, 0.5, -0.4])
    assert np.abs(same.rhs(0.0, x) - other.rhs(0.0, x)).max() > 1e-3
    assert same.verify().worst < 1e-13
    assert "built in" in str(other.verify())
