"""States of a model in the coordinates and speeds of other programs, and back.

::

    q_pin, v = cd.convert.to_pinocchio(model, q, u, peer=pin_model)
    q, u = cd.convert.from_mujoco(model, data.qpos, data.qvel, peer=mj_model)

Joints are matched by name. ``peer=`` is the model of the other program, of which only numbers and
names are read, or the names of its joints in order; without it the order follows from a rule, see
each function. Neither program needs to be installed. Where a program has no such joint, the error
says which joint it is.

The table in the conventions page of the documentation says what differs. As speeds are linear in
u, ``X = to_pinocchio(model, q, np.eye(model.nu), ...)[1].T`` is the matrix of their speeds X u, so
that tau is ``X.T`` times their forces and M is ``X.T @ M_theirs @ X``.

Source: J. Carpentier et al., The Pinocchio C++ library, SII 2019; E. Todorov, T. Erez, Y. Tassa,
MuJoCo: A physics engine for model-based control, IROS 2012, and the manuals of both.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import overload

from numpy.typing import ArrayLike

from ...arrays import Array
from ...errors import ArgumentError
from ...runtime.calls.argument_values import numbers
from ...runtime.models.loaded_model import LoadedModel
from .coordinates import Coordinates
from .joint_pairs import joint_map
from .programs import MUJOCO, PINOCCHIO, MujocoModel, PinocchioModel, Program

__all__ = ["from_mujoco", "from_pinocchio", "to_mujoco", "to_pinocchio"]

_Mujoco = MujocoModel | Sequence[str] | None
_Pinocchio = PinocchioModel | Sequence[str] | None


@overload
def to_pinocchio(
    model: LoadedModel,
    q: ArrayLike,
    u: None = None,
    *,
    peer: _Pinocchio = None,
    continuous: Sequence[str] = (),
) -> Array: ...
@overload
def to_pinocchio(
    model: LoadedModel,
    q: ArrayLike,
    u: ArrayLike,
    *,
    peer: _Pinocchio = None,
    continuous: Sequence[str] = (),
) -> tuple[Array, Array]: ...
def to_pinocchio(
    model: LoadedModel,
    q: ArrayLike,
    u: ArrayLike | None = None,
    *,
    peer: PinocchioModel | Sequence[str] | None = None,
    continuous: Sequence[str] = (),
) -> Array | tuple[Array, Array]:
    """Coordinates, and speeds if given, as Pinocchio has them.

    Args:
        model: Compiled, in joint coordinates.
        q: Its coordinates (..., nq); leading axes of q and u broadcast.
        u: Its speeds (..., nu).
        peer: The ``pinocchio.Model``, or the names of its joints in order. By default joints come
            depth first, those of one body in the order of the alphabet, as in its URDF reader.
        continuous: Revolute joints that it writes as (cos, sin), such as those of type continuous
            in a URDF; read from ``peer`` if that is a model.

    Returns:
        q (..., nq) of Pinocchio: of a free joint position, then quaternion (x, y, z, w). With u
        also v (..., nv): of a free joint linear, then angular velocity, both in axes of the body.

    Raises:
        ArgumentError: a joint without counterpart; wrong shapes; the order is not known by rule.
    """
    return _to(_map(PINOCCHIO, model, peer, continuous), "to_pinocchio", q, u)


@overload
def from_pinocchio(
    model: LoadedModel,
    q: ArrayLike,
    v: None = None,
    *,
    peer: _Pinocchio = None,
    continuous: Sequence[str] = (),
) -> Array: ...
@overload
def from_pinocchio(
    model: LoadedModel,
    q: ArrayLike,
    v: ArrayLike,
    *,
    peer: _Pinocchio = None,
    continuous: Sequence[str] = (),
) -> tuple[Array, Array]: ...
def from_pinocchio(
    model: LoadedModel,
    q: ArrayLike,
    v: ArrayLike | None = None,
    *,
    peer: PinocchioModel | Sequence[str] | None = None,
    continuous: Sequence[str] = (),
) -> Array | tuple[Array, Array]:
    """Coordinates, and speeds if given, of Pinocchio as the model has them.

    Args:
        model: Compiled, in joint coordinates.
        q: Coordinates of Pinocchio (..., nq); leading axes of q and v broadcast.
        v: Its speeds (..., nv).
        peer, continuous: As in :func:`to_pinocchio`.

    Returns:
        q (..., nq); with v also u (..., nu). Angles of continuous joints are within half a turn;
        coordinates of joints that follow others are not read.

    Raises:
        ArgumentError: as in :func:`to_pinocchio`.
    """
    return _from(_map(PINOCCHIO, model, peer, continuous), "from_pinocchio", q, v)


@overload
def to_mujoco(
    model: LoadedModel, q: ArrayLike, u: None = None, *, peer: _Mujoco = None
) -> Array: ...
@overload
def to_mujoco(
    model: LoadedModel, q: ArrayLike, u: ArrayLike, *, peer: _Mujoco = None
) -> tuple[Array, Array]: ...
def to_mujoco(
    model: LoadedModel,
    q: ArrayLike,
    u: ArrayLike | None = None,
    *,
    peer: MujocoModel | Sequence[str] | None = None,
) -> Array | tuple[Array, Array]:
    """Coordinates, and speeds if given, as MuJoCo has them.

    Args:
        model: Compiled, in joint coordinates.
        q: Its coordinates (..., nq); leading axes of q and u broadcast.
        u: Its speeds (..., nu).
        peer: The ``mujoco.MjModel``, or the names of its joints in order. By default joints come
            depth first, those of one body as declared: the order of an MJCF file. Joints of two or
            three coordinates are so many joints there, named like the coordinates.

    Returns:
        qpos (..., nq): of a free joint position, then quaternion (w, x, y, z). With u also qvel
        (..., nv): of a free joint linear velocity in ground axes, then angular velocity in axes of
        the body.

    Raises:
        ArgumentError: a joint without counterpart; wrong shapes.
    """
    return _to(_map(MUJOCO, model, peer), "to_mujoco", q, u)


@overload
def from_mujoco(
    model: LoadedModel, qpos: ArrayLike, qvel: None = None, *, peer: _Mujoco = None
) -> Array: ...
@overload
def from_mujoco(
    model: LoadedModel, qpos: ArrayLike, qvel: ArrayLike, *, peer: _Mujoco = None
) -> tuple[Array, Array]: ...
def from_mujoco(
    model: LoadedModel,
    qpos: ArrayLike,
    qvel: ArrayLike | None = None,
    *,
    peer: MujocoModel | Sequence[str] | None = None,
) -> Array | tuple[Array, Array]:
    """Coordinates, and speeds if given, of MuJoCo as the model has them.

    Args:
        model: Compiled, in joint coordinates.
        qpos: Coordinates of MuJoCo (..., nq); leading axes of qpos and qvel broadcast.
        qvel: Its speeds (..., nv).
        peer: As in :func:`to_mujoco`.

    Returns:
        q (..., nq); with qvel also u (..., nu). Coordinates of joints that follow others are not
        read.

    Raises:
        ArgumentError: as in :func:`to_mujoco`.
    """
    return _from(_map(MUJOCO, model, peer), "from_mujoco", qpos, qvel)


def _map(
    program: Program,
    model: object,
    peer: PinocchioModel | MujocoModel | Sequence[str] | None,
    continuous: Sequence[str] = (),
) -> Coordinates:
    if not isinstance(model, LoadedModel):
        raise ArgumentError(
            f"convert to {program.name}: the first argument is the compiled model "
            f"(the order of joints depends on it), not {type(model).__name__}"
        )
    return joint_map(program, model, peer, continuous)


def _to(
    joints: Coordinates, where: str, q: ArrayLike, u: ArrayLike | None
) -> Array | tuple[Array, Array]:
    ours = _row(where, "q", q, joints.sizes.nq)
    if u is None:
        return joints.q(ours)
    return joints.q(ours), joints.speeds(ours, _row(where, "u", u, joints.sizes.nu))


def _from(
    joints: Coordinates, where: str, q: ArrayLike, u: ArrayLike | None
) -> Array | tuple[Array, Array]:
    ours = joints.q_back(_row(where, "coordinates", q, joints.sizes.nq_theirs))
    if u is None:
        return ours
    return ours, joints.back(ours, _row(where, "speeds", u, joints.sizes.nu_theirs))


def _row(where: str, what: str, value: ArrayLike, size: int) -> Array:
    array = numbers(f"{where}: {what}", value)
    if array.ndim == 0 or array.shape[-1] != size:
        raise ArgumentError(f"{where}: {what} has shape {array.shape}, expected (..., {size})")
    return array
