"""Features with states of their own, modes and events."""

from __future__ import annotations

import sympy as sp

import cardan as cd

from .mechanism import SPAN, Mechanism


def pid(made: Mechanism, present: bool) -> None:
    """A continuous controller of the shoulder."""
    if present:
        q, u = made.scene.q("shoulder"), made.scene.u("shoulder")
        law = cd.Controller.pid("shoulder", q, u, target=0.2, kp=30.0, ki=40.0, kd=1.0)
        made.scene.force("pid", law)


def actuator(made: Mechanism, present: bool) -> None:
    """A torque at the elbow that follows its command."""
    if present:
        made.scene.force("valve", cd.Actuator("elbow", command=0.8 * sp.sin(8 * cd.t), lag=0.05))


def maxwell(made: Mechanism, present: bool) -> None:
    """A spring and a damper in series between the forearm and the base."""
    if present:
        ends = made.forearm.at(0.3, 0, 0), made.root.at(0.4, 0.1, 0.5)
        made.scene.force("creep", cd.Maxwell(*ends, 60.0, 5.0, rest_length=0.5))


def motor_current(made: Mechanism, present: bool) -> None:
    """A motor at the elbow, with resistance, inductance and back voltage."""
    if present:
        i, speed = sp.Symbol("current"), made.scene.u("elbow")
        law = cd.Controller("elbow", (i,), ((2 - i - 0.3 * speed) / 0.02,), 0.3 * i)
        made.scene.force("winding", law)


def sampled_pid(made: Mechanism, present: bool) -> None:
    """A controller of the elbow in a computer."""
    if present:
        q, u = made.scene.q("elbow"), made.scene.u("elbow")
        law = cd.Controller.pid("elbow", q, u, target=0.4, kp=4.0, ki=5.0, kd=0.1, sample=0.02)
        made.scene.force("computer", law)


def stop(made: Mechanism, present: bool) -> None:
    """The end of the range of the shoulder."""
    if present:
        made.scene.force("bump", cd.Stop("shoulder", upper=0.4, restitution=0.3))


def latch(made: Mechanism, present: bool) -> None:
    """The elbow locks where it passes an angle."""
    if present:
        made.scene.force("latch", cd.Lock("elbow", when=0.52 - made.scene.q("elbow")))


def contact(made: Mechanism, present: bool) -> None:
    """A sphere at the end of the forearm that meets a floor."""
    if present:
        law = cd.Contact(
            made.forearm.at(0.4, 0, 0), made.root.at(0, 0, -0.55),
            radius=0.05, stiffness=2e3, damping=0.1, mu=0.1, transition_velocity=0.05,
        )  # fmt: skip
        made.scene.force("floor", law)


def event(made: Mechanism, present: bool) -> None:
    """A record of the time at which the elbow passes an angle."""
    if present:
        made.scene.force("passes", cd.Event(0.51 - made.scene.q("elbow"), direction="both"))


def time_event(made: Mechanism, present: bool) -> None:
    """A push on the forearm that begins at a time, and a record of it."""
    if present:
        push = sp.Piecewise((0, cd.t < 0.1), (2, True))
        made.scene.force("pushed", cd.Force(made.forearm.at(0.4, 0, 0), (0, push, push)))
        made.scene.force("begins", cd.Event(0.1 - cd.t))


def input_jump(made: Mechanism, present: bool) -> None:
    """A force on the forearm by an input that jumps."""
    push = made.scene.input("push", unit="N")
    made.scene.force("shove", cd.Force(made.forearm.at(0.4, 0, 0), (0, push, push)))
    made.inputs["push"] = ([0, 0.15, 0.15, SPAN], [0, 0, 3, 3]) if present else 0.0
