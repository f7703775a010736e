"""Examples that the documentation of SymPy's mechanics package works out, rebuilt.

Every maker returns equations as SymPy has them and values of their parameters.

Source: docs.sympy.org, Physics, Classical Mechanics, examples; S. Meijaard, J. Papadopoulos,
A. Ruina, A. Schwab, Linearized dynamics equations for the balance and steer of a bicycle, 2007.
"""

from __future__ import annotations

from collections.abc import Callable
from math import acos, cos, hypot, pi, sin
from typing import Any

import sympy as sm
from sympy.physics import mechanics as me
from sympy.physics.mechanics import models

Made = tuple[Any, dict[Any, float]]


def _disc(speeds: bool = False) -> tuple[Any, ...]:
    """Frames of a thin disc by yaw, lean and spin, and its parameters."""
    q = me.dynamicsymbols("q1:4")
    r, m, g = sm.symbols("r m g")
    ground = me.ReferenceFrame("N")
    yaw = ground.orientnew("Y", "Axis", [q[0], ground.z])
    lean = yaw.orientnew("L", "Axis", [q[1], yaw.x])
    disc = lean.orientnew("R", "Axis", [q[2], lean.y])
    inertia = me.inertia(lean, m / 4 * r**2, m / 2 * r**2, m / 4 * r**2)
    return q, (r, m, g), (ground, yaw, lean, disc), inertia


DISC = {"r": 0.6, "m": 1.3, "g": 9.81}


def _kane_disc(auxiliary: bool) -> Made:
    """A disc that rolls on a plane, without constraints: told from the contact point."""
    q, (r, m, g), (ground, yaw, lean, disc), inertia = _disc()
    u, extra = me.dynamicsymbols("u1:4"), me.dynamicsymbols("u4:7") if auxiliary else []
    turning = disc.ang_vel_in(ground)
    disc.set_ang_vel(ground, u[0] * lean.x + u[1] * lean.y + u[2] * lean.z)
    contact = me.Point("C")
    axes = tuple(yaw)
    contact.set_vel(ground, sum((x * e for x, e in zip(extra, axes, strict=False)), me.Vector(0)))
    center = contact.locatenew("D", r * lean.z)
    center.v2pt_theory(contact, ground, disc)
    kinematics = [me.dot(turning - disc.ang_vel_in(ground), e) for e in lean]
    forces = sm.symbols("f1:4") if auxiliary else []
    loads = [(center, -m * g * yaw.z)]
    if auxiliary:
        loads.append((contact, sum((f * e for f, e in zip(forces, axes, strict=True)), 0 * yaw.x)))
    body = me.RigidBody("disc", center, disc, m, (inertia, center))
    kane = me.KanesMethod(ground, q, u, kinematics, u_auxiliary=extra or None)
    kane.kanes_equations([body], loads)
    return kane, DISC


def disc_kane() -> Made:
    """Rolling disc by Kane's method."""
    return _kane_disc(auxiliary=False)


def disc_auxiliary() -> Made:
    """Rolling disc by Kane's method with the forces at the contact brought into evidence."""
    return _kane_disc(auxiliary=True)


def disc_dependent() -> Made:
    """Rolling disc by Kane's method with its center and three dependent speeds."""
    angles, (r, m, g), (ground, yaw, lean, disc), inertia = _disc()
    q = [*angles, *me.dynamicsymbols("q4:7")]
    u = me.dynamicsymbols("u1:7")
    origin = me.Point("O")
    center = origin.locatenew("D", q[3] * ground.x + q[4] * ground.y + q[5] * ground.z)
    turning, moving = disc.ang_vel_in(ground), center.pos_from(origin).dt(ground)
    held = lean.ang_vel_in(ground)
    disc.set_ang_vel(ground, u[0] * lean.x + u[1] * lean.y + u[2] * lean.z)
    center.set_vel(ground, u[3] * disc.x + u[4] * disc.y + u[5] * disc.z)
    contact = center.locatenew("P", r * lean.z)
    contact.v2pt_theory(center, ground, disc)
    kinematics = [me.dot(turning - disc.ang_vel_in(ground), e) for e in lean]
    kinematics += [me.dot(moving - center.vel(ground), e) for e in ground]
    rates = sm.solve(kinematics, [x.diff() for x in q])
    lean.set_ang_vel(ground, held.subs(rates))
    spin = disc.ang_vel_in(ground)
    disc.set_ang_acc(ground, spin.dt(lean) + me.cross(lean.ang_vel_in(ground), spin))
    body = me.RigidBody("disc", center, disc, m, (inertia, center))
    kane = me.KanesMethod(
        ground,
        q[:5],
        u[:3],
        kinematics,
        q_dependent=[q[5]],
        configuration_constraints=[q[5] - me.dot(center.pos_from(contact), ground.z)],
        u_dependent=u[3:],
        velocity_constraints=[me.dot(contact.vel(ground), e) for e in disc],
    )
    kane.kanes_equations([body], [(center, m * g * yaw.z)])
    return kane, DISC


def disc_lagrange() -> Made:
    """Rolling disc by Lagrange's method, told from the contact point as SymPy does."""
    q, (r, m, g), (ground, _, lean, disc), inertia = _disc()
    contact = me.Point("C")
    contact.set_vel(ground, 0)
    center = contact.locatenew("D", r * lean.z)
    center.v2pt_theory(contact, ground, disc)
    body = me.RigidBody("disc", center, disc, m, (inertia, center))
    body.potential_energy = m * g * r * sm.cos(q[1])
    lagrange = me.LagrangesMethod(me.Lagrangian(ground, body), q)
    lagrange.form_lagranges_equations()
    return lagrange, DISC


def disc_multipliers() -> Made:
    """Rolling disc by Lagrange's method: nonholonomic constraints, and one of height."""
    angles, (r, m, g), (ground, _, lean, disc), inertia = _disc()
    q = [*angles, *me.dynamicsymbols("q4:7")]
    origin = me.Point("O")
    origin.set_vel(ground, 0)
    center = origin.locatenew("D", q[3] * ground.x + q[4] * ground.y + q[5] * ground.z)
    center.set_vel(ground, center.pos_from(origin).dt(ground))
    contact = center.locatenew("P", -r * lean.z)
    contact.v2pt_theory(center, ground, disc)
    body = me.RigidBody("disc", center, disc, m, (inertia, center))
    body.potential_energy = m * g * q[5]
    lagrange = me.LagrangesMethod(
        me.Lagrangian(ground, body),
        q,
        hol_coneqs=[q[5] - r * sm.cos(q[1])],
        nonhol_coneqs=[me.dot(contact.vel(ground), e) for e in (ground.x, ground.y)],
    )
    lagrange.form_lagranges_equations()
    return lagrange, DISC


def pendulum_kane() -> Made:
    """Pendulum by its two positions, one of them dependent, by Kane's method."""
    q, u = me.dynamicsymbols("q1:3"), me.dynamicsymbols("u1:3")
    length, m, g = sm.symbols("L m g")
    ground, pivot = me.ReferenceFrame("N"), me.Point("pN")
    pivot.set_vel(ground, 0)
    along = ground.orientnew("A", "axis", [sm.atan(q[1] / q[0]), ground.z])
    tip = pivot.locatenew("P1", q[0] * ground.x + q[1] * ground.y)
    tip.set_vel(ground, u[0] * ground.x + u[1] * ground.y)
    kane = me.KanesMethod(
        ground,
        [q[1]],
        [u[1]],
        [a.diff() - b for a, b in zip(q, u, strict=True)],
        q_dependent=[q[0]],
        configuration_constraints=[tip.pos_from(pivot).magnitude() - length],
        u_dependent=[u[0]],
        velocity_constraints=[tip.vel(ground).express(along).dot(along.x)],
    )
    kane.kanes_equations([me.Particle("tip", tip, m)], [(tip, m * g * ground.x)])
    return kane, {"L": 1.4, "m": 0.7, "g": 9.81}


def pendulum_lagrange() -> Made:
    """The same by Lagrange's method with a multiplier."""
    q = me.dynamicsymbols("q1:3")
    length, m, g = sm.symbols("L m g")
    ground, pivot = me.ReferenceFrame("N"), me.Point("pN")
    pivot.set_vel(ground, 0)
    tip = pivot.locatenew("P1", q[0] * ground.x + q[1] * ground.y)
    tip.set_vel(ground, tip.pos_from(pivot).dt(ground))
    lagrange = me.LagrangesMethod(
        me.Lagrangian(ground, me.Particle("tip", tip, m)),
        q,
        hol_coneqs=[q[0] ** 2 + q[1] ** 2 - length**2],
        forcelist=[(tip, m * g * ground.x)],
        frame=ground,
    )
    lagrange.form_lagranges_equations()
    return lagrange, {"L": 1.4, "m": 0.7, "g": 9.81}


def four_bar() -> Made:
    """Four-bar linkage of three moving links, closed by two conditions of position."""
    q, u = me.dynamicsymbols("q1:4"), me.dynamicsymbols("u1:4")
    lengths, rho = sm.symbols("l1:5"), sm.symbols("rho")
    ground, origin = me.ReferenceFrame("N"), me.Point("P1")
    origin.set_vel(ground, 0)
    frame, at, bodies = ground, origin, []
    for k, (angle, speed, length) in enumerate(zip(q, u, lengths[:3], strict=True), 2):
        turned = frame.orientnew(f"A{k}", "Axis", [angle, frame.z])
        turned.set_ang_vel(frame, speed * frame.z)
        center = at.locatenew(f"C{k}", length / 2 * turned.x)
        center.v2pt_theory(at, ground, turned)
        end = at.locatenew(f"P{k}", length * turned.x)
        end.v2pt_theory(at, ground, turned)
        inertia = me.inertia(turned, 0, 0, rho * length**3 / 12)
        bodies.append(me.RigidBody(f"b{k}", center, turned, rho * length, (inertia, center)))
        frame, at = turned, end
    loop = at.pos_from(origin) - lengths[3] * ground.x
    held = [sm.trigsimp(loop.dot(e)) for e in (ground.x, ground.y)]
    swap = {a.diff(): b for a, b in zip(q, u, strict=True)}
    kane = me.KanesMethod(
        ground,
        q[:1],
        u[:1],
        [a - b for a, b in swap.items()],
        q_dependent=q[1:],
        configuration_constraints=held,
        u_dependent=u[1:],
        velocity_constraints=[g.diff(me.dynamicsymbols._t).xreplace(swap) for g in held],
    )
    kane.kanes_equations(bodies)
    return kane, {"l1": 0.8, "l2": 2.0, "l3": 1.7, "l4": 2.2, "rho": 5.0}


def cart(links: int = 3) -> Made:
    """Pendulum of some links on a cart that is pushed."""
    kane = models.n_link_pendulum_on_cart(links, cart_force=True, joint_torques=False)
    values = {f"l{i}": 0.5 + 0.1 * i for i in range(links)}
    values |= {f"m{i}": 1.0 + 0.3 * i for i in range(links + 1)}
    return kane, {**values, "g": 9.81}


def masses(count: int = 3) -> Made:
    """Row of masses, springs and dampers that hangs and is pushed."""
    kane = models.multi_mass_spring_damper(count, apply_gravity=True, apply_external_forces=True)
    values = {f"m{i}": 1.0 + 0.1 * i for i in range(count)}
    values |= {f"k{i}": 20.0 + i for i in range(count)} | {f"c{i}": 0.2 for i in range(count)}
    return kane, {**values, "g": 9.81}


def bicycle() -> Made:
    """Carvallo-Whipple bicycle: knife-edge wheels, contact points that roll."""
    q = dict(zip("1245", me.dynamicsymbols("q1 q2 q4 q5"), strict=True))
    u = dict(zip("123456", me.dynamicsymbols("u1:7"), strict=True))
    names = "rf rr tilt offset fork frame fork1 fork3 frame1 frame3"
    rf, rr, tilt, offset, fork, frame, fork1, fork3, frame1, frame3 = sm.symbols(names)
    i_r11, i_r22, i_f11, i_f22 = sm.symbols("Ir11 Ir22 If11 If22")
    i_b, i_h = sm.symbols("Ib11 Ib22 Ib33 Ib31"), sm.symbols("Ih11 Ih22 Ih33 Ih31")
    m_b, m_h, m_f, m_r, g = sm.symbols("mb mh mf mr g")
    ground = me.ReferenceFrame("N")
    yaw = ground.orientnew("Y", "Axis", [q["1"], ground.z])
    roll = yaw.orientnew("R", "Axis", [q["2"], yaw.x])
    rear = roll.orientnew("B", "Axis", [q["4"] + tilt, roll.y])
    upright = rear.orientnew("B0", "Axis", [-tilt, rear.y])
    front = rear.orientnew("H", "Axis", [q["5"], rear.x])
    turned = front.orientnew("H0", "Axis", [-tilt, front.y])
    wheel_r, wheel_f = me.ReferenceFrame("WR"), me.ReferenceFrame("WF")
    contact_r = me.Point("CR")
    hub_r = contact_r.locatenew("HR", rr * roll.z)
    steer = hub_r.locatenew("S", frame * rear.z)
    com_b = hub_r.locatenew("MB", -frame1 * rear.x + frame3 * rear.z)
    com_h = steer.locatenew("MH", -fork1 * front.x + fork3 * front.z)
    hub_f = steer.locatenew("HF", fork * front.x + offset * front.z)
    down = (me.dot(front.y, yaw.z) * front.y - yaw.z).normalize()
    contact_f = hub_f.locatenew("CF", rf * down)
    yaw.set_ang_vel(ground, u["1"] * yaw.z)
    roll.set_ang_vel(yaw, u["2"] * roll.x)
    wheel_r.set_ang_vel(rear, u["3"] * rear.y)
    rear.set_ang_vel(roll, u["4"] * rear.y)
    front.set_ang_vel(rear, u["5"] * front.x)
    wheel_f.set_ang_vel(front, u["6"] * front.y)
    contact_r.set_vel(ground, 0)
    for point, other, body in (
        (hub_r, contact_r, wheel_r),
        (steer, hub_r, rear),
        (com_b, hub_r, rear),
        (com_h, steer, front),
        (hub_f, steer, front),
        (contact_f, hub_f, wheel_f),
    ):
        point.v2pt_theory(other, ground, body)
    tensors = (
        me.inertia(upright, *i_b[:3], 0, 0, i_b[3]),
        me.inertia(turned, *i_h[:3], 0, 0, i_h[3]),
        me.inertia(rear, i_r11, i_r22, i_r11),
        me.inertia(front, i_f11, i_f22, i_f11),
    )
    parts = (com_b, rear, m_b), (com_h, front, m_h), (hub_r, wheel_r, m_r), (hub_f, wheel_f, m_f)
    bodies = [
        me.RigidBody(f"body{k}", point, body, mass, (tensor, point))
        for k, ((point, body, mass), tensor) in enumerate(zip(parts, tensors, strict=True))
    ]
    rates = {q["1"]: u["1"], q["2"]: u["2"], q["4"]: u["4"], q["5"]: u["5"]}
    kane = me.KanesMethod(
        ground,
        [q["1"], q["2"], q["5"]],
        [u["2"], u["3"], u["5"]],
        [a.diff() - b for a, b in rates.items()],
        q_dependent=[q["4"]],
        configuration_constraints=[me.dot(contact_f.pos_from(contact_r), yaw.z)],
        u_dependent=[u["1"], u["4"], u["6"]],
        velocity_constraints=[me.dot(contact_f.vel(ground), e) for e in yaw],
        constraint_solver="CRAMER",
    )
    kane.kanes_equations(bodies, [(point, -mass * g * yaw.z) for point, _, mass in parts])
    return kane, benchmark()


def benchmark() -> dict[Any, float]:
    """Values of the benchmark bicycle in the lengths of :func:`bicycle`."""
    r_rear, r_front, base, trail, tilt = 0.3, 0.35, 1.02, 0.08, pi / 2 - pi / 10
    rake = -(trail * sin(tilt) - r_front * cos(tilt))
    x_b, z_b, x_h, z_h = 0.3, 0.9, 0.9, 0.7
    fork = base * cos(tilt) - (r_front - r_rear) * sin(tilt)
    a, b = z_h - r_front, base - x_h
    turn = pi / 2 - tilt - acos(a / hypot(a, b))
    ahead = z_b - r_rear - x_b / sin(tilt) * cos(tilt)
    values = {
        "rf": r_front,
        "rr": r_rear,
        "tilt": tilt,
        "offset": rake,
        "fork": fork,
        "frame": base * sin(tilt) - (rake - (r_front - r_rear) * cos(tilt)),
        "fork1": hypot(a, b) * cos(turn) - fork,
        "fork3": rake + hypot(a, b) * sin(turn),
        "frame1": ahead * sin(tilt),
        "frame3": x_b / sin(tilt) + ahead * cos(tilt),
    }
    values |= {"Ir11": 0.0603, "Ir22": 0.12, "If11": 0.1405, "If22": 0.28}
    values |= {"Ib11": 9.2, "Ib22": 11.0, "Ib33": 2.8, "Ib31": -2.4}
    values |= {"Ih11": 0.05892, "Ih22": 0.06, "Ih33": 0.00708, "Ih31": 0.00756}
    return values | {"mb": 85.0, "mh": 4.0, "mf": 3.0, "mr": 2.0, "g": 9.81}


EXAMPLES: tuple[Callable[[], Made], ...] = (
    disc_kane,
    disc_auxiliary,
    disc_dependent,
    disc_lagrange,
    disc_multipliers,
    pendulum_kane,
    pendulum_lagrange,
    four_bar,
    cart,
    masses,
    bicycle,
)
