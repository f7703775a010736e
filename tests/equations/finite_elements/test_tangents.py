"""Tangents of every element against complex steps, one member of every kind."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.equations.finite_elements.record import BlockKind, Group
from cardan.ir.interpreter import evaluate
from equations.finite_elements.reference import Reference
from equations.finite_elements.test_forced import SCENES
from laws.circuits import scene_of
from laws.test_cut_joints import INSTANCES, machine
from mechanisms import ZOO
from mechanisms.rolling import ROLLING
from spread import some

Array = np.ndarray
STEP = 1e-30
EXACT = 1e-12
SEED = 13
CHOSEN: dict[str, Callable[[], cd.Scene]] = {
    **{
        name: ZOO[name].build
        for name in ("backwards", "backwards_guided", "drives", "springs", "free_mrp", "free_dcm")
    },
    **{name: (lambda name=name: scene_of(name)) for name in ("stewart", "cam")},
    **{
        f"{name}, cut" if cut else name: (lambda name=name, cut=cut: machine(INSTANCES[name], cut))
        for name in ("revolute oblique", "universal", "point on curve", "wheel", "gear", "custom")
        for cut in (False, True)
    },
    **{name: ROLLING[name] for name in ("wheel", "skate")},
    **SCENES,
}


class Element:
    """The first member of a group at a random state of its places."""

    def __init__(self, reference: Reference, group: Group) -> None:
        self.kind, rng = group.kind, np.random.default_rng(SEED)
        self.q = np.concatenate([_coordinates(block, rng) for block in self.kind.blocks] or [[]])
        u, udot = rng.normal(size=(2, self.kind.nu))
        self.rest = {
            "t": [0.3],
            "r": rng.normal(size=len(reference.inputs)),
            "p": reference.data(group)[0],
            "lam": rng.normal(size=self.kind.m),
            "z": [] if group.z is None else rng.normal(size=group.z.shape[1]),
            "s": [] if group.s is None else rng.normal(size=group.s.shape[1]),
        }
        self.u, self.udot = u, udot

    def call(self, function: str, q: Array, u: Array, udot: Array) -> dict[str, Any]:
        values = {"q": q, "u": u, "udot": udot, **self.rest}
        return evaluate(self.kind.functions[function], values, "numpy")

    def balance(self, q: Array, u: Array, udot: Array) -> Array:
        """Balance, then rates, then positions."""
        if "balance" not in self.kind.functions:
            return np.zeros(self.kind.nu + self.kind.m + self.kind.mp)
        found = self.call("balance", q, u, udot)
        return np.concatenate([found[n] for n in ("balance", "rates", "g") if n in found])

    def moved(self, step: Array) -> Array:
        """q moved along the speeds."""
        found, q, u = [], 0, 0
        for block in self.kind.blocks:
            own, du = self.q[q : q + block.nq], step[u : u + block.nu]
            if block.functions:
                own = evaluate(block.functions["move"], {"q": own, "du": du}, "numpy")["q"]
            else:
                own = own + du
            found.append(own)
            q, u = q + block.nq, u + block.nu
        return np.concatenate(found)

    def derivative(self, along: str) -> Array:
        """Columns of the balance along q, u or udot, by complex steps."""
        columns = []
        for e in np.eye(self.kind.nu) * (1j * STEP):
            given = {"q": self.q, "u": self.u, "udot": self.udot}
            given[along] = self.moved(e) if along == "q" else given[along] + e
            columns.append(self.balance(**given).imag / STEP)
        return np.stack(columns, axis=-1)


def _coordinates(block: BlockKind, rng: np.random.Generator) -> Array:
    """Beside the defaults; quaternions anywhere."""
    q = np.array(block.defaults) + rng.uniform(0.1, 0.5, block.nq)
    if block.quaternion is not None:
        own = slice(block.quaternion, block.quaternion + 4)
        q[own] = rng.normal(size=4)
        q[own] /= np.linalg.norm(q[own])
    return q


@pytest.mark.parametrize("name", some(CHOSEN, 3, 1))
def test_tangents_are_derivatives(name: str) -> None:
    tangents_agree(Reference(cd.derive(CHOSEN[name](), coordinates="absolute"), None, None))


def tangents_agree(reference: Reference) -> None:
    """Tangents of one member of every kind are the derivatives of its balance."""
    for group in reference.scene.groups:
        element = Element(reference, group)
        nu, m = element.kind.nu, element.kind.m
        if not nu:
            continue
        by_q, by_u, by_udot = (element.derivative(along) for along in ("q", "u", "udot"))
        expected = {"K": by_q[:nu], "C": by_u[:nu], "M": by_udot[:nu]}
        expected |= {"R": by_q[nu : nu + m], "G": by_u[nu : nu + m]}
        found = {}
        if "balance_tangent" in element.kind.functions:
            found = element.call("balance_tangent", element.q, element.u, element.udot)
        scale = 1 + max(np.abs(x).max(initial=0) for x in expected.values())
        for letter, matrix in expected.items():
            error = np.abs(found.get(letter, 0.0) - matrix).max(initial=0)
            assert error < EXACT * scale, (group.kind.name, letter, error / scale)
        if "G" in found:
            gradient = found["G"][: element.kind.mp] - by_q[nu + m :]
            assert np.abs(gradient).max(initial=0) < EXACT * scale
