"""Applied forces and reactions, judged by the balance of every body."""

from __future__ import annotations

from typing import Any

import numpy as np

from .differences import relative
from .evaluation import Trial
from .joint_motion import Array, cross, joint_motion, times
from .loop_constraints import circuits_of
from .loops import accelerations
from .motions import moves_alone
from .newton_euler import along_joints, joint_rows, moving, rates_of_momentum, transmitted

Loads = tuple[list[Array], list[Array]]


def _saved(trial: Trial) -> dict[str, Array]:
    """Forces of elements on bodies, and along the speeds of joints."""
    if "saved loads" not in trial.cache:
        model, blocks = trial.model, trial.blocks
        p = model.parameters.vector
        inputs: dict[str, Any] = {"p": p, **{k: blocks[k] for k in "tquzrs"}}
        results = model._evaluate_saved("wrenches", **inputs)
        n, ends = len(trial.reference.q), {"joints": 1}
        wide = {
            k: np.broadcast_to(x, (n, *np.shape(x)[-ends.get(k, 2) :])) for k, x in results.items()
        }
        trial.cache["saved loads"] = wide
    loads: dict[str, Array] = trial.cache["saved loads"]
    return loads


def _elements(trial: Trial) -> Loads:
    """Moment about its origin and force of elements on every body, in ground axes."""
    n, bodies = len(trial.reference.q), range(len(trial.scene.parents))
    if "wrenches" not in trial.model.saved:
        return [np.zeros((n, 3)) for _ in bodies], [np.zeros((n, 3)) for _ in bodies]
    loads, rotations = _saved(trial), trial.moving.rotations
    moments, forces = (
        [times(rotations[i + 1], loads[name][:, i]) for i in bodies] for name in ("moment", "force")
    )
    return moments, forces


def _generalized(trial: Trial, loads: Loads) -> Array:
    """Along the speeds of the model."""
    still = [np.zeros((len(trial.reference.q), 1))] * len(trial.scene.parents)
    return trial.along(along_joints(trial.scene, trial.moving, *loads, still))


def applied(trial: Trial, of: str | None) -> float | str:
    """Generalized forces of the wrenches of all elements, and of what acts along joints."""
    value = trial.call("applied_forces")
    if trial.model.manifest.scene.forces == []:
        return relative(value, np.ones_like(value))
    if "wrenches" not in trial.model.saved:
        return "what elements do on bodies is not saved"
    loads = _elements(trial)
    along, joints = _generalized(trial, loads), _saved(trial)["joints"]
    sizes = [np.concatenate(part, axis=-1) for part in loads]
    return relative(value - along - joints, value, along, joints, *sizes)


def _outside(trial: Trial) -> tuple[Array, Loads]:
    """A random block of wrenches of parts, and what it does on every body."""
    model, m, manifest = trial.model, trial.moving, trial.model.manifest
    n, parts = len(trial.reference.q), model._layout.parts
    block = np.random.default_rng(5).uniform(-1, 1, (n, len(parts), 6))
    moments = [np.zeros((n, 3)) for _ in trial.scene.parents]
    forces = [np.zeros((n, 3)) for _ in trial.scene.parents]
    places = {row.name: k for k, row in enumerate(manifest.frames)}
    row = 0
    for i, body in enumerate(manifest.bodies):
        for part in body.parts:
            at = trial.scene.numbers["frame_position"][places[part]]
            arm = times(m.rotations[i + 1], at)
            moment, force = block[:, row, :3], block[:, row, 3:]
            moments[i] = moments[i] + moment + cross(arm, force)
            forces[i] = forces[i] + force
            row += 1
    return block, (moments, forces)


def reaction(trial: Trial, of: str) -> float | str:
    """Reaction of a joint: the load of the bodies behind it, less all other forces on them."""
    manifest, model = trial.model.manifest, trial.model
    joints = [row.name for row in manifest.joints]
    cuts = [row.name for row in manifest.cuts]
    why = _why_not(trial, of, joints, cuts)
    if why:
        return why
    block, outside = _outside(trial)
    loads: Loads = _elements(trial)
    loads = _sum(loads, outside)
    reference = trial.reference
    applied_force = reference.tau + _generalized(trial, outside)
    force = reference.under(applied_force, outside) + applied_force
    udot = accelerations(trial, force)
    handed = {name: trial.call("reaction", name, {"wrench": block}) for name in cuts}
    needs, rotors = _needs(trial, udot)
    for k, wrench in enumerate(handed.values()):
        loads = _sum(loads, _closing(trial, k, wrench))
    left = [[a - b for a, b in zip(x, y, strict=True)] for x, y in zip(needs, loads, strict=True)]
    along, moments, forces = transmitted(trial.scene, trial.moving, left[0], left[1], rotors)
    sizes = [np.concatenate(x, axis=-1) for x in (*needs, *loads)]
    if of in cuts:
        # what joints that close loops hand on leaves the joints of the tree to their drives
        driven = reference.tau + (_saved(trial)["joints"] if "wrenches" in model.saved else 0.0)
        idle = _work(trial, cuts.index(of), handed[of])
        return max(relative(trial.along(along) - driven, driven, *sizes), relative(idle, *sizes))
    i = joints.index(of)
    expected = _at_joint(trial, i, moments[i], forces[i])
    value = trial.call("reaction", of, {"wrench": block})
    return relative(value - expected, expected, *sizes)


def _why_not(trial: Trial, of: str, joints: list[str], cuts: list[str]) -> str:
    """Why a reaction is judged by its expressions alone."""
    manifest = trial.model.manifest
    if of not in joints and of not in cuts:
        return "inside of a rigid body"
    if any(joint.solved for joint in manifest.joints):
        return "loops in closed form"
    if any(row.name == row.joint for row in manifest.multipliers):
        return "constraints of the user's own"
    if trial.redundant:
        return "redundant constraints leave it undetermined"
    if any(("reaction", cut) not in trial.callable_keys for cut in cuts):
        return "reactions of joints that close loops are not compiled"
    return moves_alone(trial)


def _sum(one: Loads, other: Loads) -> Loads:
    first, second = (
        [a + b for a, b in zip(x, y, strict=True)] for x, y in zip(one, other, strict=True)
    )
    return first, second


def _needs(trial: Trial, udot: Array) -> tuple[Loads, list[Array]]:
    """Moment and force that every body needs to move so, gravity taken off; of rotors."""
    scene, (q, u, _, motion) = trial.scene, trial.tree
    m = moving(scene, q, u, udot, motion)
    pairs = [
        rates_of_momentum(scene.numbers, i, m.rotations[i + 1], m.omega[i + 1], a, b)
        for i, (a, b) in enumerate(zip(m.alpha[1:], m.accel[1:], strict=True))
    ]
    rotors = [rate for rate, _ in m.rotors]
    return ([moment for moment, _ in pairs], [force for _, force in pairs]), rotors


def _closing(trial: Trial, k: int, wrench: Array) -> Loads:
    """Loads of a joint that closes a loop."""
    scene, m = trial.scene, trial.moving
    closer = circuits_of(trial.model.manifest, scene, trial.model.nq).closers[k]
    n = len(wrench)
    moments = [np.zeros((n, 3)) for _ in scene.parents]
    forces = [np.zeros((n, 3)) for _ in scene.parents]
    child, parent = closer.child, closer.parent
    rotation = m.rotations[child.body + 1] @ child.rotation
    arm = times(m.rotations[child.body + 1], child.position)
    force, moment = times(rotation, wrench[:, 3:]), times(rotation, wrench[:, :3])
    place = m.place[child.body + 1] + arm
    for body, sign in ((child.body, 1.0), (parent.body, -1.0)):
        if body >= 0:
            to = place - m.place[body + 1]
            moments[body] = moments[body] + sign * (moment + cross(to, force))
            forces[body] = forces[body] + sign * force
    return moments, forces


def _work(trial: Trial, k: int, wrench: Array) -> Array:
    """Work of a wrench along the motions that its joint allows."""
    circuits = circuits_of(trial.model.manifest, trial.scene, trial.model.nq)
    closer = circuits.closers[k]
    bound: Any = trial.reference.bound
    (q, nq), (u, nu) = closer.q, closer.u
    joint = joint_motion(closer.joint, bound.q[:, q : q + nq], bound.u[:, u : u + nu])
    shift = np.swapaxes(joint.rotation, -1, -2) @ joint.shift
    turn = np.broadcast_to(joint.turn, shift.shape)
    both = np.concatenate([turn, shift], axis=-2)
    return times(np.swapaxes(both, -1, -2), wrench)


def _at_joint(trial: Trial, i: int, moment: Array, force: Array) -> Array:
    """Wrench that joint i transmits, on its declared child at its frame in its axes."""
    m, scene = trial.moving, trial.scene
    manifest = trial.model.manifest
    if manifest.joints[i].child == manifest.bodies[i].name:
        back = np.swapaxes(m.rotations[i + 1], -1, -2)
        return np.concatenate([times(back, moment), times(back, force)], axis=-1)
    q, u, _, motion = trial.tree
    joint = joint_motion(scene.joints[i], *joint_rows(scene, i, q, (u,), motion))
    side = m.rotations[i + 1] @ np.swapaxes(joint.rotation, -1, -2)
    back = np.swapaxes(side, -1, -2)
    # the seat of the joint on the parent lies behind the origin of the body
    arm = times(side, joint.position)
    return -np.concatenate([times(back, moment + cross(arm, force)), times(back, force)], axis=-1)


JUDGES = {"applied_forces": applied, "reaction": reaction}
