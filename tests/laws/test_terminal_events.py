"""Events of a scene that end a run."""

from __future__ import annotations

import pytest

import cardan as cd
from table import each


@each("direction, q0, u0", [(d, q, u) for d in ("down", "up", "both") for q in (0.0, 0.5)
                            for u in (1.0, -1.0)])  # fmt: skip
def test_an_event_of_a_scene_ends_a_run_where_a_watched_one_does(
    direction: str, q0: float, u0: float
) -> None:
    """A start on the far side is no crossing: the run ends where the value passes zero."""
    scene = cd.Scene("swing", gravity=(0, 0, -9.81))
    bob = scene.body("bob", mass=1.0, com=(0, 0, -1.0), inertia=(0.1, 0.1, 0.1))
    scene.joint("hinge", cd.Revolute("y"), scene.ground, bob)
    watched = cd.compile(scene)
    scene.force("pass", cd.Event(scene.q("hinge") - 0.2, terminal=True, direction=direction))
    ended = cd.compile(scene).simulate(5.0, q={"hinge": q0}, u={"hinge": u0}, rtol=1e-10)
    by_hand = watched.simulate(
        5.0, q={"hinge": q0}, u={"hinge": u0}, rtol=1e-10,
        events={"pass": (lambda t, x: x[0] - 0.2, "end", direction)},
    )  # fmt: skip
    assert ended.status == by_hand.status == "event"
    assert ended.t[-1] == pytest.approx(by_hand.t[-1], rel=1e-8)
    assert ended.t[-1] > 0.1
