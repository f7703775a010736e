"""Applied forces and reactions, judged by the balance of every body."""

from __future__ import annotations

from typing import Any

import numpy as np

from .differences import relative
from .evaluation import Asked
from .joint_motion import Array, cross, joint_motion, times
from .loop_constraints import circuits_of
from .loops import accelerations
from .motions import moves_alone
from .newton_euler import along_joints, moving, own, rates_of_momentum, transmitted

Loads = tuple[list[Array], list[Array]]


def _saved(asked: Asked) -> dict[str, Array]:
    """What elements do on bodies, and along the speeds of joints."""
    if "saved loads" not in asked.kept:
        model, blocks = asked.model, asked.blocks
        p = model.parameters.vector
        given: dict[str, Any] = {"p": p, **{k: blocks[k] for k in "tquzrs"}}
        found = model._evaluate_saved("wrenches", **given)
        n, ends = len(asked.truth.q), {"joints": 1}
        wide = {
            k: np.broadcast_to(x, (n, *np.shape(x)[-ends.get(k, 2) :])) for k, x in found.items()
        }
        asked.kept["saved loads"] = wide
    loads: dict[str, Array] = asked.kept["saved loads"]
    return loads


def _elements(asked: Asked) -> Loads:
    """Moment about its origin and force of elements on every body, in ground axes."""
    n, bodies = len(asked.truth.q), range(len(asked.scene.parents))
    if "wrenches" not in asked.model.saved:
        return [np.zeros((n, 3)) for _ in bodies], [np.zeros((n, 3)) for _ in bodies]
    loads, turned = _saved(asked), asked.moving.turned
    moments, forces = (
        [times(turned[i + 1], loads[name][:, i]) for i in bodies] for name in ("moment", "force")
    )
    return moments, forces


def _generalized(asked: Asked, loads: Loads) -> Array:
    """Along the speeds of the model."""
    still = [np.zeros((len(asked.truth.q), 1))] * len(asked.scene.parents)
    return asked.along(along_joints(asked.scene, asked.moving, *loads, still))


def applied(asked: Asked, of: str | None) -> float | str:
    """Generalized forces of the wrenches of all elements, and of what acts along joints."""
    value = asked.call("applied")
    if asked.model.manifest.scene.forces == []:
        return relative(value, np.ones_like(value))
    if "wrenches" not in asked.model.saved:
        return "what elements do on bodies is not saved"
    loads = _elements(asked)
    along, joints = _generalized(asked, loads), _saved(asked)["joints"]
    sizes = [np.concatenate(part, axis=-1) for part in loads]
    return relative(value - along - joints, value, along, joints, *sizes)


def _outside(asked: Asked) -> tuple[Array, Loads]:
    """A random block of wrenches of parts, and what it does on every body."""
    model, m, manifest = asked.model, asked.moving, asked.model.manifest
    n, parts = len(asked.truth.q), model._layout.parts
    block = np.random.default_rng(5).uniform(-1, 1, (n, len(parts), 6))
    moments = [np.zeros((n, 3)) for _ in asked.scene.parents]
    forces = [np.zeros((n, 3)) for _ in asked.scene.parents]
    places = {row.name: k for k, row in enumerate(manifest.frames)}
    row = 0
    for i, body in enumerate(manifest.bodies):
        for part in body.parts:
            at = asked.scene.numbers["frame_position"][places[part]]
            arm = times(m.turned[i + 1], at)
            moment, force = block[:, row, :3], block[:, row, 3:]
            moments[i] = moments[i] + moment + cross(arm, force)
            forces[i] = forces[i] + force
            row += 1
    return block, (moments, forces)


def reaction(asked: Asked, of: str) -> float | str:
    """What a joint hands on: what the bodies behind it need, less what acts on them otherwise."""
    manifest, model = asked.model.manifest, asked.model
    joints = [row.name for row in manifest.joints]
    cuts = [row.name for row in manifest.cuts]
    why = _why_not(asked, of, joints, cuts)
    if why:
        return why
    block, outside = _outside(asked)
    loads: Loads = _elements(asked)
    loads = _sum(loads, outside)
    truth = asked.truth
    given = truth.tau + _generalized(asked, outside)
    force = truth.under(given, outside) + given
    udot = accelerations(asked, force)
    handed = {name: asked.call("reaction", name, {"wrench": block}) for name in cuts}
    needs, rotors = _needs(asked, udot)
    for k, wrench in enumerate(handed.values()):
        loads = _sum(loads, _closing(asked, k, wrench))
    left = [[a - b for a, b in zip(x, y, strict=True)] for x, y in zip(needs, loads, strict=True)]
    along, moments, forces = transmitted(asked.scene, asked.moving, left[0], left[1], rotors)
    sizes = [np.concatenate(x, axis=-1) for x in (*needs, *loads)]
    if of in cuts:
        # what joints that close circuits hand on leaves the joints of the tree to their drives
        driven = truth.tau + (_saved(asked)["joints"] if "wrenches" in model.saved else 0.0)
        idle = _work(asked, cuts.index(of), handed[of])
        return max(relative(asked.along(along) - driven, driven, *sizes), relative(idle, *sizes))
    i = joints.index(of)
    known = _at_joint(asked, i, moments[i], forces[i])
    value = asked.call("reaction", of, {"wrench": block})
    return relative(value - known, known, *sizes)


def _why_not(asked: Asked, of: str, joints: list[str], cuts: list[str]) -> str:
    """Why a reaction is judged by its expressions alone."""
    manifest = asked.model.manifest
    if of not in joints and of not in cuts:
        return "inside of a rigid body"
    if any(joint.solved for joint in manifest.joints):
        return "loops in closed form"
    if any(row.name == row.joint for row in manifest.multipliers):
        return "constraints of the user's own"
    if asked.redundant:
        return "redundant constraints leave it undetermined"
    if any(("reaction", cut) not in asked.known for cut in cuts):
        return "reactions of joints that close loops are not compiled"
    return moves_alone(asked)


def _sum(one: Loads, other: Loads) -> Loads:
    first, second = (
        [a + b for a, b in zip(x, y, strict=True)] for x, y in zip(one, other, strict=True)
    )
    return first, second


def _needs(asked: Asked, udot: Array) -> tuple[Loads, list[Array]]:
    """Moment and force that every body needs to move so, gravity taken off; of rotors."""
    scene, (q, u, _, motion) = asked.scene, asked.tree
    m = moving(scene, q, u, udot, motion)
    pairs = [
        rates_of_momentum(scene.numbers, i, m.turned[i + 1], m.omega[i + 1], a, b)
        for i, (a, b) in enumerate(zip(m.alpha[1:], m.accel[1:], strict=True))
    ]
    rotors = [rate for rate, _ in m.rotors]
    return ([moment for moment, _ in pairs], [force for _, force in pairs]), rotors


def _closing(asked: Asked, k: int, wrench: Array) -> Loads:
    """What a joint that closes a circuit does on bodies."""
    scene, m = asked.scene, asked.moving
    closer = circuits_of(asked.model.manifest, scene, asked.model.nq).closers[k]
    n = len(wrench)
    moments = [np.zeros((n, 3)) for _ in scene.parents]
    forces = [np.zeros((n, 3)) for _ in scene.parents]
    child, parent = closer.child, closer.parent
    turned = m.turned[child.body + 1] @ child.rotation
    arm = times(m.turned[child.body + 1], child.position)
    force, moment = times(turned, wrench[:, 3:]), times(turned, wrench[:, :3])
    place = m.place[child.body + 1] + arm
    for body, sign in ((child.body, 1.0), (parent.body, -1.0)):
        if body >= 0:
            to = place - m.place[body + 1]
            moments[body] = moments[body] + sign * (moment + cross(to, force))
            forces[body] = forces[body] + sign * force
    return moments, forces


def _work(asked: Asked, k: int, wrench: Array) -> Array:
    """What a wrench does along the motions that its joint allows."""
    circuits = circuits_of(asked.model.manifest, asked.scene, asked.model.nq)
    closer = circuits.closers[k]
    bound: Any = asked.truth.bound
    (q, nq), (u, nu) = closer.q, closer.u
    joint = joint_motion(closer.joint, bound.q[:, q : q + nq], bound.u[:, u : u + nu])
    shift = np.swapaxes(joint.rotation, -1, -2) @ joint.shift
    turn = np.broadcast_to(joint.turn, shift.shape)
    both = np.concatenate([turn, shift], axis=-2)
    return times(np.swapaxes(both, -1, -2), wrench)


def _at_joint(asked: Asked, i: int, moment: Array, force: Array) -> Array:
    """What joint i hands on, on its declared child at its frame in its axes."""
    m, scene = asked.moving, asked.scene
    manifest = asked.model.manifest
    if manifest.joints[i].child == manifest.bodies[i].name:
        back = np.swapaxes(m.turned[i + 1], -1, -2)
        return np.concatenate([times(back, moment), times(back, force)], axis=-1)
    q, u, _, motion = asked.tree
    joint = joint_motion(scene.joints[i], *own(scene, i, q, (u,), motion))
    side = m.turned[i + 1] @ np.swapaxes(joint.rotation, -1, -2)
    back = np.swapaxes(side, -1, -2)
    # the seat of the joint on the parent lies behind the origin of the body
    arm = times(side, joint.position)
    return -np.concatenate([times(back, moment + cross(arm, force)), times(back, force)], axis=-1)


JUDGES = {"applied": applied, "reaction": reaction}
