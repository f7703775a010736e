"""Trees on slides far from where these begin: kernels give the digits that they give near by.

No entry depends on where slides that stand on the ground have moved what they carry. Sums about the
place where the first one begins would lose what its square is above the square of the arm.
"""

from __future__ import annotations

import numpy as np

import cardan as cd
from table import each

EPS = np.finfo(float).eps
FAR = 1e6  # m
JOINTS = 9  # of an arm: with its slides enough pairs of speeds for the kernel


def add_arm(scene: cd.Scene, name: str, base: cd.Body, first: object) -> None:
    for i in range(JOINTS):
        link = scene.body(f"{name}{i}", 1.0, com=(0.1, 0.05, -0.3), inertia=(0.02, 0.03, 0.01))
        joint = cd.Revolute("xyz"[i % 3]) if i else first
        scene.joint(f"{name}.j{i}", joint, base.at(0.1, 0, -0.6), link)
        base = link


def gantry(branched: bool) -> cd.CompiledModel:
    """An arm on three slides, and a second one on its own trolley on the first slide."""
    scene = cd.Scene("gantry", gravity=(0, 0, -9.81))
    base, rail = scene.ground, scene.ground
    for axis in "xyz":
        slide = scene.body(f"slide_{axis}", 0.5, com=(0.1, 0, 0), inertia=(0.1, 0.1, 0.1))
        scene.joint(axis, cd.Prismatic(axis), base, slide)
        rail = slide if axis == "x" else rail
        base = slide
    add_arm(scene, "arm", base, cd.Revolute("x"))
    if branched:
        trolley = scene.body("trolley", 0.7, com=(0.1, 0, 0), inertia=(0.1, 0.2, 0.1))
        scene.joint("trolley", cd.Translation(), rail, trolley)
        add_arm(scene, "other", trolley, cd.Spherical())
    functions = ("mass_matrix", "inverse_dynamics", "derivative", "integrate")
    return cd.compile(scene, functions=functions, loops=True)


@each("branched", [False, True])
def test_far_slides_change_nothing(branched: bool) -> None:
    model = gantry(branched)
    rng = np.random.default_rng(8)
    names = [row.name for row in model.manifest.coordinates]
    slides = [k for k, n in enumerate(names) if n in "xyz" or n.startswith("trolley")]
    assert len(slides) == (6 if branched else 3)
    q, (u, udot) = rng.uniform(-1, 1, model.nq), rng.uniform(-1, 1, (2, model.nu))
    if branched:
        turns = [k for k, n in enumerate(names) if n.startswith("other.j0")]
        q[turns] /= np.linalg.norm(q[turns])
    q[slides] = 0
    far = q.copy()
    far[slides] = FAR * rng.uniform(0.5, 1, len(slides))

    # M against unit accelerations in Newton and Euler's recursion
    n, M = model.nu, model.mass_matrix(q)
    assert "tree_mass.h" in model.manifest.functions["mass_matrix"].headers
    still = model.inverse_dynamics(q, np.zeros(n), np.zeros(n))
    by_unit = [model.inverse_dynamics(q, np.zeros(n), e) - still for e in np.eye(n)]
    size = np.abs(M).max() + np.abs(still).max()
    np.testing.assert_allclose(M, by_unit, rtol=0, atol=20 * n * EPS * size)
    np.testing.assert_allclose(model.mass_matrix(far), M, rtol=0, atol=n * EPS * np.abs(M).max())

    # slopes against differences, whose error is that of rounding over h, and of h^2
    slope = model.derivative("inverse_dynamics", wrt=("q", "u"))
    near_by = slope(q, u, udot)
    h = 1e-5
    for k in range(n):
        e = h * np.eye(n)[k]
        change = model.inverse_dynamics(q, u + e, udot) - model.inverse_dynamics(q, u - e, udot)
        scale = np.abs(near_by[1]).max()
        np.testing.assert_allclose(near_by[1][:, k], change / (2 * h), rtol=0, atol=1e-8 * scale)
        moved = (model.integrate(q, x) for x in (e, -e))
        after, before = (model.inverse_dynamics(x, u, udot) for x in moved)
        scale = np.abs(near_by[0]).max()
        slopes = (after - before) / (2 * h)
        np.testing.assert_allclose(near_by[0][:, k], slopes, rtol=0, atol=1e-8 * scale)
    for distant, near in zip(slope(far, u, udot), near_by, strict=True):
        np.testing.assert_allclose(distant, near, rtol=0, atol=n * EPS * np.abs(near).max())


@each("slide", [cd.Prismatic("x"), cd.Translation(), cd.Free()])
def test_a_slide_on_a_body_that_rotates_keeps_the_digits_of_what_it_carries(slide: object) -> None:
    """M does not depend on where a slide has moved a body about the axes of that body's own arm."""
    scene = cd.Scene("boom", gravity=(0, 0, -9.81))
    add_arm(scene, "boom", scene.ground, cd.Revolute("x"))
    carriage = scene.body("carriage", 0.5, com=(0.1, 0, 0), inertia=(0.1, 0.1, 0.1))
    scene.joint("slide", slide, scene.bodies["boom8"], carriage)
    add_arm(scene, "arm", carriage, cd.Revolute("y"))
    model = cd.compile(scene, functions=("mass_matrix",), loops=True)
    q = np.zeros(model.nq)
    names = [row.name for row in model.manifest.coordinates]
    q[[k for k, name in enumerate(names) if name == "slide.qw"]] = 1.0
    arm = [k for k, row in enumerate(model.manifest.speeds) if row.name.startswith("arm")]
    moved = [k for k, n in enumerate(names) if n == "slide" or n in ("slide.x", "slide.px")]
    assert len(moved) == 1
    near = model.mass_matrix(q)[np.ix_(arm, arm)]
    q[moved] = FAR
    far = model.mass_matrix(q)[np.ix_(arm, arm)]
    assert np.abs(far - near).max() <= 100 * EPS * np.abs(near).max()
