"""The data of the 3-D page: names as JSON, numbers packed into one block."""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence

import numpy as np

from ..arrays import Array, Integers
from ..errors import ModelError
from . import meshes
from .beams import STRAIN, DrawnBeam
from .drawing import Drawing
from .mesh_parts import MeshParts
from .packing import JsonObject, Packer, step_of, turns
from .solids import Solid, short
from .surfaces import DISPLACEMENT, DrawnSurface

# steps of lengths, turns and curves against the size of what is shown
FINE, TURN, CURVE, STILL = 1e-5, 1e-5, 1e-4, 1e-9
DEFORMED = 1e-5  # of shapes of surfaces and their amplitudes, which may cancel each other
ROUND = 24  # corners of a round section


def parts(drawing: Drawing, detail: str | float) -> tuple[str, str]:
    """JSON and block of a page.

    Args:
        drawing: What it shows.
        detail: As ``meshes=`` of :func:`.page.animate`.
    """
    pack = Packer()
    size = size_of(drawing)
    solids = _Solids(pack, drawing, detail)
    t = drawing.abscissa.values
    span = float(np.ptp(t)) or 1.0
    poses = np.stack([body.poses for body in drawing.bodies], axis=1) if drawing.bodies else None
    data = {
        "name": drawing.name,
        "abscissa": {"name": drawing.abscissa.name, "unit": drawing.abscissa.unit},
        "t": pack.add(t - t[0], span * 1e-8) | {"first": float(t[0])},
        "bodies": [
            {"name": b.name, "solids": solids.of(b.solids, b.fallback)} for b in drawing.bodies
        ],
        "poses": None if poses is None else _places(pack, poses, size),
        "ground": solids.of(drawing.ground, []),
        "beams": [_beam(pack, beam, size) for beam in drawing.beams],
        "surfaces": [_surface(pack, one, size) for one in drawing.surfaces],
        "supports": [
            {
                "kind": one.kind,
                "at": short(one.at),
                "axis": one.axis.tolist(),
                "r": one.radius,
                "travel": one.travel,
            }
            for one in drawing.supports
        ],
        "scale": _scale(drawing.beams, drawing.surfaces),
        "springs": [
            {
                "name": s.name,
                "coil": s.coil,
                "damper": s.damper,
                "ends": pack.add(np.concatenate(s.ends, axis=1), FINE * size),
            }
            for s in drawing.springs
        ],
        "arrows": [
            {
                "name": a.name,
                "layer": a.layer,
                "at": pack.add(a.at, FINE * size),
                "vector": pack.add(a.vector, CURVE * _most(a.vector)),
            }
            for a in drawing.arrows
        ],
        "traces": [
            {"name": name, "at": pack.add(path, FINE * size)}
            for name, path in drawing.traces.items()
        ],
        "histories": [
            {"name": group.name, "unit": group.unit, "curves": _curves(pack, group.curves)}
            for group in drawing.histories
        ],
        "events": [{"t": at, "name": name} for at, name in drawing.events],
        "up": drawing.up.tolist(),
        "normal": None if drawing.normal is None else drawing.normal.tolist(),
        "floor": drawing.floor,
        "rate": drawing.rate,
        "follow": drawing.follow,
        "layers": list(drawing.layers),
    }
    solids.complain()
    return json.dumps(data, separators=(",", ":"), allow_nan=False), pack.text()


def _curves(pack: Packer, curves: Sequence[tuple[str, Array]]) -> list[JsonObject]:
    """Curves of one axis, in steps of what it spans; ``gaps`` are rows without a number."""
    finite = [y[np.isfinite(y)] for _, y in curves]
    every = np.concatenate([*finite, np.zeros(0)])
    # rounding in the last digits is no history
    step = max(CURVE * float(np.ptp(every)), STILL * _most(every)) if every.size else 1.0
    entries: list[JsonObject] = []
    for (name, y), there in zip(curves, finite, strict=True):
        gaps = np.flatnonzero(~np.isfinite(y))
        filled = np.where(np.isfinite(y), y, there[0] if there.size else 0.0)
        entry = {"name": name, "y": pack.add(filled, step)}
        entries.append(entry | ({"gaps": gaps.tolist()} if gaps.size else {}))
    return entries


def _most(values: Array) -> float:
    return float(np.abs(values).max(initial=0.0)) or 1.0


def size_of(drawing: Drawing) -> float:
    """Extent of what is shown at the start [m]."""
    points = [body.poses[0, :3, 3] for body in drawing.bodies]
    points += [p for beam in drawing.beams for p in beam.sections[0, :, :3, 3]]
    points += [p for one in drawing.surfaces for p in (one.points.min(0), one.points.max(0))]
    extents = [float(np.ptp(points, axis=0).max())] if points else []
    for solid in [s for body in drawing.bodies for s in body.solids]:
        numbers = [*solid.get("size", ()), solid.get("r", 0.0), *solid.get("a", ())]
        extents.append(float(np.abs(numbers).max(initial=0.0)))
    return max((x for x in extents if np.isfinite(x)), default=0.0) or 1.0


def _places(pack: Packer, poses: Array, size: float) -> JsonObject:
    """Positions and quaternions (nt, n, 7) of transforms (nt, n, 4, 4)."""
    if not np.isfinite(poses).all():
        raise ModelError("a page shows bodies at finite places; some are not")
    # one array of whole numbers: quaternions are stretched to the steps of the lengths, which are
    # larger than is wanted where bodies go far
    rows, at = len(poses), poses[..., :3, 3]
    step = step_of(FINE * size, float(np.abs(at - at[0]).max(initial=0.0)))
    table = np.concatenate([poses[..., :3, 3], turns(poses[..., :3, :3]) * (step / TURN)], axis=-1)
    return pack.add(table.reshape(rows, -1), step) | {"stretch": step / TURN}


def _beam(pack: Packer, beam: DrawnBeam, size: float) -> JsonObject:
    """A beam as the page draws it."""
    y, z = beam.half_widths
    outline: list[tuple[float, float]] = [(y, z), (-y, z), (-y, -z), (y, -z)]
    if beam.is_round:
        around = 2 * np.pi * np.arange(ROUND) / ROUND
        outline = [(y * c, z * s) for c, s in zip(np.cos(around), np.sin(around), strict=True)]
    elif beam.contour:
        outline = list(beam.contour)
    values = beam.values
    return {
        "name": beam.name,
        "count": beam.sections.shape[1],
        "outline": [[float(f"{x:.5g}") for x in point] for point in outline],
        "round": beam.is_round,
        "places": _places(pack, beam.sections, size),
        "values": None if values is None else pack.add(values, 0.002 * _most(values)),
    }


def _surface(pack: Packer, one: DrawnSurface, size: float) -> JsonObject:
    """A surface as the page draws it: it adds the shapes itself."""
    # amplitudes of several units in parts of their largest values, all to the same digits
    largest = np.abs(one.amplitudes).max(axis=0, initial=0.0)
    sizes = np.where(largest > 0, largest, 1.0)
    shapes, stresses = (x * sizes[:, None, None] for x in (one.shapes, one.stresses))
    count = len(one.shapes)

    def places(rows: Integers) -> JsonObject | None:
        return pack.add(rows, 1.0, orders=1) if len(rows) else None

    return {
        "name": one.name,
        "points": pack.add(one.points, FINE * size, orders=1),
        "triangles": places(one.triangles),
        "lines": places(one.lines),
        "outline": places(one.outline),
        "places": None if one.poses is None else _places(pack, one.poses[:, None], size),
        # small ones are colored too
        "shapes": pack.add(shapes.reshape(count, -1), DEFORMED * _most(shapes), orders=0),
        "amplitudes": pack.add(one.amplitudes / sizes, DEFORMED),
        "kind": one.kind,
        "stressed": places(one.stressed),
        "stresses": pack.add(stresses.reshape(count, -1), DEFORMED * _most(stresses), orders=0)
        if one.stresses.size
        else None,
    }


# units of what is colored, the largest that leaves a number above 1
UNITS = {
    "stress": {"GPa": 1e9, "MPa": 1e6, "kPa": 1e3, "Pa": 1.0},
    "strain": {"1": 1.0},
    DISPLACEMENT: {"m": 1.0, "mm": 1e-3, "um": 1e-6},
}


def _scale(beams: Iterable[DrawnBeam], surfaces: Iterable[DrawnSurface]) -> JsonObject | None:
    """Legend of the colors of beams and surfaces; None where nothing is colored."""
    colored = [
        (beam.colored_by, "strain" if beam.colored_by == STRAIN else "stress", _most(beam.values))
        for beam in beams
        if beam.values is not None
    ]
    colored += [(one.colored_by, one.kind, one.largest) for one in surfaces if one.kind]
    if not colored:
        return None
    kinds = [kind for _, kind, _ in colored]
    kind = next((one for one in ("strain", "stress") if one in kinds), kinds[0])
    most = max(value for _, _, value in colored)
    units = UNITS[kind]
    unit = next((name for name, size in units.items() if most >= size), [*units][-1])
    return {
        "name": colored[0][0],
        "kind": kind,
        "unit": unit,
        "most": most,
        "shown": most / units[unit],
    }


class _Solids:
    """Solids of a page; meshes are packed, each file once."""

    def __init__(self, pack: Packer, drawing: Drawing, detail: str | float) -> None:
        self._pack = pack
        self._packed: dict[str, list[JsonObject]] = {}
        every = [s for body in drawing.bodies for s in body.solids] + drawing.ground
        self._meshes = MeshParts(every, detail)

    def of(self, solids: list[Solid], fallback: list[Solid]) -> list[JsonObject]:
        """Solids as the page draws them, ``fallback`` where not one can be."""
        drawn: list[JsonObject] = []
        for solid in solids:
            if solid["kind"] != "mesh":
                drawn.append(solid)
                continue
            for entry in self._mesh(str(solid["file"])):
                color = entry["color"] if solid["color"] is None else solid["color"]
                drawn.append({**entry, **_scaled(entry, solid), "color": color})
        return drawn or fallback

    def _mesh(self, file: str) -> list[JsonObject]:
        if file not in self._packed:
            entries: list[JsonObject] = []
            for part in self._meshes.of(file):
                small = meshes.encoded(part)
                entries.append(
                    {
                        "kind": "mesh",
                        "positions": self._pack.add(small.positions, 1.0, orders=1),
                        "triangles": self._pack.add(small.triangles, 1.0, orders=1),
                        "low": small.low,
                        "unit": small.size / meshes.STEPS,
                        "color": small.color,
                    }
                )
            self._packed[file] = entries
        return self._packed[file]

    def complain(self) -> None:
        """Warn of meshes that are not shown."""
        self._meshes.complain()


def _scaled(entry: JsonObject, solid: Solid) -> JsonObject:
    """The box of a mesh in the scale of its solid, and where it stands."""
    scale = np.asarray(solid["scale"], dtype=np.float64)
    box = {name: [float(f"{x:.6g}") for x in entry[name] * scale] for name in ("low", "unit")}
    return {**box, "R": solid["R"], "a": solid["a"]}
