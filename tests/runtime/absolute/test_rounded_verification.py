"""Verification of elements whose values are blurred by rounding, and of elements on two joints."""

from __future__ import annotations

import numpy as np
import pytest

import cardan as cd
from cardan.errors import BuildError
from cardan.runtime.verification.finite_elements.members import Members
from spread import some

SLENDER = cd.section.general(EA=1e12, GA=1e12, GJ=1.0, EI=1.0, rhoA=1e-6, rhoI=1e-12)


def rod(element: str, section: cd.section.General = SLENDER) -> cd.Scene:
    """A rod of which EA L^2 / EI is 1e12, unless given another section."""
    scene = cd.Scene("rod", gravity=(0, 0, 0))
    tip = scene.body("tip", mass=1.0, inertia=(1e-9, 1e-9, 1e-9), pose=(1, 0, 0))
    scene.beam("rod", scene.ground, tip, section, elements=8, element=element)
    return scene


@pytest.mark.parametrize("element", some(["hellinger_reissner", "helicoidal"], 2))
def test_slender_beams_are_approved_at_all_states(element: str) -> None:
    model = cd.compile(rod(element))
    for seed in range(3):
        assert model.verify(seed=seed).worst < 1e-9


@pytest.mark.parametrize("wrong", [1.0 + 1e-4, np.nan])
def test_blur_hides_no_fault(wrong: float, monkeypatch: pytest.MonkeyPatch) -> None:
    model, call = cd.compile(rod("hellinger_reissner")), Members.call

    def changed(self: Members, form: str, *given: object) -> np.ndarray:
        result = call(self, form, *given)
        return result * wrong if form == "energy" else result

    model.verify()
    monkeypatch.setattr(Members, "call", changed)
    with pytest.raises(BuildError, match="differs from"):
        model.verify()


@pytest.mark.parametrize("form", ["balance", "mixed", "mixed_step", "stress"])
@pytest.mark.parametrize("stiffness", [1e4, 1e12])
def test_results_that_differ_from_call_to_call_are_refused(
    form: str, stiffness: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    section = cd.section.general(EA=stiffness, GA=stiffness, GJ=1.0, EI=1.0, rhoA=1e-6, rhoI=1e-12)
    model, call = cd.compile(rod("hellinger_reissner", section)), Members.call
    rng = np.random.default_rng(1)

    def noisy(self: Members, name: str, *given: object) -> np.ndarray:
        result = call(self, name, *given)
        return result * (1 + 1e-3 * rng.uniform(-1, 1, result.shape)) if name == form else result

    model.verify()
    monkeypatch.setattr(Members, "call", noisy)
    with pytest.raises(BuildError, match="differs from"):
        model.verify()


def test_an_elastic_drive_beside_a_beam_is_approved() -> None:
    scene = rod("helicoidal")
    arm = scene.body("arm", mass=1.0, inertia=(0.1, 0.1, 0.1), com=(0.2, 0, 0))
    scene.joint("hinge", cd.Revolute("y"), scene.ground, arm)
    scene.force("motor", cd.Drive("hinge", inertia=1e-3, ratio=20.0, torque=0.1, stiffness=50.0))
    assert cd.compile(scene).verify().worst < 1e-9
