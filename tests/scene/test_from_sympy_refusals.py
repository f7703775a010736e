"""What written equations are refused for, and what they take part in."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sm
from sympy.physics import mechanics as me

import cardan as cd
from table import each

T = me.dynamicsymbols._t
Q, U = me.dynamicsymbols("q u")


def written(**changed: Any) -> cd.Scene:
    """A pendulum as (q, u, M, f), with parts of it replaced; the symbols m, g and q have values."""
    m, g = sm.symbols("m g")
    parts = {"q": [Q], "u": [U], "M": sm.Matrix([[m]]), "f": [-m * g * sm.sin(Q)]} | changed
    symbols = sm.Matrix([*parts["M"], *parts["f"]]).free_symbols
    values = {x: 1.0 for x in symbols if x.name in ("m", "g", "q")}
    return cd.from_sympy(tuple(parts.values()), parameters=values)


@each(
    ("changed", "words"),
    [
        ({"f": [sm.Symbol("k") * Q]}, r"1 symbol has no value: give parameters=\{'k'"),
        ({"f": [sm.Function("foo")(Q)]}, r"'foo\(q\(t\)\)' is not a function"),
        ({"f": [sm.gamma(Q)]}, "'gamma' in .* is not a function"),
        ({"f": [cd.table([0, 1, 2], [0, 1, 4], kind="linear")(Q)]}, "is a table of data"),
        ({"f": [Q.diff(T, 2)]}, "is an acceleration"),
        ({"f": [U.diff(T)]}, "is an acceleration"),
        ({"q": [Q, me.dynamicsymbols("p")]}, "2 coordinates and 1 speeds"),
        ({"M": sm.eye(2)}, "here M is 2x2"),
        ({"f": [sm.Symbol("q")]}, "the name 'q' stands for"),
        ({"q": [sm.Symbol("q")]}, r"make it with dynamicsymbols\('q'\)"),
        ({"f": [sm.sqrt(-2 - Q**2)]}, "no state was found"),
        ({"M": sm.zeros(1)}, "M is singular"),
    ],
)
def test_refusals_name_the_culprit(changed: dict[str, Any], words: str) -> None:
    with pytest.raises(cd.ModelError, match=words):
        written(**changed)


def test_kinematics_are_linear_and_free_of_inputs() -> None:
    for kinematics, words in (([U**2], "not linear"), ([U + me.dynamicsymbols("v")], "the input")):
        with pytest.raises(cd.ModelError, match=words):
            cd.from_sympy(([Q], [U], kinematics, [[1]], [-Q]))


def test_tables_by_name_are_mappings() -> None:
    plain = ([Q], [U], sm.eye(1), [-Q])
    for value in (np.ones(3), [1], 3):
        for word in ("outputs", "parameters", "inputs"):
            with pytest.raises(cd.ModelError, match=f"from_sympy: {word}=.*: give .* by "):
                cd.from_sympy(plain, **{word: value})


def test_values_that_nothing_depends_on_are_refused() -> None:
    with pytest.raises(cd.ModelError, match="'length' does not occur in the equations"):
        cd.from_sympy(([Q], [U], [[1]], [-Q]), parameters={"length": 2.0})


def test_names_that_nothing_has() -> None:
    for given, words in (
        ({"inputs": {"F": 1}}, "there is no input 'F'"),
        ({"potential": Q * T}, "coordinates and parameters alone"),
    ):
        with pytest.raises(cd.ModelError, match=words):
            cd.from_sympy(([Q], [U], [[1]], [-Q]), **given)
    with pytest.raises(cd.ModelError, match=r"takes a KanesMethod.*not int"):
        cd.from_sympy(3)
    with pytest.raises(cd.ModelError, match="kanes_equations"):
        cd.from_sympy(me.KanesMethod(me.ReferenceFrame("N"), [Q], [U], [Q.diff() - U]))


def test_a_configuration_that_velocities_do_not_keep_is_refused() -> None:
    x, y = me.dynamicsymbols("x y")
    v, w = me.dynamicsymbols("v w")
    ground, origin = me.ReferenceFrame("N"), me.Point("O")
    origin.set_vel(ground, 0)
    point = origin.locatenew("P", x * ground.x + y * ground.y)
    point.set_vel(ground, v * ground.x + w * ground.y)
    kane = me.KanesMethod(
        ground,
        [x],
        [v],
        [x.diff() - v, y.diff() - w],
        q_dependent=[y],
        configuration_constraints=[y - x],
        u_dependent=[w],
        velocity_constraints=[w - 2 * v],
    )
    kane.kanes_equations([me.Particle("p", point, 1)])
    with pytest.raises(cd.ModelError, match="configuration1 forbid"):
        cd.from_sympy(kane)


def test_what_needs_bodies_says_so(tmp_path: Path) -> None:
    scene = written()
    model = cd.compile(scene)
    at = np.zeros(1)
    for call in (
        lambda: model.pose("rod", at),
        lambda: model.reaction("pivot", at, at),
        lambda: model.com(at),
        lambda: model.momentum(at, at),
    ):
        with pytest.raises(cd.ModelError, match="tell of no bodies"):
            call()
    with pytest.raises(cd.ModelError, match="tell gravity"):
        model.gravity(at)
    with pytest.raises(cd.ModelError, match="potential="):
        model.energy(at, at)
    motion = model.simulate(1.0, q={"q": 0.4})
    with pytest.raises(cd.ModelError, match="a page shows bodies"):
        motion.animate(tmp_path / "page.html")
    with pytest.raises(cd.DerivationError, match="coordinates of their own"):
        cd.derive(scene, coordinates="absolute")
    with pytest.raises(cd.DerivationError, match="taken as they are"):
        cd.derive(scene, method="lagrange")
    with pytest.raises(cd.ModelError, match="scene files have no words"):
        scene.save(tmp_path / "scene.yaml")
    with pytest.raises(cd.ModelError, match="cannot be a part"):
        cd.Scene("whole").include(scene, "part")


def test_analyses_take_written_equations() -> None:
    q, u = me.dynamicsymbols("q u")
    k, m = sm.symbols("k m")
    scene = cd.from_sympy(([q], [u], [[m]], [-k * q + 1]), parameters={k: 8, m: 2}, name="mass")
    model = cd.compile(scene)
    rest = model.equilibrium()
    assert rest["q"] == pytest.approx(0.125, rel=1e-12)
    np.testing.assert_allclose(sorted(model.linearize(rest).eigenvalues.imag), [-2, 2], rtol=1e-12)
    np.testing.assert_allclose(model.modes().angular, [2.0], rtol=1e-12)
    ends = model.ensemble(1.0, q={"q": np.array([0.1, 0.2])})
    assert len(ends) == 2
    np.testing.assert_allclose(model.derivative("forward_dynamics", "k")([0.3], [0.0]), [-0.15])
    assert cd.derive(scene).mass_matrix == sm.Matrix([[sm.Symbol("m")]])


def test_scenes_of_written_equations_can_be_added_to() -> None:
    scene = written()
    scene.output("both", scene.q("q") + 2 * scene.u("u"))
    scene.force("brake", cd.JointForce("equations", -3 * scene.u("u")))
    model = cd.compile(scene)
    np.testing.assert_allclose(model.outputs([0.2], [0.5]), [1.2], rtol=1e-15)
    plain = cd.compile(written()).forward_dynamics([0.2], [0.5])
    np.testing.assert_allclose(model.forward_dynamics([0.2], [0.5]), plain - 1.5, rtol=1e-15)
    # SymPy knows nothing of the brake
    assert "the speeds of joint 'equations' are of its own making" in str(model.verify())


def test_a_shipped_model_is_judged_without_sympy(tmp_path: Path) -> None:
    folder = cd.derive(written()).export(tmp_path / "c", functions=("rhs", "mass_matrix"))
    program = (
        "import sys, cardan as cd\n"
        "model = cd.load_model(sys.argv[1])\n"
        "model.rhs(0.0, [0.3, 0.1])\n"
        "assert model.verify().checked == ('mass_matrix', 'rhs')\n"
        "assert 'sympy' not in sys.modules"
    )
    command = [sys.executable, "-c", program, str(folder)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize(
    "place", ["M", "f", "kinematics", "q", "constraint", "output", "potential"]
)
def test_a_text_is_refused_and_never_run(place: str, tmp_path: Path) -> None:
    """SymPy would run it as Python."""
    q, u = me.dynamicsymbols("q u")
    ran = tmp_path / "ran"
    text = f"open({str(ran)!r}, 'w')"
    put = {name: text if name == place else value for name, value in
           (("q", q), ("kinematics", u), ("M", 1), ("f", -q), ("constraint", q - u))}  # fmt: skip
    equations = ([put["q"]], [u], [put["kinematics"]], [[put["M"]]], [put["f"]],
                 {"c": put["constraint"]})  # fmt: skip
    options = {"outputs": {"o": text}} if place == "output" else {}
    options |= {"potential": text} if place == "potential" else {}
    with pytest.raises(cd.ModelError, match="is a text, which is not run"):
        cd.from_sympy(equations, **options)
    assert not ran.exists()
