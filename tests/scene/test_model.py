"""What the user writes: names, numbers, units, errors with their cures."""

from __future__ import annotations

import math

import numpy as np
import pytest
import sympy

from cardan.api.scene import Scene
from cardan.elements.forces import JointForce
from cardan.elements.joints import Free, Revolute, Spherical
from cardan.errors import ModelError
from cardan.scene import inertia, shape, t
from cardan.scene.units import unit
from table import each


def scene_with_arm():
    scene = Scene("robot")
    upper = scene.body("upper", mass=1.0)
    scene.body("forearm", mass=1.0)
    scene.joint("shoulder", Revolute("y"), scene.ground, upper)
    return scene


def test_parameters_and_time_are_plain_symbols():
    scene = Scene("m")
    m = scene.parameter("m", 500, unit="g")
    assert m == sympy.Symbol("m")
    assert t == sympy.Symbol("t")
    assert scene.parameters["m"].value == 0.5
    assert scene.parameters["m"].unit == "kg"


def test_unknown_child_names_the_joint_and_a_near_body():
    scene = scene_with_arm()
    with pytest.raises(ModelError) as caught:
        scene.joint("elbow", Revolute("y"), "upper", "forarm")
    assert str(caught.value) == (
        "joint 'elbow' (revolute): child body 'forarm' does not exist. "
        "Bodies: ground, upper, forearm. Did you mean 'forearm'?"
    )


@each(
    ("act", "words"),
    [
        (lambda s: s.body("upper"), "'upper': the name is taken"),
        (lambda s: s.joint("shoulder", Revolute("y"), "upper", "forearm"), "taken"),
        (lambda s: s.body("ground"), "taken"),
        (lambda s: s.body("  "), "not empty"),
        (lambda s: s.body("a\nb"), "printable"),
        (lambda s: s.body("x" * 300), "printable"),
        (lambda s: s.body("x", mass=-1.0), "must not be negative"),
        (lambda s: s.body("x", mass=math.nan), "must be finite"),
        (lambda s: s.body("x", mass=1.0, inertia=(1, math.inf, 1)), "must be finite"),
        (lambda s: s.body("x", com=(1, 2)), "three entries"),
        (lambda s: s.body("x", inertia=(1, 2)), "inertia is 3x3"),
        (lambda s: s.body("x", inertia={"xx": 1, "xw": 2}), "no entry 'xw'"),
        (lambda s: s.body("x", inertia=[[1, 2, 0], [0, 1, 0], [0, 0, 1]]), "not symmetric"),
        (lambda s: s.joint("j", Revolute("y"), "upper", "upper"), "same body"),
        (lambda s: s.joint("j", "revolute", "upper", "forearm"), "not a joint kind"),
        (lambda s: s.joint("j", Revolute("y"), "upper", "forearm", q0=(1, 2)), "q0 has 2"),
        (lambda s: s.joint("j", Revolute("y"), "upper", "forearm", limits={"lo": 1}), "'lo'"),
        (lambda s: s.joint("j", Revolute("y"), "upper", "forearm", limits=(2, 1)), "above"),
        (lambda s: s.joint("j", Spherical(), "upper", "forearm", axis="x"), "takes no axis"),
        (lambda s: s.joint("j", Revolute("y"), "upper", "forearm", couple="a"), "leader, ratio"),
        (lambda s: s.force("f", 3.0), "not a force element"),
        (lambda s: s.parameter("a", "much"), "a number is wanted"),
        (lambda s: s.parameter("t", 1.0), "t is the time"),
        (lambda s: s.parameter("a", 1.0, unit="kgg"), "Did you mean 'kg'"),
        (lambda s: s.q("shoulde"), "Did you mean 'shoulder'"),
        (lambda s: s.u("shoulder.x"), "no such component"),
        (lambda s: s.joint("j", Revolute((0, 0, 0)), "upper", "forearm"), "zero vector"),
        (lambda s: s.joint("j", Revolute("w"), "upper", "forearm"), "direction"),
    ],
)
def test_wrong_statements(act, words):
    scene = scene_with_arm()
    before = (len(scene.bodies), len(scene.joints), len(scene.forces), len(scene.parameters))
    with pytest.raises(ModelError, match=words):
        act(scene)
    after = (len(scene.bodies), len(scene.joints), len(scene.forces), len(scene.parameters))
    assert after == before


def test_same_name_for_parameter_and_input():
    scene = Scene("m")
    scene.parameter("a", 1.0)
    with pytest.raises(ModelError, match="taken"):
        scene.input("a")


def test_a_cut_joint_has_no_coordinate_to_prescribe():
    scene = scene_with_arm()
    with pytest.raises(ModelError, match="cut another joint of the loop"):
        scene.joint("j", Revolute("y"), "upper", "forearm", cut=True, prescribed=t)


def test_frames_of_other_models():
    one, other = scene_with_arm(), scene_with_arm()
    with pytest.raises(ModelError, match=r"belongs to model 'robot'.*include"):
        one.joint("j", Revolute("y"), one.bodies["upper"], other.bodies["forearm"])


def test_triangle_inequality_is_a_warning_with_the_name():
    scene = Scene("m")
    with pytest.warns(UserWarning, match="body 'bad': its inertia violates"):
        scene.body("bad", mass=1.0, inertia=(1.0, 0.1, 0.1))


@pytest.mark.filterwarnings("error")
def test_inertias_of_real_solids_pass():
    scene = Scene("m")
    rng = np.random.default_rng(5)
    scene.body("rod", mass=1.0, inertia=inertia.rod(1.0, 2.0))
    for k in range(50):
        # point masses have a physical tensor, on the very edge where they lie in a plane
        points = rng.normal(size=(5, 3)) * 10.0 ** rng.integers(-6, 6)
        if k % 2:
            points[:, 2] = 0
        tensor = sum(p @ p * np.eye(3) - np.outer(p, p) for p in points)
        scene.body(f"b{k}", mass=1.0, inertia=tensor)
    assert len(scene.bodies) == 51


def test_inertia_forms_agree():
    scene = Scene("m")
    full = [[1.0, 0.1, 0.2], [0.1, 1.2, 0.3], [0.2, 0.3, 1.4]]
    a = scene.body("a", inertia=full)
    b = scene.body("b", inertia=np.array(full))
    c = scene.body("c", inertia={"xx": 1, "yy": 1.2, "zz": 1.4, "xy": 0.1, "xz": 0.2, "yz": 0.3})
    assert a.inertia == b.inertia == c.inertia == (1.0, 0.1, 0.2, 1.2, 0.3, 1.4)
    assert scene.body("d", inertia=(1, 2, 2.5)).inertia == (1, 0, 0, 2, 0, 2.5)


def test_solids_against_integrals():
    """Moments of a box, a cylinder and a tube by a fine midpoint rule."""
    n = 200
    s = (np.arange(n) + 0.5) / n - 0.5
    # sum of (x^2) over a unit interval is 1/12 up to 1/(12 n^2)
    square = (s**2).mean()
    np.testing.assert_allclose(square, 1 / 12, rtol=2 / n**2)
    a, b, c = 0.3, 0.4, 0.5
    expected = [b**2 + c**2, a**2 + c**2, a**2 + b**2]
    np.testing.assert_allclose(
        inertia.box(2.0, a, b, c), 2 * np.array(expected) * square, rtol=2 / n**2
    )
    # rings: r^2 weighted by area between the radii
    inner, outer, length = 0.1, 0.2, 0.7
    r = inner + (outer - inner) * (s + 0.5)
    radius2 = (r**3).sum() / r.sum()
    along, across = 2 * radius2, 2 * (radius2 / 2 + length**2 * square)
    found = inertia.tube(2.0, outer, inner, length, axis="x")
    np.testing.assert_allclose(found, [along, across, across], rtol=2 / n**2)
    solid = inertia.cylinder(2.0, outer, length, axis="y")
    np.testing.assert_allclose(inertia.tube(2.0, outer, 0.0, length, axis="y"), solid)
    assert inertia.sphere(5.0, 1.0) == (2.0, 2.0, 2.0)
    with pytest.raises(ModelError, match="axis of an inertia"):
        inertia.rod(1.0, 1.0, axis="w")


@each(
    ("text", "factor", "si"),
    [
        ("", 1.0, ""),
        ("mm", 1e-3, "m"),
        ("kg m^2", 1.0, "kg m^2"),
        ("kg*m**2", 1.0, "kg m^2"),
        ("kg·m²", 1.0, "kg m^2"),
        ("g*cm^2", 1e-7, "kg m^2"),
        ("N*m/rad", 1.0, "N m/rad"),
        ("N m s/rad", 1.0, "N m s/rad"),
        ("rpm", math.pi / 30, "rad/s"),
        ("deg", math.pi / 180, "rad"),
        ("km/h", 1 / 3.6, "m/s"),
        ("1/s", 1.0, "1/s"),
        ("GPa", 1e9, "Pa"),
        ("N/mm", 1e3, "N/m"),
        ("m s^-2", 1.0, "m s^-2"),
    ],
)
def test_units(text, factor, si):
    found = unit(text)
    assert found.factor == pytest.approx(factor, rel=1e-15)
    assert found.si == si
    # the SI name means what it says
    assert unit(found.si).dimension == found.dimension


def test_dimensions_of_units():
    assert unit("N m").dimension == unit("J").dimension == unit("kg m^2/s^2").dimension
    assert unit("W").dimension == unit("V A").dimension
    assert unit("N/m^2").dimension == unit("Pa").dimension


@pytest.mark.parametrize("text", ["furlong", "m^99", "m^", "^2", "m//s?", "kg m^2.5", "\0"])
def test_no_units(text):
    with pytest.raises(ModelError, match="unit"):
        unit(text)


def test_summary_fits_on_a_screen():
    scene = scene_with_arm()
    scene.joint("elbow", Revolute("y"), "upper", "forearm", prescribed=sympy.sin(t))
    scene.force("motor", JointForce("shoulder", 1.0))
    scene.notes.append("joints elbow: limits are ignored in a run")
    text = str(scene)
    assert "model 'robot': 2 bodies, 2 joints, 1 force" in text
    assert "prescribed: sin(t)" in text
    assert "note: joints elbow: limits are ignored" in text
    inner = scene.ground
    for k in range(200):
        body = scene.body(f"link{k}", mass=1.0)
        scene.joint(f"j{k}", Revolute("y"), inner, body)
        inner = body
    assert len(str(scene).splitlines()) < 50
    assert "more" in str(scene)


def test_shapes_become_plain_numbers():
    from cardan.topology import build

    scene = Scene("m")
    l = scene.parameter("l", 2.0)
    rod = shape.cylinder(0.1, l, axis="y", position=(0, l / 2, 0), color=(1, 0, 0))
    tool = shape.mesh("tool.stl", rotation=("XYZ", math.pi / 2, 0, 0))
    body = scene.body("b", mass=1.0, shape=[rod, tool])
    scene.joint("j", Revolute("y"), scene.ground, body)
    first, second = (record for _, record in build(scene).shapes)
    assert first["length"] == 2.0
    assert first["position"] == (0, 1.0, 0)
    assert first["color"] == (1, 0, 0, 1)
    assert second["rotation"] == [[1, 0, 0], [0, 0, -1], [0, 1, 0]]


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"limits": ("low", 1)}, "limit 'lower' is not a number"),
        ({"limits": (1, 2, 3, 4, 5)}, r"limits are \(lower, upper\)"),
        ({"couple": (3, 2)}, r"couple is \(leader, ratio\)"),
        ({"q0": np.array([1.0, 2.0])}, "q0 has 2 entries, but 1"),
    ],
)
def test_what_a_joint_cannot_be_told(options, message):
    scene = Scene("m")
    with pytest.raises(ModelError, match=message):
        scene.joint("j", Revolute("z"), scene.ground, scene.body("b", mass=1.0), **options)


def test_numpy_numbers_are_numbers():
    scene = Scene("m")
    body = scene.body("b", mass=np.float32(2), com=np.array([0, 0, 1]))
    joint = scene.joint("j", Revolute("z"), scene.ground, body, q0=np.float32(0.5), u0=np.int64(2))
    assert (joint.q0, joint.u0) == ((0.5,), (2.0,))


def test_a_unit_is_text():
    with pytest.raises(ModelError, match="unit 5: a unit is text"):
        Scene("m").parameter("p", 1.0, unit=5)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"pose": 5}, "body 'b': pose: three entries are wanted, not 5"),
        ({"pose": (1, 2, 3, 4)}, "body 'b': pose: three entries"),
        ({"inertia": 5}, "inertia is 3x3, three principal values or dict"),
        ({"inertia": [(1, 2), 3, 4]}, "inertia is 3x3"),
        ({"com": 1.0}, "body 'b': com: three entries"),
    ],
)
def test_shapes_of_what_a_body_has(options, message):
    with pytest.raises(ModelError, match=message):
        Scene("m").body("b", mass=1.0, **options)


@pytest.mark.parametrize("rotation", [5, ("XYZ", 1, 2), "XYZ", [(1, 0, 0), (0, 1, 0)]])
def test_shapes_of_rotations(rotation):
    from cardan.topology import build

    scene = Scene("m")
    scene.joint("j", Revolute("z"), scene.ground.at(rotation=rotation), scene.body("b", mass=1.0))
    with pytest.raises(ModelError, match="a rotation is 3x3, a SciPy Rotation or like"):
        build(scene)


def test_inertia_as_rows_that_are_arrays():
    rows = [np.array(row) for row in ([1.0, 0.1, 0], [0.1, 1.0, 0], [0, 0, 1.5])]
    assert Scene("m").body("b", mass=1.0, inertia=rows).inertia == (1.0, 0.1, 0, 1.0, 0, 1.5)


def test_speeds_have_their_names_of_results_too() -> None:
    scene = Scene("m")
    body = scene.body("body", mass=1, inertia=(1, 1, 1))
    scene.joint("drift", Free(), scene.ground, body)
    link = scene.body("link", mass=1)
    scene.joint("u", Revolute("x"), body, link)
    assert scene.u("drift.u.y") == scene.u("drift.y")
    assert scene.u("u.u") == scene.u("u")
    with pytest.raises(ModelError, match="no such component"):
        scene.u("drift.u.w")
