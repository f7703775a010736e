"""Bushings with measured curves: potentials, periods, kinds of coordinates, files, refusals."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.interpolate import CubicSpline, PchipInterpolator
from scipy.optimize import brentq
from scipy.spatial.transform import Rotation

import cardan as cd
from table import each

COORDINATES = ("relative", "absolute")
DIRECTIONS = ("rx", "ry", "rz", "x", "y", "z")
X = np.array([-0.9, -0.4, -0.15, 0.0, 0.1, 0.5, 0.9])
Y = np.array([-40.0, -9.0, -2.0, 0.0, 1.0, 14.0, 60.0])


def mounted(mount: Any, mass: float = 1.5, inertia: Any = (0.3, 0.2, 0.4)) -> cd.Scene:
    """A free body on a bushing at the ground, without gravity; ``mount`` makes it."""
    scene = cd.Scene("mounted", gravity=(0, 0, 0))
    body = scene.body("block", mass=mass, inertia=inertia)
    scene.joint("floating", cd.Free(), scene.ground, body)
    scene.force("mount", mount(scene.ground, body))
    return scene


def period(mass: float, stiffness: float, curve: Any, amplitude: float) -> float:
    """Of an undamped swing from an amplitude to the other side and back, by quadrature.

    Energy gives the speed; the substitution x = x0 + h sin(phi) takes the roots at the ends away.
    """
    integral = curve.antiderivative()

    def potential(x: float) -> float:
        return 0.5 * stiffness * x**2 + float(integral(x) - integral(0.0))

    level = potential(amplitude)
    other = brentq(lambda x: potential(x) - level, -2.0 * amplitude, -1e-3, xtol=1e-15)
    middle, half = (amplitude + other) / 2, (amplitude - other) / 2

    def slowness(phi: float) -> float:
        x = middle + half * np.sin(phi)
        return half * np.cos(phi) / np.sqrt(2 * (level - potential(x)) / mass)

    corners = [np.arcsin((x - middle) / half) for x in X if abs(x - middle) < half]
    ends = [-np.pi / 2 + 1e-6, *corners, np.pi / 2 - 1e-6]
    slow = [quad(slowness, a, b, epsabs=1e-12)[0] for a, b in pairwise(ends)]
    # the integrand is level at both ends
    return 2 * (sum(slow) + 1e-6 * (slowness(ends[0]) + slowness(ends[-1])))


@pytest.mark.filterwarnings("ignore:.*energy unaccounted for")  # at the corners of slopes
@each("direction", DIRECTIONS)
def test_period_of_a_body_on_a_curve(direction: str) -> None:
    """Beside a linear stiffness, in every direction and kind of coordinates, by quadrature."""
    k, stiffness, amplitude = DIRECTIONS.index(direction), 11.0, 0.6
    curve = PchipInterpolator(X, Y)
    inertia = (0.3, 0.2, 0.4, 1.5, 1.5, 1.5)[k]
    time = period(inertia, stiffness, curve, amplitude)
    entries = np.full(6, 5.0)
    entries[k] = stiffness
    scene = mounted(
        lambda a, b: cd.Bushing(a, b, entries, tables={direction: cd.table(X, Y, "pchip")})
    )
    start = amplitude * np.eye(6)[k]
    q = [*np.roll(Rotation.from_rotvec(start[:3]).as_quat(), 1), *start[3:]]
    for coordinates in COORDINATES:
        motion = cd.compile(scene, coordinates=coordinates).simulate(
            [0.0, time], q={"floating": q}, method="DOP853", rtol=1e-12, atol=1e-13
        )
        pose = motion.pose("block")[-1]
        end = np.concatenate([Rotation.from_matrix(pose[:3, :3]).as_rotvec(), pose[:3, 3]])
        assert np.allclose(end, start, atol=1e-9)
        assert np.abs(motion["floating.u"][-1]).max() < 1e-6


def everywhere(rng: Any) -> dict[str, Any]:
    """A curve in each direction, with two continuous derivatives."""
    x = np.linspace(-2.5, 2.5, 11)
    return {
        name: cd.table(x, scale * (x + 0.3 * x**3 + 0.1 * rng.uniform(-1, 1, 11)), "cubic")
        for name, scale in zip(DIRECTIONS, (2.0, 3.0, 4.0, 20.0, 30.0, 25.0), strict=True)
    }


def coupled() -> Any:
    root = np.random.default_rng(5).uniform(-1, 1, (6, 6))
    return root @ root.T + np.diag((4.0, 5.0, 6.0, 40.0, 50.0, 60.0))


def pair(**arguments: Any) -> cd.Scene:
    """Two free bodies with a bushing between frames that are turned."""
    scene = cd.Scene("pair", gravity=(0, 0, 0))
    bodies = [
        scene.body("first", mass=2.0, com=(0.1, 0, 0.2), inertia=(0.3, 0.4, 0.5)),
        scene.body("second", mass=1.0, com=(0, -0.1, 0), inertia=(0.2, 0.1, 0.25)),
    ]
    for body in bodies:
        scene.joint(f"{body.name}_free", cd.Free(), scene.ground, body)
    ends = [
        body.at(0.1 * k, 0.2, -0.1, rotation=("XYZ", 0.3, k, -0.5)) for k, body in enumerate(bodies)
    ]
    scene.force("mount", cd.Bushing(*ends, **arguments))
    return scene


FAR: dict[str, Any] = {
    "q": {"first_free": [1, 0, 0, 0, 0, 0, 0], "second_free": [0.8, 0.6, 0, 0, 0.1, 0.2, 0]},
    "u": {"first_free": [1, 0.5, -0.3, 0.2, 0, 0], "second_free": [-0.5, 0.2, 0.9, 0, -0.4, 0.3]},
}


def test_curves_in_all_directions_conserve_energy_and_momentum() -> None:
    """Far turned, beside a coupled stiffness and with a strain without load."""
    rest = (0, 0.1, 0, 0.05, 0, 0)
    tables = everywhere(np.random.default_rng(2))
    scene = pair(stiffness=coupled(), rest=rest, tables=tables)
    ends = []
    for coordinates in COORDINATES:
        model = cd.compile(scene, coordinates=coordinates)
        motion = model.simulate(3.0, **FAR, method="DOP853", rtol=1e-11, atol=1e-12)
        energy = motion.energy
        assert np.ptp(energy.total) < 1e-8 * np.ptp(energy.kinetic)
        assert np.ptp(energy.potential) > 5.0
        assert not motion.work_done.any()
        momenta = [model.momentum(q, u) for q, u in zip(motion.q, motion.u, strict=True)]
        assert np.allclose(momenta, momenta[0], atol=1e-9)
        ends.append(motion.pose("second")[-1])
    assert np.allclose(*ends, atol=1e-8)


def test_every_formalism_takes_curves() -> None:
    scene = pair(stiffness=coupled(), tables=everywhere(np.random.default_rng(4)))
    accelerations = []
    for method in ("kane", "newton_euler", "articulated", "composite", "lagrange"):
        model = cd.compile(cd.derive(scene, coordinates="relative", method=method))
        states = model.split(model.initial(FAR["q"], FAR["u"]))
        accelerations.append(model.forward_dynamics(*states))
    for one in accelerations[1:]:
        assert np.allclose(one, accelerations[0], rtol=1e-11, atol=1e-10)


def test_members_that_differ_by_their_curves_alone() -> None:
    """Elements of one kind share their functions, but never the curves of another."""
    scene = cd.Scene("two", gravity=(0, 0, 0))
    for n, factor in enumerate((1.0, -2.0)):
        body = scene.body(f"b{n}", mass=1.0, inertia=(1, 1, 1))
        scene.joint(f"j{n}", cd.Free(), scene.ground, body)
        curve = cd.table(X, factor * Y, "pchip")
        scene.force(f"m{n}", cd.Bushing(scene.ground, body, tables={"z": curve}))
    model = cd.compile(scene, coordinates="absolute")
    start = {f"j{n}": [1, 0, 0, 0, 0, 0, 0.3] for n in range(2)}
    q, u = model.split(model.initial(start))
    udot = model.forward_dynamics(q, u)
    force = float(PchipInterpolator(X, Y)(0.3))
    for n, factor in enumerate((1.0, -2.0)):
        up = model.acceleration(f"b{n}", q, u, udot)[5]
        assert up == pytest.approx(-factor * force, rel=1e-13)


def test_beyond_its_ends_a_curve_continues() -> None:
    """Force and energy follow the last piece, as a table does; a straight line by hand."""
    line = cd.table([-0.1, 0.0, 0.1], [-1.0, 0.0, 3.0], "linear")
    model = cd.compile(mounted(lambda a, b: cd.Bushing(a, b, tables={"x": line})))
    for x, force, energy in ((0.5, 15.0, 3.75), (-0.4, -4.0, 0.8)):
        q, u = model.split(model.initial({"floating": [1, 0, 0, 0, x, 0, 0]}))
        assert model.forward_dynamics(q, u)[3] == pytest.approx(-force / 1.5, rel=1e-14)
        assert model.energy(q, u).potential == pytest.approx(energy, rel=1e-14)


def test_a_curve_under_the_tip_of_a_beam() -> None:
    """Rest between the bending of a cantilever, closed for small angles, and a steep curve."""
    length, EI, load = 1.0, 20.0, 1e-3
    x = 1e-5 * np.array([-4.0, -1.0, 0.0, 1.0, 4.0])
    y = 1e-3 * np.array([-5.0, -0.2, 0.0, 0.2, 5.0])
    scene = cd.Scene("tip", gravity=(0, 0, 0))
    section = cd.section.general(EA=1e6, GA=1e9, GJ=1e3, EI=EI)
    beam = scene.beam("beam", scene.ground, (length, 0, 0), section, elements=4)
    tip = scene.ground.at(length, 0, 0)
    scene.force("mount", cd.Bushing(tip, beam.end, tables={"z": cd.table(x, y, "cubic")}))
    scene.force("load", cd.Force(beam.end, (0, 0, load)))
    curve, bending = CubicSpline(x, y), 3 * EI / length**3
    deflection = brentq(lambda w: bending * w + float(curve(w)) - load, 0, 1e-4, xtol=1e-18)
    rested = cd.compile(scene).equilibrium()
    assert float(curve(deflection)) > 0.2 * load
    assert rested.pose("beam.end")[2, 3] == pytest.approx(deflection, rel=1e-7)


def test_a_scene_file_says_tables_and_branches(tmp_path: Path) -> None:
    tables = {"z": cd.table(X, Y), "rx": cd.table([-1, 0, 1], [-2, 0, 2.5], "linear")}
    one, two = ((0, 0, 0, 3, 0, 1.5), 0.2), (np.diag((1.0, 2, 3, 4, 5, 6)) + 0.1, 3.0)
    for branches in ((), (one,), (one, two), 9 * (one,)):
        scene = pair(stiffness=coupled(), tables=tables, branches=branches)
        scene.save(tmp_path / "scene.yaml")
        again = cd.load(tmp_path / "scene.yaml")
        mounts = [s.forces["mount"].element for s in (scene, again)]
        for name in ("stiffness", "tables", "branches", "rest"):
            assert getattr(mounts[0], name) == getattr(mounts[1], name)
    frame = cd.Scene("outer")
    frame.include(scene, "inner")
    assert frame.forces["inner.mount"].element.tables == mounts[0].tables


def test_a_scene_file_names_the_table_it_lacks() -> None:
    from cardan.scene.files.yaml.reader import from_text

    text = (
        "cardan: 2\n"
        "tables: {rubber: {x: [-1, 0, 1], y: [-5, 0, 9]}}\n"
        "bodies: {a: {mass: 1, inertia: [1, 1, 1]}}\n"
        "joints: {j: {type: free, parent: ground, child: a}}\n"
        "forces: {m: {type: bushing, frame_a: ground, frame_b: a, tables: {TABLE}}}\n"
    )
    scene = from_text(text.replace("TABLE", "z: rubber"))
    assert scene.forces["m"].element.tables[0][1] == cd.table([-1, 0, 1], [-5, 0, 9])
    for wrong, message in (
        ("z: ruber", r"text:5:.*no table 'ruber'.*Did you mean 'rubber'"),
        ("s: rubber", r"text:5:.*'s', which is not a direction.*Known: rx"),
        ("z: {rubber: 1}", r"text:5:.*a text is wanted, not a mapping"),
    ):
        with pytest.raises(cd.ModelError, match=message):
            from_text(text.replace("TABLE", wrong))


@each(
    "tables, message",
    [
        ({"zz": cd.table([0, 1], [0, 1])}, r"tables has the key 'zz', which is not a direction.*z"),
        ({2: cd.table([0, 1], [0, 1])}, r"tables has the key 2, which is not a direction"),
        ({"z": [0, 1]}, r"tables\['z'\] is \[0, 1\]; give cd.table\(x, y\)"),
        ({"z": 3.0}, r"tables\['z'\] is 3.0; give cd.table"),
        (cd.table([0, 1], [0, 1]), r"tables maps directions to tables, such as \{'z'"),
        (["z"], r"tables maps directions to tables"),
        (None, r"tables maps directions to tables"),
    ],
)
def test_what_is_not_a_table_is_named(tables: Any, message: str) -> None:
    with pytest.raises(cd.ModelError, match=message):
        cd.Bushing("a", "b", tables=tables)


def test_explanations_name_the_curves(tmp_path: Path) -> None:
    scene = pair(stiffness=coupled(), tables={"z": cd.table(X, Y)}, branches=((1,) * 6, 0.1))
    text = ""
    for coordinates in COORDINATES:
        cd.derive(scene, coordinates=coordinates).explain(tmp_path / "page.md")
        text = (tmp_path / "page.md").read_text()
        assert "mount" in text
    assert "t what the tables say at y" in text
    assert "W the integrals of the tables over y" in text
    assert "K the stiffness and z the flow of a branch" in text
    energy = cd.derive(scene, coordinates="absolute").kinds["bushing"].energy.potential
    assert "W" in map(str, energy.free_symbols)
