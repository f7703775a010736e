"""Superelements that spin fast for the stiffness that they have without centrifugal forces."""

from __future__ import annotations

import re
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from sympy import Symbol, exp

import cardan as cd
from cardan.analyses.simulation.linear_limits import excesses
from cardan.superelements.spin import spin_scale
from mechanisms.superelements import soft_brick
from superelements.components import brick
from superelements.moving import free
from table import each

FIRST = 6.259491671  # rad/s of the soft brick with one end fixed
RUN = {"t": 0.02, "method": "DOP853", "rtol": 1e-8}


def warned(model: Any, spin: Any) -> list[str]:
    """What a short run with an angular velocity says."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        model.simulate(u={"free": [*spin, 0, 0, 0]}, **RUN)
    return [str(one.message) for one in caught if one.category is cd.SolveWarning]


@each("frame, slow, fast", [("root", 1.2, 1.4), ("mean", 2.9, 3.4)])
def test_fast_spins_are_warned_of(frame: str, slow: float, fast: float) -> None:
    """Beyond 0.2 of the first frequency with a frame on an interface, else beyond 0.5."""
    model = free(frame, (0.0, 0.0, 0.0))
    assert warned(model, (0, 0, slow)) == []
    (text,) = warned(model, (0, 0, fast))
    numbers = [float(x) for x in re.findall(r"(?:w1? = |, )([\d.]+)(?: rad/s| times)", text)]
    np.testing.assert_allclose(numbers, [fast, fast / FIRST, FIRST], rtol=0.02)
    assert "superelement 'boom'" in text
    assert "stiffening='root'" in text
    assert ("a part of their stiffening" in text) == (frame == "mean")


def test_steady_motions_are_warned_of() -> None:
    """And states of rest, of rotations of interfaces; the others are not."""
    scene = cd.Scene("rotor", gravity=(0, 0, 0))
    hub = scene.body("hub", 1.0, inertia=(1.0, 1.0, 1.0))
    scene.joint("bearing", cd.Revolute("z"), scene.ground, hub)
    body = scene.superelement("boom", soft_brick(), {"root": hub}, frame="root")
    force = scene.parameter("force", 0.0)
    scene.force("push", cd.Force(body.at("tip"), (0, 0, force), in_=hub))
    model = cd.compile(scene)
    with warnings.catch_warnings():
        warnings.simplefilter("error", cd.SolveWarning)
        model.equilibrium(u={"bearing": 1.0})
    with pytest.warns(cd.SolveWarning, match="'boom' spins with w = 3 rad/s"):
        model.equilibrium(u={"bearing": 3.0})
    with pytest.warns(cd.SolveWarning, match=r"'boom\.tip' turns by"):
        model.equilibrium(parameters={"force": 500.0}, locked={"bearing": 0.0})


def test_a_shaft_that_turns_about_itself_is_not_stretched() -> None:
    model = free("root", (0.0, 0.0, 0.0))
    assert warned(model, (5.0, 0, 0)) == []
    assert len(warned(model, (0, 5.0, 0))) == 1


def test_a_knock_is_not_a_spin() -> None:
    """The mean over a period of the first vibration counts."""
    scene = cd.Scene("knocked", gravity=(0, 0, 0))
    hub = scene.body("hub")
    angle = 0.008 * exp(-(((Symbol("t") - 0.05) / 0.003) ** 2))
    scene.joint("hinge", cd.Revolute("z"), scene.ground, hub, prescribed=angle)
    scene.superelement("boom", soft_brick(), {"root": hub}, frame="root")
    model = cd.compile(scene)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        run = model.simulate(np.linspace(0, 0.1, 101), method="DOP853", rtol=1e-6)
    fastest = np.abs(model.velocity("boom.axes", run.q, run.u, t=run.t)[:, 2]).max()
    assert fastest > 0.3 * FIRST


def test_stiffened_ones_and_those_without_elastic_motion_are_left_out() -> None:
    beams = cd.Scene("beams", gravity=(0, 0, 0))
    section = cd.section.general(EA=1e4, GA=1e4, GJ=1.0, EI=1.0, rhoA=1.0, rhoI=1e-2)
    beams.beam("beam", beams.ground, (1.0, 0, 0), section, elements=4)
    record = cd.superelement.from_beams(beams, "beam", modes=1, stiffening="start")
    for stiffening in (True, False):
        scene = cd.Scene("flying", gravity=(0, 0, 0))
        boom = scene.superelement("boom", record, frame="start", stiffening=stiffening)
        scene.joint("free", cd.Free(), scene.ground, boom.at("start"))
        said = warned(cd.compile(scene), (0, 0, 3.0))
        assert bool(said) != stiffening
    single = cd.superelement.reduce(*soft_block(), {"root": range(4)}, modes=0)
    assert spin_scale(single, ["root"]).frequency == 0.0


def soft_block() -> tuple[Any, Any, Any]:
    """Four masses on springs between them."""
    nodes = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
    K = np.zeros((12, 12))
    for i in range(4):
        for j in range(i):
            e = np.zeros(12)
            way = (nodes[i] - nodes[j]) / np.linalg.norm(nodes[i] - nodes[j])
            e[3 * i : 3 * i + 3], e[3 * j : 3 * j + 3] = way, -way
            K += 1e6 * np.outer(e, e)
    return np.eye(12), K, nodes


def test_the_scale_is_of_the_interface_that_fixes_least() -> None:
    record = brick(modes=4)
    for names in (["root"], ["tip"], ["root", "tip"]):
        scale = spin_scale(record, names)
        lowest = min(record.modes(name).frequencies[0] for name in names)
        np.testing.assert_allclose(scale.frequency, lowest, rtol=1e-12)
    # of a bar of 1 x 0.3 x 0.1 about its end
    scale = spin_scale(record, ["root"])
    expected = [(0.3**2 + 0.1**2) / 12, 1 / 3 + 0.1**2 / 12, 1 / 3 + 0.3**2 / 12]
    np.testing.assert_allclose(scale.inertia, np.diag(expected) / expected[-1], atol=1e-6)


def test_saved_models_and_runs_keep_what_it_needs(tmp_path: Path) -> None:
    model = free("root", (0.0, 0.0, 0.0))
    again = cd.load_model(model.directory)
    (text,) = warned(again, (0, 0, 3.0))
    assert text == warned(model, (0, 0, 3.0))[0]
    with pytest.warns(cd.SolveWarning, match="spins with w = 2.998 rad/s"):
        run = model.simulate(u={"free": [0, 0, 3.0, 0, 0, 0]}, **RUN)
    run.save(tmp_path / "run.npz")
    loaded = cd.load_motion(tmp_path / "run.npz")
    row, kept = run.manifest.superelements[0], loaded.manifest.superelements[0]
    for name in ("frame_choice", "stiffening", "fixed", "first_frequency", "relative_inertia"):
        assert getattr(kept, name) == getattr(row, name), name
    # what is said of a run has been said
    assert [*excesses(loaded)] == []
