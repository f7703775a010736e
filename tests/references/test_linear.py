"""Published linear models, by linearization of nonlinear scenes."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from spread import some

# which eigenvalues are exactly 0 is a matter of rounding
pytestmark = pytest.mark.optimized

HERE = Path(__file__).parent
BICYCLE = HERE.parents[1] / "src" / "cardan" / "scenes" / "bicycle.yaml"
G = 9.81
Array = np.ndarray


def reference(name: str) -> dict[str, Any]:
    return json.loads((HERE / f"{name}.json").read_text(encoding="utf-8"))


def alike(found: Array, expected: Array, tolerance: float) -> None:
    """Equal as sets."""
    left = list(expected)
    assert len(found) == len(left)
    for value in found:
        nearest = int(np.argmin(np.abs(np.array(left) - value)))
        assert abs(left.pop(nearest) - value) < tolerance


# the bicycle of Meijaard, Papadopoulos, Ruina and Schwab

BOTH = ("rear_contact.lean", "steer")
SPEEDS = reference("bicycle_linear")["reference"]["eigenvalues_by_speed"]


@pytest.fixture(scope="module")
def bicycle() -> cd.CompiledModel:
    return cd.compile(cd.load(BICYCLE))


def upright(model: cd.CompiledModel, speed: float) -> Any:
    """Straight ahead."""
    return model.trim({"rear_contact.lean": 0.0, "rear_hub.u": -speed / 0.3}, check=True)


def test_matrices_of_the_bicycle(bicycle: cd.CompiledModel) -> None:
    known = reference("bicycle_linear")["reference"]
    # steering is about an axis that points up here
    turned = np.diag([1.0, -1.0])
    at = {v: upright(bicycle, v).linear.second_order(BOTH) for v in (0.0, 5.0, 10.0)}
    K0 = at[0.0].K
    for v, found in at.items():
        matrices = {"M": found.M, "K0": K0 / G}
        if v > 0:
            matrices |= {"C1": found.damping / v, "K2": (found.K - K0) / v**2}
        for name, matrix in matrices.items():
            expected = np.array(known[name])
            off = np.abs(turned @ matrix @ turned - expected).max() / np.abs(expected).max()
            print(f"{name} at {v:g} m/s: {off:.1e}")
            assert off < 1e-12
    assert np.abs(at[0.0].damping).max() < 1e-12


@pytest.mark.parametrize("speed", SPEEDS)
def test_eigenvalues_of_the_bicycle(bicycle: cd.CompiledModel, speed: str) -> None:
    expected = np.array([complex(*pair) for pair in SPEEDS[speed]])
    found = upright(bicycle, float(speed)).linear.eigenvalues
    # all that is left of the other motions is drift: exactly 0
    alike(found[np.abs(found) > 0], expected, 1e-11 * np.abs(expected).max())


def test_speeds_at_which_the_bicycle_is_stable(bicycle: cd.CompiledModel) -> None:
    known = reference("bicycle_linear")["reference"]
    wanted = {"rear_contact.lean": 0.0, "rear_hub.u": (-3 / 0.3, -7 / 0.3)}
    path = bicycle.root_locus(targets=wanted, count=9)
    weave, capsize = path.changes
    assert (weave.kind, weave.lost) == ("flutter", False)
    assert (capsize.kind, capsize.lost) == ("divergence", True)
    # published to 12 places
    for change, name in ((weave, "v_weave"), (capsize, "v_capsize")):
        assert -0.3 * change.values["rear_hub.u"] == pytest.approx(known[name], abs=1e-11)


# a satellite that faces the earth

INERTIAS = ((10.0, 12.0, 5.0), (12.0, 10.0, 5.0), (10.0, 5.0, 12.0), (9.0, 10.0, 2.0))


def satellite(kind: str) -> cd.Scene:
    """x flies ahead, z points down, y is against the orbit's normal; orbit rate 1."""
    scene = cd.Scene("satellite", gravity=(0, 0, 0))
    orbit = scene.body("orbit", mass=0, inertia=(0, 0, 0))
    inertia = [
        scene.parameter(f"I{axis}", value) for axis, value in zip("xyz", INERTIAS[0], strict=True)
    ]
    body = scene.body("body", mass=1.0, inertia=inertia)
    scene.joint("circle", cd.Revolute("y"), scene.ground, orbit, prescribed=-cd.t)
    scene.joint("attitude", cd.Spherical(rotation="XYZ"), orbit.at(0, 0, -1), body)
    if kind == "element":
        pull = cd.GravityGradient(scene.ground, 1.0, bodies=body, force=False)
        scene.force("gradient", pull)
    else:
        down = body.rotation(wrt=orbit)[2, :]
        arm = [inertia[k] * down[k] for k in range(3)]
        torque = [3 * (down[(k + 1) % 3] * arm[(k + 2) % 3] - down[(k + 2) % 3] * arm[(k + 1) % 3])
                  for k in range(3)]  # fmt: skip
        scene.force("gradient", cd.Torque(body, torque, in_=body))
    return scene


@pytest.mark.parametrize("kind", ["written", "element"])
def test_satellite_in_a_gradient_of_gravity(kind: str) -> None:
    model = cd.compile(satellite(kind))
    for number, (Ix, Iy, Iz) in enumerate(INERTIAS):
        parameters = {"Ix": Ix, "Iy": Iy, "Iz": Iz}
        found = model.linearize(model.equilibrium(u={}, parameters=parameters))
        kP, kR, kY = (Ix - Iz) / Iy, (Iy - Iz) / Ix, (Iy - Ix) / Iz
        square = np.roots([1, 1 + 3 * kR + kR * kY, 4 * kR * kY]).astype(complex)
        squares = np.concatenate([[-3 * kP], square])
        expected = np.concatenate([np.sqrt(squares), -np.sqrt(squares)])
        alike(found.eigenvalues, expected, 1e-10)
        inside = kR * kY > 0 and 1 + 3 * kR + kR * kY > 4 * np.sqrt(kR * kY)
        assert found.stable is bool(Ix > Iz and inside)
        assert found.acceleration < 1e-12
        if number == 0:
            pitch, others = reference("gravity_gradient")["reference"]["I10_12_5"]
            values = np.sort(found.eigenvalues.imag)[3:]
            assert values[1] == pytest.approx(complex(pitch).real, abs=1e-12)
            known = [complex(x).real for x in others.strip("[]").split()]
            assert values[[2, 0]] == pytest.approx(known, abs=1e-8)


# a platform with a rotor

I1, I2, I3, AXIAL = 4.0, 5.0, 3.0, 0.5


def gyrostat(damped: bool = False) -> cd.Scene:
    """A platform with principal moments I1, I2, I3 together with its rotor along z."""
    scene = cd.Scene("gyrostat", gravity=(0, 0, 0))
    platform = scene.body("platform", mass=1, inertia=(I1 - 0.3, I2 - 0.3, I3 - AXIAL))
    rotor = scene.body("rotor", mass=1, inertia=(0.3, 0.3, AXIAL))
    scene.joint("attitude", cd.Spherical(), scene.ground, platform)
    scene.joint("rotor", cd.Revolute("z"), platform, rotor)
    if damped:
        for side in (1, -1):
            ball = scene.body(f"ball{side}", mass=0.05)
            name = f"damper{side}"
            scene.joint(name, cd.Prismatic("z"), platform.at(side, 0, 0), ball)
            force = -0.05 * scene.q(name) - 0.1 * scene.u(name)
            scene.force(name, cd.JointForce(name, force))
    return scene


@pytest.fixture(scope="module")
def spun() -> cd.CompiledModel:
    return cd.compile(gyrostat())


@pytest.mark.parametrize("nu", [1.0, -0.7])
@pytest.mark.parametrize("spin", [-20.0, 2.5, 3.0, 3.6, 12.0])
def test_gyrostat(spun: cd.CompiledModel, nu: float, spin: float) -> None:
    found = spun.linearize(u={"attitude.u.z": nu, "rotor": spin})
    along = I3 * nu + AXIAL * spin
    square = (along - I1 * nu) * (along - I2 * nu) / (I1 * I2)
    nutation = np.sqrt(complex(-square))
    moving = found.eigenvalues[np.abs(found.eigenvalues) > 1e-6]
    # in the turning axes of the platform; from outside at nu more: direction of momentum
    alike(moving, [nutation, -nutation, 1j * nu, -1j * nu], 1e-10)
    assert found.stable is bool(square > 0)


def test_limits_of_the_gyrostat(spun: cd.CompiledModel) -> None:
    path = spun.root_locus(rotor=(0.0, 8.0), u={"attitude.u.z": 1.0})
    # between momenta of I1 nu and I2 nu it tumbles
    limits = [(moment - I3) / AXIAL for moment in (I1, I2)]
    assert [change.values["rotor"] for change in path.changes] == pytest.approx(limits, rel=1e-8)
    assert [change.lost for change in path.changes] == [True, False]


@pytest.mark.parametrize(("spin", "stable"), [(12.0, True), (-1.0, False), (1.0, False)])
def test_a_damper_on_the_platform(spin: float, stable: bool) -> None:
    model = cd.compile(gyrostat(damped=True))
    found = model.linearize(u={"attitude.u.z": 1.0, "rotor": spin})
    # Landon and Iorillo: (I3 nu + h) / nu against the larger of the others, with the balls
    ratio = I3 + 0.1 + AXIAL * spin
    assert (ratio > I2 + 0.1) is stable
    assert found.stable is stable


# the sleeping top


@pytest.mark.parametrize(
    ("Ia", "It", "m", "length"), some([(0.1, 0.5, 2.0, 0.4), (0.6, 0.5, 1.0, 0.3)], 2)
)
def test_sleeping_top(Ia: float, It: float, m: float, length: float) -> None:
    scene = cd.Scene("top", gravity=(0, 0, -G))
    center = It - m * length**2
    top = scene.body("top", mass=m, com=(0, 0, length), inertia=(center, center, Ia))
    scene.joint("tip", cd.Spherical(), scene.ground, top)
    model = cd.compile(scene)
    limit = np.sqrt(4 * It * m * G * length) / Ia
    for factor, stable in ((1 - 1e-6, False), (1 + 1e-6, True)):
        assert model.linearize(u={"tip.u.z": factor * limit}).stable is stable
    (change,) = model.root_locus({"tip.u.z": (0.5 * limit, 1.7 * limit)}, count=7).changes
    print(f"off by {change.values['tip.u.z'] / limit - 1:.1e}")
    assert change.values["tip.u.z"] == pytest.approx(limit, rel=1e-10)
    assert (change.kind, change.lost) == ("flutter", False)


# the coin that rolls upright


@pytest.mark.parametrize("r", some([0.1, 0.35], 2))
def test_upright_coin(r: float) -> None:
    scene = cd.Scene("coin", gravity=(0, 0, -G))
    disk = scene.body("disk", mass=2.0, inertia=(r**2 / 2, r**2, r**2 / 2))
    scene.joint("rolls", cd.RollingDisk(r), scene.ground, disk)
    model = cd.compile(scene)
    limit = np.sqrt(G * r / 3)
    straight = {"rolls.lean": 0.0, "rolls.u.yaw": 0.0}
    for factor, stable in ((1 - 1e-6, False), (1 + 1e-6, True)):
        found = model.trim({**straight, "rolls.u.spin": factor * limit / r}, check=True)
        assert found.stable is stable
    spin = (0.5 * limit / r, 1.8 * limit / r)
    (change,) = model.root_locus(targets={**straight, "rolls.u.spin": spin}, count=7).changes
    v = change.values["rolls.u.spin"] * r
    print(f"off by {v / limit - 1:.1e}")
    assert v**2 == pytest.approx(G * r / 3, rel=1e-8)
    assert (change.kind, change.lost) == ("divergence", False)
