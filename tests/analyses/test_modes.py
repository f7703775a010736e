"""Modes against closed forms: springs, prestress, whirling, damping, effective masses, sparse."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.sparse import csr_array

import cardan as cd
from cardan.analyses.systems.dynamic_system import DynamicSystem, Moment, Tangents
from cardan.analyses.systems.joint_system import JointSystem
from cardan.analyses.systems.saddle_point import Dense, Sparse
from mechanisms.closed import CLOSED
from mechanisms.flexible import slider_crank

G = 9.81


def row(n: int, grounded: bool = True, damping: float = 0.0) -> cd.CompiledModel:
    """n masses of 1 kg in a row of springs of 100 N/m, held at both ends or free."""
    scene = cd.Scene("row", gravity=(0, 0, 0))
    last: Any = scene.ground
    first = 0 if grounded else 1
    for k in range(n):
        body = scene.body(f"b{k}", mass=1.0, inertia=(1, 1, 1))
        scene.joint(f"s{k}", cd.Prismatic("x"), last, body)
        if k >= first:
            force = -100.0 * scene.q(f"s{k}") - damping * scene.u(f"s{k}")
            scene.force(f"f{k}", cd.JointForce(f"s{k}", force))
        last = body
    if grounded:
        whole = sum(scene.q(f"s{k}") for k in range(n))
        end = scene.ground.at(0, 0, 0)
        scene.force("wall", cd.Force(last, (-100.0 * whole, 0, 0)))
        assert end is not None
    return cd.compile(scene)


def test_masses_in_a_row() -> None:
    n = 5
    found = row(n).modes()
    k = np.arange(1, n + 1)
    np.testing.assert_allclose(found.angular, 20 * np.sin(k * np.pi / (2 * (n + 1))), rtol=1e-12)
    # places of the masses: sines, of modal mass 1
    places = np.cumsum(found.shapes, axis=0)
    expected = np.sin(np.outer(k, k) * np.pi / (n + 1)) * np.sqrt(2 / (n + 1))
    np.testing.assert_allclose(np.abs(places), np.abs(expected), atol=1e-10)
    # momentum in x of unit modal speed; its squares add up to the mass
    np.testing.assert_allclose(found.effective_mass[3].sum(), n, rtol=1e-12)
    np.testing.assert_allclose(np.abs(found.participation[3]), np.abs(expected.sum(axis=0)),
                               atol=1e-10)  # fmt: skip
    assert not found.rigid.any()
    assert "frequency [Hz]" in repr(found)


def test_a_free_row_has_a_rigid_mode() -> None:
    found = row(4, grounded=False).modes()
    np.testing.assert_allclose(found.angular, 20 * np.sin(np.arange(4) * np.pi / 8), atol=1e-6)
    assert found.rigid.tolist() == [True, False, False, False]
    shape = found.shape(0)
    assert abs(shape["s0"]) == pytest.approx(0.5, rel=1e-9)
    assert "rigid" in repr(found)


def test_damping_ratios() -> None:
    # dampers in proportion to springs: zeta = beta omega / 2
    found, free = row(3, grounded=False, damping=2.0).modes(), row(3, grounded=False).modes()
    size = np.abs(found.values[1:])
    np.testing.assert_allclose(size, free.angular[1:], rtol=1e-9)
    np.testing.assert_allclose(found.damping[1:], 0.02 * free.angular[1:] / 2, rtol=1e-9)
    undamped = row(3, grounded=False, damping=2.0).modes(damped=False)
    np.testing.assert_allclose(undamped.angular, free.angular, atol=1e-6)
    # what does not oscillate has frequency 0, not rounding
    heavy = row(3, grounded=False, damping=2e3).modes()
    slow = np.abs(heavy.values.imag) <= 1e-8 * np.abs(heavy.values)
    assert slow.sum() > 2
    assert not heavy.frequencies[slow].any()
    # in motion damping is not told apart from other effects of speeds
    with pytest.raises(cd.ModelError, match="damped=False needs a state at rest"):
        row(3, grounded=False, damping=2.0).modes(u={"s0": 1.0}, damped=False)
    # entries of a shape are in phase or opposed: no angle is told twice, by its sign
    assert " at 180 deg" in repr(found)
    assert " at -" not in repr(found)


def test_prestress() -> None:
    scene = cd.Scene("column", gravity=(0, 0, 0))
    P = scene.parameter("P", 0.0)
    bar = scene.body("bar", mass=1.0, com=(0, 0, 0.5), inertia=(0.1, 0.1, 0.01))
    scene.joint("base", cd.Revolute("y"), scene.ground, bar)
    scene.force("spring", cd.JointForce("base", -4.0 * scene.q("base")))
    scene.force("load", cd.Force(bar.at(0, 0, 1), (0, 0, -P)))
    model = cd.compile(scene)
    for load in (0.0, 2.0, 3.99):
        found = model.modes(x=model.equilibrium(parameters={"P": load}))
        np.testing.assert_allclose(found.angular**2, (4.0 - load) / 0.35, rtol=1e-9)
    buckled = model.modes(parameters={"P": 5.0})
    np.testing.assert_allclose(buckled.values.real**2, 1.0 / 0.35, rtol=1e-9)
    assert buckled.damping[0] == -1


def rotor(offset: float = 0.0) -> cd.CompiledModel:
    """A disk on springs that tilts about two axes and spins: gyroscopic splitting."""
    scene = cd.Scene("rotor", gravity=(0, 0, 0))
    one, two = scene.body("one", mass=0.0), scene.body("two", mass=0.0)
    disk = scene.body("disk", mass=1.0, com=(0, 0, offset), inertia=(0.2, 0.2, 0.3))
    scene.joint("x", cd.Revolute("x"), scene.ground, one)
    scene.joint("y", cd.Revolute("y"), one, two)
    scene.joint("spin", cd.Revolute("z"), two, disk)
    for name in "xy":
        scene.force(f"k{name}", cd.JointForce(name, -50.0 * scene.q(name)))
    return cd.compile(scene)


@pytest.mark.parametrize("spin", [0.0, 5.0, 40.0, 400.0])
def test_whirling(spin: float) -> None:
    found = rotor().modes(u={"spin": spin})
    half = 0.3 * spin / 0.2 / 2
    expected = np.sqrt(half**2 + 50.0 / 0.2) + np.array([-half, half])
    np.testing.assert_allclose(found.angular[~found.rigid], expected, rtol=1e-9)
    assert found.rigid.sum() == 1
    if spin:
        # both axes take part, a quarter turn apart: forward and backward
        forward, backward = found.shapes[:2, 2], found.shapes[:2, 1]
        turn = np.angle(forward[1] / forward[0]) * np.angle(backward[1] / backward[0])
        assert turn == pytest.approx(-(np.pi**2) / 4, rel=1e-6)


def test_jeffcott_rotor_in_ground_axes() -> None:
    scene = cd.Scene("jeffcott", gravity=(0, 0, 0))
    slides = [scene.body(name, mass=0.0) for name in ("a", "b")]
    disk = scene.body("disk", mass=2.0, inertia=(0.01, 0.01, 0.02))
    scene.joint("x", cd.Prismatic("x"), scene.ground, slides[0])
    scene.joint("y", cd.Prismatic("y"), slides[0], slides[1])
    scene.joint("spin", cd.Revolute("z"), slides[1], disk)
    for name, k in (("x", 800.0), ("y", 1800.0)):
        scene.force(f"k{name}", cd.JointForce(name, -k * scene.q(name)))
    found = cd.compile(scene).modes(u={"spin": 100.0})
    # no gyroscopic forces: the critical speeds, at any speed
    np.testing.assert_allclose(found.angular[~found.rigid], [20.0, 30.0], rtol=1e-9)


def test_a_turning_observer() -> None:
    # a mass on springs that turn with the shaft: (omega -+ W), from equations in turning axes
    scene = cd.Scene("turntable", gravity=(0, 0, 0))
    table, slide = (
        scene.body("table", mass=1.0, inertia=(1e6, 1e6, 1e6)),
        scene.body("slide", mass=0.0),
    )
    mass = scene.body("mass", mass=1.0)
    scene.joint("turn", cd.Revolute("z"), scene.ground, table)
    scene.joint("x", cd.Prismatic("x"), table, slide)
    scene.joint("y", cd.Prismatic("y"), slide, mass)
    for name in "xy":
        scene.force(f"k{name}", cd.JointForce(name, -100.0 * scene.q(name)))
    found = cd.compile(scene).modes(u={"turn": 3.0})
    oscillating = found.angular[found.angular > 1]
    np.testing.assert_allclose(oscillating, [7.0, 13.0], rtol=1e-5)


def test_a_rod_on_a_driven_crank() -> None:
    """Bending between hinges in closed form; a crank without speeds of its own carries one end."""
    model = cd.compile(slider_crank(elements=4))
    stiffness, mass = 2e11 * 0.008**4 / 12, 7870 * 0.008**2
    expected = np.pi / 2 * np.sqrt(stiffness / mass) / 0.3**2
    assert model.modes().frequencies[0] == pytest.approx(expected, rel=2e-3)


def test_frequencies_of_a_spinning_rod_do_not_depend_on_where_it_points() -> None:
    """Those far above the spin were off by 4e-9, as the search for what is next to 0 left them."""
    scene = cd.Scene("spun", gravity=(0, 0, 0))
    hub = scene.body("hub", mass=300.0, inertia=(400.0,) * 3)
    section = cd.section.general(EA=1e6, GA=1e8, EI=1500.0, GJ=1500.0, rhoA=1.2, rhoI=1e-6)
    for name, x in (("left", -1.0), ("right", 1.0)):
        scene.beam(name, hub.at(x, 0, 0), (9 * x, 0, 0), section, elements=24, base=hub)
    scene.joint("free", cd.Revolute("z"), scene.ground, hub)
    model = cd.compile(scene)
    found = [
        model.modes(20, model.equilibrium(q={"free": angle}, u={"free": 0.3})).angular
        for angle in (0.0, 0.4, 0.9)
    ]
    elastic = [row[row > 1.0] for row in found]
    np.testing.assert_allclose(elastic[1:], elastic[:1] * 2, rtol=1e-10)


def test_constraints_hold_in_modes() -> None:
    model = cd.compile(CLOSED["four_bar"].build())
    rest = model.equilibrium()
    found = model.modes(x=rest)
    assert len(found) == 1
    np.testing.assert_allclose(model.constraint_jacobian(rest.q) @ found.shapes, 0, atol=1e-10)
    # the linear model knows no K and M of ours, only accelerations
    values = model.linearize(rest).eigenvalues
    np.testing.assert_allclose(found.angular, values.imag.max(), rtol=1e-9)


# sparse: the same systems behind a contract with sparse matrices


class Sparsely:
    """A contract whose matrices are sparse."""

    def __init__(self, model: cd.CompiledModel) -> None:
        self.inner, self.saddle = JointSystem(model), Sparse()

    def __getattr__(self, name: str) -> Any:
        return getattr(self.inner, name)

    def tangents(self, at: Moment) -> Tangents:
        found = self.inner.tangents(at)
        return Tangents(*(csr_array(x) for x in vars(found).values()))

    def stiffness(self, at: Moment) -> tuple[Any, Any]:
        found = self.tangents(at)
        return found.K, found.G


@pytest.fixture
def sparse(monkeypatch: pytest.MonkeyPatch) -> None:
    from cardan.analyses.linear import linearize, modes
    from cardan.analyses.statics import equilibrium, statics

    def contract(model: Any) -> DynamicSystem:
        return Sparsely(model)  # type: ignore[return-value]

    for module in (equilibrium, linearize, modes, statics):
        monkeypatch.setattr(module, "dynamic_system_of", contract)


@pytest.mark.usefixtures("sparse")
def test_sparse_modes() -> None:
    n, k = 30, np.arange(1, 7)
    found = row(n).modes(6)
    np.testing.assert_allclose(found.angular, 20 * np.sin(k * np.pi / (2 * (n + 1))), rtol=1e-9)
    np.testing.assert_allclose(found.effective_mass[3][1::2], 0, atol=1e-10)


@pytest.mark.usefixtures("sparse")
def test_sparse_damped_and_whirling_modes() -> None:
    found, free = row(30, damping=2.0).modes(4), 20 * np.sin(np.arange(1, 5) * np.pi / 62)
    # the spring to the wall has no damper: near the others
    np.testing.assert_allclose(np.abs(found.values), free, rtol=0.02)
    assert np.all(found.damping > 0)
    whirl = rotor().modes(u={"spin": 40.0})
    np.testing.assert_allclose(whirl.angular[~whirl.rigid], [3.9116498, 63.9116498], rtol=1e-6)


@pytest.mark.usefixtures("sparse")
def test_sparse_equilibria_and_paths() -> None:
    model = cd.compile(CLOSED["four_bar"].build())
    dense = cd.compile(CLOSED["four_bar"].build())
    held = model.equilibrium(locked={"A": 0.5})
    assert held.stable is None or held.converged
    found = model.equilibrium()
    reference = JointSystem(dense)
    assert isinstance(reference.saddle, Dense)
    np.testing.assert_allclose(dense.forward_dynamics(found.q, found.u), 0, atol=1e-8)
    path = model.statics(locked={"A": (0.5, 1.0)})
    assert path.success


# pictures and words


def test_a_mode_is_played(tmp_path: Path) -> None:
    found = row(3).modes()
    motion = found.motion(1, amplitude=0.1, periods=1.0)
    assert motion.t[-1] == pytest.approx(1 / found.frequencies[1])
    np.testing.assert_allclose(motion["s0"][0], 0.1 * found.shapes[0, 1], rtol=1e-12)
    # its speeds are the rates of its coordinates: a difference over two of 120 pictures misses
    # (2 pi / 120)^2 / 6 of the largest
    rates = np.gradient(motion.q, motion.t, axis=0)[1:-1]
    np.testing.assert_allclose(motion.u[1:-1], rates, atol=5e-4 * np.abs(motion.u).max())
    # of modal mass 1, after a quarter of the period
    assert motion.energy.kinetic[30] == pytest.approx((0.1 * found.angular[1]) ** 2 / 2, rel=1e-9)
    motion.save(tmp_path / "mode.nc")
    for read in (motion, cd.load_motion(tmp_path / "mode.nc")):
        assert "Hz, not integrated" in str(read)
        assert "unaccounted" not in str(read)
    page = found.animate(1, tmp_path / "mode.html")
    assert "mode 1" in page.html
    twist = found.twist(1, "b2")
    np.testing.assert_allclose(twist[3], found.shapes[:, 1].sum(), rtol=1e-12)


def test_picture(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    row(3).modes().plot(tmp_path / "modes.png")
    assert (tmp_path / "modes.png").read_bytes().startswith(b"\x89PNG")


def test_a_state_that_accelerates_is_told(double: cd.CompiledModel) -> None:
    with pytest.warns(cd.SolveWarning, match="accelerates .'elbow.u'|accelerates .'shoulder.u'"):
        double.modes(q={"shoulder": 1.0})


def test_a_part_without_mass_is_told() -> None:
    scene = cd.Scene("massless", gravity=(0, 0, 0))
    body = scene.body("body", mass=0.0)
    scene.joint("rail", cd.Prismatic("x"), scene.ground, body)
    scene.force("k", cd.JointForce("rail", -scene.q("rail")))
    model = cd.compile(scene)
    with pytest.raises(cd.CardanError, match="'rail' has mass or inertia"):
        model.modes(x=np.zeros(2))


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (lambda m: m.modes(0), "at least 1"),
        (lambda m: m.modes("two"), "at least 1"),
        (lambda m: m.modes().shape(7), "no mode 7"),
        (lambda m: m.modes().animate("one", "x.html"), "k='one': give a whole number"),
        (lambda m: m.modes(q={"sholder": 1}), "shoulder"),
    ],
)
def test_nonsense_is_refused(
    double: cd.CompiledModel, call: Callable[[Any], Any], said: str
) -> None:
    with pytest.raises(cd.CardanError, match=said):
        call(double)


@pytest.mark.parametrize("elements", [8, 16])
@pytest.mark.parametrize("ratio", [0.0, 1e-6, 0.02])
@pytest.mark.parametrize("length", [0.1, 10.0])
def test_free_beams_have_six_rigid_modes(elements: int, ratio: float, length: float) -> None:
    """Closed form of a free beam with a damping in proportion to stiffness; sparse matrices.

    Rigid bodies have pairs of eigenvalues 0, which rounding splits: they count once each.
    """
    E, rho, width, height = 7e10, 2700.0, 0.03 * length, 0.002 * length
    scene = cd.Scene("free", gravity=(0, 0, 0))
    section = cd.section.rectangle(width, height)
    slenderness = np.array([4.730040744862704, 7.853204624095838]) / length
    free = slenderness**2 * np.sqrt(E * height**2 / 12 / rho)
    damping = 2 * ratio / free[0]
    material = cd.material(E=E, nu=0.3, rho=rho, damping=damping)
    scene.beam("beam", (0, 0, 0), (length, 0, 0), section, material, elements=elements)
    frequencies = 2 * np.pi * np.asarray(cd.compile(scene).modes(8).frequencies)
    assert not frequencies[:6].any()
    expected = free * np.sqrt(1 - (0.5 * damping * free) ** 2)
    np.testing.assert_allclose(frequencies[6:], expected, rtol=3e-3)
