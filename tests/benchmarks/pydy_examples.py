"""PyDy's published examples, rebuilt from their descriptions.

Every maker returns a KanesMethod and values of its parameters.

Source: PyDy's repository and documentation, examples; G. Gede, D. Peterson, A. Nanjangud, J. Moore,
M. Hubbard, Constrained Multibody Dynamics with Python, ASME IDETC 2013.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

import sympy as sm
from sympy.physics import mechanics as me
from tests.scene import mechanics

Made = tuple[Any, dict[Any, float]]


def _kane(
    ground: Any, q: Sequence[Any], u: Sequence[Any], bodies: Sequence[Any], loads: Sequence[Any]
) -> Any:
    """Kane's equations of a tree with q' = u."""
    rates = [a.diff() - b for a, b in zip(q, u, strict=True)]
    kane = me.KanesMethod(ground, q, u, rates)
    kane.kanes_equations(bodies, loads)
    return kane


def double_pendulum() -> Made:
    """Two particles on massless rods in a plane."""
    q, u = me.dynamicsymbols("q1:3"), me.dynamicsymbols("u1:3")
    length, m, g = sm.symbols("l m g")
    ground, at = me.ReferenceFrame("N"), me.Point("O")
    at.set_vel(ground, 0)
    bodies, loads = [], []
    for k in range(2):
        rod = ground.orientnew(f"A{k}", "Axis", [q[k], ground.z])
        rod.set_ang_vel(ground, u[k] * ground.z)
        end = at.locatenew(f"P{k}", length * rod.x)
        end.v2pt_theory(at, ground, rod)
        bodies.append(me.Particle(f"p{k}", end, m))
        loads.append((end, m * g * ground.x))
        at = end
    return _kane(ground, q, u, bodies, loads), {"l": 1.0, "m": 1.0, "g": 9.81}


def chaos_pendulum() -> Made:
    """A plate that turns about the rod it hangs on: chaotic from small changes."""
    q, u = me.dynamicsymbols("theta phi"), me.dynamicsymbols("omega alpha")
    l_a, l_b, m_a, m_b, g = sm.symbols("lA lB mA mB g")
    i_a, i_b = sm.symbols("IAxx"), sm.symbols("IBxx IByy IBzz")
    ground, pivot = me.ReferenceFrame("N"), me.Point("No")
    pivot.set_vel(ground, 0)
    rod = ground.orientnew("A", "Axis", [q[0], ground.y])
    plate = rod.orientnew("B", "Axis", [q[1], rod.z])
    rod.set_ang_vel(ground, u[0] * ground.y)
    plate.set_ang_vel(rod, u[1] * rod.z)
    bodies, loads = [], []
    for name, frame, arm, mass, tensor in (
        ("rod", rod, (l_b - l_a / 2) / 2, m_a, (i_a, i_a, 0)),
        ("plate", plate, l_b, m_b, i_b),
    ):
        center = pivot.locatenew(f"{name}o", arm * rod.z)
        center.v2pt_theory(pivot, ground, rod)
        inertia = me.inertia(frame, *tensor)
        bodies.append(me.RigidBody(name, center, frame, mass, (inertia, center)))
        loads.append((center, mass * g * ground.z))
    values = {"lA": 0.075, "lB": 0.2, "mA": 0.01, "mB": 0.1, "g": 9.81}
    values |= {"IAxx": 2.1e-5, "IBxx": 3.3e-5, "IByy": 1.7e-4, "IBzz": 2.0e-4}
    return _kane(ground, q, u, bodies, loads), values


def conical_pendulum() -> Made:
    """Three rods in space on ball joints without spin: two angles each."""
    q, u = me.dynamicsymbols("q1:7"), me.dynamicsymbols("u1:7")
    lengths, m, g = sm.symbols("l1:4"), sm.symbols("m1:4"), sm.symbols("g")
    inertias = sm.symbols("Ixx1:4"), sm.symbols("Iyy1:4"), sm.symbols("Izz1:4")
    ground, at = me.ReferenceFrame("N"), me.Point("O")
    at.set_vel(ground, 0)
    frame, bodies, loads = ground, [], []
    swap = {a.diff(): b for a, b in zip(q, u, strict=True)}
    for k in range(3):
        turned = frame.orientnew(f"A{k}", "Body", [q[2 * k], q[2 * k + 1], 0], "123")
        turned.set_ang_vel(frame, turned.ang_vel_in(frame).subs(swap))
        center = at.locatenew(f"C{k}", lengths[k] / 2 * turned.z)
        center.v2pt_theory(at, ground, turned)
        end = at.locatenew(f"P{k}", lengths[k] * turned.z)
        end.v2pt_theory(at, ground, turned)
        tensor = me.inertia(turned, *(i[k] for i in inertias))
        bodies.append(me.RigidBody(f"b{k}", center, turned, m[k], (tensor, center)))
        loads.append((center, m[k] * g * ground.z))
        frame, at = turned, end
    values = {f"l{k}": 1.0 for k in range(1, 4)} | {f"m{k}": 1.0 for k in range(1, 4)}
    for k in range(1, 4):
        values |= {f"Ixx{k}": 0.083, f"Iyy{k}": 0.083, f"Izz{k}": 0.001}
    return _kane(ground, q, u, bodies, loads), {**values, "g": 9.81}


def astrobee() -> Made:
    """A robot that flies free in a space station, pushed and turned by six inputs."""
    q = me.dynamicsymbols("x y z phi theta psi")
    u = me.dynamicsymbols("vx vy vz wx wy wz")
    push, turn = me.dynamicsymbols("fx fy fz"), me.dynamicsymbols("tx ty tz")
    m, *inertia = sm.symbols("m Ix Iy Iz")
    ground, origin = me.ReferenceFrame("N"), me.Point("O")
    origin.set_vel(ground, 0)
    body = ground.orientnew("B", "Body", q[3:], "ZYX")
    spin = body.ang_vel_in(ground)
    center = origin.locatenew(
        "C", sum((a * e for a, e in zip(q, ground, strict=False)), 0 * body.x)
    )
    moving = center.pos_from(origin).dt(ground)
    axes = tuple(body)
    body.set_ang_vel(ground, sum((w * e for w, e in zip(u[3:], axes, strict=True)), 0 * body.x))
    center.set_vel(ground, sum((v * e for v, e in zip(u, axes, strict=False)), 0 * body.x))
    kinematics = [me.dot(moving - center.vel(ground), e) for e in ground]
    kinematics += [me.dot(spin - body.ang_vel_in(ground), e) for e in axes]
    kane = me.KanesMethod(ground, q, u, kinematics)
    loads = [
        (center, sum((f * e for f, e in zip(push, axes, strict=True)), 0 * body.x)),
        (body, sum((f * e for f, e in zip(turn, axes, strict=True)), 0 * body.x)),
    ]
    robot = me.RigidBody("robot", center, body, m, (me.inertia(body, *inertia), center))
    kane.kanes_equations([robot], loads)
    return kane, {"m": 7.0, "Ix": 0.1083, "Iy": 0.1083, "Iz": 0.1083}


def rattleback() -> Made:
    """An ellipsoid whose axes of inertia are turned rolls on a plane with some friction.

    Values: T. R. Kane, D. A. Levinson, Realistic mathematical modeling of the rattleback, 1982.
    """
    q, u = me.dynamicsymbols("alpha beta gamma"), me.dynamicsymbols("w1 w2 w3")
    a, b, c, h, m, g, sigma = sm.symbols("a b c h m g sigma")
    moments = sm.symbols("A B C D")
    ground = me.ReferenceFrame("N")
    yaw = ground.orientnew("Y", "Axis", [q[0], ground.z])
    roll = yaw.orientnew("L", "Axis", [q[1], yaw.x])
    body = roll.orientnew("R", "Axis", [q[2], roll.y])
    turning = body.ang_vel_in(ground)
    spin = sum((x * e for x, e in zip(u, body, strict=True)), 0 * body.x)
    # the normal of the plane in axes of the body says where the ellipsoid touches
    normal = [me.dot(yaw.z, e) for e in body]
    size = sm.sqrt(sum((s * n) ** 2 for s, n in zip((a, b, c), normal, strict=True)))
    reach = sum(
        (s**2 * n / size * e for s, n, e in zip((a, b, c), normal, body, strict=True)), 0 * body.x
    )
    contact = me.Point("P")
    contact.set_vel(ground, 0)
    center = contact.locatenew("RO", reach - h * body.z)
    body.set_ang_vel(ground, spin)
    center.v2pt_theory(contact, ground, body)
    tensor = me.inertia(body, *moments[:3], moments[3])
    stone = me.RigidBody("stone", center, body, m, (tensor, center))
    loads = [(center, -m * g * yaw.z), (body, -sigma * spin)]
    kinematics = [me.dot(turning - spin, e) for e in body]
    kane = me.KanesMethod(ground, q, u, kinematics)
    kane.kanes_equations([stone], loads)
    values = {"a": 0.2, "b": 0.03, "c": 0.02, "h": 0.01, "m": 1.0, "g": 9.81, "sigma": 1e-4}
    return kane, values | {"A": 2e-4, "B": 1.6e-3, "C": 1.7e-3, "D": -2e-5}


EXAMPLES: dict[str, Callable[[], Made]] = {
    "mass-spring-damper": partial(mechanics.masses, 1),
    "double pendulum": double_pendulum,
    "chaos pendulum": chaos_pendulum,
    "rolling disc": mechanics.disc_kane,
    "pendulum of 3 links on a cart": partial(mechanics.cart, 3),
    "pendulum of 5 links on a cart": partial(mechanics.cart, 5),
    "conical pendulum of 3 links": conical_pendulum,
    "Astrobee": astrobee,
    "rattleback": rattleback,
    "Carvallo-Whipple bicycle": mechanics.bicycle,
}
