"""Superelements of the beams of a scene, against closed forms, matrices written by hand and C."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.runtime.models.finite_elements.elements import State
from superelements.components import reference

RHO, E, RADIUS = 2700.0, 70e9, 0.02
ALUMINUM = cd.material(E=E, nu=0.3, rho=RHO)
ROUND = cd.section.circle(radius=RADIUS)


def slender(EA: float, EI: float, rhoA: float) -> Any:
    """A section that is stiff in shear and has next to no rotary inertia, as Euler's beam."""
    return cd.section.general(EA=EA, GA=1e3 * EA, EI=EI, GJ=EI, rhoA=rhoA, rhoI=1e-9 * rhoA)


def straight(elements: int, section: Any = ROUND, material: Any = ALUMINUM, **more: Any) -> Any:
    scene = cd.Scene("free")
    scene.beam("boom", (0, 0, 0), (1, 0, 0), section, material, elements=elements, **more)
    return scene


def in_plane(omega: np.ndarray) -> np.ndarray:
    """One of each pair of equal frequencies."""
    return omega[np.flatnonzero(np.diff(omega, prepend=0) > 1e-6 * omega)]


def test_frequencies_tend_to_those_of_the_planar_beam() -> None:
    problem = reference("se_beam_16")
    p, exact = problem["parameters"], problem["reference"]
    free = np.array(exact["continuum_free_free_omega"][:3])
    errors = []
    for elements in (16, 32):
        scene = straight(elements, slender(p["EA"], p["EI"], p["rhoA"]), None)
        ends = cd.superelement.from_beams(scene, "boom", method="rubin", modes=16)
        errors.append(abs(in_plane(ends.modes().frequencies)[:3] / free - 1))
        clamped = in_plane(ends.modes(["start"]).frequencies)[:3]
        known = np.array(exact["full_clamped_free_omega"][:3])
        np.testing.assert_allclose(clamped, known, rtol=0.03 * (16 / elements) ** 2)
    print("free beam, 16 and 32 elements: errors", *errors)
    assert np.all(np.log2(errors[0] / errors[1]) > 3.8)
    assert errors[1].max() < 1e-5


def test_the_matrices_are_those_of_compiled_elements() -> None:
    """A curved beam with damping, in axes of its own, against the tangents in C."""
    material = cd.material(E=E, nu=0.3, rho=RHO, damping=1e-4)
    scene = cd.Scene("arc", gravity=(0, 0, 0))
    line = cd.arc(through=(0.6, 0.5, 0.3))
    scene.beam("boom", (0, 0, 0), (1, 1, 0.2), ROUND, material, elements=6, line=line)
    model = cd.compile(scene, coordinates="absolute")
    tip = cd.superelement.from_beams(scene, "boom", {"tip": "boom.end"}, modes=36)
    assert tip.n == len(tip.dofs) == model.nu
    mesh = model._source.results(model).mesh
    compiled = mesh.tangent(State(model.parts_of(model.initial())[0]))
    # no mode is left out: complex frequencies, damping included, are those of the elements in C
    here = damped(tip.M, tip.C, tip.K)
    there = damped(*(compiled[name].toarray() for name in "MCK"))
    assert (here > 1.0).sum() >= 15  # the others are overdamped
    np.testing.assert_allclose(here[here > 1.0][:15], there[there > 1.0][:15], rtol=1e-8)


def damped(M: np.ndarray, C: np.ndarray, K: np.ndarray) -> np.ndarray:
    """Damped frequencies, rising."""
    zero, inverse = np.zeros_like(M), np.linalg.inv(M)
    A = np.block([[zero, np.eye(len(M))], [-inverse @ K, -inverse @ C]])
    return np.sort(np.linalg.eigvals(A).imag)


def test_mass_center_and_inertia() -> None:
    record = cd.superelement.from_beams(straight(8), "boom", modes=4)
    mass = RHO * np.pi * RADIUS**2
    np.testing.assert_allclose(record.properties.mass, mass, rtol=1e-12)
    np.testing.assert_allclose(record.properties.center, (0.5, 0, 0), atol=1e-12)
    across = mass * (1 / 12 + RADIUS**2 / 4)
    inertia = np.diag([mass * RADIUS**2 / 2, across, across])
    np.testing.assert_allclose(record.properties.inertia, inertia, rtol=1e-10, atol=1e-12)


def satellite() -> Any:
    p = reference("satellite_two_beams_A")["parameters"]
    scene = cd.Scene("satellite", gravity=(0, 0, 0))
    J = p["J_hub"]
    hub = scene.body("hub", mass=p["m_hub"], inertia=(J, J, J))
    scene.joint("free", cd.Free(), scene.ground, hub)
    section = slender(1e9, p["EI"], p["rhoA"])
    for name, side in (("left", -1), ("right", 1)):
        root, tip = side * p["a"], side * (p["a"] + p["L"])
        scene.beam(name, hub.at(root, 0, 0), (tip, 0, 0), section, elements=48, base=hub)
    return scene


def test_beams_on_a_body() -> None:
    scene = satellite()
    record = cd.superelement.from_beams(
        scene, ["left", "right"], {"hub": "hub"}, bodies=["hub"], method="rubin", modes=16
    )
    known = reference("satellite_two_beams_A")
    exact = known["reference"]
    (hub,) = record.interfaces
    np.testing.assert_allclose(hub.position, 0, atol=1e-12)
    p = known["parameters"]
    np.testing.assert_allclose(record.properties.mass, p["m_hub"] + 2 * p["rhoA"] * p["L"])
    omega = record.modes().frequencies
    for family in ("still_antisymmetric", "still_symmetric"):
        nearest = [abs(omega / one - 1).min() for one in exact[family][:2]]
        print(family, nearest)
        assert max(nearest) < 2e-3
    locked = record.modes(["hub"]).frequencies
    assert max(abs(locked / one - 1).min() for one in exact["clamped_beam"][:2]) < 2e-3


def test_an_end_on_a_body_outside_is_a_node_of_its_own() -> None:
    record = cd.superelement.from_beams(satellite(), "right", modes=4)
    assert [frame.position for frame in record.interfaces] == [(1, 0, 0), (9, 0, 0)]
    assert len(record.dofs) == 6 * 49


def test_interfaces_between_the_ends() -> None:
    scene = straight(8)
    node = scene.beams["boom"].at(0.3, name="sensor")
    ends = {"root": "boom.start", "sensor": node, "mid": ("boom", 0.65)}
    record = cd.superelement.from_beams(scene, "boom", ends, modes=2)
    places = [frame.position[0] for frame in record.interfaces]
    np.testing.assert_allclose(places, (0, 0.3, 0.65), atol=1e-12)


def test_what_it_costs(capsys: pytest.CaptureFixture[str]) -> None:
    scene = straight(16)
    record = scene.reduce("boom", modes=6)
    printed = capsys.readouterr().out
    assert "102 coordinates before, 18 after (12 of interfaces, 6 modal)" in printed
    cost = record.cost
    np.testing.assert_allclose(cost.highest, record.frequencies[-1])
    np.testing.assert_allclose(cost.dropped, record.dropped[0])
    # equal frequencies of a round section: errors against those without reduction
    full = cd.superelement.from_beams(scene, "boom", modes=90).modes(["start"]).frequencies
    reduced = cost.modes["start"]
    for k in range(4):
        error = reduced.frequencies[k] / full[k] - 1
        assert error < reduced.bounds[k]
        assert error / 30 < reduced.estimates[k] < 30 * error
    scene.reduce("boom", modes=2, report=False)
    assert not capsys.readouterr().out


def hinged() -> Any:
    scene = straight(4)
    scene.beam("tip", (1, 0, 0), (2, 0, 0), ROUND, ALUMINUM, elements=4)
    scene.joint("elbow", cd.Revolute("y"), "boom.end", "tip.start")
    return scene


@pytest.mark.parametrize(
    ("make", "arguments", "message"),
    [
        (straight, {"beams": "bom"}, "there is no beam 'bom'.*'boom'"),
        (straight, {"beams": []}, "give at least one"),
        (lambda _: cd.Scene("empty"), {"beams": "boom"}, "has no beams"),
        (straight, {"interfaces": {"mid": ("boom", 0.4)}}, "no node at 0.4.*nearest is at 0.5.*at"),
        (straight, {"interfaces": {"a": "ground"}}, "'ground' is on none of the beams"),
        (straight, {"interfaces": {"a": 3}}, "interface 'a': 3; give an end"),
        (lambda n: straight(n, prestrain={"curvature2": 0.1}), {}, "'boom': .*prestrain= stress"),
        (lambda _: hinged(), {"beams": ["boom", "tip"]}, "not connected.* joint .* moves"),
        (lambda _: satellite(), {"beams": ["left", "right"]}, r"add bodies=\['hub'\]"),
        (
            lambda _: satellite(),
            {"beams": ["left", "right"], "bodies": ["hub"]},
            "2 beams have several ends",
        ),
        (straight, {"modes": 500}, "modes=500"),
        (straight, {"beams": 3}, "there is no beam '3'"),
        (straight, {"beams": None}, "there is no beam 'None'"),
        (straight, {"bodies": 3}, "body.*3"),
        (straight, {"interfaces": ["boom.end"]}, r"interfaces=\['boom.end'\]: give them by name"),
        (straight, {"interfaces": {"a": ("boom", True)}}, "give a number from 0 to 1"),
        (straight, {"interfaces": {"a": ("boom", float("nan"))}}, "give a number from 0 to 1"),
        (straight, {"interfaces": {"\ud800": "boom.end"}}, "is not a name"),
    ],
)
def test_bad_input(make: Any, arguments: dict[str, Any], message: str) -> None:
    with pytest.raises(cd.ModelError, match=message):
        cd.superelement.from_beams(make(4), **{"beams": "boom", **arguments})
