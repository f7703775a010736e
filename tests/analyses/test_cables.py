"""Cables: closed forms, other coordinates, files, pages."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import fsolve

import cardan as cd
from cardan.topology.cables.hanging_shape import hanging
from cardan.view.drawing import solids_of
from table import each

COORDINATES = ("relative", "auto", "absolute")
EA, MASS, LENGTH, GRAVITY = 2000.0, 1.5, 10.0, 9.81


def hung(elements: int, **options: Any) -> cd.Scene:
    scene = cd.Scene("catenary", gravity=(0, 0, -GRAVITY))
    far = scene.ground.at(8.0, 0, 1.0)
    numbers = {"EA": EA, "rhoA": MASS, "length": LENGTH} | options
    scene.cable("rope", scene.ground, far, elements=elements, **numbers)
    return scene


def catenary(s: Any) -> tuple[Any, Any]:
    """Points (x, z) of the elastic catenary at lengths s without load, and its tension there."""
    weight = MASS * GRAVITY

    def point(s: Any, h: float, v: float) -> tuple[Any, Any]:
        # Irvine, Cable Structures, equations 1.13: v is what the first end carries
        x = h * s / EA + h / weight * (np.arcsinh(v / h) - np.arcsinh((v - weight * s) / h))
        sag = (
            s / EA * (v - weight * s / 2) + (np.hypot(h, v) - np.hypot(h, v - weight * s)) / weight
        )
        return x, -sag

    def gap(x: Any) -> Any:
        end = point(LENGTH, *x)
        return end[0] - 8.0, end[1] - 1.0

    h, v = fsolve(gap, (weight * LENGTH / 2, weight * LENGTH / 2), xtol=1e-13)
    return np.stack(point(s, h, v), axis=-1), np.hypot(h, v - weight * s)


def test_a_hanging_cable_is_the_elastic_catenary() -> None:
    """Second order in its pieces, from the reference configuration as from an equilibrium."""
    errors = []
    for elements in (8, 16, 32):
        model = cd.compile(hung(elements))
        start = model.initial()
        rest = model.equilibrium()
        assert np.allclose(rest.q, start[: model.nq], atol=1e-9)
        s = LENGTH * np.arange(1, elements) / elements
        points, _ = catenary(s)
        nodes = np.array([rest.pose(f"rope.node{k}")[[0, 2], 3] for k in range(1, elements)])
        cable = model.cable("rope", rest.q)
        _, tension = catenary(LENGTH * cable.s)
        errors.append((np.abs(nodes - points).max(), np.abs(cable.tension - tension).max()))
        assert cable.taut.all()
    for coarse, fine in pairwise(errors):
        assert 3.5 < coarse[0] / fine[0] < 4.5
        assert 3.0 < coarse[1] / fine[1] < 5.0
    assert errors[-1][0] < 3e-3


@each("coordinates", COORDINATES)
def test_frequencies_of_a_taut_string(coordinates: str) -> None:
    """Those of n - 1 points on a string, sin(k pi / 2 n) exactly."""
    n, tension = 6, 300.0
    scene = cd.Scene("string", gravity=(0, 0, 0))
    ends = (scene.ground, scene.ground.at(0, 2.0, 0))
    scene.cable("string", *ends, EA=EA, rhoA=0.3, tension=tension, elements=n)
    model = cd.compile(scene, coordinates=coordinates)
    rest = model.equilibrium()
    assert np.allclose(model.cable("string", rest.q).tension, tension, rtol=1e-12)
    length = 2.0 / (1 + tension / EA)
    mass, span = 0.3 * length / n, 2.0 / n
    k = np.arange(1, n)
    across = 2 * np.sqrt(tension / (mass * span)) * np.sin(k * np.pi / (2 * n))
    along = 2 * np.sqrt(EA / (length / n) / mass) * np.sin(k * np.pi / (2 * n))
    expected = np.sort([*across, *across, *along])
    found = np.sort(2 * np.pi * model.modes(len(expected), rest).frequencies)
    assert np.allclose(found, expected, rtol=1e-8)


def tether(scene: cd.Scene) -> None:
    ball = scene.body("ball", mass=2.0, inertia=(0.1, 0.1, 0.1))
    scene.joint("free", cd.Translation(), scene.ground, ball)
    scene.cable("tether", scene.ground, ball, EA=500.0, length=1.0, damping=0.02)


@each("coordinates", ("relative", "absolute"))
def test_a_slack_tether_by_hand_written_equations(coordinates: str) -> None:
    """Free flight, then a pull that damping takes energy from; in a scene of rigid bodies."""
    scene = cd.Scene("tethered", gravity=(0, 0, -2.0))
    tether(scene)
    # ends of steps lie at the kinks
    span = scene.bodies["ball"].position()
    distance = (span[0] ** 2 + span[1] ** 2 + span[2] ** 2) ** 0.5
    scene.force("taut", cd.Event(distance - 1))
    scene.force("slack", cd.Event(1 - distance))
    model = cd.compile(scene, coordinates=coordinates)
    start, speed = np.array([0.3, 0.1, 0.2]), np.array([1.0, -0.5, 0.7])
    motion = model.simulate(
        3.0,
        q={"free": start},
        u={"free": speed},
        # rounding says on which side of the jump of the damping force a step starts, and so which
        # power its first stage has: in short steps that stage weighs little
        **{"method": "DOP853", "rtol": 1e-11, "atol": 1e-11, "max_step": 1e-4},
    )

    def rates(_: float, x: Any) -> Any:
        p, v = np.split(x, 2)
        size = np.linalg.norm(p)
        strain, rate = size - 1.0, p @ v / size
        pull = max(500.0 * (strain + 0.02 * rate), 0.0) if strain > 0 else 0.0
        return np.concatenate([v, -pull * p / size / 2.0 + [0, 0, -2.0]])

    solution = solve_ivp(
        rates, (0, 3.0), [*start, *speed], rtol=1e-10, atol=1e-11, max_step=1e-3, method="DOP853"
    )
    assert np.allclose(motion["free"][-1], solution.y[:3, -1], atol=1e-6)
    tension = motion.cable("tether")
    assert tension.taut.any()
    assert not tension.taut.all()
    assert np.abs(motion.energy_residual).max() < 1e-4


def test_a_cable_on_a_prescribed_hook_at_a_time() -> None:
    scene = cd.Scene("hoist", gravity=(0, 0, 0))
    hook, drum = (scene.body(name, mass=1.0, inertia=(1, 1, 1)) for name in ("hook", "drum"))
    scene.joint("lift", cd.Prismatic("z"), scene.ground, hook, prescribed=1 + 0.1 * cd.t)
    scene.joint("spin", cd.Revolute("z"), scene.ground, drum)
    scene.cable("rope", scene.ground, hook, EA=500.0, length=1.0)
    model = cd.compile(scene)
    rest = model.cable("rope", model.initial()[:1], t=2.0)
    assert np.allclose(rest.tension, 500.0 * 0.2)


def crane(**places: Any) -> cd.Scene:
    """A boom held by a guy, with a rope of several pieces to a load, and a beam with a stay."""
    scene = cd.Scene("crane")
    boom = scene.body("boom", mass=4.0, com=(1.0, 0, 0), inertia=(0.01, 1.3, 1.3))
    scene.joint("luff", cd.Revolute("y"), scene.ground, boom)
    scene.cable("guy", scene.ground.at(0, 0, 2), boom.at(2, 0, 0), EA=5e4, tension=30.0)
    load = scene.body("load", mass=3.0, inertia=(0.1, 0.1, 0.1))
    scene.joint("swing", cd.Translation(), scene.ground, load, q0=(2.0, 0, -1.5))
    scene.cable("rope", boom.at(2, 0, 0), (2.0, 0, -1.5), EA=4e4, rhoA=0.4, elements=3)
    scene.force("hook", cd.SpringDamper("rope.end", load, stiffness=900.0, damping=5.0))
    return scene


def accelerations(scene: cd.Scene, coordinates: str) -> Any:
    model = cd.compile(scene, coordinates=coordinates)
    names = ["boom", "load", "rope.node1", "rope.node2", "rope.end"]
    q = {"luff": 0.05, "rope.node1": (2.0, 0.1, -0.5), "rope.end": (2.1, 0, -1.6)}
    u = {"luff": 0.4, "rope.node2": (0.3, -0.2, 0.1)}
    q, u = model.split(model.initial(q, u))
    udot = model.forward_dynamics(q, u)
    found = [model.acceleration(name, q, u, udot)[3:] for name in names]
    return np.array(found), model.energy(q, u)


def test_every_kind_of_coordinates_has_the_same_accelerations() -> None:
    relative, energy = accelerations(crane(), "relative")
    for coordinates in ("auto", "absolute"):
        other, of_other = accelerations(crane(), coordinates)
        assert np.allclose(other, relative, rtol=1e-10, atol=1e-9)
        assert np.allclose(of_other, energy, rtol=1e-10)


def test_a_beam_with_a_stay() -> None:
    """The cable carries what the tip of the beam is short of; many pieces weigh what one does."""
    for elements in (1, 5):
        scene = cd.Scene("mast", gravity=(0, 0, 0))
        section = cd.section.general(EA=1e7, GA=4e6, GJ=1e4, EI=2e4, rhoA=5.0, rhoI=0.01)
        mast = scene.beam("mast", scene.ground, (0, 0, 3.0), section, elements=4)
        foot = scene.ground.at(2.0, 0, 0)
        scene.cable("stay", mast.end, foot, EA=1e5, rhoA=0.1, tension=50.0, elements=elements)
        scene.force("wind", cd.Force(mast.end, (-200.0, 0, 0)))
        model = cd.compile(scene)
        rest = model.equilibrium()
        tension = model.cable("stay", rest.q).tension
        assert np.ptp(tension) < 1e-6
        tip = rest.pose("mast.end")[:3, 3]
        along = (np.array([2.0, 0, 0]) - tip) / np.linalg.norm(np.array([2.0, 0, 0]) - tip)
        force = model.beam("mast", rest.q)
        shear = force.force[-1]
        turned = rest.pose("mast.end")[:3, :3] @ shear
        assert np.allclose(turned, tension[0] * along + [-200.0, 0, 0], rtol=1e-3)


def test_files_and_parts(tmp_path: Path) -> None:
    scene = crane()
    scene.save(tmp_path / "crane.yaml")
    text = (tmp_path / "crane.yaml").read_text()
    assert "rope.node1" not in text
    again = cd.load(tmp_path / "crane.yaml")
    whole = cd.Scene("whole")
    whole.include(scene, "left")
    found = [cd.compile(one) for one in (scene, again, whole)]
    states = [one.split(one.initial()) for one in found]
    udots = [one.forward_dynamics(*state) for one, state in zip(found, states, strict=True)]
    for q, udot in zip((state[0] for state in states[1:]), udots[1:], strict=True):
        assert np.allclose(q, states[0][0], atol=1e-14)
        assert np.allclose(udot, udots[0], atol=1e-9)
    assert found[2].parameters["left.rope.EA"] == 4e4


def test_numbers_are_parameters() -> None:
    model = cd.compile(hung(4))
    changed = model.with_parameters({"rope.length": 9.0, "rope.rhoA": 2.0})
    fresh = cd.compile(hung(4, length=9.0, rhoA=2.0))
    assert np.allclose(changed.equilibrium().q, fresh.equilibrium().q, atol=1e-8)
    scene = hung(4)
    scene.values["rope.EA"] = 3000.0
    other = cd.compile(hung(4, EA=3000.0))
    assert np.allclose(cd.compile(scene).initial(), other.initial(), atol=1e-9)
    scene = cd.Scene("expressions")
    stiffness = scene.parameter("k", 700.0, unit="N")
    scene.cable("rope", scene.ground, (1, 0, 0), EA=2 * stiffness, rhoA=0.1, elements=2)
    assert np.isclose(cd.compile(scene).with_parameters(k=800.0).parameters["k"], 800.0)


def test_pages_draw_lines_without_their_nodes() -> None:
    motion = cd.compile(crane()).simulate(0.05)
    bodies, _, lines, _ = solids_of(motion)
    assert {line.name: line.sections.shape[1] for line in lines} == {"guy": 2, "rope": 4}
    # its free end is a body of its own
    assert {body.name for body in bodies} == {"boom", "load", "rope.end"}
    rope = lines[[line.name for line in lines].index("rope")]
    for k, frame in enumerate(("rope.node1", "rope.node2", "rope.end"), 1):
        assert np.allclose(rope.sections[:, k, :3, 3], motion.pose(frame)[:, :3, 3])
    turns = rope.sections[..., :3, :3]
    assert np.allclose(turns @ np.swapaxes(turns, -1, -2), np.eye(3), atol=1e-12)
    assert "rope" in Path(motion.animate(None).path).read_text()


@pytest.mark.parametrize("length", [1.0, 2.5])
def test_hanging_without_gravity_and_straight_down(length: float) -> None:
    none, down = np.zeros(3), np.array([0, 0, -3.0])
    for end, weight in (((2.0, 0, 0), none), ((0, 0, -1.0), down), ((0, 0, 0), down)):
        points = hanging(np.zeros(3), np.array(end), length, 1e5, weight, 6)
        assert np.allclose(points[-1], end, atol=1e-9)
        pieces = np.linalg.norm(np.diff(points, axis=0), axis=1)
        if np.linalg.norm(end) < length:
            assert np.allclose(pieces, length / 6, rtol=0.1 if weight.any() else 1e-3)


def test_what_is_shown_of_cables() -> None:
    scene = crane()
    assert "rope   40000   0.4          " in str(scene)
    assert "cable: boom == rope.end  [rope: 3 elements]" in str(scene.graph)
    assert scene.cables["rope"].at(1 / 3).name == "rope.node1"
    cable = cd.compile(hung(4)).cable("rope", cd.compile(hung(4)).initial()[:9])
    assert str(cable).startswith("CableTension('rope', 4 elements: ")


def test_messages() -> None:
    scene = cd.Scene("messages")
    far = scene.ground.at(1, 0, 0)
    bad: list[tuple[dict[str, Any], str]] = [
        ({"EA": 0}, "EA is 0; give more than 0"),
        ({"EA": 1, "rhoA": -1}, "rhoA is -1; give 0 or more"),
        ({"EA": 1, "elements": 3}, r"its nodes have no mass.*give rhoA, or one element"),
        ({"EA": 1, "length": 1, "tension": 2}, "length and tension exclude each other"),
        ({"EA": 1, "tension": -2}, "tension is -2; a cable does not push"),
    ]
    for options, message in bad:
        with pytest.raises(cd.ModelError, match=message):
            scene.cable("rope", scene.ground, far, **options)
    rope = scene.cable("rope", scene.ground, far, EA=1, rhoA=1, elements=4)
    with pytest.raises(cd.ModelError, match=r"at\(0.3\) is not a node; nodes are at multiples"):
        rope.at(0.3)
    with pytest.raises(cd.ModelError, match="cable 'rope': the name is taken"):
        scene.cable("rope", scene.ground, far, EA=1)
    loop = cd.Scene("loop")
    loop.cable("ring", loop.ground, loop.ground, EA=1, rhoA=1, elements=4)
    with pytest.raises(cd.ModelError, match=r"its ends are at one point.*give length="):
        cd.derive(loop)
    with pytest.raises(cd.ArgumentError, match=r"cable 'rop' does not exist.*Did you mean 'rope'"):
        cd.compile(hung(2)).cable("rop", np.zeros(3))


@each("tension", (40.0, -4.0))
def test_a_prestressed_bar_with_a_hinge(tension: float) -> None:
    """Along and across a mass in its middle; one that pushes buckles there."""
    scene, L, mass = cd.Scene("bar", gravity=(0, 0, 0)), 2.0, 0.3
    far = scene.ground.at(L, 0, 0)
    numbers = {"EA": EA, "rhoA": 1e-9, "tension": tension, "elements": 2, "compression": True}
    bar = scene.cable("bar", scene.ground, far, **numbers)
    load = scene.body("load", mass)
    scene.joint("weld", cd.Fixed(), bar.at(0.5), load)
    model = cd.compile(scene)
    assert np.allclose(model.cable("bar", model.initial()[: model.nq]).tension, tension, rtol=1e-9)
    q, still, d = model.initial()[: model.nq], np.zeros(model.nu), 1e-6
    ends = [[model.forward_dynamics(q + s * row, still) for s in (-d, d)] for row in np.eye(3)]
    k = -mass * np.diff(ends, axis=1)[:, 0] / (2 * d)
    unloaded = L / (1 + tension / EA)
    expected = np.diag([4 * EA / unloaded, *([4 * tension / L] * 2)])
    np.testing.assert_allclose(k, expected, rtol=1e-6, atol=1e-5)


def test_a_shallow_truss_of_bars_snaps() -> None:
    """The load over the height, in closed form; prestressed bars have more of it."""
    width, height = 1.0, 0.2
    size = np.hypot(width, height)
    for tension in (0.0, -30.0):
        scene = cd.Scene("truss", gravity=(0, 0, 0))
        top = scene.body("top", 1.0)
        scene.joint("slide", cd.Prismatic("z"), scene.ground, top)
        for side in (-1, 1):
            foot = scene.ground.at(side * width, 0, -height)
            scene.cable(f"bar{side + 1}", foot, top, EA, tension=tension, compression=True)
        model = cd.compile(scene)
        length = size / (1 + tension / EA)
        for z in np.linspace(-0.3, 0.3, 7):
            distance = np.hypot(width, z)
            pull = -2 * EA * (distance / length - 1) * z / distance
            energy = EA * length * (distance / length - 1) ** 2
            q = [z - height]
            assert model.forward_dynamics(q, [0.0])[0] == pytest.approx(pull, rel=1e-12, abs=1e-9)
            assert model.energy(q, [0.0]).potential == pytest.approx(energy, rel=1e-12, abs=1e-12)


def test_bars_in_files_and_what_they_refuse(tmp_path: Path) -> None:
    scene = cd.Scene("truss", gravity=(0, 0, 0))
    far = scene.ground.at(2.0, 0, 0)
    bar = {"EA": EA, "rhoA": 0.1, "compression": True}
    scene.cable("strut", scene.ground, far, tension=-5.0, elements=2, **bar)
    scene.save(tmp_path / "truss.yaml")
    again = cd.load(tmp_path / "truss.yaml")
    assert again.cables["strut"].compression
    assert again.cables["strut"].tension == -5.0
    with pytest.raises(cd.ModelError, match="compression=True for a bar"):
        scene.cable("rope", scene.ground, far, EA, tension=-5.0)
    with pytest.raises(cd.ModelError, match="no bar is that short: give more than -EA"):
        scene.cable("rod", scene.ground, far, EA, tension=-2 * EA, compression=True)
    page = cd.derive(scene).explain(tmp_path / "truss.html").read_text("utf-8")
    assert "strain" in page
    assert "slack" not in page


@each("EA", (5.0, 4.0, 0.0))
def test_bars_whose_parameters_give_no_length(EA: float) -> None:
    """They were refused by the mass of a node, or by a division."""
    scene = cd.Scene("bar", gravity=(0, 0, 0))
    far, stiffness = scene.ground.at(2.0, 0, 0), scene.parameter("EA", EA)
    bar = {"rhoA": 0.1, "elements": 2, "compression": True}
    scene.cable("bar", scene.ground, far, stiffness, tension=-5.0, **bar)
    with pytest.raises(cd.ModelError, match=r"cable 'bar': EA is .* no length gives a tension"):
        cd.derive(scene)
