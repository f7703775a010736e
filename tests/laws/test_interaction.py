"""Forces with states of their own, and laws of control that hold a model of what they move."""

from __future__ import annotations

import functools

import numpy as np
import sympy as sp

import cardan as cd

TIGHT = {"rtol": 1e-11, "atol": 1e-12}
K, C = 30.0, 6.0


def strut(length: float = 0.5) -> cd.Scene:
    """A strut between the ground and a carriage."""
    scene = cd.Scene("strut", gravity=(0, 0, 0))
    carriage = scene.body("carriage", mass=2.0)
    scene.joint("x", cd.Prismatic("x"), scene.ground.at(length, 0, 0), carriage)
    scene.force("strut", cd.Maxwell(scene.ground, carriage, K, C, rest_length=length))
    return scene


def test_force_of_a_strut_drawn_steadily() -> None:
    """It rises to damping times speed as 1 - exp(-k t / c)."""
    scene = strut()
    scene.joints.clear()
    carriage, v = scene.bodies["carriage"], 0.3
    scene.joint("x", cd.Prismatic("x"), scene.ground.at(0.5, 0, 0), carriage, prescribed=v * cd.t)
    motion = cd.compile(scene).simulate(2.0, **TIGHT)
    force = C * v * (1 - np.exp(-K / C * motion.t))
    np.testing.assert_allclose(motion["strut.flow"], v * motion.t - force / K, atol=1e-10)
    # what the motion of the carriage gives: the integral of that force
    given = C * v**2 * (motion.t - force / (K * v))
    np.testing.assert_allclose(motion.work["x.motion"], given, atol=1e-9)


def test_free_carriage_on_a_strut() -> None:
    """The modes of m, k and c in series: one creeps, two swing; the ledger has what it took."""
    model = cd.compile(strut())
    values = np.sort_complex(np.linalg.eigvals(model.linearize().A))
    # m x'' = -k (x - y), c y' = k (x - y): x keeps nothing of where it was
    wanted = np.sort_complex(np.concatenate([[0.0], np.roots([2.0 * C, 2.0 * K, K * C])]))
    np.testing.assert_allclose(values, wanted, atol=1e-10)
    motion = model.simulate(3.0, u={"x": 1.0}, **TIGHT)
    assert np.abs(motion.energy_residual).max() < 1e-9
    assert motion.work["strut"][-1] < -0.5


def arm() -> cd.Scene:
    """Two links under gravity, driven in both joints."""
    scene = cd.Scene("arm", gravity=(0, 0, -9.81))
    upper = scene.body("upper", mass=3.0, com=(0.25, 0, 0), inertia=(0.01, 0.07, 0.07))
    lower = scene.body("lower", mass=1.5, com=(0.2, 0, 0), inertia=(0.005, 0.03, 0.03))
    scene.joint("shoulder", cd.Revolute("y"), scene.ground, upper)
    scene.joint("elbow", cd.Revolute("y"), upper.at(0.5, 0, 0), lower)
    return scene


KP, KD = 36.0, 9.0
START = np.array([0.3, -0.2])


def wanted(t: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Path, its rate and acceleration."""
    size, rate = np.array([0.8, -0.6]), np.array([1.3, 2.1])
    angle = rate * t
    return size * np.sin(angle), size * rate * np.cos(angle), -size * rate**2 * np.sin(angle)


def error(t: np.ndarray) -> np.ndarray:
    """Of e'' + kd e' + kp e = 0 from START at rest."""
    a, b = np.roots([1.0, KD, KP])
    return START * ((b * np.exp(a * t) - a * np.exp(b * t)) / (b - a)).real[:, None]


def controlled() -> tuple[cd.Scene, cd.Equations]:
    """The arm with the law of the computed torque as an expression, and the arm alone."""
    alone = cd.derive(arm())
    scene, names = arm(), ("shoulder", "elbow")
    e, ed, acceleration = [], [], []
    for k, name in enumerate(names):
        size, rate = (0.8, -0.6)[k], (1.3, 2.1)[k]
        path = size * sp.sin(rate * cd.t)
        e.append(path - scene.q(name))
        ed.append(path.diff(cd.t) - scene.u(name))
        acceleration.append(path.diff(cd.t, 2) + KD * ed[-1] + KP * e[-1])
    numbers = {sp.Symbol(p.name): p.value for p in alone.system.parameters}
    torque = (alone.mass_matrix * sp.Matrix(acceleration) + alone.bias).subs(numbers)
    for name, law in zip(names, torque, strict=True):
        scene.force(f"{name}_motor", cd.JointForce(name, law))
    return scene, alone


def test_computed_torque_as_an_expression() -> None:
    """The error falls as the law says, to the accuracy of the run."""
    motion = cd.compile(controlled()[0]).simulate(2.0, **started())
    found = np.array([wanted(t)[0] for t in motion.t]) - motion.q
    np.testing.assert_allclose(found, error(motion.t), atol=2e-9)


def test_computed_torque_by_sampled_inverse_dynamics() -> None:
    """Torques from inverse dynamics of the same model, held between samples."""
    scene = arm()
    for name in ("shoulder", "elbow"):
        scene.force(f"{name}_motor", cd.JointForce(name, scene.input(f"{name}_torque")))
    model, inner = cd.compile(scene), cd.compile(arm())
    worst = []
    for sample in (4e-3, 2e-3):

        def law(t: float, x: np.ndarray, k: int) -> float:
            q, u = x[:2], x[2:]
            path, rate, acceleration = wanted(t)
            wished = acceleration + KD * (rate - u) + KP * (path - q)
            return float(inner.inverse_dynamics(q, u, wished)[k])

        inputs = {
            "shoulder_torque": functools.partial(law, k=0),
            "elbow_torque": functools.partial(law, k=1),
        }
        motion = model.simulate(1.0, inputs=inputs, sample=sample, **started())
        found = np.array([wanted(t)[0] for t in motion.t]) - motion.q
        worst.append(np.abs(found - error(motion.t)).max())
    assert worst[0] < 0.02
    assert 1.9 < worst[0] / worst[1] < 2.1


def started() -> dict[str, object]:
    """Off the path by START, with its rate."""
    path, rate, _ = wanted(0.0)
    q, names = path - START, ("shoulder", "elbow")
    return {
        "q": dict(zip(names, q, strict=True)),
        "u": dict(zip(names, rate, strict=True)),
        **TIGHT,
    }
