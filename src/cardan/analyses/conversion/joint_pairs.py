"""Pairs of joints: one of a model, and the same joint in another program."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

from ...errors import ArgumentError, brief, near
from ...runtime.models.loaded_model import LoadedModel
from ...runtime.verification.flat_scene import scene_of
from ...runtime.verification.joint_motion import REVERSED
from ...schema.mechanism import GROUND, JointRow
from .coordinates import SIZES, Coordinates, Follower, Pair, Sizes, paired
from .programs import MujocoModel, PeerJoint, PinocchioModel, Program


class ModelJoint(NamedTuple):
    """A joint of the model, or one coordinate of it.

    Attributes:
        name: That its counterpart has.
        kind: One of ``SIZES``.
        body: Its child.
        q, u: First entries; those of the joint it follows, if it does.
        ratio, offset: Of a follower.
    """

    name: str
    kind: str
    body: str
    q: int
    u: int
    ratio: float | None = None
    offset: float = 0.0


def joint_map(
    program: Program,
    model: LoadedModel,
    peer: PinocchioModel | MujocoModel | Sequence[str] | None,
    continuous: Sequence[str] = (),
) -> Coordinates:
    """The map between the states of a model and those of a program.

    Args:
        peer: Model of the program, names of its joints, or None: by rule.
        continuous: Revolute joints that are (cos, sin) there.

    Raises:
        ArgumentError: a joint without counterpart.
    """
    ours = {joint.name: joint for joint in _joints(program, model)}
    _check_names("continuous", continuous)
    if isinstance(peer, Sequence):
        _check_names("peer", peer)
    if peer is None or isinstance(peer, Sequence):
        for name in continuous:
            if name not in ours or ours[name].kind != "revolute":
                raise ArgumentError(
                    f"continuous: model '{model.name}' has no revolute joint "
                    f"{brief(name)}.{near(name, _revolute(ours.values()))}"
                )
        names = _order_by_rule(program, model, ours) if peer is None else peer
        theirs = _joints_in_order(program, model, ours, names, continuous)
    else:
        theirs = _read(program, peer)
    matches = _matches(program, model, ours, theirs)
    pairs, followers = [], []
    for name, row in matches.items():
        joint = ours[name]
        # one entry more than here: the angle is (cos, sin) there
        cosine = row.nq > SIZES[joint.kind][0]
        place = (joint.q, joint.u, row.q, row.u)
        if joint.ratio is None:
            pairs.append(Pair(joint.kind, *place, cosine))
        else:
            followers.append(Follower(*place, joint.ratio, joint.offset, cosine))
    ends = (max((r.q + r.nq for r in theirs), default=0), sum(r.nu for r in theirs))
    return paired(pairs, program.convention, Sizes(model.nq, model.nu, *ends), followers)


def _check_names(what: str, names: object) -> None:
    """Refuse what is not a list of texts; a text is a sequence of letters."""
    rows = names if isinstance(names, Sequence) and not isinstance(names, str) else (None,)
    if not all(isinstance(name, str) for name in rows):
        raise ArgumentError(f"{what}={brief(names)}: give the names of joints in a list")


def _revolute(ours: Iterable[ModelJoint]) -> list[str]:
    return [joint.name for joint in ours if joint.kind == "revolute"]


# joints of the model


def _joints(program: Program, model: LoadedModel) -> list[ModelJoint]:
    """Those that have a counterpart, in our order."""
    manifest = model.manifest
    if manifest.absolute:
        raise ArgumentError(
            f"model '{model.name}' has absolute coordinates, which {program.name} has not: "
            "derive it with coordinates='relative'"
        )
    joints, rows = [], {str(row.name): row for row in manifest.joints}
    kinds = dict(zip(rows, manifest.scene.kinds, strict=False))
    coupled = any(row.coupled for row in rows.values())
    values = scene_of(model).numbers if coupled else {}
    numbers = {name: (values["ratio"][i], values["offset"][i]) for i, name in enumerate(rows)
               } if coupled else {}  # fmt: skip
    for name, row in rows.items():
        reason = _refusal(program, row, kinds.get(name, row.kind))
        if reason:
            raise ArgumentError(f"joint '{name}' ({row.kind}) has no counterpart in {program.name}"
                                f": {reason}")  # fmt: skip
        if row.coupled:
            joints.append(_follower(rows, numbers, row))
            continue
        q, u = row.slot("q")[0], row.slot("u")[0]
        if row.kind in program.divided:
            parts = model.coordinates[q : q + row.slot("q")[1]]
            joints += [ModelJoint(part, "revolute", str(row.child), q + k, u + k)
                       for k, part in enumerate(parts)]  # fmt: skip
        else:
            joints.append(ModelJoint(name, row.kind, str(row.child), q, u))
    return joints


def _refusal(program: Program, row: JointRow, kind: str) -> str:
    """Why a joint has no counterpart, "" if it has."""
    if row.solved:
        return "its loop determines it and it has no coordinates here"
    if row.prescribed:
        return "it is prescribed and has no coordinates here"
    if row.coupled:
        return ""
    if row.kind not in program.kinds | program.divided:
        return f"that has {', '.join(sorted(program.kinds | program.divided))}"
    if kind.startswith(REVERSED):
        return "its child carries its parent; declare it the other way round"
    if row.rotation and row.rotation != "quaternion":
        return f"it turns by {row.rotation}; give it rotation='quaternion'"
    if row.q and not row.u:
        return "its speeds are not those of the joint; derive the model without speeds="
    if program.ground and row.kind == "free" and (
        row.parent_frame != GROUND or row.child_frame != row.child
    ):  # fmt: skip
        return "that has free joints from the ground to the origin of a body"
    return ""


def _follower(
    rows: Mapping[str, JointRow], numbers: Mapping[str, tuple[float, float]], row: JointRow
) -> ModelJoint:
    """A joint in coordinates of the one that it follows in the end."""
    ratio, offset, leader = 1.0, 0.0, row
    while leader.coupled:
        one, shift = numbers[str(leader.name)]
        ratio, offset = ratio * float(one), offset + ratio * float(shift)
        leader = rows[leader.coupled.leader]
    if leader.q is None or leader.u is None:
        raise ArgumentError(
            f"joint '{row.name}' follows '{leader.name}', which has no coordinates here"
        )
    kind = "prismatic" if row.kind == "prismatic" else "revolute"
    return ModelJoint(str(row.name), kind, str(row.child), leader.q[0], leader.u[0], ratio, offset)


# joints of the program


def _order_by_rule(
    program: Program, model: LoadedModel, ours: Mapping[str, ModelJoint]
) -> list[str]:
    """Names in the order of the program: depth first."""
    rows = model.manifest.joints
    parts: dict[str, list[str]] = {str(row.child): [] for row in rows}
    for name, joint in ours.items():
        parts[joint.body].append(name)
    children: dict[str, list[JointRow]] = {}
    for row in rows:
        children.setdefault(str(row.parent), []).append(row)
    if program.alphabetical:
        for parent, several in children.items():
            if len(several) > 1 and model.manifest.fixed:
                listed = ", ".join(f"'{row.name}'" for row in several[:3])
                raise ArgumentError(
                    f"joints {listed} are on body '{parent}', and their order in {program.name} "
                    "depends on fixed joints that the model no longer has: give peer=, its model "
                    "there or the names of its joints"
                )
            several.sort(key=lambda row: str(row.name))
    names: list[str] = []
    waiting = children.get(GROUND, [])[::-1]
    while waiting:
        row = waiting.pop()
        names += parts[str(row.child)]
        waiting += children.get(str(row.child), [])[::-1]
    return names


def _joints_in_order(
    program: Program,
    model: LoadedModel,
    ours: Mapping[str, ModelJoint],
    names: Sequence[str],
    continuous: Sequence[str],
) -> list[PeerJoint]:
    """Joints one after the other, with the sizes that their kinds have."""
    rows: list[PeerJoint] = []
    q = u = 0
    for name in names:
        if name == "universe":
            continue
        joint = ours.get(name) or _base(ours, name)
        if joint is None:
            raise _no_counterpart(program, model, name, ours)
        nq, nu = SIZES[joint.kind]
        nq += name in continuous or joint.kind in program.cosines
        rows.append(PeerJoint(name, q, u, nq, nu))
        q, u = q + nq, u + nu
    return rows


def _base(ours: Mapping[str, ModelJoint], name: str) -> ModelJoint | None:
    """The free joint behind the name that free flyers get from Pinocchio."""
    free = [joint for joint in ours.values() if joint.kind == "free"]
    return free[0] if name == "root_joint" and len(free) == 1 else None


def _read(program: Program, peer: PinocchioModel | MujocoModel) -> list[PeerJoint]:
    """Joints of a model of the program."""
    try:
        return program.read(peer)
    except AttributeError:
        raise ArgumentError(
            f"peer={type(peer).__name__}: give the model of {program.name} or the names of its "
            "joints in order"
        ) from None


# both


def _matches(
    program: Program,
    model: LoadedModel,
    ours: Mapping[str, ModelJoint],
    theirs: Sequence[PeerJoint],
) -> dict[str, PeerJoint]:
    """The counterpart of every joint, by name of ours."""
    named = {row.name: row for row in theirs if row.name}
    matches = {name: named[name] for name in ours if name in named}
    unmatched = [row for row in theirs if row.name not in matches]
    for name, joint in ours.items():
        if name in matches:
            continue
        size = SIZES[joint.kind]
        # joints without names by the body; the free one of a robot by what it is
        candidates = [row for row in unmatched if not row.name and row.body == joint.body]
        if joint.kind == "free":
            candidates = candidates or [row for row in unmatched if (row.nq, row.nu) == size]
        if len(candidates) == 1:
            matches[name] = candidates[0]
            unmatched.remove(candidates[0])
        elif joint.ratio is None:
            names = [row.name or f"one on body '{row.body}'" for row in unmatched]
            raise ArgumentError(
                f"joint '{name}' of model '{model.name}' has no counterpart in {program.name}: "
                f"no joint there has its name.{near(name, names)}"
            )
    if unmatched:
        raise _no_counterpart(
            program, model, unmatched[0].name or f"on body '{unmatched[0].body}'", ours
        )
    for name, row in matches.items():
        _check(program, ours[name], row)
    return matches


def _no_counterpart(
    program: Program, model: LoadedModel, name: str, ours: Mapping[str, ModelJoint]
) -> ArgumentError:
    return ArgumentError(
        f"joint '{name}' of {program.name} has no counterpart in model '{model.name}'."
        f"{near(name, ours)}"
    )


def _check(program: Program, joint: ModelJoint, row: PeerJoint) -> None:
    """Refuse counterparts of another kind."""
    nq, nu = SIZES[joint.kind]
    sizes = set() if joint.kind in program.cosines else {(nq, nu)}
    if joint.kind in program.cosines | program.perhaps_cosines:
        sizes.add((nq + 1, nu))
    if (row.nq, row.nu) not in sizes:
        raise ArgumentError(
            f"joint '{joint.name}' ({joint.kind}) has {nq} coordinates and {nu} speeds; its "
            f"counterpart in {program.name} has {row.nq} and {row.nu}"
        )
