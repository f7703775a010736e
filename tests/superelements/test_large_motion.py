"""Superelements that move far: against an independent route, and the laws of mechanics."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import cardan as cd
from superelements.components import beam, brick, brick_matrices, faces, planar_beam, reference
from superelements.corotational import Corotational
from superelements.corotational_motion import accelerations
from superelements.moving import FRAMES, free, soft_brick, state_of
from superelements.moving import reference as by_numpy
from superelements.rotations import exponential, rotation
from table import each

RNG = np.random.default_rng(3)
SPIN, TURN = RNG.normal(size=3), exponential(RNG.normal(size=3))


def springy_beam(damping: float = 0.0) -> Any:
    """A beam, whose mass matrix depends on directions."""
    beams = cd.Scene("beams", gravity=(0, 0, 0))
    section = cd.section.general(EA=1e4, GA=1e4, GJ=1.0, EI=1.0, rhoA=1.0, rhoI=1e-2)
    beams.beam("beam", beams.ground, (1.0, 0, 0), section, elements=4)
    return cd.superelement.from_beams(beams, "beam", modes=2, damping=damping)


def some_state(element: Corotational, size: float = 0.05) -> tuple[Any, Any]:
    """A turned, moved and deformed configuration, and speeds."""
    rng = np.random.default_rng(5)
    q = element.start(TURN, rng.normal(size=3))
    q = element.moved(q, size * rng.normal(size=element.n_speeds))
    return q, rng.normal(size=element.n_speeds)


@each("frame", FRAMES)
def test_against_the_reference(frame: str) -> None:
    """Energies, momenta and accelerations at a state that turns fast and is much deformed."""
    model, element = free(frame), by_numpy(frame)
    q, u = some_state(element)
    place, speed = state_of(model, frame, q, u)
    energy = model.energy(place, speed)
    np.testing.assert_allclose(energy.kinetic, element.kinetic(q, u), rtol=1e-12)
    np.testing.assert_allclose(energy.potential, element.potential(q), rtol=1e-12)
    linear, angular = np.split(element.momentum(q, u), 2)
    expected = np.concatenate([angular, linear])
    np.testing.assert_allclose(model.momentum(place, speed), expected, rtol=1e-11, atol=1e-11)
    found = model.forward_dynamics(place, speed)
    expected = accelerations(element, q, u)
    first = model.manifest.joints[[j.name for j in model.manifest.joints].index("free")].slot("u")[
        0
    ]
    scale = np.abs(expected).max()
    np.testing.assert_allclose(found[first : first + 6], expected[:6], atol=1e-10 * scale)


@each("frame", FRAMES)
def test_a_free_motion_keeps_energy_and_momenta(frame: str) -> None:
    model = free(frame, (0.0, 0.0, 0.0))
    run = model.simulate(
        [0, 0.1, 0.2], u={"free": [1, 2, 8, 0.5, 0, 0]}, method="DOP853", rtol=1e-11
    )
    total = run.energy.total
    np.testing.assert_allclose(total, total[0], rtol=1e-10)
    momenta = [model.momentum(q, u) for q, u in zip(run.q, run.u, strict=True)]
    np.testing.assert_allclose(momenta, [momenta[0]] * 3, rtol=1e-10, atol=1e-9)
    assert np.abs(run.q[-1] - run.q[0]).max() > 0.3


@each("frame", FRAMES)
def test_a_free_superelement_keeps_energy_and_momenta_for_many_steps(frame: str) -> None:
    """By the energy-momentum method, which is of second order."""
    model, start = free(frame, (0.0, 0.0, 0.0)), {"free": [1, 2, 8, 0.5, 0, 0]}
    method, times = "EnergyMomentum", np.linspace(0, 5, 11)
    run = model.simulate(times, u=start, method=method, step=5e-4)
    total = run.energy.total
    momenta = np.array([model.momentum(q, u) for q, u in zip(run.q, run.u, strict=True)])
    drift = np.abs(total / total[0] - 1).max(), np.abs(momenta - momenta[0]).max()
    print(f"energy {drift[0]:.1e}, momenta {drift[1]:.1e}")
    assert drift[0] < 1e-11
    assert drift[1] < 1e-11 * np.abs(momenta).max()
    q = model.simulate([0, 0.2], u=start, method="DOP853", rtol=1e-11).q[-1]
    missed = [
        np.abs(model.simulate([0, 0.2], u=start, method=method, step=h).q[-1] - q).max()
        for h in (5e-4, 2.5e-4)
    ]
    assert np.log2(missed[0] / missed[1]) == pytest.approx(2, abs=0.15)


@each("inertia", ("nodal", "projected", "corotated"))
def test_a_swinging_superelement_keeps_its_energy(inertia: str) -> None:
    """A heavy one on a hinge, with a load; of a damped one the method says what it misses."""
    for damping in (0.0, 0.01):
        scene = cd.Scene("swing", gravity=(0, 0, -0.2))
        hub = scene.body("hub", 1.0, (0.1, 0.05, 0), (0.1, 0.2, 0.15))
        scene.joint("hinge", cd.Revolute("y"), scene.ground, hub)
        part, at = springy_beam(damping), {"start": hub}
        arm = scene.superelement("arm", part, at, frame="start", inertia=inertia)
        load = scene.body("load", 0.5, (0, 0.1, 0), (0.01, 0.02, 0.03))
        scene.joint("pin", cd.Revolute("x"), arm.at("end"), load)
        model = cd.compile(scene, coordinates="absolute")
        options = {"u": {"hinge": 0.5}, "method": "EnergyMomentum", "step": 1e-3}
        if damping:
            with pytest.raises(cd.ModelError, match="it is damped"):
                model.simulate([0, 1], **options)
            continue
        energy = model.simulate(np.linspace(0, 1, 11), **options).energy
        assert np.abs(energy.total - energy.total[0]).max() < 1e-10 * energy.kinetic.max()


@each("frame", FRAMES)
def test_motions_do_not_depend_on_a_common_velocity_or_on_axes(frame: str) -> None:
    """Galilean invariance and objectivity: of two runs, one boosted and turned."""
    model = free(frame, (0.0, 0.0, 0.0))
    spin, boost = np.array([1.0, 2.0, 8.0]), np.array([30.0, -50.0, 20.0])
    options = {"method": "DOP853", "rtol": 1e-11}
    one = model.simulate([0, 0.1], u={"free": [*spin, 0, 0, 0]}, **options)
    start = {"free": [*TURN, 1.0, 2.0, 3.0]}
    two = model.simulate([0, 0.1], q=start, u={"free": [*spin, *boost]}, **options)
    p, x = one.pose("boom.tip")[-1][:3, :3], one.pose("boom.tip")[-1][:3, 3]
    there = two.pose("boom.tip")[-1]
    R = rotation(TURN)
    np.testing.assert_allclose(there[:3, :3], R @ p, atol=1e-9)
    expected = R @ x + [1.0, 2.0, 3.0] + 0.1 * boost
    np.testing.assert_allclose(there[:3, 3], expected, atol=1e-8)


def test_beams_do_not_depend_on_a_common_velocity() -> None:
    """Whose mass matrix depends on directions."""
    scene = cd.Scene("free", gravity=(0, 0, 0))
    boom = scene.superelement("boom", beam(modes=3))
    hub = scene.body("hub", 1.0, inertia=(1.0, 1.0, 1.0))
    scene.joint("plane", cd.Planar("z"), scene.ground, hub)
    scene.joint("held", cd.Fixed(), hub, boom.at("root"))
    model = cd.compile(scene)
    tips = []
    for speed in (0.0, 50.0):
        u = {"plane": [speed, 0, 20.0]}
        run = model.simulate([0, 0.05], u=u, method="Radau", rtol=1e-10)
        tips.append(run.pose("boom.tip")[-1][:3, 3] - [0.05 * speed, 0, 0])
    np.testing.assert_allclose(tips[1], tips[0], atol=1e-8)


@each("frame", FRAMES)
def test_small_motions_are_those_of_the_record(frame: str) -> None:
    """Frequencies of the free body and of one that is clamped, whatever the frame."""
    record = soft_brick()
    found = free(frame, (0.0, 0.0, 0.0)).modes().frequencies * 2 * np.pi
    expected = record.modes().frequencies
    found = np.sort(found[found > 1e-2 * expected[0]])
    np.testing.assert_allclose(found, expected[: len(found)], rtol=1e-8)
    assert len(found) == len(expected)
    scene = cd.Scene("clamped", gravity=(0, 0, 0))
    scene.superelement("boom", record, {"root": scene.ground}, frame=frame)
    clamped = cd.compile(scene).modes().frequencies * 2 * np.pi
    np.testing.assert_allclose(np.sort(clamped), record.modes("root").frequencies, rtol=1e-8)


def test_matrices_are_part_of_the_cached_code() -> None:
    """Of two components that differ in nothing else."""
    found = []
    for scale in (1.0, 4.0):
        M, K, nodes = brick_matrices()
        record = cd.superelement.reduce(M, scale * K, nodes, faces(), modes=1)
        scene = cd.Scene("clamped", gravity=(0, 0, 0))
        scene.superelement("boom", record, {"root": scene.ground}, frame="root")
        found.append(cd.compile(scene).modes().frequencies)
    np.testing.assert_allclose(found[1], 2 * found[0], rtol=1e-9)


@each("inertia", ("nodal", "projected", "corotated"))
def test_every_form_of_the_inertia_obeys_the_laws(inertia: str) -> None:
    """Of a beam, whose mass matrix depends on directions."""
    scene = cd.Scene("flying")
    boom = scene.superelement("boom", springy_beam(), frame="end", inertia=inertia)
    scene.joint("free", cd.Free(), scene.ground, boom.at("start"))
    assert cd.compile(scene).verify(seed=2).worst < 1e-9


@each("frame", FRAMES)
def test_verified(frame: str) -> None:
    """Balances against energies, tangents against slopes of balances."""
    assert free(frame).verify(seed=2).worst < 1e-9


def test_a_brick_on_a_spherical_joint() -> None:
    given = reference("se_spherical_joint_A")
    data, rows = given["parameters"], given["reference"]["rows"]
    M, K, nodes = brick_matrices()
    record = cd.superelement.reduce(M, data["K_scale"] * K, nodes, faces(), modes=data["cb_modes"])
    scene = cd.Scene("pendulum", gravity=(0, 0, -data["gravity"]))
    arm = scene.superelement("arm", record, frame="root")
    scene.joint("ball", cd.Spherical(), scene.ground, arm.at("root"))
    run = cd.compile(scene).simulate(
        [0, *(row["t"] for row in rows)],
        u={"ball": given["initial_state"]["w0"]},
        method="DOP853",
        rtol=1e-12,
    )
    tips = np.asarray(run.pose("arm.tip"))[1:, :3, 3]
    np.testing.assert_allclose(tips, [row["tip"] for row in rows], atol=1e-9)


def test_a_slider_crank_with_a_flexible_rod() -> None:
    """Whose values are those of the mass matrix as it is."""
    from sympy import Symbol

    given = reference("slider_crank_superelement_A")
    data, rows = given["parameters"], given["reference"]["rows"][:2]
    M, K, nodes = planar_beam(*(data[k] for k in ("rod", "elements", "EA", "EI", "rhoA")))
    ends = {"pin": 0, "slider": data["elements"]}
    modes = data["cb_modes"]
    record = cd.superelement.reduce(M, K, nodes, ends, node_dofs="x y rz", modes=modes)
    scene = cd.Scene("slider_crank", gravity=(0, 0, 0))
    crank, slider = scene.body("crank"), scene.body("slider", data["slider_mass"])
    turning = data["Omega"] * Symbol("t")
    scene.joint("crank", cd.Revolute("z"), scene.ground, crank, prescribed=turning)
    rod = scene.superelement("rod", record, frame="chord", inertia="projected")
    scene.joint("pin", cd.Revolute("z"), crank.at(data["crank"]), rod.at("pin"))
    scene.joint("slide", cd.Prismatic("x"), scene.ground, slider)
    scene.joint("wrist", cd.Revolute("z"), rod.at("slider"), slider)
    model = cd.compile(scene)
    run = model.simulate([0, *(row["t"] for row in rows)], method="DOP853", rtol=1e-11)
    names = [one.name for one in model.manifest.coordinates]
    q = dict(zip(names, np.asarray(run.q).T[:, 1:], strict=True))
    assert np.abs(np.asarray(run.q)[0, names.index("rod.slider.x")]) < 1e-12  # starts undeformed
    for k, row in enumerate(rows):
        angles = q["rod.pin.rz"][k], q["rod.slider.rz"][k]
        np.testing.assert_allclose(angles, (row["theta1"], row["theta2"]), atol=1e-9)
        stretch = q["rod.slider.x"][k] - q["rod.pin.x"][k]
        np.testing.assert_allclose(stretch, row["elongation"], atol=1e-11)
        eta = q["rod.mode1"][k], q["rod.mode2"][k]
        np.testing.assert_allclose(np.abs(eta), np.abs(row["eta"]), atol=1e-11)
        np.testing.assert_allclose(q["slide"][k], row["slider"], atol=1e-11)


@each("modes", (0, 4, 10))
def test_a_hub_with_a_brick_has_known_frequencies(modes: int) -> None:
    given = reference("hub_brick_A")
    data, expected = given["parameters"], given["reference"][f"cb_{modes}_omega"]
    scene = cd.Scene("hub", gravity=(0, 0, 0))
    hub = scene.body("hub", data["hub_mass"], data["hub_com_from_node0"], data["hub_inertia"])
    scene.joint("free", cd.Free(), scene.ground, hub)
    scene.superelement("panel", brick(modes=modes), {"root": hub})
    found = cd.compile(scene).modes().frequencies * 2 * np.pi
    found = np.sort(found[found > 1.0])[: len(expected)]
    np.testing.assert_allclose(found, expected, rtol=1e-7)


@pytest.mark.parametrize(
    ("interfaces", "options", "text"),
    [
        ({"rot": "ground"}, {}, "no interface 'rot'.*Did you mean 'root'"),
        ({"ground": "root"}, {}, "no interface 'ground'.*Interfaces come first: {'root': ...}"),
        ({"root": "nowhere"}, {}, "'nowhere' does not exist"),
        ({}, {"frame": "middle"}, "no frame 'middle'"),
        ({}, {"weights": [1.0]}, "give 2 numbers"),
        ({}, {"weights": [1.0, float("nan")]}, "finite"),
        ({}, {"weights": [0.0, 0.0]}, "one of them positive"),
    ],
)
def test_wrong_arguments(interfaces: Any, options: Any, text: str) -> None:
    scene = cd.Scene("wrong")
    with pytest.raises(cd.ModelError, match=text):
        scene.superelement("boom", soft_brick(), interfaces, **options)
    assert not scene.superelements


def test_names_that_are_taken() -> None:
    scene = cd.Scene("taken")
    scene.superelement("boom", soft_brick())
    with pytest.raises(cd.ModelError, match="taken"):
        scene.superelement("boom", soft_brick())
    with pytest.raises(cd.ModelError, match="taken"):
        scene.body("boom.tip")
    with pytest.raises(cd.ModelError, match="no interface"):
        scene.superelement("other", soft_brick()).at("middle")


def test_superelements_are_no_frames_and_files_no_records() -> None:
    scene = cd.Scene("mistaken")
    boom = scene.superelement("boom", soft_brick())
    load = scene.body("load", mass=1.0)
    with pytest.raises(cd.ModelError, match=r"not a frame: take its interface at\('root'\) or"):
        scene.joint("pin", cd.Fixed(), load, boom)  # type: ignore[arg-type]
    with pytest.raises(cd.TopologyError, match=r"body 'load' and superelement 'boom' to the gro"):
        cd.derive(scene)
    with pytest.raises(cd.ArgumentError, match=r"record='boom.npz': give a Superelement, as cd"):
        scene.superelement("other", "boom.npz")  # type: ignore[arg-type]


def test_a_massless_record_is_refused() -> None:
    scene = cd.Scene("massless")
    with pytest.raises(cd.ModelError, match="have no mass"):
        scene.superelement("boom", brick(method="macneal", modes=3))


def test_large_rotations_of_interfaces_are_warned_of() -> None:
    model, start = free("root"), {"free": [1, 2, 8, 0, 0, 0]}
    with pytest.warns(cd.SolveWarning, match=r"'boom\.tip' turns by .* divide the body"):
        model.simulate(0.02, q={"boom.tip.rz": 0.3}, u=start, method="DOP853")
