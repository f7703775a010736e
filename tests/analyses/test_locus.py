"""Families of linear models: loci, where stability changes, Campbell diagrams, sensitivities."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.analyses.linear.spectrum import spectrum
from spread import some

Array = np.ndarray
G = 9.81


def column() -> cd.Scene:
    """A bar on a spring and a damper, under a load that keeps its direction."""
    scene = cd.Scene("column", gravity=(0, 0, 0))
    P, c, k = (scene.parameter(n, v) for n, v in (("P", 0.5), ("c", 0.2), ("k", 2.0)))
    bar = scene.body("bar", mass=1.0, com=(0, 0, 0.5), inertia=(0.1, 0.1, 0.01))
    scene.joint("foot", cd.Revolute("y"), scene.ground, bar)
    scene.force("spring", cd.JointForce("foot", -k * scene.q("foot") - c * scene.u("foot")))
    scene.force("load", cd.Force(bar.at(0, 0, 1), (0, 0, -P)))
    return scene


@pytest.fixture(scope="module")
def bar() -> cd.CompiledModel:
    return cd.compile(column())


@pytest.mark.parametrize("damping", [0.0, 0.2])
def test_divergence(bar: cd.CompiledModel, damping: float) -> None:
    path = bar.root_locus(P=(0, 3), parameters={"c": damping}, count=8)
    (change,) = path.changes
    assert (change.kind, change.lost, change.frequency) == ("divergence", True, 0.0)
    assert change.values["P"] == pytest.approx(2.0, abs=1e-11)
    assert path.stable.tolist() == [p < 2 for p in path["P"]]
    # J s^2 + c s + k - P
    for P, values in zip(path["P"], path.eigenvalues, strict=True):
        np.testing.assert_allclose(np.sort_complex(values),
                                   np.sort_complex(np.roots([0.35, damping, 2.0 - P])),
                                   atol=1e-7)  # fmt: skip
    assert "divergence begins at P = 2" in repr(path)


def test_flutter_of_negative_damping(bar: cd.CompiledModel) -> None:
    (change,) = bar.root_locus({"c": np.linspace(-1, 3, 8)}).changes
    assert change.kind == "flutter"
    assert not change.lost
    assert change.values["c"] == pytest.approx(0.0, abs=1e-12)
    assert change.frequency == pytest.approx(math.sqrt(1.5 / 0.35), rel=1e-10)


def ziegler(follower: bool) -> cd.Scene:
    """Two links of length 1, masses 2 and 1 at their ends, springs of 1 N m, a load at the tip."""
    scene = cd.Scene("ziegler", gravity=(0, 0, 0))
    P = scene.parameter("P", 0.0)
    first, second = (scene.body(n, mass=m, com=(0, 0, 1)) for n, m in (("a", 2.0), ("b", 1.0)))
    scene.joint("a", cd.Revolute("y"), scene.ground, first)
    scene.joint("b", cd.Revolute("y"), first.at(0, 0, 1), second)
    for name in "ab":
        scene.force(f"k{name}", cd.JointForce(name, -scene.q(name)))
    tip = second.at(0, 0, 1)
    scene.force("load", cd.Force(tip, (0, 0, -P), in_=second if follower else None))
    return scene


def test_flutter_of_ziegler() -> None:
    model = cd.compile(ziegler(follower=True))
    path = model.root_locus(P=(0, 5), count=11)
    (begin,) = path.changes
    # Ziegler 1952: 2 w^4 - (7 - 2 P) w^2 + 1 = 0 with c / l = 1 and masses 2 and 1
    assert begin.values["P"] == pytest.approx((7 - math.sqrt(8)) / 2, rel=1e-10)
    assert begin.frequency == pytest.approx(2**-0.25, rel=1e-5)
    assert (begin.kind, begin.lost) == ("flutter", True)
    for P, values in zip(path["P"], path.eigenvalues, strict=True):
        squares = np.roots([2, 7 - 2 * P, 1])
        np.testing.assert_allclose(np.sort_complex(np.unique(np.round(values**2, 8))),
                                   np.sort_complex(np.round(squares, 8)), atol=3e-8)  # fmt: skip
    # the load that follows drives around, the dead one has a potential
    assert np.abs(path.members[5].linear.circulatory).max() > 0.1
    dead = cd.compile(ziegler(follower=False)).root_locus(P=(0, 1), count=5)
    assert np.abs(dead.members[2].linear.circulatory).max() < 1e-12
    assert dead.changes[0].kind == "divergence"


def test_eigenvalues_are_followed_where_they_cross() -> None:
    # two oscillators that know nothing of each other: frequencies cross, shapes do not change
    scene = cd.Scene("two", gravity=(0, 0, 0))
    k = scene.parameter("k", 1.0)
    for name, stiffness in (("still", 4.0), ("moved", k)):
        body = scene.body(name, mass=1.0)
        scene.joint(name, cd.Prismatic("x"), scene.ground, body)
        scene.force(f"spring_{name}", cd.JointForce(name, -stiffness * scene.q(name)))
    path = cd.compile(scene).root_locus(k=(1, 9), count=6)
    upper = path.eigenvalues[:, path.eigenvalues[0].imag > 0].imag
    by_start = upper[:, upper[0].argsort()]
    np.testing.assert_allclose(by_start[:, 0], np.sqrt(path["k"]), rtol=1e-10)
    np.testing.assert_allclose(by_start[:, 1], 2.0, rtol=1e-10)


# Campbell diagrams


def wheel(I: float, Ip: float, k: float) -> cd.Scene:
    """A disk that tilts on springs and spins."""
    scene = cd.Scene("wheel", gravity=(0, 0, 0))
    a, b = (scene.body(name, mass=0, inertia=(0, 0, 0)) for name in ("a", "b"))
    disk = scene.body("disk", mass=1.0, inertia=(I, I, Ip))
    scene.joint("tx", cd.Revolute("x"), scene.ground, a)
    scene.joint("ty", cd.Revolute("y"), a, b)
    scene.joint("spin", cd.Revolute("z"), b, disk)
    for name in ("tx", "ty"):
        scene.force(f"k{name}", cd.JointForce(name, -k * scene.q(name)))
    return scene


@pytest.mark.parametrize(("Ip", "way"), some([(0.9, -1), (0.3, 1), (0.9, 1), (0.3, -1)], 2))
def test_gyroscopic_splitting(Ip: float, way: int) -> None:
    inertia, k = 0.5, 200.0
    found = cd.compile(wheel(inertia, Ip, k)).campbell(spin=(0, 60 * way), count=13)
    for speed, row, whirl in zip(found.speed, found.frequencies, found.whirl, strict=True):
        # I w^2 - Ip W w - k: the positive root whirls forward
        roots = np.roots([inertia, -Ip * abs(speed), -k])
        np.testing.assert_allclose(np.sort(row), np.sort(np.abs(roots)), rtol=1e-10)
        if speed:
            np.testing.assert_allclose(np.sort(whirl), [-1, 1], atol=1e-9)
            assert whirl[row.argmax()] > 0
    expected = [math.sqrt(k / (inertia + Ip))]
    # forward there is one for bodies that are longer than wide
    expected += [math.sqrt(k / (inertia - Ip))] if Ip < inertia else []
    np.testing.assert_allclose(np.sort(np.abs(found.critical())), expected, rtol=1e-9)
    assert found.stable.all()
    assert "critical speeds" in repr(found)


def jeffcott(turning: bool) -> cd.Scene:
    """A disk on a shaft that bends, with dampers outside and inside, in fixed or turning axes."""
    scene = cd.Scene("jeffcott", gravity=(0, 0, 0))
    bodies = [scene.body(name, mass=0, inertia=(0, 0, 0)) for name in ("a", "b")[: 2 - turning]]
    disk = scene.body("disk", mass=2.0, inertia=(0.1, 0.1, 0.2))
    if turning:
        hub = scene.body("hub", mass=1.0, inertia=(0.1, 0.1, 0.2))
        scene.joint("spin", cd.Revolute("z"), scene.ground, hub)
        scene.joint("x", cd.Prismatic("x"), hub, bodies[0])
        scene.joint("y", cd.Prismatic("y"), bodies[0], disk)
    else:
        scene.joint("x", cd.Prismatic("x"), scene.ground, bodies[0])
        scene.joint("y", cd.Prismatic("y"), bodies[0], bodies[1])
        scene.joint("spin", cd.Revolute("z"), bodies[1], disk)
    x, y, vx, vy, W = (scene.q("x"), scene.q("y"), scene.u("x"), scene.u("y"), scene.u("spin"))
    # a damper of 0.5 in the axes of the coordinates, and one in axes that turn against them
    other = -W if turning else W
    along = -800 * x - 0.5 * vx - 0.5 * (vx + other * y)
    across = -800 * y - 0.5 * vy - 0.5 * (vy - other * x)
    scene.force("fx", cd.JointForce("x", along))
    scene.force("fy", cd.JointForce("y", across))
    return scene


@pytest.mark.parametrize("turning", [False, True])
def test_damping_inside_a_shaft(turning: bool) -> None:
    model = cd.compile(jeffcott(turning))
    found = model.campbell(spin=(4, 60), count=12, locked={"spin": 0.0}, corotating=turning)
    # beyond w (1 + outer / inner) damping that turns along drives
    (change,) = found.locus.changes
    assert change.values["spin"] == pytest.approx(40.0, rel=1e-6)
    assert (change.kind, change.lost) == ("flutter", True)
    # seen from the ground both whirl at about w, at all speeds
    np.testing.assert_allclose(found.frequencies, 20.0, rtol=1e-3)
    np.testing.assert_allclose(found.critical()[:1], 20.0, rtol=1e-3)
    forward = found.whirl[-1].argmax()
    assert found.values[-1, forward].real > 0


def test_motions_on_the_line_do_not_cross_it() -> None:
    """In axes of the body turns of the whole keep to the line of the spin; nutation crosses it."""
    scene = cd.Scene("gyrostat", gravity=(0, 0, 0))
    I1, I2, I3, h = 4.0, 4.2, 3.6, 3.0
    bus = scene.body("bus", mass=1.0, inertia=(I1, I2, I3))
    scene.joint("attitude", cd.Spherical(), scene.ground, bus)
    scene.force("wheel", cd.Rotor(bus, axis="z", momentum=h))
    found = cd.compile(scene).campbell({"attitude.u.z": (0, 3)}, count=16)
    # ((I3 - I1) n + h) ((I3 - I2) n + h) = I1 I2 n^2
    roots = np.roots([(I3 - I1) * (I3 - I2) - I1 * I2, (2 * I3 - I1 - I2) * h, h**2])
    # beside it both motions are next to the line: which is meant is told to some 1e-6 only
    assert found.critical() == pytest.approx([n for n in roots if n > 0], rel=1e-5)


@pytest.mark.slow
def test_shaft_of_a_beam() -> None:
    EI, length, m, across, along = 100.0, 1.0, 2.0, 0.02, 0.035
    section = cd.section.general(EA=1e7, GA=1e10, GJ=1e3, EI=EI, rhoA=1e-6, rhoI=1e-12)
    scene = cd.Scene("shaft", gravity=(0, 0, 0))
    hub = scene.body("hub", mass=1, inertia=(1, 1, 1))
    scene.joint("drive", cd.Revolute("z"), scene.ground, hub)
    beam = scene.beam("shaft", hub, (0, 0, length), section, elements=1)
    # x of the beam's end goes along it
    disk = scene.body("disk", mass=m, inertia=(along, across, across))
    scene.joint("keyed", cd.Fixed(), beam.end, disk)
    found = cd.compile(scene).campbell(drive=(0, 60), locked={"drive": 0}, count=4)
    assert found.corotating
    K = EI * np.array([[12 / length**3, -6 / length**2], [-6 / length**2, 4 / length]])
    M = np.diag([m, across])
    for speed, row, whirl in zip(found.speed, found.frequencies, found.whirl, strict=True):
        # w^2 M z = K z + w W G z of complex displacement and slope, seen from the ground
        G = np.diag([0, along * speed])
        below = np.hstack([np.linalg.solve(M, K), np.linalg.solve(M, G)])
        for way in np.linalg.eigvals(np.vstack([np.eye(2, 4, 2), below])).real:
            nearest = int(np.abs(row - abs(way)).argmin())
            assert row[nearest] == pytest.approx(abs(way), rel=3e-6)
            if speed:
                assert whirl[nearest] == pytest.approx(np.sign(way), abs=1e-3)


def test_pictures(bar: cd.CompiledModel, tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    bar.root_locus(P=(0, 3), count=5).plot(tmp_path / "locus.png")
    linear = bar.linearize(inputs=["foot"], outputs=["foot"])
    linear.plot(tmp_path / "bode.svg")
    cd.compile(wheel(0.5, 0.3, 200.0)).campbell(spin=(0, 60), count=5).plot(
        tmp_path / "campbell.pdf", orders=(1, 2)
    )
    assert all((tmp_path / n).stat().st_size for n in ("locus.png", "bode.svg", "campbell.pdf"))
    with pytest.raises(cd.ModelError, match="no such input: 'fot'"):
        linear.plot(inputs=["fot"])


# sensitivities


def test_sensitivities_in_closed_form(bar: cd.CompiledModel) -> None:
    found = bar.sensitivity(["P", "c", "k", "bar.mass"])
    value, J, c = found.eigenvalues[0], 0.35, 0.2
    below = 2 * J * value + c
    for name, expected in (("P", 1 / below), ("c", -value / below), ("k", -1 / below),
                           ("bar.mass", -(value**2) * 0.25 / below)):  # fmt: skip
        assert found[name][0] == pytest.approx(expected, rel=1e-9)
    assert found.errors.max() < 1e-8
    assert "bar.mass" in repr(found)


def test_sensitivity_of_a_motion_that_moves_along() -> None:
    scene = cd.Scene("cone", gravity=(0, 0, -G))
    shaft = scene.body("shaft", mass=0.1, inertia=(0.1, 0.1, 0.1))
    bob = scene.body("bob", mass=1.0, com=(0, 0, -0.8))
    scene.joint("turn", cd.Revolute("z"), scene.ground, shaft)
    scene.joint("swing", cd.Revolute("y"), shaft, bob, q0=1.0)
    model = cd.compile(scene)
    rest = model.equilibrium(q={"swing": 1.0}, u={"turn": 5.0}, locked={"turn": 0.0})
    found = model.sensitivity(["gravity.z"], rest)
    # at this speed cos = g / (l W^2); w = W sin: with the shaft held to its speed
    g, length, W = G, 0.8, 5.0
    cosine = g / (length * W**2)
    slope = -W * cosine / math.sqrt(1 - cosine**2) / (length * W**2)
    assert found.eigenvalues[0].imag == pytest.approx(W * math.sqrt(1 - cosine**2), rel=1e-12)
    # gravity.z is -g
    assert found["gravity.z"][0] == pytest.approx(-1j * slope, rel=1e-8)
    # trimmed to stay at its angle the speed moves instead: w = sqrt(g / (l cos)) sin
    trimmed = model.trim({"swing": 1.0}, free=["turn.u"], u={"turn": 5.0})
    value = model.sensitivity(["gravity.z"], trimmed)
    moving = int(value.eigenvalues.imag.argmax())
    other = trimmed.linear.eigenvalues[moving]
    assert value["gravity.z"][moving] == pytest.approx(other / (2 * -G), rel=1e-8)


# eigenvalues without vectors of their own


def test_defective_eigenvalues_are_marked() -> None:
    scene = cd.Scene("free", gravity=(0, 0, 0))
    body = scene.body("body", mass=2.0)
    scene.joint("rail", cd.Prismatic("x"), scene.ground, body)
    model = cd.compile(scene)
    linear = model.linearize()
    assert linear.spectrum.defective.all()
    assert linear.stable
    assert linear.drifts
    assert "some drift" in repr(linear)
    assert np.isnan(linear.participation).all()
    found = model.sensitivity(["body.mass"])
    assert np.isnan(found.values).all()
    assert "defective" in repr(found)


@pytest.mark.parametrize("scale", [1.0, 1e-6, 1e6])
def test_spectrum(scale: float) -> None:
    rng = np.random.default_rng(5)
    V = rng.normal(size=(5, 5))
    blocks = np.diag([-1.0, -1.0, 2.0, 0.0, -3.0])
    A = scale * V @ blocks @ np.linalg.inv(V)
    found = spectrum(A, np.ones(5))
    # a double one with two vectors is not defective
    assert not found.defective.any()
    np.testing.assert_allclose(found.left.conj().T @ found.right, np.eye(5), atol=1e-8)
    np.testing.assert_allclose(A @ found.right, found.right * found.values, atol=1e-12 * scale)
    # where both leave each other
    dA = scale * V @ np.diag([1.0, 3.0, 0.5, 0.1, 0.0]) @ np.linalg.inv(V)
    double = np.abs(found.values + scale) < 1e-6 * scale
    np.testing.assert_allclose(np.sort(found.derivative(dA)[double].real), [scale, 3 * scale],
                               rtol=1e-7)  # fmt: skip
    blocks[0, 1] = 1.0
    jordan = spectrum(scale * V @ blocks @ np.linalg.inv(V), np.ones(5))
    assert jordan.defective.sum() == 2
    assert np.isnan(jordan.derivative(dA)[jordan.defective]).all()
    assert not np.isnan(jordan.derivative(dA)[~jordan.defective]).any()


# what is refused


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (lambda m: m.root_locus(), "say what changes"),
        (lambda m: m.root_locus(PP=(0, 1)), "Did you mean 'P'"),
        (lambda m: m.root_locus(P=3), r"give \(start, end\)"),
        (lambda m: m.root_locus(P=(0, math.inf)), "finite"),
        (lambda m: m.root_locus(P=[0, 1, 2], k=[1, 2, 3, 4]), "goes together"),
        (lambda m: m.root_locus(P=(0, 1), count=1), "at least 2"),
        (lambda m: m.root_locus(P=(0, 1), coordinates=["fot"]), "Did you mean 'foot'"),
        (lambda m: m.sensitivity(["PP"]), "Did you mean 'P'"),
        (
            lambda m: m.sensitivity(["P"], np.zeros(2)),
            "about=.*give an Equilibrium or a SteadyMotion",
        ),
        (lambda m: m.sensitivity(["P"])["k"], "not asked for"),
        (lambda m: m.linearize().shape(7), "no number 7"),
    ],
)
def test_nonsense_is_refused(bar: cd.CompiledModel, call: Callable[[Any], Any], said: str) -> None:
    with pytest.raises(cd.CardanError, match=said):
        call(bar)


def test_a_locus_keeps_what_it_has() -> None:
    # beyond some speed the governor's arm is thrown out of its stop: no equilibrium
    scene = cd.Scene("magnet", gravity=(0, 0, 0))
    F = scene.parameter("F", 0.0)
    body = scene.body("body", mass=1.0)
    scene.joint("x", cd.Prismatic("x"), scene.ground, body)
    x = scene.q("x")
    # the spring gives way beyond x = 1: at most 2 / 3 N
    scene.force("spring", cd.JointForce("x", -(x - x**3 / 3) - 0.1 * scene.u("x") + F))
    model = cd.compile(scene)
    with pytest.warns(cd.SolveWarning, match="ends behind F = 0.6"):
        path = model.root_locus(F=(0, 1), count=11)
    assert path["F"][-1] == pytest.approx(0.6)
    with pytest.raises(cd.SolveError, match="ends behind"):
        model.root_locus(F=(0, 1), count=11, check=True)
