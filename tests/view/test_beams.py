"""Beams on the page: tubes along their nodes, in every picture."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest

import cardan as cd
from cardan.view.beams import MOST_SECTIONS, beams, bodies

GENERAL = cd.section.general(EA=1e4, GA=1e4, GJ=1, EI=1, rhoA=1, rhoI=1e-3)


@pytest.fixture(scope="module")
def motion() -> cd.Trajectory:
    scene = cd.Scene("swing")
    block = cd.shape.box(0.2, 0.2, 0.2)
    load = scene.body("load", mass=0.1, inertia=(1e-3, 1e-3, 1e-3), shape=block)
    beam = scene.beam("rope", (0, 0, 0), (1, 0, 0), GENERAL, elements=4)
    scene.beam("twig", beam.at(0.4), (0.5, 0.5, 0), cd.section.circle(0.02), RUBBER, elements=100)
    scene.joint("pin", cd.Revolute("y"), scene.ground, beam.start)
    scene.joint("hook", cd.Fixed(), beam.end, load)
    return cd.compile(scene).simulate(0.02, step=2e-3, rtol=1e-3)


RUBBER = cd.material(E=5e6, nu=0.3, rho=1100)


def test_lines_run_through_all_nodes(motion: cd.Trajectory) -> None:
    rope = motion.line("rope")
    assert rope.shape == (len(motion), 5, 3)
    np.testing.assert_allclose(rope[:, 0], motion.pose("rope.start")[:, :3, 3])
    np.testing.assert_allclose(rope[:, -1], motion.pose("load")[:, :3, 3])
    middle = next(b for b in motion.manifest["beams"] if b["name"] == "rope")["end"]
    assert middle == "rope.at1"
    np.testing.assert_allclose(rope[:, 2], motion.pose("rope.at1")[:, :3, 3])
    np.testing.assert_allclose(rope[0, :, 0], [0, 0.2, 0.4, 0.7, 1], atol=1e-12)
    assert rope[-1, 3, 2] < -1e-4
    with pytest.raises(cd.ModelError, match=r"beam .rop. does not exist.*rope"):
        motion.line("rop")


def test_page_draws_tubes(motion: cd.Trajectory, tmp_path: Path) -> None:
    page = motion.animate(tmp_path / "page.html", fps=200, page="plain").html
    found = re.search(r'id="data">(.*?)</script>', page, re.DOTALL)
    assert found
    data = json.loads(found.group(1))
    rope, twig = data["beams"]
    assert (rope["name"], twig["name"]) == ("rope", "twig")
    assert len(rope["path"]) == len(data["t"])
    assert {len(row) for row in rope["path"]} == {15}
    assert {len(row) for row in twig["path"]} == {3 * MOST_SECTIONS}
    assert rope["r"] == pytest.approx(2 * 1e-2)
    assert twig["r"] == 0.02


def test_nodes_are_drawn_with_their_beams(motion: cd.Trajectory) -> None:
    drawn = {body.name: body.solids for body in bodies(motion, beams(motion))[0]}
    (body,) = drawn.values()
    assert [one["kind"] for one in body] == ["box"]


def test_bodies_in_absolute_coordinates_are_drawn_by_their_frames() -> None:
    scene = cd.Scene("pendulum")
    rod = scene.body("rod", mass=1, com=(0, 0, -0.5), inertia=(0.1, 0.1, 0.01))
    rod.at(0, 0, -1, name="tip")
    scene.joint("pivot", cd.Revolute("y"), scene.ground, rod)
    model = cd.compile(scene, coordinates="absolute")
    (body,) = bodies(model.simulate(0.01, step=1e-3), [])[0]
    ball, link = body.solids
    assert ball["kind"] == "sphere"
    assert link["b"] == [0, 0, -1]
