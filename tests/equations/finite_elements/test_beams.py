"""Beams of a scene as tables of elements: places, tables, small displacements in closed form."""

from __future__ import annotations

import numpy as np
import pytest

import cardan as cd
from cardan.equations.finite_elements.record import FiniteElementRecord
from cardan.equations.functions.blocks import coordinates, defaults
from cardan.ir.function import Function, Output
from cardan.ir.interpreter import evaluate
from cardan.schema.finite_elements import GROUND
from equations.finite_elements.reference import Reference

STEEL = cd.material(E=2.1e11, nu=0.3, rho=7850)
TUBE = cd.section.tube(0.02, 0.015)
LENGTH, LOAD = 2.0, 10.0


def at_rest(scene: FiniteElementRecord) -> Reference:
    """A scene in its reference configuration."""
    system = scene.system
    start = np.concatenate(
        [
            j.q0 if j.q0 is not None else [c.default for c in j.element.coordinates]
            for j in system.joints
            if j.q >= 0
        ]
        or [np.zeros(0)]
    )
    assert len(start) == len(coordinates(system))
    given = defaults(system) | {"q": start, "u": np.zeros(system.nu)}
    q = evaluate(scene.states, given, "numpy")["q"]
    return Reference(scene, np.concatenate([q, scene.reference]), np.zeros(scene.places.nu))


def cantilever(elements: int = 8, force: float = 0.0, **more: object) -> cd.Scene:
    """A beam along x, clamped to the ground, with a force upward at its end."""
    scene = cd.Scene("cantilever", gravity=(0, 0, 0))
    beam = scene.beam("rod", (0, 0, 0), (LENGTH, 0, 0), TUBE, STEEL, elements=elements, **more)
    scene.joint("wall", cd.Fixed(), scene.ground, beam.start)
    scene.force("tip", cd.Force(beam.end, (0, 0, force)))
    return scene


def clamped(elements: int = 8, force: float = 0.0, **more: object) -> cd.Scene:
    """The same without a joint."""
    scene = cd.Scene("clamped", gravity=(0, 0, 0))
    beam = scene.beam("rod", scene.ground, (LENGTH, 0, 0), TUBE, STEEL, elements=elements, **more)
    scene.force("tip", cd.Force(beam.end, (0, 0, force)))
    return scene


def test_beams_make_equations_absolute() -> None:
    assert isinstance(cd.derive(clamped()), FiniteElementRecord)
    with pytest.raises(cd.DerivationError, match="coordinates='absolute'"):
        cd.derive(clamped(), coordinates="relative")


def test_places_and_tables() -> None:
    found = cd.derive(clamped(5), coordinates="absolute")
    assert list(found.places.names) == ["rod.end", *(f"rod.node{k}" for k in range(1, 5))]
    (line,) = found.lines
    assert list(line) == [GROUND, 1, 2, 3, 4, 0]
    own = [g for g in found.groups if g.kind.name.startswith("hellinger")]
    assert [(g.kind.nu // 6, list(g.members)) for g in own] == [
        (1, ["rod.1"]),
        (2, ["rod.2", "rod.3", "rod.4", "rod.5"]),
    ]
    assert own[1].places.tolist() == [[1, 2], [2, 3], [3, 4], [4, 0]]
    for group in found.groups:
        data = at_rest(found).data(group)
        assert data.shape == (len(group), len(group.kind.data))


def test_text_does_not_grow_with_the_number_of_elements() -> None:
    few, many = (cd.derive(clamped(n), coordinates="absolute") for n in (4, 4000))
    assert [k.name for k in few.kinds] == [k.name for k in many.kinds]
    assert many.places.nu - few.places.nu == 6 * 3996


@pytest.mark.parametrize("build", [cantilever, clamped])
def test_nothing_is_strained_at_rest(build: object) -> None:
    reference = at_rest(cd.derive(build(), coordinates="absolute"))  # type: ignore[operator]
    _, bias, _, _ = reference.assembled()
    # stiffness times rounding of positions
    assert np.abs(bias).max() < 1e-14 * 2.1e11 * np.pi * 0.02**2 / (LENGTH / 8)


@pytest.mark.parametrize("build", [cantilever, clamped])
@pytest.mark.parametrize("up", ["z", (0, 1, 1)])
def test_small_deflection(build: object, up: object) -> None:
    """P L^3 / (3 E I) + P L / G A, which the elements give exactly."""
    scene = cd.derive(build(force=LOAD, up=up), coordinates="absolute")  # type: ignore[operator]
    reference = at_rest(scene)
    nu, (_, bias, G, _) = scene.places.nu, reference.assembled()
    K = np.zeros((nu, nu))
    for group in scene.groups:
        if "balance_tangent" in group.kind.functions:
            found = reference.call(group, "balance_tangent").get("K", np.zeros(()))
            at = reference.entries(group, "u")
            if found.ndim == 3:
                np.add.at(K, (at[:, :, None], at[:, None, :]), found)
    held = np.block([[K, G.T], [G, np.zeros((len(G), len(G)))]])
    load = np.concatenate([-bias, np.zeros(len(G))])
    x = np.linalg.solve(held, load)
    (segment,) = scene.system.segments
    tip = scene.places.u[scene.lines[0][-1]] + 5
    made = Function(
        "section",
        scene.system.graph,
        (),
        tuple(Output(name, (), segment.data[name][2]) for name in ("EI2", "GA3")),
    )
    numbers = evaluate(made, {"p": defaults(scene.system)["p"]})
    (bending,), (shear,) = numbers["EI2"], numbers["GA3"]
    expected = LOAD * LENGTH**3 / (3 * bending) + LOAD * LENGTH / shear
    assert x[tip] == pytest.approx(expected, rel=1e-7)


def test_weight_and_mass() -> None:
    """The beam weighs what its section says."""
    model = clamped()
    model.gravity = (0, 0, -9.81)
    scene = cd.derive(model, coordinates="absolute")
    reference = at_rest(scene)
    M, bias, _, _ = reference.assembled()
    up = np.zeros(scene.places.nu)
    up[scene.places.u[:-1] + 5] = 1.0
    weight = 7850 * np.pi * (0.02**2 - 0.015**2) * LENGTH
    # half of the first element hangs on the wall
    missing = weight / 16
    assert up @ M @ up == pytest.approx(weight - missing, rel=0.05)
    assert up @ bias == pytest.approx((weight - missing) * 9.81, rel=0.05)


def test_beams_that_carry_their_loads() -> None:
    """Weight and dead loads act once, whichever element has them."""
    found = []
    for element in ("hellinger_reissner", "hellinger_reissner_loaded"):
        model = clamped(element=element)
        model.gravity = (0, 0, -9.81)
        model.force("snow", cd.LineLoad("rod", force=(0, 3.0, -50.0)))
        scene = cd.derive(model, coordinates="absolute")
        _, bias, _, _ = at_rest(scene).assembled()
        found.append(bias.reshape(-1, 6))
        loads = [g.kind.name for g in scene.groups if g.kind.name.startswith("dead_load")]
        assert bool(loads) == (element == "hellinger_reissner")
    assert np.abs(found[0]).max() > 10
    assert found[1] == pytest.approx(found[0], abs=1e-9)


def test_a_beam_on_a_hinged_arm() -> None:
    """Ends on bodies, released ends, joints to nodes: everything finds its place."""
    model = cd.Scene("arm", gravity=(0, 0, -9.81))
    hub = model.body("hub", mass=1.0, inertia=(0.1, 0.1, 0.1))
    model.joint("drive", cd.Revolute("z"), model.ground, hub)
    beam = model.beam("blade", hub.at(0.3, 0, 0), (2, 0, 0), TUBE, STEEL, elements=4)
    weight = model.body("weight", mass=0.5, inertia=(0.1, 0.1, 0.1))
    model.joint("glue", cd.Fixed(), beam.at(0.5), weight)
    stay = model.beam("stay", hub.at(0, 0.4, 0), (1, 1, 0), TUBE, STEEL, 3, release_start=("rz",))
    load = model.body("load", mass=3.0, inertia=(0.1, 0.1, 0.1))
    model.joint("hook", cd.Spherical(), beam.end, load)
    model.constraint("rail", stay.end.position()[2])
    scene = cd.derive(model)
    assert isinstance(scene, FiniteElementRecord)
    members = [m for g in scene.groups if g.kind.name.startswith("helling") for m in g.members]
    assert sorted(members) == [*(f"blade.{k}" for k in (1, 2, 3, 4)), "stay.1", "stay.2", "stay.3"]
    reference = at_rest(scene)
    g, rates = reference.constraints()
    assert np.abs(g).max() < 1e-14
    assert np.abs(rates).max() == 0.0
    udot, _, _ = reference.solved()
    assert np.isfinite(udot).all()
    _, bias, _, _ = reference.assembled()
    # the load hangs on the node as a tree of its own
    assert np.abs(bias).max() < (3.0 + 1.0) * 9.81 * 1.01


def test_damping_and_loads_have_elements_and_powers() -> None:
    model = cd.Scene("loaded")
    soft = cd.material(E=2.1e11, nu=0.3, rho=7850, damping=1e-3, expansion=1e-5)
    model.beam("rod", (0, 0, 0), (LENGTH, 0, 0), TUBE, soft, 3, temperature=20)
    model.beam("other", (0, 1, 0), (LENGTH, 1, 0), TUBE, STEEL, 2, inertia="lumped")
    model.force("wind", cd.LineLoad("rod", force=(0, 0, 3), follower=True))
    model.force("snow", cd.LineLoad("other", force=(0, 0, -2)))
    scene = cd.derive(model, coordinates="absolute")
    told = {kind.name: sum(len(g) for g in scene.groups if g.kind is kind) for kind in scene.kinds}
    assert told == {
        "hellinger_reissner": 5,
        "linked_inertia": 3,
        "damping": 3,
        "follower_load": 3,
        "lumped_inertia": 2,
        "dead_load": 2,
    }
    assert scene.powers == ("rod", "other")
    names = [group.common.name for group in scene.groups if group.common is not None]
    assert len(set(names)) == len(names)
    reference = at_rest(scene)
    u = np.random.default_rng(3).normal(size=scene.places.nu)
    power = Reference(scene, reference.q, u).listed("power", 0 * u, np.zeros(0))
    # damping takes more than wind can give; snow has a potential
    assert power[0] < 0 == power[1]


def test_an_end_is_let_go_of_the_node_of_another_beam() -> None:
    """The axes of the joint are those of its own beam; nothing is strained at the start."""
    model = cd.Scene("branch", gravity=(0, 0, 0))
    beam = model.beam("stem", (0, 0, 0), (2, 0, 0), TUBE, STEEL, 2)
    model.beam("twig", beam.at(0.5), (1, 1, 1), TUBE, STEEL, 2, release_start=("rx", "ry", "rz"))
    model.beam("thorn", beam.at(0.5), (0, 1, 0), TUBE, STEEL, 2, release_start=("ry",))
    reference = at_rest(cd.derive(model, coordinates="absolute"))
    g, _ = reference.constraints()
    assert np.abs(g).max() < 1e-14
    _, bias, _, _ = reference.assembled()
    assert np.abs(bias).max() < 1e-13 * 2.1e11 * np.pi * 0.02**2
