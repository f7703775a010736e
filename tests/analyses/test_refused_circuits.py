"""Loops that cannot move, or cannot move on: what is said, and where."""

from __future__ import annotations

import math

import numpy as np
import pytest

import cardan as cd
from laws.circuits import compiled, start
from mechanisms.closed import four_bar, parallelogram


def tilted() -> cd.Scene:
    """A four-bar with one hinge out of the normal of its plane: it has one position, no motion."""
    flat, scene = four_bar(), cd.Scene("tilted", gravity=(0, -9.81, 0))
    links = {
        body.name: scene.body(body.name, mass=body.mass, com=body.com, inertia=(1e-3, 1e-3, 1e-3))
        for body in flat.bodies.values()
    }
    for joint in flat.joints.values():
        axis = (0, math.sin(0.1), math.cos(0.1)) if joint.name == "B" else "z"
        ends = []
        for place in (joint.parent, joint.child):
            body = links.get(place.body.name, scene.ground)
            ends.append(body if place is place.body else body.at(*place.coordinates))
        scene.joint(joint.name, cd.Revolute(axis), *ends)
    return scene


def braced() -> cd.Scene:
    """Parallelograms with a diagonal: a frame."""
    scene = parallelogram()
    diagonal = scene.body("diagonal", mass=1.0, com=(0.5, 0, 0), inertia=(0, 0.1, 0.1))
    scene.joint("P", cd.Revolute("z"), scene.ground, diagonal)
    corner = scene.bodies["crank1"].at(1, 0, 0)
    scene.joint("Q", cd.Revolute("z"), diagonal.at(math.sqrt(2), 0, 0), corner)
    return scene


def test_an_overconstrained_circuit() -> None:
    model = cd.compile(tilted())
    found = model.assemble()
    assert found.freedoms == 0
    told = str(model.redundancy(found.q))
    assert "5 constraints, 3 independent, 2 redundant; 0 degrees of freedom" in told
    assert "redundant: " in told
    assert not any(model.redundancy(found.q).joints.values())
    with pytest.raises(cd.ModelError, match=r"'A' \(asked 0\.5; reached .*\) is out of reach"):
        model.assemble({"A": 0.5})
    # what cannot move stays where it is
    assert np.abs(model.forward_dynamics(found.q, 0 * found.u)).max() < 1e-9


def test_a_frame_carries_its_load() -> None:
    model = cd.compile(braced())
    found = model.assemble({"A0": math.pi / 2})
    redundancy = model.redundancy(found.q)
    # three loops of planar motion hold three directions each that nothing moves along
    assert (redundancy.freedoms, redundancy.redundant) == (0, 9)
    assert all(redundancy.released(joint) == "Mx, My, Fz" for joint in redundancy.joints)
    motion = model.simulate(1.0, x0=found.x)
    assert motion.success
    np.testing.assert_allclose(motion.q[-1], found.q, rtol=0, atol=1e-10)
    # both ground joints of the triangle share the weight of everything that hangs on it
    assert np.abs(model.reaction("P", found.q, found.u)[3:]).max() > 1.0


def test_a_rank_change_that_can_be_passed() -> None:
    """The arms of a falling Delta robot stretch: rank drops, momentum carries it through."""
    model = compiled("delta")
    q, u = start(model, "delta", 0.1, 0.0)
    motion = model.simulate(0.5, q=q, u=u, rtol=1e-8)
    assert motion.success
    quality = [np.linalg.svd(G, compute_uv=False)[-1] for G in model.constraint_jacobian(motion.q)]
    assert min(quality) < 0.05 * quality[0]
    total = motion.energy.total
    assert np.ptp(total) < 1e-6 * motion.energy.kinetic.max()


def test_a_motion_that_ends_says_when_and_where() -> None:
    """A rocker driven beyond its dead end."""
    flat = four_bar()
    scene = cd.Scene("driven", gravity=(0, -9.81, 0))
    links = {b.name: scene.body(b.name, b.mass, b.com, (1e-4,) * 3) for b in flat.bodies.values()}
    crank, coupler, rocker = links.values()
    pivot = scene.ground.at(0.3, 0, 0)
    scene.joint("D", cd.Revolute("z"), pivot, rocker, prescribed=2.0 + cd.t)
    scene.joint("A", cd.Revolute("z"), scene.ground, crank, q0=1.5)
    scene.joint("B", cd.Revolute("z"), crank.at(0.1, 0, 0), coupler, q0=-1.2)
    scene.joint("C", cd.Revolute("z"), coupler.at(0.25, 0, 0), rocker.at(0.2, 0, 0))
    model = cd.compile(scene)
    with pytest.warns(cd.SolveWarning, match=r"stopped at t = 0\.\d+ s of 5 s: .*'C'"):
        motion = model.simulate(5.0)
    assert not motion.success
    # crank and coupler lie on each other: 0.25 - 0.1 m from the one pivot to the rocker's end
    end = math.pi - math.acos((0.3**2 + 0.2**2 - 0.15**2) / (2 * 0.3 * 0.2))
    assert motion.t[-1] == pytest.approx(end - 2.0, abs=1e-3)
