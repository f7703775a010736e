"""Forces of superelements by name: their sums, their laws, and the formulas that readers see."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.runtime.models.finite_elements.assembled import Assembled
from cardan.runtime.models.finite_elements.elements import State
from elements.formula_values import computed
from superelements.components import brick_matrices, faces
from superelements.test_formulas import constants, frame_of
from superelements.test_formulas import scene as free_scene

FORMS = ("nodal", "projected", "corotated")
# of sums of matrices whose entries differ by six orders
ROUNDING = 1e-12


@cache
def record() -> Any:
    M, K, nodes = brick_matrices()
    return cd.superelement.reduce(M, 1e-4 * K, nodes, faces(), modes=3, damping=0.1)


@cache
def beam() -> Any:
    """Soft beams, which are stiffened by their spin; their masses depend on directions."""
    beams = cd.Scene("beams", gravity=(0, 0, 0))
    section = cd.section.general(EA=1e4, GA=1e4, GJ=1.0, EI=1.0, rhoA=1.0, rhoI=1e-2)
    beams.beam("beam", beams.ground, (1.0, 0, 0), section, elements=4)
    return cd.superelement.from_beams(beams, "beam", modes=2, stiffening="start")


@cache
def model_of(frame: str, inertia: str, stiffening: bool = False) -> Any:
    scene, of = cd.Scene("free", gravity=(1.0, -2.0, -9.8)), beam() if stiffening else record()
    body = scene.superelement("body", of, frame=frame, inertia=inertia, stiffening=stiffening)
    scene.joint("free", cd.Free(), scene.ground, body.at("start" if stiffening else "root"))
    return cd.compile(scene)


def some_state(model: Any, size: float = 0.05) -> tuple[Any, Any, Any]:
    """Coordinates, speeds and accelerations of a model that moves and is deformed."""
    rng = np.random.default_rng(7)
    q = size * rng.normal(size=model.nq)
    for k in model.manifest.quaternions:
        q[k : k + 4] = rng.normal(size=4)
        q[k : k + 4] /= np.linalg.norm(q[k : k + 4])
    return q, rng.normal(size=model.nu), rng.normal(size=model.nu)


def places_of(model: Any, parts: Any) -> list[int]:
    names = [row.name for row in model.manifest.speeds]
    return [names.index(name) for name in parts.speeds]


def assert_sums(model: Any) -> Any:
    """Parts add up to the compiled balance and to its tangents, which complex steps judge."""
    at = some_state(model)
    parts = model.superelement_parts("body", *at)
    source = model._source
    assert isinstance(source, Assembled)
    mesh = source.results(model).mesh
    state = State(*at)
    places = places_of(model, parts)
    mesh.connect("balance", "balance_tangent")
    expected = {name: x.toarray() for name, x in mesh.tangent(state, ("K", "C", "M")).items()}
    for letter, whole in expected.items():
        # whatever else is there has no mass
        here = whole[np.ix_(places, places)]
        np.testing.assert_allclose(np.abs(whole).sum(), np.abs(here).sum(), rtol=1e-14)
        np.testing.assert_allclose(
            parts.total(letter), here, atol=ROUNDING * np.abs(here).max(), rtol=0
        )
    force = mesh.balance(state)[0][places]
    np.testing.assert_allclose(parts.total("forces"), force, atol=ROUNDING * np.abs(force).max())
    return parts, at


@pytest.mark.parametrize(
    ("frame", "inertia"),
    [
        ("mean", "nodal"),
        ("root", "corotated"),
        ("root", "nodal"),
        ("tip", "nodal"),
        *(("chord", form) for form in FORMS),
    ],
)
def test_parts_add_up(frame: str, inertia: str) -> None:
    model = model_of(frame, inertia)
    parts, (_, speeds, _) = assert_sums(model)
    u = speeds[places_of(model, parts)]
    assert not parts.C["geometric"].any()
    for name, sign in (("gyroscopic", -1), ("pseudo_damping", 1)):
        assert np.abs(parts.C[name]).max() > 1e-3
        np.testing.assert_array_equal(parts.C[name].T, sign * parts.C[name])
    assert abs(parts.forces["gyroscopic"] @ u) < 1e-13 * np.abs(parts.forces["gyroscopic"]).max()


@pytest.mark.parametrize("inertia", FORMS)
def test_with_stiffening(inertia: str) -> None:
    """The geometric part is what a scene without it has not."""
    model = model_of("start", inertia, True)
    parts, at = assert_sums(model)
    scene = cd.Scene("free", gravity=(1.0, -2.0, -9.8))
    body = scene.superelement("body", beam(), frame="start", inertia=inertia)
    scene.joint("free", cd.Free(), scene.ground, body.at("start"))
    without = cd.compile(scene).superelement_parts("body", *at)
    for letter in ("K", "C", "M", "forces"):
        one, other = getattr(parts, letter), getattr(without, letter)
        for name in one:
            expected = other[name] if name != "geometric" else 0 * one[name]
            if name != "geometric":
                scale = np.abs(parts.total(letter)).max()
                np.testing.assert_allclose(one[name], expected, atol=ROUNDING * scale, rtol=0)
        assert np.abs(one["geometric"]).max() > 1e-4
    assert model.verify(seed=1).worst < 1e-9


def test_pseudo_damping_is_the_rate_of_the_mass() -> None:
    """u.P u / 2 = u.M~ u / 2 by central differences of the mass along the motion."""
    model = model_of("root", "nodal")
    q, u, _ = some_state(model)
    power = model.superelement_parts("body", q, u).forces["pseudo_damping"] @ u
    energies = []
    rates = model.qdot(q, u)
    for step in (1e-5, -1e-5):
        M = model.superelement_parts("body", q + step * rates, 0 * u).M["inertia"]
        energies.append(u @ M @ u / 2)
    np.testing.assert_allclose(power, (energies[0] - energies[1]) / 2e-5, rtol=1e-8)


def test_parts_are_those_of_the_formulas() -> None:
    """Of the coordinates, by what readers see of them and by complex steps of it."""
    model, rng = cd.compile(free_scene(on_ground=False)), np.random.default_rng(2)
    q, u, udot = some_state(model)
    parts = model.superelement_parts("body", q, u, udot)
    kind = cd.derive(free_scene(on_ground=False)).kinds["superelement"].kinds[0]
    frame = frame_of(q[:7], u[:6], udot[:6])
    given = constants(slice(6, 15)) | frame
    given |= {f"omega_{k + 1}": float(x) for k, x in enumerate(frame["omega"].ravel())}
    motion = {"z": q[7:], "zdot": u[6:], "zddot": udot[6:]}

    def along_z(**change: Any) -> Any:
        z = {name: (motion[name] + change.get(name, 0.0))[:, None] for name in motion}
        return computed(kind.formulas, given | z, "nu")

    shown, own = along_z(), np.ix_(range(6, 15), range(6, 15))
    named = {
        ("C", "gyroscopic"): shown["C_g"],
        ("C", "damping"): given["D"],
        ("K", "elastic"): given["K"],
        ("M", "inertia"): given["M"],
    }
    for (letter, name), expected in named.items():
        found = getattr(parts, letter)[name][own]
        np.testing.assert_allclose(found, expected, atol=1e-11 * np.abs(expected).max())
    centrifugal = parts.K["centrifugal"][own]
    np.testing.assert_allclose(centrifugal, -shown["K_c"], atol=1e-9 * np.abs(shown["K_c"]).max())
    way, step = rng.normal(size=9), 1e-30
    for letter, name in (("K", "z"), ("C", "zdot"), ("M", "zddot")):
        slope = np.imag(along_z(**{name: 1j * step * way})["b_z"]).ravel() / step
        found = parts.total(letter)[6:, 6:] @ way
        np.testing.assert_allclose(found, slope, atol=1e-10 * np.abs(slope).max())


def test_what_is_asked_wrongly() -> None:
    model = model_of("root", "nodal")
    q, u, _ = some_state(model)
    with pytest.raises(cd.ModelError, match=r"no superelement 'boddy'.*Did you mean 'body'"):
        model.superelement_parts("boddy", q)
    with pytest.raises(cd.ArgumentError, match=r"u has shape \(2,\)"):
        model.superelement_parts("body", q, u[:2])
    parts = model.superelement_parts("body", q)
    assert "elastic" in repr(parts)
    assert "gyroscopic" not in repr(parts)
    with pytest.raises(cd.ArgumentError, match="give 'forces', 'M', 'C' or 'K'"):
        parts.total("D")


def test_printed_parts_show_what_is_no_number() -> None:
    model = model_of("root", "nodal")
    parts = model.superelement_parts("body", np.full(model.nq, np.nan))
    assert "forces  inertia nan" in str(parts)
