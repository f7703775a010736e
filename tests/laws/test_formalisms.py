"""All formalisms give the same M, inverse and forward dynamics on the whole zoo."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import cardan as cd
from laws.cases import SEED, bound, call, derived, deviation, states, values
from laws.test_absolute import both, carried
from mechanisms import METHODS, ZOO
from mechanisms.rolling import ROLLING
from spread import some
from table import each

# all formalisms against Kane's on the system as it was described; those that recursions leave far
# behind in speed on a spread
FAST = ("newton_euler", "composite", "articulated")
PAIRS = [(name, method) for name, member in ZOO.items() for method in member.methods[1:]]
QUICK = [pair for pair in PAIRS if pair[1] in FAST]
OTHERS = [pair for pair in PAIRS if pair[1] not in FAST]


def udot_of(name: str) -> np.ndarray:
    return np.random.default_rng(SEED + 1).uniform(-3, 3, states(name)[1].shape)


def agree(name: str, method: str) -> None:
    """A formalism gives the functions that Kane's gives."""
    q, u = states(name)
    first, other = derived(name, "kane").without_rewrites, derived(name, method)
    mass = call(first, "mass_matrix", q=q)["M"]
    allowed = bound(mass)
    found = {
        "M": (call(other, "mass_matrix", q=q)["M"], mass),
        **{
            function: tuple(call(e, function, q=q, u=u)[output] for e in (other, first))
            for function, output in (("bias", "h"), ("gravity", "gravity"), ("applied_forces", "f"))
        },
        "tau": tuple(
            call(e, "inverse_dynamics", q=q, u=u, udot=udot_of(name))["tau"] for e in (other, first)
        ),
        "udot": tuple(call(e, "forward_dynamics", q=q, u=u)["udot"] for e in (other, first)),
    }
    errors = {key: deviation(*pair) / allowed for key, pair in found.items()}
    assert {key: error.max() for key, error in errors.items() if error.max() > 1} == {}


@pytest.mark.parametrize(("name", "method"), some(QUICK, 3))
def test_recursions_agree(name: str, method: str) -> None:
    agree(name, method)


@pytest.mark.parametrize(("name", "method"), some(OTHERS, 11))
def test_other_formalisms_agree(name: str, method: str) -> None:
    agree(name, method)


SLOW = [method for method in METHODS if method not in (*FAST, "kane")]
IN_C = [(name, method) for name in ("satellite", "gripper", "free_quaternion") for method in SLOW]


@pytest.mark.parametrize(("name", "method"), some(IN_C, 3))
def test_compiled(name: str, method: str) -> None:
    functions = ("forward_dynamics", "inverse_dynamics", "mass_matrix", "bias")
    e, (q, u) = derived(name, method), states(name)
    model = cd.compile(e, functions=functions)
    model.prepare(*functions)
    checks = model.verify().checks
    assert {check.function for check in checks if not check.reason} >= set(functions)
    at = values(e)["t"][0]
    exact = call(e, "forward_dynamics", q=q, u=u)["udot"]
    mass = call(e, "mass_matrix", q=q)["M"]
    assert np.all(deviation(model.forward_dynamics(q, u, t=at), exact) <= bound(mass))


@each("method", METHODS)
def test_agreement_with_absolute_coordinates(method: str) -> None:
    """Every body with the equations of Newton and Euler, every joint with its constraints."""
    name = "spatial_chain"
    model, other = both(name)
    q, u = (block[-1] for block in states(name))
    found = model.forward_dynamics(*carried(model, other, q, u))
    mine = [found[model.speeds.index(speed)] for speed in other.speeds]
    udot = call(derived(name, method), "forward_dynamics", q=q, u=u)["udot"]
    np.testing.assert_allclose(mine, udot, rtol=0, atol=1e-9 * (1 + np.abs(udot).max()))


def held_by(ball: Any, method: str) -> Any:
    """A body that turns in space, and one on a hinge of it."""
    scene = cd.Scene("locked")
    top = scene.body("top", mass=1.0, com=(0.1, 0.2, 0.3), inertia=(0.1, 0.2, 0.25))
    arm = scene.body("arm", mass=0.5, com=(0, 0.2, 0.1), inertia=(0.01, 0.02, 0.025))
    scene.joint("ball", ball, scene.ground, top)
    scene.joint("hinge", cd.Revolute((1, 2, 3)), top.at(0.3, 0, 0), arm)
    return cd.derive(scene, method=method)


@each(("kind", "sequence"), [(cd.Spherical, "XYZ"), (cd.Free, "zyx")])
@each("method", METHODS)
def test_gimbal_lock_does_no_harm(method: str, kind: Any, sequence: str) -> None:
    """Where qdot = N u is infinite M, h and udot are what they are by quaternions."""
    angles = [0.3, np.pi / 2, 0.4]
    x, y, z, w = Rotation.from_euler(sequence, angles).as_quat()
    place = [0.1, 0.2, 0.3] if kind is cd.Free else []
    u = np.array([0.5, -1.0, 2.0, *place, 0.3])
    locked, free = held_by(kind(rotation=sequence), method), held_by(kind(), "newton_euler")
    for function, output in (("mass_matrix", "M"), ("bias", "h"), ("forward_dynamics", "udot")):
        found = call(locked, function, q=np.array([*angles, *place, 0.7]), u=u)[output]
        wanted = call(free, function, q=np.array([w, x, y, z, *place, 0.7]), u=u)[output]
        size = 1 + np.abs(wanted).max()
        np.testing.assert_allclose(found, wanted, rtol=0, atol=1e-13 * size, err_msg=function)


@each("name", ZOO)
def test_mass_matrix_is_symmetric_and_positive(name: str) -> None:
    mass = call(derived(name), "mass_matrix", q=states(name)[0])["M"]
    np.testing.assert_allclose(mass, np.swapaxes(mass, -1, -2), rtol=1e-14, atol=1e-14 * mass.max())
    assert np.linalg.eigvalsh(mass).min() > 0


@each("name", ZOO)
def test_inverse_dynamics_is_mass_matrix_and_bias(name: str) -> None:
    (q, u), udot, e = states(name), udot_of(name), derived(name)
    mass = call(e, "mass_matrix", q=q)["M"]
    bias = call(e, "bias", q=q, u=u)["h"]
    applied = call(e, "applied_forces", q=q, u=u)["f"]
    expected = np.einsum("kij,kj->ki", mass, udot) + bias - applied
    tau = call(e, "inverse_dynamics", q=q, u=u, udot=udot)["tau"]
    # three sums of the size of their largest term, a few roundings per body
    size = np.abs(mass).max() * np.abs(udot).max() + np.abs(bias).max() + np.abs(applied).max()
    np.testing.assert_allclose(tau, expected, rtol=0, atol=100 * np.finfo(float).eps * size)


@each("name", ZOO)
def test_forward_undoes_inverse(name: str) -> None:
    (q, u), udot, e = states(name), udot_of(name), derived(name)
    tau = call(e, "inverse_dynamics", q=q, u=u, udot=udot)["tau"]
    back = call(e, "forward_dynamics", q=q, u=u, tau=tau)["udot"]
    mass = call(e, "mass_matrix", q=q)["M"]
    # tau carries the rounding of h, which may be larger than M udot
    bias = np.abs(call(e, "bias", q=q, u=u)["h"]).max(axis=1)
    growth = 1 + bias / np.abs(tau).max(axis=1)
    assert np.all(deviation(back, udot) <= growth * bound(mass))


def test_the_zoo_covers_what_it_promises() -> None:
    from cardan.elements.joints import JOINTS
    from cardan.spatial.rotations import ROTATIONS

    systems = [derived(name, "newton_euler").system for name in ZOO]
    systems += [cd.derive(build()).system for build in ROLLING.values()]
    elements = [joint.element for system in systems for joint in system.joints]
    kinds = {element.kind for element in elements}
    kinds |= {"fixed"} if any(system.fixed for system in systems) else set()
    assert kinds == set(JOINTS)
    assert {element.rotation for element in elements if element.kind == "spherical"} >= set(
        ROTATIONS
    )
    assert set(METHODS) == {m for member in ZOO.values() for m in member.methods}
    assert len({name.split("_")[0] for name in ZOO}) >= 12
