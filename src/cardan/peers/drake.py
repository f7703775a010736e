"""Derivatives by Drake: its MultibodyPlant over numbers that carry slopes, called from Python.

A call is one into its C++, to which Python adds some 10 us; its other functions take less than that
and would look slower than they are.

Source: R. Tedrake and the Drake Development Team, Drake: Model-based design and verification for
robotics, 2019.
"""

from __future__ import annotations

import importlib.metadata
from collections.abc import Callable, Sequence
from time import perf_counter
from typing import TYPE_CHECKING

import numpy as np

from ..api.comparison import Scene
from ..arrays import Array
from . import coordinates
from .peer import Contender, Peer, States, installed
from .tree import central, directions

if TYPE_CHECKING:
    from pydrake.multibody.plant import MultibodyPlant
    from pydrake.multibody.tree import Joint, SpatialInertia


def missing() -> str:
    """Reason why it cannot be called, "" where there is none."""
    return installed("pydrake", "drake")


def refusal(scene: Scene, joints: Sequence[str]) -> str:
    """Trees of hinges and slides, whose coordinates are ours."""
    return coordinates.refusal(scene, joints, ("revolute", "prismatic"))


def _plant(scene: Scene) -> tuple[MultibodyPlant, list[Joint]]:
    """The tree, and its joints by our bodies."""
    from pydrake.math import RigidTransform, RotationMatrix
    from pydrake.multibody import plant as plants
    from pydrake.multibody import tree

    n = scene.numbers
    (com, inertia), axes = central(scene), directions(scene)
    plant = plants.MultibodyPlant(0.0)
    plant.mutable_gravity_field().set_gravity_vector(n["gravity"])
    bodies, joints = [plant.world_body()], []
    for i, parent in enumerate(scene.parents):
        body = plant.AddRigidBody(f"b{i}", _inertia(n["mass"][i], com[i], inertia[i]))
        turn = RotationMatrix.ProjectToRotationMatrix(n["rotation"][i])
        place = tree.FixedOffsetFrame(
            f"f{i}", bodies[parent + 1].body_frame(), RigidTransform(turn, n["position"][i])
        )
        base = plant.AddFrame(place)
        kind = tree.RevoluteJoint if scene.kinds[i] == "revolute" else tree.PrismaticJoint
        joints.append(plant.AddJoint(kind(f"j{i}", base, body.body_frame(), axes[i])))
        bodies.append(body)
    plant.Finalize()
    return plant, joints


def _inertia(mass: float, com: Array, central_inertia: Array) -> SpatialInertia:
    """Spatial inertia about the origin of a body, also where no real body has such moments."""
    from pydrake.multibody.tree import SpatialInertia, UnitInertia

    about = central_inertia + mass * (com @ com * np.eye(3) - np.outer(com, com))
    i = about / mass
    unit = UnitInertia(i[0, 0], i[1, 1], i[2, 2], i[0, 1], i[0, 2], i[1, 2])
    return SpatialInertia(mass, com, unit, skip_validity_check=True)


def contender(scene: Scene) -> Contender:
    """Drake on a tree of hinges and slides.

    Raises:
        ValueError: a body has no mass.
    """
    from pydrake.autodiffutils import ExtractGradient, InitializeAutoDiff

    if not np.all(scene.numbers["mass"] > 0):
        raise ValueError("a body has no mass")
    plant, joints = _plant(scene)
    dual = plant.ToAutoDiffXd()
    context = dual.CreateDefaultContext()
    forces = dual.get_applied_generalized_force_input_port()
    nu = plant.num_velocities()
    # our entry of each of theirs
    order = np.empty(nu, dtype=int)
    for body, joint in enumerate(joints):
        order[joint.velocity_start()] = scene.q[body][0]
    back = np.argsort(order)

    def rows(states: States) -> list[tuple[Array, Array]]:
        x = np.hstack([states.q[:, order], states.u[:, order]])
        return list(zip(x, states.third[:, order], strict=True))

    def slopes(x: Array, force: Array) -> Array:
        forces.FixValue(context, force)
        dual.SetPositionsAndVelocities(context, InitializeAutoDiff(x)[:, 0])
        rates = dual.EvalTimeDerivatives(context).CopyToVector()
        gradient: Array = ExtractGradient(rates[nu:])
        return gradient

    def start(function: str, states: States) -> Callable[[int], float]:
        inputs = rows(states)

        def run(repeats: int) -> float:
            began = perf_counter()
            for _ in range(repeats):
                for x, force in inputs:
                    slopes(x, force)
            return (perf_counter() - began) / repeats / len(inputs)

        return run

    def results(function: str, states: States) -> Array:
        gradients = np.array([slopes(x, force) for x, force in rows(states)])
        split = gradients.reshape(-1, nu, 2, nu).transpose(0, 2, 1, 3)
        return split[:, :, back][:, :, :, back]

    title = f"Drake {importlib.metadata.version('drake')}, called from Python"
    return Contender(title, ("derivatives",), start, results, (plant, dual, context))


PEER = Peer("Drake", "drake", missing, refusal, contender)
