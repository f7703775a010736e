"""The page of a model that runs in it; ``live.js`` runs, ``live_panel.js`` has the sliders."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from ..arrays import Array
from ..errors import CardanError
from ..runtime.trajectory.trajectory import TrajectoryRecord
from ..schema import wasm_kernels
from .drawing import Drawing, solids_of
from .packing import JsonObject, deflated, text_of
from .page import Page, drawing_page
from .solids import Solid

KERNELS = "kernels"
MARK = re.compile("__(KERNELS|MODEL|PROGRAM|START)__")
# values of a slider at which solids are looked at; what of a solid they may change
SAMPLES = 9
GEOMETRY = frozenset({"a", "b", "r", "end", "size"})


def page(
    drawing: Drawing,
    spec: JsonObject,
    module: bytes,
    path: str | Path | None,
    kind: str,
    detail: str | float,
    title: str | None,
) -> Page:
    """The page.

    Args:
        drawing: Some motion of the model, of which the first row is drawn.
        spec: What the page has to know of the model, as ``live.js`` takes it.
        module: The model as WebAssembly.
        path, kind, detail, title: As ``drawing_page`` takes them.
    """
    low, high = _reach(drawing)
    size = max(1e-6, *(end - start for start, end in zip(low, high, strict=True)))
    spec |= {"reach": {"low": low, "high": high, "size": size}}
    # the script of the plain page comes along, deflated
    scripts = ("live.js", "live_panel.js", *(["plain.js"] if kind == "plain" else []))
    program = "".join(map(text_of, scripts)).replace('"use strict";', "")
    parts = {
        "KERNELS": deflated(wasm_kernels.content(KERNELS)),
        "MODEL": deflated(module),
        "PROGRAM": deflated(program.encode()),
        "START": text_of("live_start.js"),
    }
    block = MARK.sub(lambda mark: parts[mark[1]], text_of("live.html"))
    return drawing_page(_still(drawing), path, kind, detail, title, (spec, block))


def _still(drawing: Drawing) -> Drawing:
    """The bodies of the first row, and what stands around them."""
    return replace(
        drawing,
        abscissa=replace(drawing.abscissa, values=drawing.abscissa.values[:1]),
        bodies=[replace(body, poses=body.poses[:1]) for body in drawing.bodies],
        springs=[replace(s, ends=(s.ends[0][:1], s.ends[1][:1])) for s in drawing.springs],
        arrows=[],
        traces={},
        histories=[],
        events=[],
    )


def shapes(motion: TrajectoryRecord, sliders: Sequence[JsonObject]) -> list[JsonObject]:
    """What changes in the solids of bodies and ground over the ranges of sliders.

    Args:
        motion: A motion at the usual values.
        sliders: Of parameters and inputs, as ``live.js`` takes them.

    Returns:
        One entry per field that changes: number of the slider, values of the slider, number of the
        body (-1: ground) and of the solid, name of the field, its values.
    """
    usual, changes = _solids(motion), list[JsonObject]()
    for k, slider in enumerate(sliders):
        if slider["kind"] != "parameter" or motion.model is None:
            continue
        values = np.unique([*np.linspace(slider["low"], slider["high"], SAMPLES), slider["value"]])
        rows = [_solids_at(motion, slider["name"], float(value)) for value in values]
        for body, solids in usual.items():
            for n, solid in enumerate(solids):
                # at some values there may be more solids, or others
                each = [row[body][n] if n < len(row.get(body, ())) else solid for row in rows]
                for name in GEOMETRY & solid.keys():
                    samples = [_rounded((one if name in one else solid)[name]) for one in each]
                    if any(value != _rounded(solid[name]) for value in samples):
                        entry = {
                            "slider": k,
                            "at": _rounded(values.tolist()),
                            "body": body,
                            "solid": n,
                        }
                        changes.append(entry | {"field": name, "values": samples})
    return changes


def _rounded(value: float | list[float]) -> float | list[float]:
    """A field of a solid to six digits."""
    if isinstance(value, list):
        return [float(f"{x:.6g}") for x in value]
    return float(f"{value:.6g}")


def _solids(motion: TrajectoryRecord) -> dict[int, list[Solid]]:
    """Solids by the number of their body; -1: the ground."""
    bodies, ground, *_ = solids_of(motion)
    return {-1: ground, **{k: body.solids for k, body in enumerate(bodies)}}


def _solids_at(motion: TrajectoryRecord, name: str, value: float) -> dict[int, list[Solid]]:
    """The same at another value of a parameter; none where that is impossible."""
    assert motion.model is not None
    try:
        return _solids(replace(motion, model=motion.model.with_parameters({name: value})))
    except CardanError:
        return {}


def _reach(drawing: Drawing) -> tuple[list[float], list[float]]:
    """Corners of the box in which bodies move; of their start alone where they go far."""
    start, every = (_box(drawing, rows) for rows in (slice(0, 1), slice(None)))
    far = np.ptp(every, axis=0).max() > 3 * np.ptp(start, axis=0).max()
    low, high = start if far else every
    return low.tolist(), high.tolist()


def _box(drawing: Drawing, rows: slice) -> Array:
    """Corners (2, 3) of the box around what is drawn at some rows."""
    lows, highs = list[Array](), list[Array]()
    if not drawing.bodies:
        # the ground alone
        return np.zeros((2, 3))
    for body in drawing.bodies:
        poses = body.poses[rows]
        for solid in body.solids if all("a" in s for s in body.solids) else ():
            ends = [np.asarray(solid[key], dtype=np.float64) for key in ("a", "b") if key in solid]
            radius = float(
                np.linalg.norm(solid["size"]) / 2 if "size" in solid else solid.get("r", 0.0)
            )
            for end in ends:
                at = poses[:, :3, :3] @ end + poses[:, :3, 3]
                lows.append(at.min(axis=0) - radius)
                highs.append(at.max(axis=0) + radius)
        lows.append(poses[:, :3, 3].min(axis=0))
        highs.append(poses[:, :3, 3].max(axis=0))
    return np.array([np.min(lows, axis=0), np.max(highs, axis=0)])
