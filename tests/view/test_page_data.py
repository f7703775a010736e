"""What the 3-D page is given: places, curves, arrows, meshes, the direction to look from."""

from __future__ import annotations

import struct
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import cardan as cd
from cardan.view.packing import Packer, turns
from view.unpacked import data_of


@pytest.fixture(scope="module")
def motion() -> cd.Trajectory:
    scene = cd.Scene("arm", gravity=(0, 0, -9.81))
    upper = scene.body("upper", mass=1, com=(0, 0, -0.5), inertia=(1, 1, 0.1))
    lower = scene.body("lower", mass=1, com=(0, 0, -0.4), inertia=(1, 1, 0.1))
    scene.joint("shoulder", cd.Revolute("y"), scene.ground, upper)
    scene.joint("elbow", cd.Revolute("x"), upper.at(0, 0, -1), lower)
    scene.force("spring", cd.SpringDamper(scene.ground.at(1, 0, 0), lower, stiffness=10))
    scene.force("damper", cd.SpringDamper(scene.ground.at(2, 0, 0), lower, damping=0.3))
    scene.force("stop", cd.Stop("elbow", upper=0.5))
    return cd.compile(scene).simulate(2.0, q={"shoulder": 1.0, "elbow": 0.4})


def page(motion: cd.Trajectory, tmp_path: Path, **options: object) -> dict[str, object]:
    return data_of(motion.animate(tmp_path / "page.html", **options).html)  # type: ignore[arg-type]


@pytest.mark.parametrize("orders", [0, 1, 2])
def test_packed_numbers_are_those_given_to_half_a_step(orders: int) -> None:
    rng = np.random.default_rng(orders)
    table = np.cumsum(rng.normal(size=(50, 3)), axis=0) * 1e3
    pack = Packer()
    pack.add(np.zeros((3, 2)), 1.0)
    entry = pack.add(table, 1e-3, orders)
    text = f'<script id="data">{{"a": {str(entry).replace(chr(39), chr(34))}}}</script>'
    found = data_of(f'{text}<script id="blob">{pack.text()}</script>')["a"]
    np.testing.assert_allclose(found, table, rtol=0, atol=0.5001e-3)


def test_numbers_that_are_not_finite_are_refused() -> None:
    with pytest.raises(cd.ModelError, match="finite"):
        Packer().add([[0.0], [np.nan]], 1.0)


def test_quaternions_do_not_jump() -> None:
    angles = np.linspace(0, 4 * np.pi, 200)
    found = turns(Rotation.from_rotvec(angles[:, None] * [[0, 0, 1]]).as_matrix()[:, None])
    assert np.abs(np.diff(found, axis=0)).max() < 0.05


def test_places_are_those_of_the_motion(motion: cd.Trajectory, tmp_path: Path) -> None:
    data = page(motion, tmp_path)
    t, poses = data["t"][:, 0], data["poses"].reshape(-1, 2, 7)  # type: ignore
    assert [body["name"] for body in data["bodies"]] == ["upper", "lower"]  # type: ignore
    at = motion.resample(t).pose("lower")
    np.testing.assert_allclose(poses[:, 1, :3], at[:, :3, 3], rtol=0, atol=2e-5)
    turned = Rotation.from_quat(poses[:, 1, 3:]).as_matrix()
    np.testing.assert_allclose(turned, at[:, :3, :3], rtol=0, atol=5e-5)


def test_springs_and_dampers_hang_between_their_frames(
    motion: cd.Trajectory, tmp_path: Path
) -> None:
    data = page(motion, tmp_path)
    spring, damper = data["springs"]  # type: ignore
    assert (spring["name"], spring["coil"], spring["damper"]) == ("spring", True, False)
    assert (damper["coil"], damper["damper"]) == (False, True)
    end = motion.resample(data["t"][:, 0]).pose("lower")[:, :3, 3]  # type: ignore
    np.testing.assert_allclose(spring["ends"][:, :3], [[1, 0, 0]] * len(end), atol=1e-4)
    np.testing.assert_allclose(spring["ends"][:, 3:], end, rtol=0, atol=1e-4)


def test_reactions_are_computed_when_they_are_named(motion: cd.Trajectory, tmp_path: Path) -> None:
    assert page(motion, tmp_path)["arrows"] == []
    data = page(motion, tmp_path, show="reactions")
    arrow = next(a for a in data["arrows"] if a["name"] == "shoulder.force")  # type: ignore
    exact = motion.resample(data["t"][:, 0])  # type: ignore
    turn = exact.pose("upper")[:, :3, :3]
    expected = np.einsum("tij,tj->ti", turn, exact["shoulder.force"])
    size = np.abs(expected).max()
    np.testing.assert_allclose(arrow["vector"], expected, rtol=0, atol=1e-3 * size)


def test_loads_and_contacts_are_arrows_where_they_act(tmp_path: Path) -> None:
    scene = cd.Scene("ball", gravity=(0, 0, -9.81))
    ball = scene.body("ball", mass=2, inertia=(0.1, 0.1, 0.1))
    scene.joint("lift", cd.Prismatic("z"), scene.ground, ball)
    floor = cd.Contact(ball, scene.ground, radius=0.1, stiffness=1e4, damping=0.5)
    scene.force("floor", floor)
    scene.force("wind", cd.Force(ball.at(0, 0, 0.1), (3, 0, 0)))
    motion = cd.compile(scene).simulate(10.0, q={"lift": 0.12})
    arrows = {a["name"]: a for a in page(motion, tmp_path)["arrows"]}  # type: ignore
    assert {a["layer"] for a in arrows.values()} == {"contacts", "forces"}
    # at rest the floor bears the weight
    np.testing.assert_allclose(arrows["floor.force"]["vector"][-1], [0, 0, 2 * 9.81], rtol=0.02)
    np.testing.assert_allclose(arrows["wind.force"]["vector"][-1], [3, 0, 0], atol=1e-2)
    rise = arrows["wind.force"]["at"][:, 2] - arrows["floor.force"]["at"][:, 2]
    np.testing.assert_allclose(rise, 0.1, atol=1e-4)
    assert page(motion, tmp_path)["floor"] == 0


def test_curves_have_names_units_and_events(motion: cd.Trajectory, tmp_path: Path) -> None:
    data = page(motion, tmp_path)
    energy, angles = data["histories"]  # type: ignore
    assert (energy["unit"], [c["name"] for c in energy["curves"]]) == (
        "J",
        ["kinetic", "potential", "total"],
    )
    assert [c["name"] for c in angles["curves"]] == ["shoulder", "elbow"]
    at = motion.resample(data["t"][:, 0])  # type: ignore
    np.testing.assert_allclose(angles["curves"][1]["y"][:, 0], at["elbow"], rtol=0, atol=2e-4)
    assert [e["name"] for e in data["events"]] == [e.name for e in motion.events]  # type: ignore
    chosen = page(motion, tmp_path, plots=["elbow.u", "shoulder.force"])
    units = [(h["unit"], len(h["curves"])) for h in chosen["histories"]]  # type: ignore
    assert units == [("rad/s", 1), ("N", 3)]


def test_what_does_not_exist_is_named(motion: cd.Trajectory, tmp_path: Path) -> None:
    for options, said in (
        ({"show": "reaction"}, "no such layer.*reactions"),
        ({"plots": "elbo"}, "no such history.*elbow"),
        ({"follow": "uper"}, "no such body.*upper"),
        ({"traces": ["uper"]}, "frame 'uper' does not exist.*upper"),
        ({"meshes": 0.0}, "meshes=0.0: give"),
        ({"page": "2d"}, "no such page"),
    ):
        with pytest.raises(cd.CardanError, match=said):
            page(motion, tmp_path, **options)


def test_a_plane_is_looked_at_from_its_side(tmp_path: Path) -> None:
    for axis, normal, up in (("y", (0, -1, 0), (0, 0, 1)), ("z", (0, 0, 1), (0, 1, 0))):
        scene = cd.Scene("swing", gravity=tuple(-9.81 * x for x in up))
        com = tuple(-0.5 * x for x in up)
        rod = scene.body("rod", mass=1, com=com, inertia=(1, 1, 1))
        scene.joint("pivot", cd.Revolute(axis), scene.ground, rod)
        data = page(cd.compile(scene).simulate(1.0, q={"pivot": 1.0}), tmp_path)
        np.testing.assert_allclose(data["normal"], normal, atol=1e-9)
        np.testing.assert_allclose(data["up"], up)


def test_joints_that_close_loops_are_pins_along_their_axes(tmp_path: Path) -> None:
    model = cd.compile(cd.examples["four_bar"])
    data: Any = page(model.simulate([0, 0.1], q={"A": 0.5}), tmp_path)
    pins = {
        body["name"]: [s for s in body["solids"] if s["kind"] == "cylinder" and s["color"]]
        for body in data["bodies"]
    }
    # B sits on the coupler, C closes the loop on the tip of the rocker; all turn about z
    assert {name: len(solids) for name, solids in pins.items()} == {
        "crank": 1,
        "coupler": 1,
        "rocker": 2,
    }
    closing = np.array([pins["rocker"][1][end] for end in "ab"])
    np.testing.assert_allclose(closing.mean(axis=0), [0.2, 0, 0], atol=1e-6)
    along = closing[1] - closing[0]
    np.testing.assert_allclose(along, [0, 0, np.linalg.norm(along)], atol=1e-6)


def test_motion_in_space_has_no_plane(motion: cd.Trajectory, tmp_path: Path) -> None:
    assert page(motion, tmp_path)["normal"] is None


def test_fast_swings_are_slowed_down(tmp_path: Path) -> None:
    def rate(stiffness: float, time: float) -> float:
        scene = cd.Scene("mass", gravity=(0, 0, 0))
        body = scene.body("body", mass=1)
        scene.joint("slide", cd.Prismatic("x"), scene.ground, body)
        scene.force("spring", cd.JointSpring("slide", stiffness=stiffness))
        run = cd.compile(scene).simulate(time, q={"slide": 0.1})
        return float(page(run, tmp_path)["rate"])  # type: ignore[arg-type]

    assert rate(1.0, 20.0) == 1.0
    # 100 Hz at some swings per second
    assert rate((200 * np.pi) ** 2, 2.0) == pytest.approx(0.01)


def stl(path: Path, size: float) -> None:
    """A tetrahedron."""
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], dtype="<f4") * size
    faces = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
    rows = b"".join(
        struct.pack("<3f", 0, 0, 0) + corners[list(f)].tobytes() + b"\0\0" for f in faces
    )
    path.write_bytes(bytes(80) + struct.pack("<I", len(faces)) + rows)


def test_meshes_are_in_the_page(tmp_path: Path) -> None:
    stl(tmp_path / "part.stl", 2.0)
    scene = cd.Scene("one")
    shape = cd.shape.mesh(str(tmp_path / "part.stl"), scale=(0.5, 1, 1), color=(1, 0, 0, 1))
    body = scene.body("body", mass=1, inertia=(1, 1, 1), shape=shape)
    scene.joint("pivot", cd.Revolute("y"), scene.ground, body)
    motion = cd.compile(scene).simulate(0.1)
    (solid,) = page(motion, tmp_path)["bodies"][0]["solids"]  # type: ignore[index]
    corners = np.array(solid["low"]) + np.array(solid["unit"]) * solid["positions"]
    assert {tuple(np.round(c, 3)) for c in corners} == {(0, 0, 0), (1, 0, 0), (0, 2, 0), (0, 0, 2)}
    assert solid["triangles"].shape == (4, 3)
    assert solid["color"] == [1, 0, 0, 1]
    # what cannot be read is drawn as links, and said
    (tmp_path / "part.stl").write_bytes(b"no mesh")
    with pytest.warns(cd.ModelWarning, match="1 mesh cannot be drawn: .*part.stl"):
        solids = page(motion, tmp_path)["bodies"][0]["solids"]  # type: ignore[index]
    assert solids[0]["kind"] == "link"
    assert page(motion, tmp_path, meshes=False)["bodies"][0]["solids"] == solids  # type: ignore


def test_positions_that_are_no_motion_have_pages(tmp_path: Path) -> None:
    scene = cd.Scene("press", gravity=(0, 0, -9.81))
    body = scene.body("body", mass=1, inertia=(1, 1, 1))
    scene.joint("guide", cd.Prismatic("z"), scene.ground, body)
    load, top = scene.parameter("P", 0.0), scene.parameter("top", 1.0)
    scene.force("spring", cd.SpringDamper(scene.ground.at(0, 0, top), body, stiffness=50))
    scene.force("load", cd.Force(body, (0, 0, -load)))
    model = cd.compile(scene)
    rest = model.equilibrium()
    still = data_of(rest.animate(tmp_path / "rest.html", show="reactions").html)
    assert len(still["t"]) == 1
    assert still["poses"][0, 2] == pytest.approx(rest["guide"], abs=1e-4)
    with pytest.raises(cd.ArgumentError, match="a single position has not"):
        rest.animate(tmp_path / "rest.html", plots="guide")
    path = model.statics(P=(0, 20))
    shown = data_of(path.animate(tmp_path / "path.html").html)
    assert shown["abscissa"] == {"name": "P", "unit": ""}
    np.testing.assert_allclose(shown["t"][:, 0], path["P"], atol=1e-6)
    np.testing.assert_allclose(shown["poses"][:, 2], path["guide"], atol=1e-4)
    # a parameter of the path that moves a frame moves it in the picture
    risen = model.statics(top=(1, 2))
    ends = data_of(risen.animate(tmp_path / "path.html").html)["springs"][0]["ends"]
    np.testing.assert_allclose(ends[:, 2], risen["top"], atol=1e-4)
    found = model.assemble({"guide": 0.3})
    assert data_of(found.animate(tmp_path / "found.html").html)["poses"][0, 2] == pytest.approx(
        0.3, abs=1e-4
    )
    sweep = model.sweep("guide", [0.0, 0.5, 1.0])
    swept = data_of(sweep.animate(tmp_path / "sweep.html").html)
    np.testing.assert_allclose(swept["t"][:, 0], sweep.values, atol=1e-6)
    mode = data_of(model.modes().animate(0, tmp_path / "mode.html").html)
    assert np.ptp(mode["poses"][:, 2]) > 0.1


def test_pages_of_sweeps_take_the_modes_and_states_of_a_start(tmp_path: Path) -> None:
    scene = cd.Scene("lift", gravity=(0, 0, 0))
    body = scene.body("body", mass=1, inertia=(1, 1, 1))
    scene.joint("guide", cd.Prismatic("z"), scene.ground, body)
    scene.force("end", cd.Stop("guide", upper=5.0))
    scene.force("mount", cd.Maxwell(scene.ground.at(0, 1, 0), body, stiffness=1e3, damping=1.0))
    scene.cable("rope", scene.ground.at(0, 0, 3.0), body, EA=1e3, length=2.0)
    sweep = cd.compile(scene).sweep("guide", [0.0, 0.5, 1.0])
    shown = data_of(sweep.animate(tmp_path / "sweep.html").html)
    np.testing.assert_allclose(shown["t"][:, 0], sweep.values, atol=1e-6)


def test_a_page_without_a_path_is_shown(
    motion: cd.Trajectory, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    import sys
    import webbrowser

    opened: list[str] = []
    monkeypatch.setattr(webbrowser, "open", lambda url: bool(opened.append(url)))
    shown = motion.animate()
    assert shown.path is not None
    assert opened == [shown.path.as_uri()]
    assert str(shown.path) in capsys.readouterr().err
    shown.path.unlink()
    # in a notebook it stands in a frame of its own
    monkeypatch.setitem(sys.modules, "ipykernel", sys)
    inline = motion.animate()
    assert inline.path is None
    frame = inline._repr_html_()
    assert frame.startswith("<iframe srcdoc=")
    assert 'sandbox="allow-scripts allow-downloads"' in frame
    assert "<script" not in frame
