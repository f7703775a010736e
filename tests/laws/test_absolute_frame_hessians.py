"""Second derivatives of functions of frames by parameters of their places, in closed form."""

from __future__ import annotations

import itertools
from typing import Any

import numpy as np

import cardan as cd
from table import each

# how parameters are in the scene
VALUES = {"a": 0.4, "b": 0.7}
ROUNDING = 1e-12
# frames on a body of a rigid tree, on one with a node in space or in a plane, and on the ground
CARRIERS: dict[str, dict[str, Any]] = {
    "tree": {},
    "node": {"coordinates": "absolute"},
    "plane": {"coordinates": "absolute", "plane": "y"},
}


def swing(**options: Any) -> cd.CompiledModel:
    """A body at the tip of a bar on a hinge; frames are where products of parameters say."""
    scene = cd.Scene("swing", gravity=(0, 0, -9.81))
    a, b = (scene.parameter(name, value) for name, value in VALUES.items())
    hub = scene.body("hub", mass=0.2, inertia=(1e-3, 1e-3, 1e-3))
    scene.joint("hinge", cd.Revolute("y"), scene.ground, hub)
    material = cd.material(E=5e6, nu=0.45, rho=1100)
    section = cd.section.rectangle(0.03, 0.04)
    bar = scene.beam("bar", hub, (1, 0, 0), section, material, elements=1)
    tip = scene.body("tip", mass=0.1, inertia=(1e-3, 1e-3, 1e-3))
    scene.joint("wrist", cd.Revolute("y"), bar.end, tip)
    for name, carrier in (("sensor", tip), ("mark", scene.ground)):
        carrier.at(a * b, a**2 * b, b**3, rotation=("XYZ", a**2 * b, 0, 0), name=name)
    return cd.compile(scene, **options)


def second_of_place() -> tuple[Any, Any]:
    """Second derivatives by a and b of the axes (2, 2, 3, 3), and of the origin (2, 2, 3)."""
    a, b = VALUES.values()
    angle, slope = a**2 * b, np.array([2 * a * b, a**2])
    bend = np.array([[2 * b, 2 * a], [2 * a, 0]])
    s, c = np.sin(angle), np.cos(angle)
    by_angle = np.array([[0, 0, 0], [0, -s, -c], [0, c, -s]])
    twice = np.array([[0, 0, 0], [0, -c, s], [0, -s, -c]])
    axes = np.multiply.outer(bend, by_angle) + np.multiply.outer(np.outer(slope, slope), twice)
    of_x, of_z = np.array([[0, 1], [1, 0]]), np.array([[0, 0], [0, 6 * b]])
    return axes, np.stack([of_x, bend, of_z], axis=-1)


@each("carrier, frame", itertools.product(CARRIERS, ("sensor", "mark")))
def test_by_parameters_of_the_place(carrier: str, frame: str) -> None:
    """All functions are linear in the axes L and the origin e of the frame on its body:
    R L and R e, w x R e, w' x R e + w x (w x R e)."""
    model, rng = swing(**CARRIERS[carrier]), np.random.default_rng(3)
    q, u = model.split(model.initial())
    q = model.integrate(q, 0.2 * rng.uniform(-1, 1, model.nu))
    u, udot = rng.uniform(-1, 1, (2, model.nu))
    body = "tip" if frame == "sensor" else "ground"
    R = model.pose(body, q)[:3, :3]
    w, w_rate = model.velocity(body, q, u)[:3], model.acceleration(body, q, u, udot)[:3]
    J = model.frame_jacobian(body, q)[:3]
    axes, origin = second_of_place()
    arm = origin @ R.T
    # results (..., 2, 2), of which only some depend on the place
    pose, velocity, acceleration = (np.zeros((*size, 2, 2)) for size in ((4, 4), (6,), (6,)))
    jacobian = np.zeros((6, model.nu, 2, 2))
    pose[:3, :3] = np.einsum("ij,abjk->ikab", R, axes)
    pose[:3, 3] = np.moveaxis(arm, -1, 0)
    velocity[3:] = np.moveaxis(np.cross(w, arm), -1, 0)
    acceleration[3:] = np.moveaxis(np.cross(w_rate, arm) + np.cross(w, np.cross(w, arm)), -1, 0)
    jacobian[3:] = np.moveaxis(np.cross(J.T[:, None, None], arm), (-1, 0), (0, 1))
    rows = {
        "pose": (pose, (q,)),
        "velocity": (velocity, (q, u)),
        "acceleration": (acceleration, (q, u, udot)),
        "frame_jacobian": (jacobian, (q,)),
    }
    for function, (second, at) in rows.items():
        weights = rng.uniform(0.5, 1, second.shape[:-2])
        H = model.hessian((function, frame), wrt=tuple(VALUES))(*at, weights)
        expected = np.tensordot(weights, second, weights.ndim)
        assert np.abs(H - expected).max() <= ROUNDING * np.abs(weights).sum(), function
        # on the ground only the pose depends on where the frame is
        assert np.any(expected) == (body == "tip" or function == "pose"), function
