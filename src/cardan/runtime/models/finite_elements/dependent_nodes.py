"""Nodes of beams that follow what their beams are joined to, for the start of runs.

A joint that stands otherwise than in the reference configuration carries the node it moves. What
hangs on it by beams goes along rigidly; between two nodes that were carried apart the motion goes
over from one to the other along the beam.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence

import numpy as np
from scipy.spatial.transform import Rotation

from ....arrays import Array
from ....records import dataclass
from ....schema.finite_elements import GROUND
from .tables import Integers, Tables


@dataclass(frozen=True)
class Motion:
    """Displacement of a node from its reference pose:

    a rotation about the ground's origin, then a shift.

    Attributes:
        turn: Rotation.
        shift: (3,) [m].
        omega, velocity: Angular velocity, and velocity of what is at the origin, ground axes.
    """

    turn: Rotation
    shift: Array
    omega: Array
    velocity: Array

    def at(self, home: Array) -> Array:
        """Where it takes a position (..., 3)."""
        return np.asarray(self.turn.apply(home) + self.shift)

    def velocity_at(self, home: Array) -> Array:
        """Velocity (..., 3) of what was at a position (..., 3)."""
        return self.velocity + np.cross(self.omega, self.at(home))


STILL = Motion(Rotation.identity(), np.zeros(3), np.zeros(3), np.zeros(3))


def trailed(
    tables: Tables,
    lines: Sequence[Integers],
    reference: Array,
    x: Array,
    located: Collection[int],
    tree_ends: Mapping[int, Motion],
) -> Array:
    """A state (nx,) whose beams follow the nodes that stand where they are told to.

    Args:
        tables: Places of the model.
        lines: Of every segment the places of its nodes from end to end; GROUND for the ground,
            less for bodies of rigid trees.
        reference: Coordinates (nq,) in the reference configuration.
        x: The state, with those nodes where they are to be.
        located: Places that are there already.
        tree_ends: Displacements of the bodies of rigid trees that segments end at.
    """
    moved, motions = x.copy(), {GROUND: STILL, **tree_ends}
    ends = {int(place) for line in lines for place in (line[0], line[-1])}
    for place in ends & set(located):
        motions[place] = motion_of(tables, reference, x, place)
    waiting = joined(lines, motions)
    while waiting:
        # first what lies between two known ends, then what hangs on one
        ready = sorted(waiting, key=lambda line: -sum(int(line[k]) in motions for k in (0, -1)))
        line = ready[0]
        waiting = [other for other in waiting if other is not line]
        one, other = (motions.get(int(line[k])) for k in (0, -1))
        if one is None and other is None:
            break
        _carry(tables, reference, moved, line, one or other or STILL, other or one or STILL)
        for k, motion in ((0, other), (-1, one)):
            motions.setdefault(int(line[k]), motion or STILL)
    return moved


def joined(lines: Sequence[Integers], located: Collection[int]) -> list[Integers]:
    """Lines that go on through nodes where nothing else hangs and nobody says where they are."""
    at: dict[int, list[int]] = {}
    for k, line in enumerate(lines):
        for place in (int(line[0]), int(line[-1])):
            at.setdefault(place, []).append(k)
    through = {
        place
        for place, lines_there in at.items()
        if len(set(lines_there)) == 2 and place not in located
    }
    chains: list[Integers] = []
    for line in lines:
        # segments of a beam follow each other
        if chains and int(line[0]) in through and chains[-1][-1] == line[0]:
            chains[-1] = np.concatenate([chains[-1], line[1:]])
        else:
            chains.append(line)
    return chains


def motion_of(tables: Tables, reference: Array, x: Array, place: int) -> Motion:
    """Displacement of a place from its pose in the reference configuration."""
    at, home = tables.pose(x, place), tables.pose(reference, place)
    return displacement(at, tables.speeds(x[tables.nq :], place), home)


def displacement(at: Array, speed: Array, home: Array) -> Motion:
    """Motion of a body from one pose to another.

    Args:
        at, home: Unit quaternion and position (7,) now and before.
        speed: Angular velocity in its axes and velocity now (6,).
    """
    now = _rotation(at[:4])
    turn = now * _rotation(home[:4]).inv()
    omega = now.apply(speed[:3])
    return Motion(turn, at[4:] - turn.apply(home[4:]), omega, speed[3:] - np.cross(omega, at[4:]))


def _carry(
    tables: Tables, reference: Array, x: Array, line: Integers, one: Motion, other: Motion
) -> None:
    """Move the nodes inside of a segment, and ends that are not known, into ``x``."""
    nodes = line >= 0
    places, s = line[nodes], np.linspace(0.0, 1.0, len(line))[nodes, None]
    arc = (other.turn * one.turn.inv()).as_rotvec()
    turn = Rotation.from_rotvec(s * arc) * one.turn if arc.any() else one.turn
    home = tables.poses(reference, places)
    positions = [motion.at(home[:, 4:]) for motion in (one, other)]
    position = (1 - s) * positions[0] + s * positions[1]
    now = turn * _rotation(home[:, :4])
    omega = (1 - s) * one.omega + s * other.omega
    velocity = (1 - s) * one.velocity + s * other.velocity + np.cross(omega, position)
    poses = np.hstack([np.roll(now.as_quat(), 1, axis=1), position])
    tables.put(x, places, poses, np.hstack([now.inv().apply(omega), velocity]))


def _rotation(q: Array) -> Rotation:
    """Rotation matrices of unit quaternions (..., 4)."""
    return Rotation.from_quat(np.roll(q, -1, axis=-1))
