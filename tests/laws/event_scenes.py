"""Scenes with events, modes and internal states, and where their runs start."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import sympy as sp

import cardan as cd

G = 9.81
Start = dict[str, Any]


def slider(name: str, axis: str = "x", gravity: float = 0.0, mass: float = 2.0) -> cd.Scene:
    """A mass on a rail."""
    scene = cd.Scene(name, gravity=(0, 0, -gravity))
    block = scene.body("block", mass=mass, inertia=(0.1, 0.2, 0.3))
    scene.joint("x", cd.Prismatic(axis), scene.ground, block)
    return scene


def pendulum(name: str, links: int = 2) -> cd.Scene:
    """A chain of bars in a plane."""
    scene = cd.Scene(name, gravity=(0, 0, -G))
    end = scene.ground
    for k in range(links):
        inertia = cd.inertia.rod(0.8, 1.0, axis="x")
        bar = scene.body(f"bar{k + 1}", mass=1.0, com=(0.5, 0, 0), inertia=inertia)
        scene.joint(f"J{k + 1}", cd.Revolute("y"), end, bar)
        end = bar.at(1.0, 0, 0)
    return scene


def rubbing() -> tuple[cd.Scene, Start]:
    """A spring and dry friction, until it sticks."""
    scene = slider("rubbing")
    scene.force("spring", cd.JointSpring("x", stiffness=50.0))
    scene.force("rail", cd.Friction("x", coulomb=1.5, stribeck=0.1, static=2.0))
    return scene, {"x": 0.4}


def ball() -> tuple[cd.Scene, Start]:
    """Impacts until it lies."""
    scene = slider("ball", "z", G)
    scene.force("floor", cd.Stop("x", lower=0.0, restitution=0.5, settle=0.1))
    return scene, {"x": 1.0}


def feet() -> tuple[cd.Scene, Start]:
    """Two stops that are hit at one time."""
    scene = slider("feet", "z", G)
    other = scene.body("other", mass=1.0, inertia=(0.1, 0.1, 0.1))
    scene.joint("knee", cd.Prismatic("z"), scene.bodies["block"], other)
    scene.force("low", cd.Stop("x", lower=0.0, restitution=0.0))
    scene.force("high", cd.Stop("knee", lower=0.0, restitution=0.0))
    return scene, {"x": 0.5, "knee": 0.5}


def latch() -> tuple[cd.Scene, Start]:
    """A joint that locks, and gives way."""
    scene = pendulum("latch")
    lock = cd.Lock("J2", when=0.3 - scene.q("J2"), strength=3.0)
    scene.force("latch", lock)
    return scene, {"J1": 0.3, "J2": 0.1}


def rough_arm() -> tuple[cd.Scene, Start]:
    """Dry friction in both joints."""
    scene = pendulum("rough arm")
    for k in (1, 2):
        scene.force(f"rub{k}", cd.Friction(f"J{k}", coulomb=1.0, viscous=0.05))
    return scene, {"J1": 0.2, "J2": 0.4}


def four_bar() -> tuple[cd.Scene, Start]:
    """A crank-rocker whose rocker meets a stop."""
    scene = cd.Scene("stopped", gravity=(0, 0, -G))
    bars = {}
    for name, length in (("crank", 0.3), ("coupler", 0.9), ("rocker", 0.7)):
        inertia = cd.inertia.rod(length, length, axis="x")
        bars[name] = scene.body(name, mass=length, com=(length / 2, 0, 0), inertia=inertia)
    scene.joint("A", cd.Revolute("y"), scene.ground, bars["crank"])
    scene.joint("B", cd.Revolute("y"), bars["crank"].at(0.3, 0, 0), bars["coupler"])
    scene.joint("D", cd.Revolute("y"), scene.ground.at(0.9, 0, 0), bars["rocker"])
    scene.joint("C", cd.Revolute("y"), bars["coupler"].at(0.9, 0, 0), bars["rocker"].at(0.7, 0, 0))
    scene.force("buffer", cd.Stop("D", upper=1.6, restitution=0.4))
    return scene, {"A": 0.5}


def slider_crank() -> tuple[cd.Scene, Start]:
    """A slider that rubs, driven by a crank."""
    scene = cd.Scene("slider crank", gravity=(0, 0, -G))
    rod = cd.inertia.rod(0.5, 0.5, axis="x")
    crank = scene.body("crank", mass=1.0, com=(0.1, 0, 0), inertia=(0.01, 0.02, 0.02))
    coupler = scene.body("coupler", mass=0.5, com=(0.25, 0, 0), inertia=rod)
    block = scene.body("block", mass=0.4, inertia=(0.01,) * 3)
    scene.joint("A", cd.Revolute("y"), scene.ground, crank)
    scene.joint("B", cd.Revolute("y"), crank.at(0.2, 0, 0), coupler)
    scene.joint("S", cd.Prismatic("x"), scene.ground, block)
    scene.joint("C", cd.Revolute("y"), coupler.at(0.5, 0, 0), block)
    scene.force("rub", cd.Friction("S", coulomb=1.5))
    scene.force("up", cd.Event(scene.q("A") - 0.8, direction="both"))
    return scene, {"A": 0.3}


def bouncing() -> tuple[cd.Scene, Start]:
    """A sphere that meets a plane, with friction."""
    scene = cd.Scene("bouncing", gravity=(0, 0, -G))
    sphere = scene.body("sphere", mass=0.5, inertia=(2e-3,) * 3)
    scene.joint("J", cd.Free(), scene.ground, sphere)
    contact = cd.Contact(sphere, scene.ground, radius=0.1, stiffness=2e4, damping=0.2, mu=0.3)
    scene.force("floor", contact)
    scene.force("up", cd.Event(scene.q("J.pz") - 0.2, direction="both"))
    return scene, {"J.pz": 0.4}


def controlled(sample: float | None) -> tuple[cd.Scene, Start]:
    """A joint that a controller holds, by itself or in samples, behind a lag."""
    scene = pendulum("controlled" if sample is None else "sampled")
    q, u = scene.q("J1"), scene.u("J1")
    pid = cd.Controller.pid("J1", q, u, target=0.5, kp=60.0, ki=20.0, kd=8.0, sample=sample)
    scene.force("pid", pid)
    command = 2.0 * sp.sin(3 * sp.Symbol("t"))
    scene.force("motor", cd.Actuator("J2", command=command, lag=0.1, limit=1.5))
    return scene, {"J1": 0.1, "J2": 0.2}


SCENES: dict[str, Callable[[], tuple[cd.Scene, Start]]] = {
    "rubbing": rubbing,
    "ball": ball,
    "feet": feet,
    "latch": latch,
    "rough_arm": rough_arm,
    "four_bar": four_bar,
    "slider_crank": slider_crank,
    "bouncing": bouncing,
    "controlled": lambda: controlled(None),
    "sampled": lambda: controlled(0.05),
}
