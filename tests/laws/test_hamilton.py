"""Momenta, their rates and the Hamilton function: what they are, and Hamilton's equations."""

from __future__ import annotations

import numpy as np
import pytest
import sympy
from sympy.physics.mechanics import dynamicsymbols

import cardan as cd
from laws.cases import EPS, call, derived, states, values
from mechanisms import METHODS, ZOO
from mechanisms.rolling import ROLLING
from spread import some
from table import each

STEP = 1e-5
# error of a central difference: STEP^2 of the third derivative, and eps / STEP of rounding
CLOSE = 1e-7
SCLERONOMIC = [
    name
    for name in ZOO
    if not any(joint.motion is not None for joint in derived(name, "newton_euler").system.joints)
]
# joints without quaternions and the like: speeds are rates of coordinates
HOLONOMIC = ("pendulum", "double_pendulum", "cart_pole", "universal", "planar", "drives", "crane")


@pytest.mark.parametrize("name", some(SCLERONOMIC, 9))
def test_momenta_are_linear_and_the_energy_is_the_hamiltonian(name: str) -> None:
    (q, u), e = states(name), derived(name, "newton_euler")
    mass, p = call(e, "mass_matrix", q=q)["M"], call(e, "momenta", q=q, u=u)["momenta"]
    expected = np.einsum("kij,kj->ki", mass, u)
    size = np.abs(mass).max() * np.abs(u).max() + EPS
    np.testing.assert_allclose(p, expected, rtol=0, atol=100 * EPS * size)
    energy = call(e, "energy", q=q, u=u)["total"]
    H = call(e, "hamiltonian", q=q, u=u)["hamiltonian"]
    size = np.abs(energy).max() + np.abs(expected).max() * np.abs(u).max()
    np.testing.assert_allclose(H, energy, rtol=0, atol=100 * EPS * size)


def along(e: cd.Equations, q: np.ndarray, u: np.ndarray, step: float) -> np.ndarray:
    """Momenta a moment before or after, second order in the step."""
    udot = call(e, "forward_dynamics", q=q, u=u)["udot"]
    # speeds that turn with a body leave its direction in second order only
    moved = call(e, "integrate", q=q, du=step * u + step**2 / 2 * udot)["q"]
    time = values(e)["t"][0] + step
    return np.asarray(call(e, "momenta", q=moved, u=u + step * udot, t=[time])["momenta"])


@pytest.mark.parametrize("name", some(SCLERONOMIC, 9, 1))
def test_rates_are_those_along_the_motion(name: str) -> None:
    (q, u), e = states(name), derived(name, "newton_euler")
    rates = call(e, "momentum_rates", q=q, u=u)["momentum_rates"]
    difference = (along(e, q, u, STEP) - along(e, q, u, -STEP)) / (2 * STEP)
    size = 1 + np.abs(call(e, "momenta", q=q, u=u)["momenta"]).max() + np.abs(rates).max()
    np.testing.assert_allclose(rates, difference, rtol=0, atol=CLOSE * size)


@pytest.mark.parametrize("name", HOLONOMIC)
def test_hamiltons_equations(name: str) -> None:
    """qdot = dH/dp, pdot = -dH/dq + Q with H of q and p by solving for u, in differences."""
    e = derived(name, "hamilton")
    q, u = (block[-1] for block in states(name))

    def momenta(q: np.ndarray, u: np.ndarray) -> np.ndarray:
        return np.asarray(call(e, "momenta", q=q, u=u)["momenta"])

    def hamiltonian(q: np.ndarray, p: np.ndarray) -> float:
        rest = momenta(q, np.zeros_like(u))
        speeds = np.linalg.solve(call(e, "mass_matrix", q=q)["M"], p - rest)
        return float(call(e, "hamiltonian", q=q, u=speeds)["hamiltonian"])

    p = momenta(q, u)
    unit = np.eye(len(p)) * STEP
    by_p = [(hamiltonian(q, p + d) - hamiltonian(q, p - d)) / (2 * STEP) for d in unit]
    by_q = [(hamiltonian(q + d, p) - hamiltonian(q - d, p)) / (2 * STEP) for d in unit]
    size = 1 + np.abs(by_q).max() + np.abs(hamiltonian(q, p))
    np.testing.assert_allclose(by_p, u, rtol=0, atol=CLOSE * size)
    rates = call(e, "momentum_rates", q=q, u=u)["momentum_rates"]
    if ZOO[name].conservative:
        np.testing.assert_allclose(rates, -np.array(by_q), rtol=0, atol=CLOSE * size)
    else:
        # the work that H does not know of is the power of all elements without a potential
        power = call(e, "power", q=q, u=u)["power"]
        known = [n for n in e.function("power").outputs[0].entries if not n.endswith(".motion")]
        lost = power[: len(known)].sum()
        assert np.dot(rates + by_q, u) == pytest.approx(lost, abs=CLOSE * size)


@each("method", METHODS)
def test_every_formalism_has_them(method: str) -> None:
    name = "springs"
    (q, u), e, other = states(name), derived(name, method), derived(name, "kane").without_rewrites
    for function in ("momenta", "momentum_rates", "hamiltonian"):
        found, wanted = (call(x, function, q=q, u=u)[function] for x in (e, other))
        size = 1 + np.abs(wanted).max()
        np.testing.assert_allclose(found, wanted, rtol=0, atol=1000 * EPS * size)


def test_rates_of_a_free_body_are_eulers() -> None:
    """p of the angular velocity is I omega, its rate I omega x omega."""
    I = np.array([0.2, 0.5, 0.6])
    scene = cd.Scene("box")
    scene.joint("free", cd.Free(), scene.ground, scene.body("box", mass=2.0, inertia=tuple(I)))
    model = cd.compile(scene, functions=["momenta", "momentum_rates"], method="hamilton")
    q, omega, v = [0.5, 0.5, -0.5, 0.5, 1, 2, 3], np.array([0.3, -1.0, 2.0]), np.array([1.0, 0, -2])
    u = [*omega, *v]
    np.testing.assert_allclose(model.momenta(q, u), [*(I * omega), *(2 * v)], rtol=1e-15)
    expected = [*np.cross(I * omega, omega), 0, 0, -2.0 * 9.81]
    np.testing.assert_allclose(model.momentum_rates(q, u), expected, rtol=1e-15, atol=1e-15)
    assert model.manifest["functions"]["momenta"]["outputs"][0]["units"][0] == "kg*m^2/s"


def test_cyclic_momenta_of_a_top_are_constant() -> None:
    scene = cd.Scene("top", gravity=(0, 0, -9.81))
    top = scene.body("top", mass=0.5, com=(0, 0, 0.1), inertia=(3e-3, 3e-3, 1e-3))
    yoke, cradle = scene.body("yoke", mass=0), scene.body("cradle", mass=0)
    scene.joint("precession", cd.Revolute("z"), scene.ground, yoke)
    scene.joint("nutation", cd.Revolute("x"), yoke, cradle)
    scene.joint("spin", cd.Revolute("z"), cradle, top)
    model = cd.compile(scene, method="hamilton")
    motion = model.simulate(
        2.0, q={"nutation": 0.6}, u={"spin": 80.0, "precession": 1.0}, rtol=1e-11, atol=1e-12
    )
    p = model.momenta(motion.q, motion.u)
    # the error of the run at these tolerances
    assert max(np.ptp(p[:, 0]), np.ptp(p[:, 2])) < 1e-8
    assert np.ptp(p[:, 1]) > 1e-3
    theta, phi, psi = motion["nutation"], motion["precession.u"], motion["spin.u"]
    axial = 1e-3 * (psi + phi * np.cos(theta))
    np.testing.assert_allclose(p[:, 2], axial, rtol=1e-12)
    about = (3e-3 + 0.5 * 0.1**2) * phi * np.sin(theta) ** 2 + axial * np.cos(theta)
    np.testing.assert_allclose(p[:, 0], about, rtol=1e-12)
    np.testing.assert_allclose(
        model.hamiltonian(motion.q, motion.u), motion.energy.total, rtol=1e-13
    )


def test_a_driven_hoop_keeps_its_hamiltonian_but_not_its_energy() -> None:
    """A bead on a hoop that turns at a constant rate w: H = p²/2m - T0 + V is constant."""
    w, r, m = 5.0, 0.3, 0.7
    scene = cd.Scene("hoop", gravity=(0, 0, -9.81))
    hoop, bead = scene.body("hoop", mass=0), scene.body("bead", mass=m, com=(0, 0, -r))
    scene.joint("drive", cd.Revolute("z"), scene.ground, hoop, prescribed=w * cd.t)
    scene.joint("angle", cd.Revolute("y"), hoop, bead)
    model = cd.compile(scene)
    motion = model.simulate(2.0, q={"angle": 0.4}, rtol=1e-11, atol=1e-12)
    H = model.hamiltonian(motion.q, motion.u, t=motion.t)
    angle, rate = motion["angle"], motion["angle.u"]
    kinetic = m * r**2 * (rate**2 - (w * np.sin(angle)) ** 2) / 2
    np.testing.assert_allclose(H, kinetic - m * 9.81 * r * np.cos(angle), rtol=0, atol=1e-13)
    assert np.ptp(H) < 1e-8
    assert np.ptp(motion.energy.total) > 0.1


@pytest.mark.parametrize("name", ROLLING)
def test_constraints_are_among_the_rates(name: str) -> None:
    """pdot contains Gᵀ lam: d/dt of the momenta along what the constraints leave."""
    e = cd.derive(ROLLING[name](), method="hamilton")
    rng = np.random.default_rng(5)
    q, u = rng.uniform(0.2, 0.6, (3, len(e.coordinates))), rng.uniform(-1, 1, (3, len(e.speeds)))
    rates = call(e, "momentum_rates", q=q, u=u)["momentum_rates"]
    difference = (along(e, q, u, STEP) - along(e, q, u, -STEP)) / (2 * STEP)
    size = 1 + np.abs(rates).max()
    np.testing.assert_allclose(rates, difference, rtol=0, atol=CLOSE * size)


def written() -> cd.Scene:
    """A bead on a sine: (1 + cos(x)²) x'' = sin(x) cos(x) x'² - 9.81 cos(x)."""
    x = dynamicsymbols("x")
    v = x.diff()
    mass, force = 1 + sympy.cos(x) ** 2, sympy.sin(x) * sympy.cos(x) * v**2 - 9.81 * sympy.cos(x)
    return cd.from_sympy(([x], [v], [v], sympy.Matrix([[mass]]), [force]))


@each("method", METHODS)
def test_written_equations_have_no_energy_to_differentiate(method: str) -> None:
    if method != "composite":
        with pytest.raises(cd.DerivationError, match="made of written equations"):
            cd.derive(written(), method=method)
        return
    e = cd.derive(written(), method=method)
    q, u = np.array([0.7]), np.array([1.3])
    mass = 1 + np.cos(0.7) ** 2
    force = np.sin(0.7) * np.cos(0.7) * 1.3**2 - 9.81 * np.cos(0.7)
    found = call(e, "forward_dynamics", q=q, u=u)["udot"]
    np.testing.assert_allclose(found, [force / mass], rtol=1e-14)
    with pytest.raises(cd.DerivationError, match="no kinetic energy to differentiate"):
        e.function("momenta")
