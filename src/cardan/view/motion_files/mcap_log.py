"""MCAP logs: poses of bodies as transforms, and all histories as JSON, message by message.

Foxglove draws ``/tf`` (frames below ``ground``) and plots ``/coordinates.elbow``; PlotJuggler reads
the same names.

Source: Foxglove, MCAP Format Specification, version 0; Foxglove schemas FrameTransforms and Log.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ...arrays import Array
from ...errors import CardanError
from ...runtime.formats.contents import for_json
from ...runtime.trajectory.dataset import HistoryTable, tables
from ...runtime.trajectory.trajectory import TrajectoryRecord
from ...version import VERSION
from ..packing import turns
from ..solids import poses_of_bodies
from .motion_format import MotionFormat

if TYPE_CHECKING:
    from mcap.writer import Writer

NANO = 10**9
INFO = 2  # level of a line of a log
GROUND = "ground"
Schema = Mapping[str, object]


def _object(**properties: Schema) -> Schema:
    return {"type": "object", "properties": properties}


NUMBER, TEXT, COUNT = {"type": "number"}, {"type": "string"}, {"type": "integer", "minimum": 0}
TIME = _object(sec=COUNT, nsec=COUNT)
TRANSFORM = _object(
    timestamp=TIME,
    parent_frame_id=TEXT,
    child_frame_id=TEXT,
    translation=_object(x=NUMBER, y=NUMBER, z=NUMBER),
    rotation=_object(x=NUMBER, y=NUMBER, z=NUMBER, w=NUMBER),
)
SCHEMAS = {
    "foxglove.FrameTransforms": _object(transforms={"type": "array", "items": TRANSFORM}),
    "foxglove.Log": _object(
        timestamp=TIME, level=COUNT, message=TEXT, name=TEXT, file=TEXT, line=COUNT
    ),
}


def _written(motion: TrajectoryRecord, path: Path) -> None:
    from mcap.writer import Writer

    with path.open("wb") as stream:
        writer = Writer(stream)
        writer.start(profile="", library=f"cardan {VERSION}")
        _Log(motion, writer).write()
        writer.finish()


class _Log:
    """One writing."""

    def __init__(self, motion: TrajectoryRecord, writer: Writer) -> None:
        self.motion, self.writer = motion, writer
        self.start = min(0.0, float(motion.t.min()))
        self.times = [self._nanoseconds(t) for t in motion.t.tolist()]

    def _nanoseconds(self, t: float) -> int:
        """Time of a message: none is negative."""
        return round((t - self.start) * NANO)

    def write(self) -> None:
        """All topics, one after the other: readers sort by time."""
        manifest = self.motion.manifest
        about = {"model": manifest.name, "status": self.motion.status, "start": repr(self.start)}
        self.writer.add_metadata("cardan", about)
        self._transforms()
        for table in (*tables(self.motion), *_energies(self.motion)):
            self._histories(table)
        self._events()

    def _channel(self, topic: str, name: str, schema: Schema) -> int:
        text = json.dumps({"title": name, **schema}).encode()
        number = self.writer.register_schema(name=name, encoding="jsonschema", data=text)
        channel: int = self.writer.register_channel(
            topic=topic, message_encoding="json", schema_id=number
        )
        return channel

    def _say(self, channel: int, at: int, message: object) -> None:
        text = json.dumps(message, allow_nan=False).encode()
        self.writer.add_message(channel, log_time=at, data=text, publish_time=at)

    # topics

    def _transforms(self) -> None:
        """Where frames stand: those of bodies against the ground, others on their bodies once."""
        name = "foxglove.FrameTransforms"
        moving = self._channel("/tf", name, SCHEMAS[name])
        places = {frame: _place(poses) for frame, poses in _moving(self.motion).items()}
        for k, at in enumerate(self.times):
            rows = [_transform(at, GROUND, frame, place[k]) for frame, place in places.items()]
            self._say(moving, at, {"transforms": rows})
        fixed = [
            _transform(self.times[0], body, frame, _place(pose[None])[0])
            for body, frame, pose in _fixed(self.motion)
        ]
        if fixed:
            channel = self._channel("/tf_static", name, SCHEMAS[name])
            self._say(channel, self.times[0], {"transforms": fixed})

    def _histories(self, table: HistoryTable) -> None:
        """Numbers by name at every time; null where there is none."""
        properties = {
            name: {"type": ["number", "null"]} | ({"description": unit} if unit else {})
            for name, unit in zip(table.names, table.units, strict=True)
        }
        schema = {"type": "object", "properties": properties}
        channel = self._channel(f"/{table.name}", f"cardan.{table.name}", schema)
        for at, row in zip(self.times, for_json(table.values).tolist(), strict=True):
            self._say(channel, at, dict(zip(table.names, row, strict=True)))

    def _events(self) -> None:
        """Events, as lines of a log."""
        if not self.motion.events:
            return
        channel = self._channel("/events", "foxglove.Log", SCHEMAS["foxglove.Log"])
        for event in self.motion.events:
            at = self._nanoseconds(event.t)
            line = {"timestamp": _stamp(at), "level": INFO, "name": event.element or event.name}
            more = {"message": f"{event.name} ({event.kind})", "file": "", "line": 0}
            self._say(channel, at, line | more)


def _energies(motion: TrajectoryRecord) -> Iterator[HistoryTable]:
    """Energies, where the model knows them."""
    try:
        energy = motion.energy
    except CardanError:
        return
    yield HistoryTable("energy", energy._fields, ("J",) * 3, np.stack(energy, axis=1))


def _moving(motion: TrajectoryRecord) -> dict[str, Array]:
    """Poses (nt, 4, 4) by name: of bodies, of nodes, and of the sections of beams."""
    manifest = motion.manifest
    if not manifest.absolute:
        return poses_of_bodies(motion)
    poses = {row.name: motion.pose(row.name) for row in manifest.frames if row.body != GROUND}
    for beam in manifest.beams:
        sections = motion.sections(beam.name)
        poses |= {f"{beam.name}.section{k}": sections[:, k] for k in range(sections.shape[1])}
    return poses


def _fixed(motion: TrajectoryRecord) -> Iterator[tuple[str, str, Array]]:
    """Body, frame and pose (4, 4) there of every frame that has its place on a body."""
    for row in motion.manifest.frames:
        if row.name in (row.body, GROUND):
            continue
        if not motion.manifest.absolute:
            yield row.body, row.name, motion.frame_on_body(row.name)
        elif row.body == GROUND:
            yield GROUND, row.name, motion.pose(row.name)[0]


def _place(poses: Array) -> list[list[float]]:
    """Positions and quaternions x, y, z, w, of transforms (nt, 4, 4)."""
    table: list[list[float]] = np.hstack([poses[:, :3, 3], turns(poses[:, :3, :3])]).tolist()
    return table


def _transform(at: int, parent: str, child: str, place: list[float]) -> dict[str, object]:
    return {
        "timestamp": _stamp(at),
        "parent_frame_id": parent,
        "child_frame_id": child,
        "translation": dict(zip("xyz", place[:3], strict=True)),
        "rotation": dict(zip("xyzw", place[3:], strict=True)),
    }


def _stamp(at: int) -> dict[str, int]:
    return {"sec": at // NANO, "nsec": at % NANO}


MCAP = MotionFormat("MCAP", (".mcap",), _written, packages=("mcap",), extra="mcap")
