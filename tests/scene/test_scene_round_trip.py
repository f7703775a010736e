"""Saved and loaded again, a model is the same system: every number to its last bit."""

from __future__ import annotations

import dataclasses
import os
import stat
from pathlib import Path

import numpy as np
import pytest
import sympy
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

import cardan as cd
from cardan.codegen.fingerprint import fingerprint
from cardan.scene.checks import smallest_moment
from cardan.scene.files.expression import parse
from cardan.scene.files.yaml.expression_text import ExpressionText
from external.robots import FILES, ROBOTS
from mechanisms import ZOO, Mechanism
from mechanisms.carried import CARRIED
from mechanisms.closed import CLOSED, Closed, four_bar
from spread import some


def again(scene: cd.Scene, folder: Path) -> cd.Scene:
    """The model as its file says it; saving that gives the same file."""
    first, second = folder / "first.yaml", folder / "second.yaml"
    scene.save(first)
    loaded = cd.load(first)
    loaded.save(second)
    assert second.read_text(encoding="utf-8") == first.read_text(encoding="utf-8")
    return loaded


def assert_same(one: cd.Scene, other: cd.Scene) -> None:
    """Equal graphs, names, parameters and placeholders: the same C, byte by byte."""
    assert fingerprint(cd.derive(one)) == fingerprint(cd.derive(other))


@pytest.mark.parametrize("mechanism", some(ZOO.values(), 3, 1), ids=repr)
def test_zoo(mechanism: Mechanism, tmp_path: Path) -> None:
    scene = mechanism.build()
    assert_same(scene, again(scene, tmp_path))


@pytest.mark.parametrize("mechanism", some([*CLOSED.values(), *CARRIED.values()], 2), ids=repr)
def test_circuits(mechanism: Closed, tmp_path: Path) -> None:
    scene = mechanism.build()
    assert_same(scene, again(scene, tmp_path))


def test_cut_joints_and_constraints(tmp_path: Path) -> None:
    scene = four_bar()
    scene.joints["B"] = dataclasses.replace(scene.joints["B"], cut=True)
    x = scene.bodies["rocker"].at(0.2, 0, 0, name="tip").position()[0]
    scene.constraint("path", x - 0.1 * sympy.sin(cd.t), unit="m")
    scene.constraint("steady", scene.u("A") - scene.u("D") / 3)
    loaded = again(scene, tmp_path)
    text = (tmp_path / "first.yaml").read_text(encoding="utf-8")
    assert "path: {expression: position(tip).x - 0.1*sin(t), unit: m}" in text
    assert [name for name, joint in loaded.joints.items() if joint.cut] == ["B"]
    assert loaded.constraints == scene.constraints
    assert_same(scene, loaded)


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("name", some(FILES, 5))
def test_robots(name: str, tmp_path: Path) -> None:
    scene = cd.load(ROBOTS / name, base="free")
    tensors = [body.inertia for body in scene.bodies.values() if any(body.inertia)]
    if any(smallest_moment(tensor) < 0 for tensor in tensors):
        # of a robot that others describe it is a warning, of a scene an error
        with pytest.raises(cd.ModelError, match="negative principal moment"):
            again(scene, tmp_path)
        return
    assert_same(scene, again(scene, tmp_path))


def everything(folder: Path) -> cd.Scene:
    """What the zoo has not: units, poses, limits, odd names, shapes, overridden numbers."""
    scene = cd.Scene("every thing: [odd]", gravity=(0, 0, -9.81))
    m = scene.parameter("m", 250, unit="g")
    d = scene.parameter("left.d", 0.3)
    k = scene.parameter("my spring", 3.0, unit="N/mm")
    rate = scene.parameter("rate", 2.0, unit="rpm")
    push = scene.input("push", 0.25, unit="N m")
    shapes = [
        cd.shape.cylinder(0.1, d, axis="x", color=(1, 0.5, 0)),
        cd.shape.mesh(str(folder / "part.stl"), scale=(1, 2, 3), rotation=("xyz", 0.1, 0.2, 0.3)),
    ]
    turned = Rotation.from_euler("XYZ", [0.1, 0.2, 0.3])
    one = scene.body(
        "left wheel", mass=m, com=(0, -0.0, d / 7), inertia=np.eye(3) * 0.1, shape=shapes
    )
    two = scene.body("null", mass=np.float64(1 / 3), pose=((0, 0, 0), turned))
    three = scene.body("1e5", mass=2, inertia=cd.inertia.tube(2, 0.2, 0.1, d, axis="y"))
    four = scene.body("on", mass=1.0, pose=(1, 2, 3))
    tip = one.at(0, 0, 0.1, rotation=("XYZ", 1.5708, 0.2, 0), name="tip")
    hub = scene.ground.at(0, 1, 0)
    scene.joint("a/b", cd.Revolute((0, 0, -1)), hub, one, q0=0.1, u0=-1, limits=(-1, np.inf))
    scene.joint("true", cd.Screw("y", pitch=d), scene.ground, two)
    scene.joint("c", cd.Revolute("x"), tip, three, couple=("a/b", d / 2, 0.5))
    scene.joint("d", cd.Prismatic((1, 1, 0)), scene.ground, four, at=(0, 0, 2), axis="x")
    moved = hub.velocity(wrt=one, in_=three)[1] + tip.rotation(two)[1, 2] * scene.u("a/b")
    law = push * sympy.Piecewise((moved, cd.t < 1), (sympy.Max(rate / 3, cd.t), True))
    scene.force("f", cd.JointForce("a/b", law + sympy.sqrt(2) / (1 + cd.t**2)))
    scene.force("g", cd.SpringDamper(tip, hub, stiffness=k, damping=0.1))
    scene.output("height", two.position()[2] / 3, unit="mm")
    scene.output("phase", sympy.sin(sympy.pi * scene.q("true")) ** sympy.Rational(2, 3))
    scene.values["1e5.mass"] = 2.5
    scene.settings.update(t=(0.0, 2.5), rtol=1e-10, q={"a/b": 0.3}, method="RK4", step=1e-3)
    return scene


def test_everything(tmp_path: Path) -> None:
    (tmp_path / "part.stl").write_bytes(b"")
    scene = everything(tmp_path)
    loaded = again(scene, tmp_path)
    assert "file: part.stl" in (tmp_path / "first.yaml").read_text(encoding="utf-8")
    assert_same(scene, loaded)
    assert loaded.settings == scene.settings
    assert loaded.parameters == scene.parameters
    assert loaded.joints["a/b"].limits == scene.joints["a/b"].limits


def test_included_models_are_written_out(tmp_path: Path) -> None:
    scene = cd.Scene("pair")
    cart = scene.body("cart", mass=1.0)
    scene.joint("track", cd.Prismatic("x"), scene.ground, cart)
    scene.include(ZOO["pendulum"].build(), "left", at=cart.at(0, 1, 0))
    placed = cd.Scene("placed")
    placed.body("rod", mass=1.0, pose=(0, 0, 1))
    placed.joint("hinge", cd.Revolute("x"), "ground", "rod", at=(0, 0, 2))
    scene.include(placed, "right_", at=cart)
    assert_same(scene, again(scene, tmp_path))


def test_overridden_numbers_of_a_robot_are_kept(tmp_path: Path) -> None:
    arm = Path(__file__).parents[2] / "examples" / "arm.urdf"
    name = next(name for name in cd.compile(cd.load(arm)).parameters if name.endswith(".mass"))
    scene = cd.load(arm, parameters={name: 3.25})
    loaded = again(scene, tmp_path)
    assert cd.compile(loaded).parameters[name] == 3.25


def test_a_robot_can_be_edited(tmp_path: Path) -> None:
    path = tmp_path / "arm.yaml"
    cd.load(Path(__file__).parents[2] / "examples" / "arm.urdf").save(path)
    text = path.read_text(encoding="utf-8")
    assert "  elbow:" in text
    path.write_text(text + "outputs: {reach: q(elbow)}\n", encoding="utf-8")
    model = cd.compile(cd.load(path))
    q = np.array([0.1, 0.2, 0.3])
    assert model.outputs(q, np.zeros(3))[0] == q[model.coordinates.index("elbow")]


# expressions

NAMES = ("m", "l", "k2", "left.m", "two words")
SCENE = cd.Scene("names")
SYMBOLS = {name: SCENE.parameter(name, 1.0) for name in NAMES}
NUMBERS = st.one_of(
    st.integers(-50, 50).map(sympy.Integer),
    st.fractions(-9, 9, max_denominator=30).map(
        lambda f: sympy.Rational(f.numerator, f.denominator)
    ),
    st.floats(1e-3, 1e6).map(sympy.Float),
    st.just(sympy.pi),
)
LETTERS = st.sampled_from(list(SYMBOLS.values()))
HALF = sympy.Rational(1, 2)
POWERS = st.sampled_from([-2, -1, 2, 3, HALF, -3 * HALF, sympy.Float(0.7)])


def grown(parts: st.SearchStrategy) -> st.SearchStrategy:
    several = st.lists(parts, min_size=2, max_size=4)
    conditions = st.tuples(LETTERS, st.floats(0.1, 9)).map(lambda pair: sympy.Lt(*pair))
    return st.one_of(
        several.map(lambda terms: sympy.Add(*terms)),
        several.map(lambda factors: sympy.Mul(*factors)),
        st.tuples(LETTERS, POWERS).map(lambda pair: pair[0] ** pair[1]),
        st.tuples(LETTERS, parts, POWERS).map(lambda x: (x[0] + x[1] ** 2) ** x[2]),
        st.tuples(LETTERS, parts).map(lambda pair: sympy.sin(pair[0] * pair[1])),
        st.tuples(LETTERS, parts).map(lambda pair: sympy.tanh(pair[0] - pair[1])),
        st.tuples(LETTERS, parts).map(lambda pair: sympy.Max(pair[0], pair[0] ** 2 + pair[1])),
        st.tuples(conditions, parts, parts).map(
            lambda x: sympy.Piecewise((x[1], x[0]), (x[2], True))
        ),
    )


LEAVES = st.one_of(LETTERS, NUMBERS)


@settings(max_examples=300, deadline=None, database=None, derandomize=True)
@given(st.recursive(LEAVES, grown, max_leaves=12))
def test_expressions_come_back_the_same(expression: sympy.Expr) -> None:
    if not expression.free_symbols or expression.has(sympy.zoo, sympy.nan, sympy.oo, sympy.I):
        return
    text = ExpressionText(SCENE).text(expression, "here")
    assert parse(text, SYMBOLS, where="here") == expression, text


# files


def test_saving_is_whole_or_not_at_all(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "scene.yaml"
    scene = ZOO["pendulum"].build()
    scene.save(path)
    before = path.read_bytes()
    assert stat.S_IMODE(path.stat().st_mode) & 0o400
    scene.output("bad", sympy.gamma(cd.t))
    with pytest.raises(cd.ModelError, match=r"output 'bad': 'gamma\(t\)' cannot be said"):
        scene.save(path)
    del scene.outputs["bad"]

    def full(*names: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "replace", full)
    with pytest.raises(cd.ModelError, match=r"scene.yaml cannot be written: No space"):
        scene.save(path)
    assert path.read_bytes() == before
    assert [entry.name for entry in tmp_path.iterdir()] == ["scene.yaml"]


@pytest.mark.parametrize(
    "name", ["scene.sdf", "scene", "no/such/folder.yaml", "no/such/folder.urdf"]
)
def test_places_that_cannot_be_written(name: str, tmp_path: Path) -> None:
    with pytest.raises(cd.ModelError, match=r"scene|folder"):
        ZOO["pendulum"].build().save(tmp_path / name)
    assert not list(tmp_path.iterdir())
