"""The URDFs of the PyPI package example-robot-data, and Pinocchio's view of them."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
import pinocchio as pin
from scipy.spatial.transform import Rotation

from mechanisms.robots import folder

# Pinocchio's XML reader stops at a robot without a name
UNREADABLE = frozenset({"ur_description/urdf/ur3.urdf"})
# its joints mimic "index_q1", which the file calls "Left_index_q1": they stay free
LEADERLESS = frozenset({"alex_description/urdf/alex_psyonic_hands.urdf"})
# their M is singular: links without inertia at the end of joints
SINGULAR = frozenset(
    {"romeo_description/urdf/romeo.urdf", "romeo_description/urdf/romeo_laas_small.urdf"}
)


ROBOTS = folder()
FILES = sorted(
    name
    for name in (path.relative_to(ROBOTS).as_posix() for path in ROBOTS.rglob("*.urdf"))
    if name not in UNREADABLE
)


@dataclass(frozen=True)
class Mimic:
    """q = multiplier q_leader + offset, read here on its own."""

    leader: str
    multiplier: float
    offset: float


def mimics(name: str) -> dict[str, Mimic]:
    """The mimicking joints of a file."""
    found = {}
    for joint in ET.parse(ROBOTS / name).getroot().iter("joint"):
        tag = joint.find("mimic")
        if tag is not None:
            ratio, offset = float(tag.get("multiplier", 1)), float(tag.get("offset", 0))
            found[joint.get("name", "")] = Mimic(tag.get("joint", ""), ratio, offset)
    return found


WITH_MIMIC = [name for name in FILES if mimics(name) and name not in LEADERLESS]


@dataclass(frozen=True)
class Slot:
    """A joint in our q and u: first entries and kind."""

    name: str
    q: int
    u: int
    free: bool


@dataclass(frozen=True)
class Peer:
    """Pinocchio's model of a file, speaking in our coordinates and speeds.

    Ours: Free has q = [quaternion w first, position], u = [omega in body axes, velocity in
    ground axes]. Pinocchio: q = [position, quaternion w last], v = [velocity, omega] in body
    axes, and (cos, sin) for joints without limits.
    """

    model: Any
    slots: tuple[Slot, ...]

    @staticmethod
    def read(name: str, free: bool, mimic: bool, slots: tuple[Slot, ...]) -> Peer:
        path = str(ROBOTS / name)
        root = (pin.JointModelFreeFlyer(),) if free else ()
        model = pin.buildModelFromUrdf(path, *root, mimic=mimic)
        for field in ("damping", "friction", "armature", "rotorInertia"):
            if hasattr(model, field):
                setattr(model, field, np.zeros_like(getattr(model, field)))
        return Peer(model, slots)

    @cached_property
    def data(self) -> Any:
        return self.model.createData()

    def _index(self, slot: Slot) -> int:
        name = "root_joint" if slot.free else slot.name
        index = self.model.getJointId(name)
        assert index < self.model.njoints, name
        return int(index)

    def q(self, q: np.ndarray) -> np.ndarray:
        """Our coordinates as Pinocchio's."""
        result = np.zeros(self.model.nq)
        for slot in self.slots:
            index = self._index(slot)
            start, count = self.model.idx_qs[index], self.model.nqs[index]
            if slot.free:
                w, x, y, z, *position = q[slot.q : slot.q + 7]
                own = [*position, x, y, z, w]
            else:
                angle = q[slot.q]
                own = [np.cos(angle), np.sin(angle)] if count == 2 else [angle]
            result[start : start + count] = own
        return result

    def speeds(self, q: np.ndarray) -> np.ndarray:
        """X (nv, nu): Pinocchio's velocities are X u."""
        matrix = np.zeros((self.model.nv, self.model.nv))
        for slot in self.slots:
            start = self.model.idx_vs[self._index(slot)]
            if slot.free:
                rotation = _rotation(q, slot).T
                matrix[start : start + 3, slot.u + 3 : slot.u + 6] = rotation
                matrix[start + 3 : start + 6, slot.u : slot.u + 3] = np.eye(3)
            else:
                matrix[start, slot.u] = 1.0
        return matrix

    def speeds_rate(self, q: np.ndarray, u: np.ndarray) -> np.ndarray:
        """Xdot u (nv)."""
        result = np.zeros(self.model.nv)
        for slot in self.slots:
            if slot.free:
                start = self.model.idx_vs[self._index(slot)]
                omega, v = u[slot.u : slot.u + 3], u[slot.u + 3 : slot.u + 6]
                result[start : start + 3] = -np.cross(omega, _rotation(q, slot).T @ v)
        return result

    def mass_matrix(self, q: np.ndarray) -> np.ndarray:
        m = np.array(pin.crba(self.model, self.data, self.q(q)))
        m = np.triu(m) + np.triu(m, 1).T
        x = self.speeds(q)
        return x.T @ m @ x

    def inverse_dynamics(self, q: np.ndarray, u: np.ndarray, udot: np.ndarray) -> np.ndarray:
        x = self.speeds(q)
        rate = x @ udot + self.speeds_rate(q, u)
        return x.T @ np.array(pin.rnea(self.model, self.data, self.q(q), x @ u, rate))

    def forward_dynamics(self, q: np.ndarray, u: np.ndarray, tau: np.ndarray) -> np.ndarray:
        x = self.speeds(q)
        # X is a permutation with rotations: its transpose is its inverse
        rate = np.array(pin.aba(self.model, self.data, self.q(q), x @ u, x @ tau))
        return x.T @ (rate - self.speeds_rate(q, u))

    def pose(self, link: str, q: np.ndarray) -> np.ndarray:
        """Pose (4, 4) of a link; call :meth:`place` first."""
        return np.array(self.data.oMf[self.model.getFrameId(link, pin.FrameType.BODY)].homogeneous)

    def place(self, q: np.ndarray) -> None:
        pin.framesForwardKinematics(self.model, self.data, self.q(q))

    @property
    def links(self) -> list[str]:
        return [f.name for f in self.model.frames if f.type == pin.FrameType.BODY]


def _rotation(q: np.ndarray, slot: Slot) -> np.ndarray:
    w, x, y, z = q[slot.q : slot.q + 4]
    return Rotation.from_quat([x, y, z, w]).as_matrix()
