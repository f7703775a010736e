"""The page and the picture of a motion: complete, self-contained, safe against any name."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest

import cardan as cd
from cardan.view.histories import curves_by_unit
from cardan.view.solids import bodies

NASTY = "</script><img src=x onerror=alert(1)>"


@pytest.fixture(scope="module")
def motion() -> cd.Trajectory:
    scene = cd.Scene(NASTY)
    block = cd.shape.box(0.2, 0.3, 1.0, position=(0, 0, -0.5))
    upper = scene.body("upper<b>", mass=1, com=(0, 0, -0.5), inertia=(1, 1, 0.1), shape=block)
    lower = scene.body("lower", mass=1, com=(0, 0, -0.4), inertia=(1, 1, 0.1))
    scene.joint("shoulder", cd.Revolute("y"), scene.ground, upper)
    scene.joint("elbow", cd.Revolute("x"), upper.at(0, 0, -1), lower)
    return cd.compile(scene).simulate(2.0, q={"shoulder": 1.0, "elbow": 0.4})


@pytest.mark.parametrize("kind", ["3d", "plain"])
def test_page_is_self_contained_and_safe(motion: cd.Trajectory, tmp_path: Path, kind: str) -> None:
    page = motion.animate(tmp_path / "deep" / "page.html", page=kind).path.read_text("utf-8")
    assert NASTY not in page
    assert page.count("<script") == page.count("</script>") == (4 if kind == "3d" else 2)
    assert not re.search(r"https?://|<[^>]*(src|href)=", page)
    assert "__DATA__" not in page
    assert [path.name for path in (tmp_path / "deep").iterdir()] == ["page.html"]


def test_page_holds_the_motion(motion: cd.Trajectory, tmp_path: Path) -> None:
    page = motion.animate(tmp_path / "page.html", fps=30, page="plain").html
    found = re.search(r'id="data">(.*?)</script>', page, re.S)
    assert found
    data = json.loads(found.group(1))
    assert data["name"] == NASTY
    assert len(data["t"]) == 61
    lower = data["bodies"][1]
    assert lower["name"] == "lower"
    at = motion.resample(data["t"]).pose("lower")
    expected = np.concatenate([at[:, :3, :3].reshape(-1, 9), at[:, :3, 3]], axis=1)
    # five digits are kept
    np.testing.assert_allclose(lower["pose"], expected, atol=6e-6)


def test_bodies_are_drawn_by_shape_or_as_links(motion: cd.Trajectory) -> None:
    (upper, lower), _ = bodies(motion)
    assert [solid["kind"] for solid in upper.solids] == ["box"]
    assert upper.solids[0]["a"] == [0, 0, -0.5]
    # no shape: a link through the center of mass to twice its distance
    assert [solid["kind"] for solid in lower.solids] == ["link", "cylinder"]
    assert lower.solids[0]["b"] == [0, 0, -0.8]
    # a mass at the end of its rod is a ball
    scene = cd.Scene("bob")
    bob = scene.body("bob", mass=1, com=(0, 0, -1))
    bob.at(0, 0, -1, name="tip")
    scene.joint("pivot", cd.Revolute("y"), scene.ground, bob)
    (heavy,), _ = bodies(cd.compile(scene).simulate(0.1))
    assert [solid["kind"] for solid in heavy.solids] == ["link", "cylinder", "sphere"]
    # a pin says which way a body turns
    assert np.subtract(heavy.solids[1]["b"], heavy.solids[1]["a"])[[0, 2]] == pytest.approx(0)


def test_output_times_without_dense_output_can_be_shown(tmp_path: Path) -> None:
    scene = cd.Scene("pendulum")
    rod = scene.body("rod", mass=1, com=(0, 0, -0.5), inertia=(0.1, 0.1, 0.01))
    scene.joint("pivot", cd.Revolute("y"), scene.ground, rod)
    times = np.linspace(0, 1, 11)
    motion = cd.compile(scene).simulate(times, q={"pivot": 0.5})
    page = motion.animate(tmp_path / "page.html", page="plain").html
    found = re.search(r'id="data">(.*?)</script>', page, re.S)
    assert found
    assert json.loads(found.group(1))["t"] == pytest.approx(times)


def test_plot_writes_a_picture(motion: cd.Trajectory, tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    figure = motion.plot(tmp_path / "all.png")
    # angles, their rates and the energies
    assert [axis.get_ylabel() for axis in figure.axes] == ["[rad]", "[rad/s]", "energy [J]"]
    assert (tmp_path / "all.png").stat().st_size > 10_000
    chosen = motion.plot(names=["elbow", "shoulder.u"])
    line = chosen.axes[0].lines[0]
    # a curve through every row, with what lies between
    times, drawn = line.get_xdata(), line.get_ydata()
    assert len(drawn) > 1000
    rows = np.searchsorted(times, motion.t)
    np.testing.assert_allclose(drawn[rows], motion["elbow"], rtol=0, atol=1e-12)
    np.testing.assert_allclose(drawn, [motion.at(t)[1] for t in times], rtol=0, atol=1e-12)


def test_what_cannot_be_plotted_says_why(motion: cd.Trajectory, tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    assert len(motion.plot(names="elbow").axes) == 1
    for given, said in (
        ({"path": ["elbow"]}, "path=.*: give the path of a file"),
        ({"path": tmp_path / "run.pgn"}, "no ending of a picture.* Did you mean 'png'"),
        ({"names": ["elbo"]}, "no such history.* Did you mean 'elbow'"),
        ({"names": [3]}, "give a list of names"),
        ({"names": []}, "names is empty"),
    ):
        with pytest.raises(cd.CardanError, match=said):
            motion.plot(**given)


def test_titles_are_text_only(motion: cd.Trajectory, tmp_path: Path) -> None:
    for kind in ("3d", "plain"):
        page = motion.animate(tmp_path / "page.html", title="__DATA__ & <i>", page=kind).html
        assert "<h1>__DATA__ &amp; &lt;i&gt;</h1>" in page


def test_nothing_is_drawn_to_a_free_body_and_far_masses_hang_on_ribs() -> None:
    scene = cd.Scene("loose")
    upper = scene.body("upper", mass=1, com=(0.4, 0, -0.5), inertia=(1, 1, 1))
    lower = scene.body("lower", mass=1, com=(0, 0, -0.5), inertia=(1, 1, 1))
    crate = scene.body("crate", mass=1, com=(0, 0, 0), inertia=(1, 1, 1))
    scene.joint("hinge", cd.Revolute("y"), scene.ground, upper)
    scene.joint("knee", cd.Revolute("y"), upper.at(0, 0, -1), lower)
    scene.joint("fly", cd.Free(), scene.ground.at(5, 0, 0), crate)
    drawn, ground = bodies(cd.compile(scene).simulate(0.1))
    assert [solid["b"] for solid in ground] == [[0, 0, 0]]
    link, _, rib, ball = drawn[0].solids
    assert link["b"] == [0, 0, -1]
    assert (rib["a"], rib["b"]) == ([0, 0, -0.5], [0.4, 0, -0.5])
    assert ball["a"] == [0.4, 0, -0.5]


def test_forces_of_elements_are_grouped_by_their_units() -> None:
    scene = cd.Scene("crane", gravity=(0, 0, -9.81))
    boom = scene.body("boom", mass=1, inertia=(1, 1, 1))
    scene.joint("hinge", cd.Revolute("y"), scene.ground, boom)
    mast = scene.ground.at(0, 0, 3)
    scene.force("rope", cd.SpringDamper(boom.at(1, 0, 0), mast, stiffness=3))
    scene.force("load", cd.Force(boom, (1, 2, 0)))
    scene.force("motor", cd.JointForce("hinge", 0.1))
    motion = cd.compile(scene).simulate(0.1)
    names = ["rope.force", "load.force", "load.moment.x", "motor.force"]
    groups = {
        (g.name, g.unit): [name for name, _ in g.curves] for g in curves_by_unit(motion, names)
    }
    assert groups == {
        ("forces", "N"): ["rope.force", "load.force.x", "load.force.y", "load.force.z"],
        ("torques", "N m"): ["load.moment.x", "motor.force"],
    }
