"""Linear models as formulas against closed forms, published matrices and the numeric ones."""

from __future__ import annotations

import json
import warnings
from pathlib import Path

import numpy as np
import pytest
import sympy as sp

import cardan as cd
from table import each

ROOT = Path(__file__).parents[2]
BICYCLE = json.loads((ROOT / "tests/references/bicycle_linear.json").read_text())["reference"]
# roll to the right is positive there and here, steering to the right there
SIGNS = np.diag([1.0, -1.0])


def trolley() -> cd.Scene:
    """A cart on a spring with a pendulum of a point mass, pushed and seen."""
    g = sp.Symbol("g")
    scene = cd.Scene("trolley", gravity=(0, 0, -g))
    scene.parameter("g", 9.81)
    M, m, ell = (scene.parameter(*pair) for pair in (("M", 2.0), ("m", 1.0), ("l", 0.5)))
    k, c = scene.parameter("k", 3.0), scene.parameter("c", 0.3)
    cart = scene.body("cart", mass=M)
    bob = scene.body("bob", mass=m, com=(0, 0, -ell))
    scene.joint("rail", cd.Prismatic("x"), scene.ground, cart)
    scene.joint("rope", cd.Revolute("y"), cart, bob)
    law = scene.input("push") - k * scene.q("rail") - c * scene.u("rail")
    scene.force("engine", cd.JointForce("rail", law))
    scene.output("tip", bob.at(0, 0, -ell).position()[0])
    return scene


def test_formulas_of_a_cart_with_a_pendulum() -> None:
    found = cd.derive(trolley()).linearize()
    g, M, m, ell, k, c = sp.symbols("g M m l k c")
    assert found.states == ("rail", "rope", "rail.u", "rope.u")
    assert sp.Matrix([[M + m, -m * ell], [-m * ell, m * ell**2]]) == found.M
    assert sp.diag(k, m * g * ell) == found.K
    assert sp.diag(c, 0) == found.damping == found.dissipative
    assert sp.zeros(2) == found.gyroscopic == found.circulatory
    assert sp.Matrix([[1], [0]]) == found.forces
    assert sp.Matrix([[1, -ell, 0, 0]]) == found.C
    expected = sp.Matrix([[-k / M, -m * g / M], [-k / (M * ell), -(M + m) * g / (M * ell)]])
    assert sp.simplify(found.A[2:, :2] - expected) == sp.zeros(2)
    assert found.needed == {}
    assert "linearized about rest" in str(found)
    assert r"\ddot y" in found._repr_latex_()


def test_a_position_with_a_symbol_says_which_force_it_takes() -> None:
    phi = sp.Symbol("phi")
    found = cd.derive(trolley()).linearize(q={"rope": phi})
    g, m, ell = sp.symbols("g m l")
    assert found.needed == {"rope.u": g * m * ell * sp.sin(phi)}
    assert found.K[1, 1] == g * m * ell * sp.cos(phi)
    with pytest.raises(cd.DerivationError, match="'phi' needs a value"):
        found.at()
    stiff = found.second_order().at(phi=[0.0, np.pi])["K"][:, 1, 1]
    np.testing.assert_allclose(stiff, [9.81 * 0.5, -9.81 * 0.5], rtol=1e-14)


def test_chosen_inputs_and_outputs() -> None:
    equations = cd.derive(trolley())
    asked = {"inputs": ["rope", "push"], "outputs": ["rope", "rope.u", "tip"]}
    found, numbers = equations.linearize(**asked).at(), cd.compile(equations).linearize(**asked)
    for name in "ABCD":
        np.testing.assert_allclose(found[name], getattr(numbers, name), atol=1e-12)


@each(
    ("asked", "said"),
    [
        ({"q": {"rop": 0.1}}, "Did you mean 'rope'"),
        ({"inputs": ["pusch"]}, "Did you mean 'push'"),
        ({"outputs": ["tipp"]}, "Did you mean 'tip'"),
        ({"independent": ["rale"]}, "Did you mean 'rail'"),
        ({"values": {"w": 1.0}}, "no symbol 'w'"),
        ({"q": {"rail": (1, 2)}}, "has 1 entries"),
        ({"q": {"rail": "alpha"}}, "'alpha', a text"),
        ({"udot": "none"}, "'free'"),
        ({"route": "differentiate"}, "Did you mean 'differentiated'"),
    ],
)
def test_refusals_name_the_culprit(asked: dict, said: str) -> None:
    with pytest.raises(cd.DerivationError, match=said):
        cd.derive(trolley()).linearize(**asked)


def test_the_benchmark_bicycle() -> None:
    # Meijaard et al.: M y'' + v C1 y' + (g K0 + v² K2) y = f with the speed as a symbol
    v = sp.Symbol("v")
    equations = cd.derive(cd.load(ROOT / "src/cardan/scenes/bicycle.yaml"))
    wanted = ["rear_contact.lean", "steer"]
    straight = equations.linearize(u={"rear_contact.x": v}, independent=[*wanted, "rear_contact.x"])
    assert straight.needed == {}
    found = straight.second_order(wanted)
    numbers = {name: SIGNS @ x @ SIGNS for name, x in found.at(v=[0.0, 1.0, 2.0]).items()
               if name not in ("forces", "inner")}  # fmt: skip
    M, C, K = (numbers[name] for name in ("M", "damping", "K"))
    expected = {name: np.array(BICYCLE[name]) for name in ("M", "C1", "K0", "K2")}
    np.testing.assert_allclose(M[0], expected["M"], rtol=1e-12, atol=1e-12)
    np.testing.assert_allclose(C[1], expected["C1"], rtol=1e-12, atol=1e-12)
    np.testing.assert_allclose(K[0] / 9.81, expected["K0"], rtol=1e-12, atol=1e-12)
    np.testing.assert_allclose((K[2] - K[0]) / 4, expected["K2"], rtol=1e-12, atol=1e-12)
    # and so do the formulas: every entry has the power of v that belongs to it
    assert all(sp.Poly(entry, v).monoms() == [(1,)] for entry in found.damping if entry)
    assert {m for entry in found.K for m in sp.Poly(entry, v).monoms()} == {(0,), (2,)}
    with pytest.raises(cd.DerivationError, match="enters the equations"):
        straight.second_order(["rear_contact.lean"])


def two_swings(m: float, l: float, k: float) -> cd.Scene:
    """Two pendulums side by side with a spring of turns between them."""
    scene = cd.Scene("swings", gravity=(0, 0, -9.81))
    mass, length, k = scene.parameter("m", m), scene.parameter("l", l), scene.parameter("k", k)
    for name in "ab":
        swing = scene.body(name, mass=mass, com=(0, 0, -length))
        scene.joint(f"{name}_pin", cd.Revolute("y"), scene.ground, swing)
    twist = scene.q("a_pin") - scene.q("b_pin")
    scene.force("on_a", cd.JointForce("a_pin", -k * twist))
    scene.force("on_b", cd.JointForce("b_pin", k * twist))
    return scene


@pytest.mark.parametrize("values", [(1e-9, 1e-4, 1e-12), (1.0, 1.0, 0.0), (1e6, 10.0, 1.0)])
def test_what_couples_is_seen_at_any_size_and_where_it_is_0_by_default(
    values: tuple[float, float, float],
) -> None:
    found = cd.derive(two_swings(*values)).linearize()
    with pytest.raises(cd.DerivationError, match="'b_pin' enters the equations of a_pin"):
        found.second_order(["a_pin"])


def test_what_a_tiny_reference_takes_is_told() -> None:
    scene = cd.Scene("tiny", gravity=(0, 0, -9.81))
    scene.joint("pin", cd.Revolute("y"), scene.ground, scene.body("a", 1e-9, com=(1e-4, 0, 0)))
    assert list(cd.derive(scene).linearize().needed) == ["pin.u"]
    assert cd.derive(scene).linearize(q={"pin": sp.pi / 2}).needed == {}


def test_internal_states_stand_in_the_equations_of_second_order() -> None:
    scene = cd.Scene("strut", gravity=(0, 0, 0))
    scene.joint("rail", cd.Prismatic("x"), scene.ground, scene.body("cart", mass=2.0))
    ends = scene.ground.at(-2, 0, 0), "cart"
    scene.force("strut", cd.Maxwell(*ends, stiffness=100.0, damping=3.0, rest_length=2.0))
    equations = cd.derive(scene)
    found = equations.linearize().second_order()
    beside = cd.compile(equations).linearize().second_order()
    numbers = found.at()
    for name in ("M", "K", "inner"):
        np.testing.assert_allclose(numbers[name], getattr(beside, name), rtol=1e-12, atol=1e-12)
    assert numbers["inner"][0, 0] == pytest.approx(100.0, rel=1e-12)
    assert "= B r + Z z" in str(found)


def test_coordinates_of_second_order_are_named_alike_in_formulas_and_numbers() -> None:
    equations = cd.derive(two_swings(1.0, 1.0, 0.0))
    symbolic = equations.linearize(independent="a_pin")
    numeric = cd.compile(equations).linearize()
    assert numeric.second_order("a_pin").coordinates == ("a_pin",)
    for found in (symbolic, numeric):
        assert found.second_order(["a_pin", "b_pin", "a_pin"]).coordinates == ("a_pin", "b_pin")
        with pytest.raises(cd.CardanError, match="name at least one"):
            found.second_order([])
        with pytest.raises(cd.CardanError, match="give a list of names"):
            found.second_order([1])


def test_accelerations_that_were_not_given_are_told_where_they_matter() -> None:
    equations, q = cd.derive(trolley()), {"rope": 0.3}
    with pytest.warns(cd.ModelWarning, match=r"forces along rope\.u .* udot='free'"):
        held = equations.linearize(q=q)
    assert "udot='free'" in str(held)
    numeric = cd.compile(equations).linearize(q=q)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        # what is meant, what needs no force, and formulas
        np.testing.assert_array_equal(equations.linearize(q=q, udot={}).at()["A"], held.at()["A"])
        equations.linearize(q={"rope": sp.Symbol("phi")})
        assert "about rest" in str(equations.linearize())
        free = equations.linearize(q=q, udot="free")
    assert "about a motion that accelerates" in str(free)
    np.testing.assert_allclose(free.at()["A"], numeric.A, atol=1e-12)
    assert np.abs(held.at()["A"] - numeric.A).max() > 0.1
