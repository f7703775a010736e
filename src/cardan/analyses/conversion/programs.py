"""Programs whose states are converted: their conventions, and the joints of their models."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple, Protocol

from ...records import dataclass
from .coordinates import SIZES, Convention

# sizes of the joints of MuJoCo by their type: free, ball, slide, hinge
MUJOCO_SIZES = ((7, 6), (4, 3), (1, 1), (1, 1))


class PinocchioModel(Protocol):
    """The part of a ``pinocchio.Model`` that is read."""

    names: Sequence[str]
    nqs: Sequence[int]
    nvs: Sequence[int]
    idx_qs: Sequence[int]
    idx_vs: Sequence[int]


class HasName(Protocol):
    """A joint or body of MuJoCo."""

    name: str


class MujocoModel(Protocol):
    """The part of a ``mujoco.MjModel`` that is read."""

    njnt: int
    jnt_type: Sequence[int]
    jnt_qposadr: Sequence[int]
    jnt_dofadr: Sequence[int]
    jnt_bodyid: Sequence[int]

    def joint(self, index: int, /) -> HasName:
        """One of its joints."""

    def body(self, index: int, /) -> HasName:
        """One of its bodies."""


class PeerJoint(NamedTuple):
    """A joint of the other program: first entries, sizes, the body that it carries."""

    name: str
    q: int
    u: int
    nq: int
    nu: int
    body: str = ""


@dataclass(frozen=True)
class Program:
    """A program whose states are converted.

    Attributes:
        name: As it calls itself.
        convention: Of its free, spherical and planar joints.
        kinds: Joints that it has as one joint.
        divided: Joints that are several joints of one coordinate each there.
        read: Its joints, of a model of it.
        cosines: Kinds whose last angle is always (cos, sin) there.
        perhaps_cosines: Kinds whose last angle may be.
        alphabetical: Joints of one body come in the order of the alphabet, not as declared.
        ground: Whether a free joint means the pose of a body on the ground.
    """

    name: str
    convention: Convention
    kinds: frozenset[str]
    read: Callable[..., list[PeerJoint]]
    divided: frozenset[str] = frozenset()
    cosines: frozenset[str] = frozenset()
    perhaps_cosines: frozenset[str] = frozenset()
    alphabetical: bool = False
    ground: bool = False


def _read_pinocchio(peer: PinocchioModel) -> list[PeerJoint]:
    rows = []
    for k, name in enumerate(peer.names):
        place = (int(peer.idx_qs[k]), int(peer.idx_vs[k]))
        row = PeerJoint(str(name), *place, int(peer.nqs[k]), int(peer.nvs[k]))
        # the universe and joints that follow others have no entries
        if row.nu:
            rows.append(row)
    return rows


def _read_mujoco(peer: MujocoModel) -> list[PeerJoint]:
    rows = []
    for j in range(peer.njnt):
        sizes = MUJOCO_SIZES[int(peer.jnt_type[j])]
        body = peer.body(int(peer.jnt_bodyid[j])).name
        place = (int(peer.jnt_qposadr[j]), int(peer.jnt_dofadr[j]))
        rows.append(PeerJoint(peer.joint(j).name, *place, *sizes, body))
    return rows


PINOCCHIO = Program(
    "Pinocchio",
    Convention(scalar_last=True, position_first=True, linear_first=True, body_axes=True),
    frozenset(SIZES) - {"cylindrical"},
    _read_pinocchio,
    cosines=frozenset({"planar"}),
    perhaps_cosines=frozenset({"revolute"}),
    alphabetical=True,
)
MUJOCO = Program(
    "MuJoCo",
    Convention(scalar_last=False, position_first=True, linear_first=True, body_axes=False),
    frozenset({"revolute", "prismatic", "spherical", "free"}),
    _read_mujoco,
    divided=frozenset({"universal", "cylindrical", "planar", "translation"}),
    ground=True,
)
