"""Messages about costs, names and motions, for people who meet them first."""

from __future__ import annotations

import functools

import pytest

import cardan as cd
from cardan.errors import ArgumentError, CodegenError, DerivationError, ModelError


@functools.cache
def hose() -> tuple[cd.Scene, cd.CompiledModel]:
    scene = cd.Scene("hose", gravity=(0, 0, -9.81))
    E = scene.parameter("E", 5e6, unit="Pa")
    hub = scene.body("hub", mass=0.5, inertia=(0.01, 0.01, 0.01))
    scene.joint("luff", cd.Revolute("y"), scene.ground, hub)
    rubber = cd.material(E=E, nu=0.45, rho=1100, damping=1e-3)
    bar = scene.beam("bar", hub, (1, 0, 0), cd.section.rectangle(0.02, 0.03), rubber, elements=4)
    scene.output("tip", bar.end.position()[2])
    return scene, cd.compile(scene)


def test_a_formula_alone_is_no_cost() -> None:
    with pytest.raises(ArgumentError, match=r'give a Cost, such as cd.cost\(final="tip"\)'):
        hose()[1].gradient(0.1, "tip", wrt="E")
    with pytest.raises(ArgumentError, match=r"cost=3: give a Cost, such as cd.cost\(final="):
        hose()[1].gradient(0.1, 3, wrt="E")


def test_names_that_people_gave_come_first() -> None:
    """Outputs, then joints; nodes of beams last; none twice."""
    _, model = hose()
    motion = model.simulate(0.01)
    with pytest.raises(ModelError, match=r"Known: tip, luff, luff.u, .*bar.end"):
        motion["tipp"]
    with pytest.raises(DerivationError, match=r"Known: tip, t, luff"):
        model.gradient(0.01, cd.cost(final="tipp"), wrt="E")
    with pytest.raises(ModelError) as problem:
        model.gradient(0.01, cd.cost(final="tip"), wrt="EE")
    assert "Known: x0, q0, u0, z0, p, q0.luff, u0.luff, E, " in str(problem.value)
    assert "u0.luff.u" not in str(problem.value)
    with pytest.raises(ModelError, match=r"neither a parameter nor a start. Known: E, .*x0"):
        model.fit({"t": [0, 1], "tip": [0, 1]}, unknown="EE")


def test_a_motion_prints_no_nodes() -> None:
    text = str(hose()[1].simulate(0.01, u={"luff": -3.0}))
    assert "start     given: luff.u = -3\n" in text
    assert "start     by default: luff = 0\n" in text
    assert "start     of nodes of beams: 52 entries, see motion.x[0]\n" in text
    assert "bar.node1" not in text


def test_exports_say_where_gradients_of_beams_are(tmp_path: object) -> None:
    equations = cd.derive(hose()[0])
    cost = cd.cost(final="tip")
    with pytest.raises(CodegenError, match=r"'hose' is in absolute coordinates.*model.gradient in"):
        equations.export(f"{tmp_path}/c", gradient=cost, integrators=["dop853"])
