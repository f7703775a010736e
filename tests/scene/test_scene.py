"""Scene files say what Python says: the same words give the same system."""

from __future__ import annotations

import json
import shutil
from dataclasses import fields
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy

import cardan as cd
from cardan.cli import main
from cardan.codegen.fingerprint import fingerprint
from cardan.elements.forces import FORCES
from cardan.elements.joints import JOINTS
from cardan.scene.files.yaml import from_text, keys
from cardan.topology import build
from table import each

EXAMPLES = Path(__file__).parents[2] / "examples"


def scene(text: str) -> cd.Scene:
    return from_text("cardan: 2\n" + text, name="scene.yaml")


def assert_same(one: cd.Scene, other: cd.Scene) -> None:
    if one.beams:
        first, second = (
            (repr(system), system.graph.nodes) for system in (build(one), build(other))
        )
        assert first == second
        return
    assert fingerprint(cd.derive(one)) == fingerprint(cd.derive(other))


def double_pendulum() -> cd.Scene:
    made = cd.Scene("double_pendulum", gravity=(0, 0, -9.81))
    m = made.parameter("m", 1.0, unit="kg")
    l = made.parameter("l", 500, unit="mm")
    rod = {"mass": m, "com": (0, 0, -l / 2), "inertia": cd.inertia.rod(m, l, axis="z")}
    upper, lower = made.body("upper", **rod), made.body("lower", **rod)
    made.joint("shoulder", cd.Revolute("y"), made.ground, upper)
    made.joint("elbow", cd.Revolute("y"), upper.at(0, 0, -l), lower)
    return made


def test_the_double_pendulum_is_that_of_python() -> None:
    loaded = cd.examples["double_pendulum"]
    assert_same(loaded, double_pendulum())
    assert loaded.settings == {"t": 10.0, "q": {"shoulder": 1.0}, "rtol": 1e-10}


def test_words_are_words_and_numbers_numbers() -> None:
    found = scene(
        "name: 12\nbodies: {on: {mass: 1e-10}, no: {mass: '2'}, ~: {mass: +.5}, 0x1F: {}}\n"
    )
    assert found.name == "12"
    assert {name: body.mass for name, body in found.bodies.items()} == {
        "on": 1e-10,
        "no": 2,
        "~": 0.5,
        "0x1F": 0,
    }


def test_numbers_keep_every_bit() -> None:
    rng = np.random.default_rng(5)
    numbers = [*(10.0 ** rng.uniform(-30, 30, 50)), 0.1, 1 / 3, 5e-324, 2.0**60]
    text = ", ".join(f"p{i}: {x!r}" for i, x in enumerate(map(float, numbers)))
    assert [p.value for p in scene(f"parameters: {{{text}}}").parameters.values()] == numbers


def test_constant_arithmetic_is_a_number() -> None:
    found = scene("bodies: {a: {mass: 1/3, com: [2*pi, -sqrt(2), '3']}}")
    assert found.bodies["a"].mass == 1 / 3
    assert found.bodies["a"].com == (2 * np.pi, -np.sqrt(2), 3)


def test_units_are_converted() -> None:
    found = scene("parameters: {a: {value: 500, unit: mm}, b: 2}\ninputs: {r: {unit: N}, s: }")
    a, b = found.parameters.values()
    assert (a.value, a.unit, a.stated, b.value, b.stated) == (0.5, "m", True, 2, False)
    assert [entry.value for entry in found.inputs.values()] == [0.0, 0.0]


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("[1, 2, 3]", (1, 0, 0, 2, 0, 3)),
        ("[[8, 1, 2], [1, 9, 3], [2, 3, 10]]", (8, 1, 2, 9, 3, 10)),
        ("{xx: 1, yy: 2, zz: 3, xz: 0.1}", (1, 0, 0.1, 2, 0, 3)),
        ("{rod: {mass: 2, length: 3, axis: x}}", (0, 0, 0, 1.5, 0, 1.5)),
        ("{box: {mass: 12, x: 1, y: 2, z: 3}}", (13, 0, 0, 10, 0, 5)),
        ("{sphere: {mass: 5, radius: 2}}", (8, 0, 0, 8, 0, 8)),
    ],
)
def test_inertias(text: str, wanted: tuple[float, ...]) -> None:
    assert scene(f"bodies: {{a: {{mass: 2, inertia: {text}}}}}").bodies["a"].inertia == wanted


NEEDED: dict[str, dict[str, Any]] = {
    "custom": {"symbols": ["x"], "position": ["x", 0, 0]},
    "point_on_curve": {"points": [[i, i**2, 0.5] for i in range(9)]},
    "distance": {"length": 2},
    "gear": {"leader": "lead"},
    "wheel": {"radius": 0.5},
    "rolling_disk": {"radius": 0.5},
}


@each("kind", JOINTS)
def test_every_joint_takes_its_own_keys(kind: str) -> None:
    """Each field, at its default where it has one, is a key with the same meaning."""
    given = NEEDED.get(kind, {})
    text = json.dumps({"type": kind, "parent": "ground", "child": "a", **given})
    lead = "lead: {type: revolute, parent: ground, child: b}"
    bodies = "{a: {mass: 1, inertia: [1, 1, 1]}, b: {mass: 1}}"
    found = scene(f"bodies: {bodies}\njoints: {{{lead}, j: {text}}}")
    made = cd.Scene("scene")
    body, other = made.body("a", mass=1, inertia=(1, 1, 1)), made.body("b", mass=1)
    made.joint("lead", cd.Revolute(), made.ground, other)
    x = sympy.Symbol("x")
    element = cd.Custom([x], position=(x, 0, 0)) if kind == "custom" else JOINTS[kind](**given)
    made.joint("j", element, made.ground, body)
    assert_same(found, made)
    assert {key.name for key in keys.of_element(JOINTS[kind])} == {
        entry.name for entry in fields(JOINTS[kind])
    }


VALUES: dict[str, Any] = {
    "compression": True,
    "frame": "a", "frame_a": "a", "frame_b": "ground", "in_": "a", "joint": "j",
    "force": [1, 2, 3], "torque": [1, 2, 3], "gyroscopic": True,
}  # fmt: skip


# where not any value goes with any other
FITTING: dict[str, dict[str, Any]] = {
    "controller": {"states": ["a"], "changes": [1.5], "force": 2.0, "start": [0.5], "sample": 0.1},
    "friction": {"mu": None, "radius": None},
    "bushing": {"stiffness": [1, 2, 3, 4, 5, 6], "damping": np.diag([1, 2, 3, 4, 5, 6.5]).tolist()}
    | {"rest": [0, 0.1, 0, 0, 0, 1], "tables": None, "branches": [[[0, 0, 3, 0, 1, 0], 0.2]]},
    "flexible_hinge": {"axis": [0, 1, 2]},
    "stop": {"lower": -1.0, "restitution": 0.5},
    "lock": {"locked": True},
    # said by the damping
    "contact": {"sphere": "a", "other": "ground", "normal": "x"}
    | {"restitution": None, "speed": None},
    "event": {"terminal": True, "direction": "up"},
    "rotor": {"axis": "x", "momentum": None, "speed": None, "torque": 2.0},
    "central_gravity": {"center": "ground", "bodies": "a"},
    "gravity_gradient": {"center": "ground", "bodies": "a", "force": False},
    "j2": {"center": "ground", "pole": "x", "bodies": "a", "gradient": True},
    "line_load": {"beam": "b", "force": [0, 1.5, 0], "moment": [0, 0, 2.0], "follower": True},
}  # fmt: skip


@each("kind", FORCES)
def test_every_force_takes_its_own_keys(kind: str) -> None:
    names = [entry.name for entry in fields(FORCES[kind])]
    given = {name: VALUES.get(name, 0.5 + i) for i, name in enumerate(names)}
    given |= FITTING.get(kind, {})
    given = {name: value for name, value in given.items() if value is not None}
    single = kind in ("joint_force", "drive", "controller")
    given |= {name: 2.0 for name in ("force", "torque") if single and name in given}
    text = json.dumps({"type": kind, **given})
    found = scene(
        "bodies: {a: {mass: 1, inertia: [1, 1, 1]}}\n"
        "joints: {j: {type: revolute, parent: ground, child: a}}\n"
        + (
            "beams: {b: {start: ground, end: [1, 0, 0], section: {general: {EA: 1, GA: 1, GJ: 1, "
            "EI: 1}}}}\n"
            if kind == "line_load"
            else ""
        )
        + f"forces: {{f: {text}}}\n"
    )
    made = cd.Scene("scene")
    places = {"ground": made.ground, "a": made.body("a", mass=1, inertia=(1, 1, 1))}
    made.joint("j", cd.Revolute(), made.ground, places["a"])
    if kind == "line_load":
        made.beam("b", made.ground, (1, 0, 0), cd.section.general(EA=1, GA=1, GJ=1, EI=1))
    arguments = {
        name: places[value] if isinstance(value, str) and value in places else value
        for name, value in given.items()
    }
    made.force("f", FORCES[kind](**arguments))
    assert_same(found, made)


def test_joint_options() -> None:
    found = scene(
        "inputs: {path: 0}\n"
        "bodies: {a: {mass: 1}, b: {mass: 1}, c: {mass: 1}, d: {mass: 1, pose: [0, 1, 0]}}\n"
        "joints:\n"
        "  i: {type: revolute, parent: ground, child: a, q0: 1, u0: [2], limits: [-1, 2, 3]}\n"
        "  j: {type: screw, axis: [0, 3, 4], pitch: 1/8, parent: a, child: b,\n"
        "      prescribed: path + t}\n"
        "  k: {type: revolute, parent: a, child: c, couple: [i, -2, 0.5],\n"
        "      limits: {upper: .inf, effort: 4}}\n"
        "  l: {type: revolute, axis: x, at: [0, 0, 1], parent: ground, child: d,\n"
        "      prescribed: null}\n"
    )
    i, j, k, l = found.joints.values()
    assert (i.q0, i.u0, i.limits) == ((1.0,), (2.0,), (-1.0, 2.0, 3.0, None))
    assert (j.kind.axis, j.kind.pitch) == ((0, 3, 4), 0.125)
    assert j.prescribed == sympy.Symbol("path") + cd.t
    assert (k.couple.leader, k.couple.ratio, k.couple.offset) == ("i", -2, 0.5)
    assert k.limits == (None, float("inf"), None, 4.0)
    assert l.at == (0, 0, 1)
    assert cd.derive(found).system.nq == 2


def test_an_alias_is_the_same_frame() -> None:
    found = scene(
        "bodies: {a: {mass: 1}, b: {mass: 1}, c: &c {mass: 2}, d: *c}\n"
        "joints:\n"
        "  i: {type: revolute, parent: ground, child: a}\n"
        "  j: {type: revolute, parent: &tip {body: a, at: [0, 0, 1]}, child: b}\n"
        "  k: {type: revolute, parent: *tip, child: c}\n"
        "  l: {type: revolute, parent: {body: a, at: [0, 0, 1]}, child: d}\n"
    )
    j, k, l = (found.joints[name].parent for name in "jkl")
    assert j is k
    assert l is not j
    assert found.bodies["d"].mass == 2


def test_rounded_quarter_turns_are_snapped(tmp_path: Path) -> None:
    text = "cardan: 2\nbodies: {a: {}}\nframes: {f: {body: a, rotation: [xyz, 1.5708, 0.1, pi/2]}}"
    path = tmp_path / "scene.yaml"
    path.write_text(text)
    found = cd.load(path)
    assert found.frames["f"].orientation == ("xyz", np.pi / 2, 0.1, np.pi / 2)
    assert found.snaps == ["frames.f.rotation[1]: 1.5708 -> pi/2"]
    assert cd.load(path, snap=False).frames["f"].orientation[1] == 1.5708


def test_tables_in_the_file_and_beside_it(tmp_path: Path) -> None:
    (tmp_path / "data").mkdir()
    (tmp_path / "data" / "motor.csv").write_text("# torque\nspeed,torque\n-1, 2\n0,0\n1.5,-3e0\n")
    (tmp_path / "scene.yaml").write_text(
        "cardan: 2\n"
        "tables:\n"
        "  one: {file: data/motor.csv, kind: linear}\n"
        "  two: {x: [-1, 0, 1.5], y: [2, 0, -3], kind: linear}\n"
        "outputs: {a: one(sin(t)), b: two(sin(t))}\n"
    )
    a, b = (output.expression for output in cd.load(tmp_path / "scene.yaml").outputs.values())
    assert a == b == cd.table([-1, 0, 1.5], [2, 0, -3], kind="linear")(sympy.sin(cd.t))


def test_parts_from_scenes_and_robots(tmp_path: Path) -> None:
    for path in (EXAMPLES / "arm.urdf", cd.examples.path("double_pendulum")):
        shutil.copy(path, tmp_path)
    path = tmp_path / "pair.yaml"
    path.write_text(
        "cardan: 2\n"
        "bodies: {cart: {mass: 1}}\n"
        "joints:\n"
        "  track: {type: prismatic, parent: ground, child: cart}\n"
        "  last: {type: fixed, parent: left.tip, child: box}\n"
        "frames: {left.tip: {body: left.lower, at: [0, 0, -0.1]}}\n"
        "include:\n"
        "  left: {file: double_pendulum.yaml, parameters: {m: 3},\n"
        "         at: {body: cart, at: [0, 1, 0]}}\n"
        "  arm: {file: arm.urdf, prefix: right_, base: free, at: cart}\n"
    )
    text = path.read_text().replace("{cart: {mass: 1}}", "{cart: {mass: 1}, box: {mass: 1}}")
    path.write_text(text)
    made = cd.Scene("pair")
    cart, box = made.body("cart", mass=1), made.body("box", mass=1)
    part = cd.load(cd.examples.path("double_pendulum"), parameters={"m": 3})
    left = made.include(part, "left", at=cart.at(0, 1, 0))
    made.include(cd.load(EXAMPLES / "arm.urdf", base="free"), "right_", at=cart)
    tip = left.bodies["lower"].at(0, 0, -0.1, name="left.tip")
    made.joint("track", cd.Prismatic(), made.ground, cart)
    made.joint("last", cd.Fixed(), tip, box)
    found = cd.load(path)
    assert set(found.joints) == set(made.joints)
    q = np.linspace(0.1, 0.9, cd.derive(found).system.nq)
    one, other = (cd.compile(m, functions=("mass_matrix",)) for m in (found, made))
    order = [one.speeds.index(name) for name in other.speeds]
    places = [other.coordinates.index(name) for name in one.coordinates]
    masses = one.mass_matrix(q[places])[np.ix_(order, order)]
    assert np.allclose(masses, other.mass_matrix(q), rtol=1e-13, atol=1e-13)


def test_simulate_follows_the_file_and_the_command_line(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    path = tmp_path / "scene.yml"
    text = cd.examples.path("double_pendulum").read_text()
    path.write_text(text.replace("time: 10.0", "time: 0.5, u: {elbow: 2}"))
    assert main(["simulate", str(path), "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert (found["time"], found["start"]["shoulder"], found["start"]["elbow.u"]) == (0.5, 1, 2)
    assert main(["simulate", str(path), "--json", "--time", "0.1", "--q", "elbow=0.3"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert (found["time"], found["start"]["shoulder"], found["start"]["elbow"]) == (0.1, 1, 0.3)
    path.write_text(text.replace("child: lower", "child: lover"))
    assert main(["simulate", str(path)]) == 1
    assert "scene.yml:13:75: joints.elbow.child" in capsys.readouterr().err
    assert main(["simulate", str(path), "--base", "free"]) == 1
    assert "are for robots" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (
            "parameters: {m: {value: 1, unit: kg}}\nbodies:\n  a: {mass: 1}\n"
            "  b.c: {mass: 1, com: [m, 0, 0]}\njoints: &j\n"
            "  j: {type: revolute, parent: ground, child: a}\n"
            "  k: {type: revolute, parent: a, child: b.c}\n",
            "scene.yaml:5:3: 'b.c.com.x': m is measured in kg, but m is wanted",
        ),
        ("bodies:\n  a: {mass: 1}\n", "scene.yaml:3:3: nothing joins body 'a' to the ground"),
        (
            "bodies: {a: {mass: 1, inertia: [1, 1, 1]}}\njoints:\n"
            "  a: {type: free, parent: ground, child: a, prescribed: t}\n",
            "scene.yaml:4:3: joint 'a' (free): prescribed= prescribes one coordinate",
        ),
        ("values: {a.mass: 2}\n", "parameters: no number of the scene is called 'a.mass'"),
    ],
)
def test_errors_that_show_later_have_their_place(text: str, words: str) -> None:
    with pytest.raises(cd.CardanError) as caught:
        cd.derive(scene(text))
    assert str(caught.value).startswith(words)


@pytest.mark.parametrize("text", ["x/0.0", "x/(1-1.0)", "mod(x, 0.0)", "0.0^-1", "x/-0.0"])
def test_zero_divides_nothing_however_it_is_written(text: str) -> None:
    import sympy

    from cardan.errors import ModelError
    from cardan.scene.files.expression import parse

    with pytest.raises(ModelError, match=r"division by zero|no such power"):
        parse(text, {"x": sympy.Symbol("x")}, where="scene.yaml:1:1")
