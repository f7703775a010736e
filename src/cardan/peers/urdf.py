"""Agreement with what Pinocchio reads from a URDF itself: nothing of our reader is shared."""

from __future__ import annotations

import importlib.util
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ..api.comparison import face, load
from ..compilation import compile

if TYPE_CHECKING:
    from types import ModuleType

STATES = 20
SEED = 4


def agreement(path: Path) -> float | None:
    """Largest relative difference of forward dynamics between cardan's C and Pinocchio's ABA.

    Both read the file as printed: angles unsnapped, mimic joints freed, damping left out.

    Args:
        path: URDF of a robot on a fixed base.

    Returns:
        max|difference| / max|udot| over random states, None where Pinocchio is not installed.
    """
    if importlib.util.find_spec("pinocchio") is None:
        return None
    import pinocchio

    model = compile(face(load(path, snap=False, mimic="free")), functions=("forward_dynamics",))
    damping = {name: 0.0 for name in model.parameters if name.endswith(".damping")}
    model = model.with_parameters(damping) if damping else model
    peer = pinocchio.buildModelFromUrdf(str(path))
    data = peer.createData()
    rng = np.random.default_rng(SEED)
    worst = 0.0
    for _ in range(STATES):
        q, u, tau = rng.uniform(-1.5, 1.5, (3, model.nu))
        theirs = _forward(pinocchio, peer, data, _ordered(model, peer), (q, u, tau))
        ours = model.forward_dynamics(q, u, tau=tau)
        worst = max(worst, float(np.abs(ours - theirs).max() / np.abs(theirs).max()))
    return worst


def _ordered(model: Any, peer: Any) -> list[int]:
    """Pinocchio's joint number of every coordinate of ours."""
    return [int(peer.getJointId(name)) for name in model.coordinates]


def _forward(
    pinocchio: ModuleType, peer: Any, data: Any, joints: list[int], state: tuple[np.ndarray, ...]
) -> np.ndarray:
    """Pinocchio's accelerations in our order; joints without limits are (cos, sin) there."""
    place, speed, torque = np.zeros(peer.nq), np.zeros(peer.nv), np.zeros(peer.nv)
    velocities = [peer.idx_vs[j] for j in joints]
    for j, angle in zip(joints, state[0], strict=True):
        entries = [np.cos(angle), np.sin(angle)] if peer.nqs[j] == 2 else [angle]
        place[peer.idx_qs[j] : peer.idx_qs[j] + len(entries)] = entries
    speed[velocities], torque[velocities] = state[1], state[2]
    accelerations: np.ndarray = pinocchio.aba(peer, data, place, speed, torque)[velocities]
    return accelerations
