"""Verification judges events of elements: what it says of right functions, and of wrong ones."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import cardan as cd
from analyses.test_beam_events import LOWER, cantilever, slider_crank
from cardan.errors import BuildError
from cardan.runtime.models.finite_elements.mesh import Mesh
from cardan.runtime.verification.finite_elements.members import Members
from laws.event_scenes import SCENES
from spread import some

OF_MODEL = ("events", "transition", "energy at events")


@pytest.mark.parametrize(
    "name", some(["ball", "feet", "latch", "four_bar", "slider_crank", "sampled"], 2)
)
def test_events_are_judged(name: str) -> None:
    found = cd.compile(SCENES[name]()[0], coordinates="absolute").verify()
    spoken = [f for f in found.checked if f.endswith((" signs", " jumps", " change"))]
    assert {*OF_MODEL} <= {*found.checked}
    assert len(spoken) >= 2
    assert not [f for f in found.unchecked if f.endswith((" signs", " jumps", " change"))]


def test_events_of_beams_are_judged() -> None:
    for scene in (cantilever(2, lower=LOWER, restitution=0.3), slider_crank(1.0)):
        found = cd.compile(scene).verify()
        assert {*OF_MODEL} <= {*found.checked}
        assert "not checked" not in "".join(c.reason for c in found.checks if "stop" in c.function)


def stop_model() -> cd.CompiledModel:
    """A beam at a stop, with everything built."""
    model = cd.compile(cantilever(2, lower=LOWER, restitution=0.3))
    model.verify()
    return model


# a fault of a function of the stop: which number it spoils, and by what
FAULTS = {
    "gap of half the size": ("signs", lambda x, at: x * np.array([0.5, 1.0, 1.0])),
    "force of the wrong sign": ("signs", lambda x, at: x * np.array([1.0, -1.0, 1.0])),
    "reads in silence": ("signs", lambda x, at: x * np.array([1.0, 1.0, 0.0])),
    "impulse elsewhere": ("jumps", lambda x, at: x + np.eye(x.shape[1])[4] * 0.1),
    "another mode": ("change", lambda x, at: np.full_like(x, -1.0)),
    "no such mode": ("change", lambda x, at: x + (at["e"].sum(axis=1) > 0)[:, None] * 7.0),
}


@pytest.mark.parametrize("fault", some(FAULTS, 2))
def test_wrong_functions_are_found(fault: str, monkeypatch: pytest.MonkeyPatch) -> None:
    model, (form, spoil) = stop_model(), FAULTS[fault]
    real, text = Members.call, Members.expressions

    def wrong(self: Members, name: str, overrides: Any = None) -> Any:
        values = real(self, name, overrides)
        stop = self.table.kind.name == "stop" and name == form
        return spoil(values, {**self.inputs, **(overrides or {})}) if stop else values

    def as_wrong(self: Members, name: str, overrides: Any = None) -> Any:
        values = text(self, name, overrides)
        stop = self.table.kind.name == "stop" and name == form
        return spoil(values, {**self.inputs, **(overrides or {})}) if stop else values

    # expressions are wrong in the same way: laws alone tell
    monkeypatch.setattr(Members, "call", wrong)
    monkeypatch.setattr(Members, "expressions", as_wrong)
    with pytest.raises(BuildError, match=f"stop ({form}|signs)|transition"):
        model.verify()


def test_a_released_row_that_is_told_to_hold_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    model, real = stop_model(), Members.call

    def wrong(self: Members, name: str, overrides: Any = None) -> Any:
        values = real(self, name, overrides)
        if self.table.kind.name == "stop" and name == "balance_tangent":
            values = values.copy()
            values[:, self.table.kind.parts["H"]] = 0.0
        return values

    monkeypatch.setattr(Members, "call", wrong)
    monkeypatch.setattr(Members, "expressions", lambda self, *_: None)
    with pytest.raises(BuildError, match="stop balance_tangent"):
        model.verify()


@pytest.mark.parametrize("what", some(OF_MODEL, 2))
def test_wrong_transitions_are_found(what: str, monkeypatch: pytest.MonkeyPatch) -> None:
    model, real, total = stop_model(), Mesh.call, Mesh.total

    def wrong(self: Mesh, name: str, at: Any, size: int, **more: Any) -> Any:
        values = real(self, name, at, size, **more)
        if name == what == "events":
            values = values * 1.01
        if name == what == "transition":
            values[: len(at.u)] += 0.01 * (values[: len(at.u)] - at.u)
        return values

    def other(self: Mesh, form: str, size: int, at: Any) -> Any:
        values = total(self, form, size, at)
        return values * 1.01 if form == "energy" and what == "energy at events" else values

    monkeypatch.setattr(Mesh, "call", wrong)
    monkeypatch.setattr(Mesh, "total", other)
    with pytest.raises(BuildError, match=what):
        model.verify()
