"""Features that are forces."""

from __future__ import annotations

import cardan as cd

from .mechanism import Mechanism


def spring_damper(made: Mechanism, present: bool) -> None:
    """Between the forearm and the base."""
    if present:
        ends = made.forearm.at(0.2, 0, 0), made.root.at(0.6, -0.2, 0.3)
        made.scene.force("strut", cd.SpringDamper(*ends, 50.0, 1.0, 0.4))


def torsion_spring(made: Mechanism, present: bool) -> None:
    """At the elbow."""
    if present:
        made.scene.force("torsion", cd.JointSpring("elbow", stiffness=4.0, damping=0.05))


def elastic_drive(made: Mechanism, present: bool) -> None:
    """A motor behind an elastic shaft at the shoulder."""
    if present:
        drive = cd.Drive(
            "shoulder", 1e-3, ratio=10.0, torque=0.1, friction=1e-4, stiffness=80.0, damping=0.2
        )
        made.scene.force("motor", drive)


def table(made: Mechanism, present: bool) -> None:
    """A measured torque over the angle of the shoulder."""
    if present:
        curve = cd.table([-4.0, 0.0, 0.4, 0.8, 4.0], [3.0, 1.0, -2.0, -3.0, -5.0])
        made.scene.force("curve", cd.JointForce("shoulder", curve(made.scene.q("shoulder"))))


def bushing(made: Mechanism, present: bool) -> None:
    """An engine on a rubber mount at the forearm; without the mount it is fixed."""
    engine = made.scene.body("engine", mass=0.3, com=(0, 0.02, 0.01), inertia=(2e-3,) * 3)
    place = made.forearm.at(0.1, 0.08, 0.02)
    if not present:
        made.scene.joint("mount", cd.Fixed(), place, engine)
        return
    made.scene.joint("mount", cd.Free(), place, engine)
    stiffness, damping = (4.0, 5.0, 6.0, 200.0, 250.0, 300.0), (0.02,) * 3 + (1.0,) * 3
    made.scene.force("rubber", cd.Bushing(place, engine, stiffness, damping))


def line_load(made: Mechanism, present: bool) -> None:
    """Along the beam."""
    if present:
        made.scene.force("wind", cd.LineLoad("beam", force=(0.0, 2.0, -3.0)))


def coulomb(made: Mechanism, present: bool) -> None:
    """In the elbow."""
    if present:
        made.scene.force("rub", cd.Friction("elbow", coulomb=0.3))


def reaction_friction(made: Mechanism, present: bool) -> None:
    """Of a sledge on the forearm, by its normal force."""
    sledge = made.scene.body("sledge", mass=0.3, inertia=(0.001, 0.001, 0.001))
    rail = made.forearm.at(0.15, 0, -0.05)
    made.scene.joint("rail", cd.Prismatic("x"), rail, sledge, u0=0.3)
    made.scene.force("sledge_spring", cd.JointSpring("rail", 40.0))
    if present:
        made.scene.force("rail_friction", cd.Friction("rail", mu=0.3))
