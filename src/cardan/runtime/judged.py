"""The flat scene of a compiled model as the judge of every build reads it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from .circle_means import Pose
from .joint_curve import Curve
from .joint_motion import CUSTOM, KINDS, REVERSED
from .newton_euler import Scene
from .rotations import PARAMETERS

if TYPE_CHECKING:
    from .compiled import CompiledModel


def unknown(model: CompiledModel) -> str:
    """Why the scene of a model cannot be judged; "" if it can."""
    manifest = model.manifest
    scene = manifest.get("scene") or {}
    if not scene or "scene" not in model.saved:
        return "not checked: the directory holds no scene"
    reasons = [str(r) for r in scene.get("unknown", [])]
    for joint, kind, rotation in zip(
        manifest["joints"], scene["kinds"], scene["rotations"], strict=True
    ):
        if kind.removeprefix(REVERSED) not in KINDS or not _posed(model, joint["name"], kind):
            reasons.append(f"joint '{joint['name']}' is {kind}")
        elif rotation is not None and rotation not in PARAMETERS:
            reasons.append(f"joint '{joint['name']}' is described by {rotation}")
    moved = any(joint["prescribed"] for joint in manifest["joints"])
    if moved and "scene_motion" not in model.saved:
        reasons.append("the motion of prescribed joints is not saved")
    if any(joint.get("solved") for joint in manifest["joints"]) and "dependents" not in model.saved:
        reasons.append("the joints that circuits determine are not saved")
    return "not checked: " + "; ".join(reasons[:3]) if reasons else ""


def unjudged(model: CompiledModel) -> str:
    """Why nothing but its own expressions speaks for a model; "" where something does."""
    scene = model.manifest.get("scene") or {}
    if "mesh" in model.manifest or scene.get("samples"):
        return ""
    from .closed_states import bound, unbound

    return unknown(model) or (unbound(model) if bound(model) else "")


POSE = "scene_pose_"


def _posed(model: CompiledModel, name: str, kind: str) -> bool:
    """Whether the pose of a joint is known: it is saved where the user wrote it."""
    number = [joint["name"] for joint in model.manifest["joints"]].index(name)
    return kind.removeprefix(REVERSED) != CUSTOM or f"{POSE}{number}" in model.saved


def _pose(model: CompiledModel, number: int) -> Pose:
    """The pose of a joint of the user's own, as it was written."""
    function, p = f"{POSE}{number}", model.parameters.vector

    def pose(q: Any) -> tuple[Any, Any]:
        found = model._evaluate_saved(function, q=q, p=p)
        n, turned, placed = len(q), found["rotation"], found["position"]
        return (
            np.broadcast_to(turned, (n, *turned.shape[-2:])).reshape(n, 3, 3),
            np.broadcast_to(placed, (n, *placed.shape[-1:])).reshape(n, 3),
        )

    return pose


def scene_of(model: CompiledModel) -> Scene:
    """The flat scene of a model with its parameter values, as :func:`scene_from` says it."""
    numbers = model._evaluate_saved("scene", p=model.parameters.vector)
    kinds = enumerate(model.manifest["scene"]["kinds"])
    own = [i for i, kind in kinds if kind.removeprefix(REVERSED) == CUSTOM]
    return replace(scene_from(model.manifest, numbers), poses={i: _pose(model, i) for i in own})


def scene_from(manifest: Mapping[str, Any], given: Mapping[str, Any]) -> Scene:
    """The flat scene of a manifest with these numbers.

    Joints that circuits determine have their coordinates and speeds behind those of the model.
    """
    joints, scene = manifest["joints"], manifest["scene"]
    place = {joint["name"]: i for i, joint in enumerate(joints)}
    numbers = {"axis2": np.zeros((len(joints), 3)), **given}
    leaders = [place[j["coupled"]["leader"]] if j["coupled"] else -1 for j in joints]
    ends = {"q": len(manifest["coordinates"]), "u": len(manifest["speeds"])}
    slots: dict[str, list[tuple[int, int]]] = {"q": [], "u": []}
    for joint in joints:
        for block, rows in slots.items():
            first, size = (joint[block] or (0, 0))[:2]
            if joint.get("solved"):
                first, size = ends[block], len(joint["solved"][block])
                ends[block] += size
            rows.append((first, size))
    return Scene(
        parents=tuple(scene["parents"]),
        kinds=tuple(scene["kinds"]),
        rotations=tuple(scene["rotations"]),
        q=tuple(slots["q"]),
        u=tuple(slots["u"]),
        leaders=tuple(leaders),
        prescribed=tuple(bool(j["prescribed"]) for j in joints),
        numbers=numbers,
        nu=ends["u"],
        curves=tuple(c and _curve(*c) for c in scene.get("curves", ())),
    )


def _curve(breaks: list[float], coefficients: list[list[list[float]]], period: float) -> Curve:
    return Curve(np.array(breaks), np.array(coefficients), period)


def motion_of(model: CompiledModel, t: float, r: Any) -> Any:
    """Value, rate and acceleration of prescribed joints (..., nb, 3); None without any."""
    if "scene_motion" not in model.saved:
        return None
    p = model.parameters.vector
    return model._evaluate_saved("scene_motion", t=np.array([t]), r=r, p=p)["motion"]
