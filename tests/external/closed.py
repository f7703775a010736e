"""Pinocchio's constrained dynamics of our closed systems: a tree with frames held together."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import pinocchio as pin

from cardan.api.comparison import PINOCCHIO
from cardan.peers.circuits import Circuits
from cardan.peers.coordinates import after_each_other, coordinates
from cardan.peers.peer import States
from cardan.peers.tree import central, depth_first, directions

# the proximal iteration ends where nothing changes any more; dependent rows need its steps
ACCURACY, WEIGHT, STEPS = 1e-14, 1e-10, 100


def _joint(kind: str, axis: np.ndarray, axis2: np.ndarray) -> Any:
    if kind == "revolute":
        return pin.JointModelRevoluteUnaligned(axis)
    if kind == "prismatic":
        return pin.JointModelPrismaticUnaligned(axis)
    if kind == "universal":
        return pin.JointModelUniversal(axis, axis2)
    return pin.JointModelSpherical() if kind == "spherical" else pin.JointModelFreeFlyer()


@dataclass
class Constrained:
    """Pinocchio's model of loops."""

    circuits: Circuits

    def __post_init__(self) -> None:
        scene = self.circuits.scene
        n, order = scene.numbers, depth_first(scene)
        com, inertia = central(scene)
        axes = directions(scene)
        model = pin.Model()
        model.gravity.linear = n["gravity"]
        numbers = {-1: 0}
        for body in order:
            place = pin.SE3(n["rotation"][body], n["position"][body])
            joint = _joint(scene.kinds[body], axes[body], n["axis2"][body])
            numbers[body] = model.addJoint(numbers[scene.parents[body]], joint, place, f"j{body}")
            own = pin.Inertia(n["mass"][body], com[body], inertia[body])
            model.appendBodyToJoint(numbers[body], own, pin.SE3.Identity())
        self.models = pin.StdVec_RigidConstraintModel()
        for held in self.circuits.connections:
            kind = pin.ContactType.CONTACT_6D if held.aligned else pin.ContactType.CONTACT_3D
            ends: list[Any] = []
            for body, r, p in zip(held.bodies, held.rotations, held.positions, strict=True):
                ends += [numbers[body], pin.SE3(r, p)]
            made = pin.RigidConstraintModel(kind, model, *ends, pin.ReferenceFrame.LOCAL)
            made.setBaumgarteCorrectorParameters(pin.BaumgarteCorrectorParameters(0.0, 0.0))
            self.models.append(made)
        self.model, self.data = model, model.createData()
        self.datas = pin.StdVec_RigidConstraintData()
        for made in self.models:
            self.datas.append(made.createData())
        self.map = coordinates(scene, PINOCCHIO.convention, after_each_other(scene, order))
        pin.initConstraintDynamics(model, self.data, self.models, self.datas)

    def forward_dynamics(self, q: np.ndarray, u: np.ndarray, tau: np.ndarray) -> np.ndarray:
        """Accelerations (n, nu) in our speeds."""
        states = self.circuits.states(States(q, u, tau))
        q, u, tau = states.q, states.u, states.third
        theirs = (self.map.q(q), self.map.speeds(q, u), self.map.speeds(q, tau))
        settings = pin.ProximalSettings(ACCURACY, WEIGHT, STEPS)
        rows = [
            np.array(
                pin.constraintDynamics(
                    self.model, self.data, *state, self.models, self.datas, settings
                )
            )
            for state in zip(*theirs, strict=True)
        ]
        return self.map.accelerations_back(q, u, np.array(rows))[:, : self.circuits.nu]
