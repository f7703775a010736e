"""Loads of records in scenes: heat, and forces that turn with the body."""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.runtime.models.initial import start_of
from mechanisms.superelements import FRAMES
from scene.test_scene_schema import complaints, document
from solids.meshes import block
from superelements.components import brick_matrices, faces, planar_beam

RUBBER = cd.material(E=5e6, nu=0.4, rho=1100, expansion=2e-4)
SIZE = (0.4, 0.05, 0.02)
EXPANSION, EA, LENGTH = 1.2e-5, 2e6, 2.0


@cache
def link() -> Any:
    """A bar of solids whose ends follow their nodes, so that they may expand."""
    mesh = block("hex8", (6, 2, 2), SIZE)
    x = mesh.points[:, 0]
    ends = {"root": np.flatnonzero(x < 1e-9), "tip": np.flatnonzero(x > SIZE[0] - 1e-9)}
    return cd.superelement.from_mesh(
        mesh,
        RUBBER,
        ends,
        modes=2,
        rigid="rbe3",
        static_shapes=["temperature"],
        stress=range(len(mesh.points)),
    )


@cache
def bar(stated: bool = True) -> Any:
    """A planar bar of four elements, by matrices, with its stress in each element."""
    M, K, nodes = planar_beam(LENGTH, 4, EA, 1e3, 10.0)
    heat = np.zeros(len(M))
    heat[[0, -3]] = -EA * EXPANSION, EA * EXPANSION
    rows = np.zeros((4, len(M)))
    for k in range(4):
        rows[k, [3 * k, 3 * k + 3]] = -EA / (LENGTH / 4), EA / (LENGTH / 4)
    stated_loads = {"heat": -EA * EXPANSION * np.ones(4)} if stated else {}
    return cd.superelement.reduce(
        M,
        K,
        nodes,
        {"left": 0, "right": 4},
        node_dofs="x y rz",
        modes=2,
        loads={"heat": heat},
        stress=rows,
        stress_names=[f"N{k}" for k in range(4)],
        load_stresses=stated_loads,
    )


@pytest.mark.parametrize("frame", ["root", "mean"])
def test_a_body_that_nothing_resists_expands_without_stress(frame: str) -> None:
    """By alpha dT L along and alpha dT b across, at rest; strains of 0.8 % and no stress."""
    scene = cd.Scene("oven", gravity=(0, 0, 0))
    scene.superelement(
        "link", link(), {"root": scene.ground}, frame=frame, loads={"temperature": 40.0}
    )
    model = cd.compile(scene)
    rest = model.equilibrium()
    strain = 40.0 * 2e-4
    tip = model.pose("link.tip", rest.q)[:3, 3] - model.pose("link.root", rest.q)[:3, 3]
    np.testing.assert_allclose(tip, [(1 + strain) * SIZE[0], 0, 0], rtol=1e-9, atol=1e-9)
    shape = model.superelement("link", rest.q)
    width = np.ptp(shape.positions, axis=0)
    np.testing.assert_allclose(width, (1 + strain) * np.array(SIZE), rtol=1e-8)
    assert shape.largest_stress < 1e-8 * RUBBER.E * strain
    # with all coordinates 0 the heat is there, and everything resists it
    held = model.superelement("link", start_of(model, {}, {})[0][: model.nq])
    pressure = RUBBER.E * strain / (1 - 2 * 0.4)
    normal = held.stress[..., :3].mean(axis=0)
    if frame == "root":
        np.testing.assert_allclose(normal, -pressure, rtol=1e-8)


@pytest.mark.parametrize("frame", ["left", "mean"])
def test_supports_of_a_heated_bar_bear_what_it_may_not_expand(frame: str) -> None:
    """EA alpha dT, whatever the temperature comes from."""
    scene = cd.Scene("bar", gravity=(0, 0, 0))
    rise = scene.parameter("rise", 30.0)
    ends = {"left": scene.ground, "right": scene.ground.at(LENGTH, 0, 0)}
    scene.superelement("bar", bar(), ends, frame=frame, loads={"heat": 2 * rise})
    model = cd.compile(scene)
    for value in (30.0, -10.0):
        there = model.with_parameters({"rise": value})
        rest = there.equilibrium()
        force = 2 * value * EA * EXPANSION
        pushes = there.reaction("bar.right.fixed", rest.q, np.zeros(there.nu))[3:]
        np.testing.assert_allclose(np.abs(pushes), [abs(force), 0, 0], rtol=1e-9, atol=1e-6)
        z = np.zeros(bar().n)
        np.testing.assert_allclose(bar().stresses(z, {"heat": 2 * value}), -force, rtol=1e-12)


def test_a_number_is_one_parameter_of_the_load_and_its_stress() -> None:
    scene = cd.Scene("bar", gravity=(0, 0, 0))
    scene.superelement("bar", bar(), {"left": scene.ground}, frame="left", loads={"heat": 30.0})
    model = cd.compile(scene)
    assert [p.name for p in model.manifest.parameters if "heat" in p.name] == ["bar.heat.factor"]
    cold = model.with_parameters({"bar.heat.factor": 5.0})
    for one, rise in ((model, 30.0), (cold, 5.0)):
        rest = one.equilibrium()
        tip = one.pose("bar.right", rest.q)[0, 3]
        np.testing.assert_allclose(tip, LENGTH * (1 + EXPANSION * rise), rtol=1e-12)
        np.testing.assert_array_equal(one.superelement("bar", rest.q).factors, [rise])


def test_free_bars_of_matrices_have_no_stress() -> None:
    record, rise = bar(), 25.0
    z = np.linalg.lstsq(record.K, rise * record.loads["heat"], rcond=1e-12)[0]
    bound = 1e-9 * rise * EA * EXPANSION
    np.testing.assert_allclose(record.stresses(z, {"heat": rise}), np.zeros(4), atol=bound)
    expected = EA * EXPANSION * rise * np.ones(4)
    np.testing.assert_allclose(record.stresses(z), expected, rtol=1e-9)
    span = np.ptp(record.displacements(z).reshape(-1, 3)[:, 0])
    np.testing.assert_allclose(span, EXPANSION * rise * LENGTH, rtol=1e-9)
    with pytest.raises(cd.ModelError, match=r"load 'heat' adds .* load_stresses="):
        bar(False).stresses(z, {"heat": rise})
    with pytest.raises(cd.ModelError, match=r"no load 'heta'.*Did you mean 'heat'"):
        record.stresses(z, {"heta": rise})


@cache
def pushed(frame: str) -> Any:
    """The brick in space under a field of forces like weight, which turns along."""
    M, K, nodes = brick_matrices()
    field = M @ np.tile([1.0, 0, 0], len(nodes))
    record = cd.superelement.reduce(
        M, 1e-4 * K, nodes, faces(), modes=2, loads={"thrust": field}, damping=0.02
    )
    scene = cd.Scene("rocket", gravity=(0, 0, 0))
    push = scene.input("push", default=3.0)
    body = scene.superelement("body", record, frame=frame, loads={"thrust": push * cd.t})
    scene.joint("free", cd.Free(), scene.ground, body.at("root"))
    return cd.compile(scene)


@pytest.mark.parametrize("frame", FRAMES)
def test_forces_turn_with_the_body(frame: str) -> None:
    """All of it is accelerated along its own axis, as by weight, and nothing deforms."""
    model = pushed(frame)
    half = np.sqrt(0.5)
    q = start_of(model, {"free": [half, 0, 0, half, 1.0, 2.0, 3.0]}, {})[0][: model.nq]
    udot = model.forward_dynamics(q, np.zeros(model.nu), t=2.0)
    found = model.acceleration("body.tip", q, np.zeros(model.nu), udot, t=2.0)
    np.testing.assert_allclose(found, [0, 0, 0, 0, 6.0, 0], atol=1e-8)


def test_work_of_loads_is_in_the_balance() -> None:
    model = pushed("root")
    run = model.simulate(
        0.1, u={"free": [0, 0, 3.0, 0, 0, 0]}, inputs={"push": 50.0}, method="DOP853", rtol=1e-10
    )
    assert abs(run.work["body.thrust"][-1]) > 1e-3
    assert abs(run.balance.residual) < 1e-8 * np.abs(run.energy.total).max()
    np.testing.assert_allclose(run["body.thrust"], 50.0 * run.t)
    assert model.verify(seed=3).worst < 1e-9


def test_stress_along_a_motion_and_in_its_file(tmp_path: Path) -> None:
    scene = cd.Scene("heated", gravity=(0, 0, 0))
    ends = {"root": scene.ground, "tip": scene.ground.at(SIZE[0], 0, 0)}
    scene.superelement("link", link(), ends, frame="root", loads={"temperature": 100 * cd.t})
    motion = cd.compile(scene).simulate([0, 0.1, 0.2], method="GeneralizedAlpha", step=0.01)
    shape = motion.superelement("link")
    # of a slow motion between fixed ends: E alpha dT, but for the ends
    middle = np.abs(shape.surface.points[shape.stressed, 0] - SIZE[0] / 2) < 0.05
    along = shape.stress[-1, middle, 0]
    np.testing.assert_allclose(along, -RUBBER.E * 2e-4 * 20.0, rtol=0.15)
    motion.save(tmp_path / "run.npz")
    again = cd.load_motion(tmp_path / "run.npz").superelement("link")
    np.testing.assert_array_equal(again.stress, shape.stress)
    np.testing.assert_array_equal(again.factors[:, 0], 100 * motion.t)


def test_in_files_and_in_other_scenes(tmp_path: Path) -> None:
    scene = cd.Scene("part", gravity=(0, 0, 0))
    rise = scene.input("rise", default=1.0)
    scene.superelement(
        "bar", bar(), {"left": scene.ground}, loads={"heat": 20 * rise + cd.t}, frame="left"
    )
    assert "heat 20*rise + t" in str(scene)
    scene.save(tmp_path / "part.yaml")
    assert complaints(document(tmp_path / "part.yaml")) == []
    again = cd.load(tmp_path / "part.yaml")
    assert again.superelements["bar"].loads == scene.superelements["bar"].loads
    record = again.superelements["bar"].record
    np.testing.assert_array_equal(record.load_stresses["heat"], bar().load_stresses["heat"])
    whole = cd.Scene("whole")
    whole.include(again, "left")
    assert str(whole.superelements["left.bar"].loads["heat"]) == "20*left.rise + t"
    text = cd.derive(whole).explain(tmp_path / "page.md").read_text("utf-8")
    assert "times the factor s" in text


REFUSED = {
    "gravity": ({"gravity": 1.0}, "gravity= of the scene"),
    "unknown": ({"hot": 1.0}, "no load 'hot'.*Give loads= to the reduction"),
    "text": ({"heat": "warm"}, "not the text 'warm'"),
    "infinite": ({"heat": float("inf")}, "finite"),
}


@pytest.mark.parametrize("case", REFUSED)
def test_refused(case: str) -> None:
    loads, message = REFUSED[case]
    with pytest.raises((cd.ModelError, cd.ArgumentError), match=message):
        cd.Scene("wrong").superelement("bar", bar(), loads=loads)


@pytest.mark.parametrize("argument", ["interfaces", "loads"])
def test_what_is_given_by_name_is_no_list(argument: str) -> None:
    options: Any = {argument: ["left"]}
    with pytest.raises(cd.ArgumentError, match=rf"{argument}=\['left'\]: give .* by name"):
        cd.Scene("wrong").superelement("bar", bar(), **options)


def test_factors_that_move_are_refused() -> None:
    scene = cd.Scene("wrong")
    scene.joint("hinge", cd.Revolute("z"), scene.ground, scene.body("hub", 1.0))
    with pytest.raises(cd.ModelError, match=r"reads 'hinge', which moves"):
        scene.superelement("bar", bar(), loads={"heat": scene.q("hinge")})


def test_stress_of_loads_that_nobody_stated_is_refused() -> None:
    mesh = block("hex8", (2, 1, 1), SIZE)
    x = mesh.points[:, 0]
    ends = {"root": np.flatnonzero(x < 1e-9), "tip": np.flatnonzero(x > SIZE[0] - 1e-9)}
    solid = cd.superelement.mesh.Solid(mesh, RUBBER)
    nodes = [*range(len(mesh.points))]
    record = cd.superelement.reduce(
        solid.mass(),
        solid.stiffness(),
        mesh.points,
        ends,
        modes=0,
        loads={"heat": cd.superelement.mesh.thermal(solid, 1.0)},
        stress=cd.superelement.mesh.stress_operator(solid, nodes),
        stress_names=[f"{k} {one}" for k in nodes for one in ("xx", "yy", "zz", "yz", "zx", "xy")],
    )
    scene = cd.Scene("heated", gravity=(0, 0, 0))
    scene.superelement("link", record, {"root": scene.ground}, frame="root", loads={"heat": 1.0})
    model = cd.compile(scene)
    shape = model.superelement("link", start_of(model, {}, {})[0][: model.nq])
    with pytest.raises(cd.ModelError, match="load_stresses= of every load that acts"):
        shape.stress  # noqa: B018
