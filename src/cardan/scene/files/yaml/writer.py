"""Model -> scene file."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import fields
from pathlib import Path
from typing import Any

from ....atomic_file import written
from ....elements.validation import AXES
from ....errors import ModelError, lasting
from ....version import SCENE
from ...beam import Beam, Cable, End
from ...beam_arguments import ELEMENT, INERTIA, ROLES
from ...body import INERTIA_ENTRIES, Body
from ...checks import is_number
from ...connections import Couple, Joint
from ...frame import Frame, Place, rows_of
from ...parameters import Constraint, Declared, Output
from ...scene import SceneRecord
from ...shape import Shape
from ...superelement import NODAL, PlacedSuperelement
from ..angles import snapped
from . import keys
from .expression_text import ExpressionText
from .frames import separate_frames
from .layout import Number, dumped
from .superelements import record_files

LIMITS = ("lower", "upper", "speed", "effort")


def write(model: SceneRecord, path: Path, strict: bool = False) -> tuple[str, ...]:
    """Write the scene; records of superelements are written beside it.

    Args:
        model: The scene.
        path: The file.
        strict: Has no effect: what the file cannot say is always refused.

    Returns:
        Nothing that it does not say.

    Raises:
        ModelError: an expression no file can say, or a file that cannot be written.
    """
    records = record_files(model, path.stem)
    text = to_text(model, path.parent, records)
    for name, record in {records[n]: one.record for n, one in model.superelements.items()}.items():
        record.save(path.with_name(name))
    written(path, text)
    return ()


def to_text(model: SceneRecord, folder: Path, records: Mapping[str, str]) -> str:
    """The scene file of a model.

    Args:
        model: The model; included models are written out.
        folder: Where the file will be; meshes below it are named from there.
        records: Files of the records of superelements.

    Raises:
        ModelError: the model has what no file can say.
    """
    for joint in model.joints.values():
        if joint.kind.bodiless:
            raise ModelError(
                f"model '{model.name}' is made of written equations, for which scene files have no "
                "words: keep the program that derives them, or export() what was compiled"
            )
    return dumped(_Writer(model, folder, records).document())


class _Writer:
    """One writing."""

    def __init__(self, model: SceneRecord, folder: Path, records: Mapping[str, str]) -> None:
        self.model = model
        self.folder = folder.resolve()
        self.records = records
        self.expressions = ExpressionText(model)
        self.separate = separate_frames(model)

    def document(self) -> dict[str, Any]:
        """The document: sections that say nothing are left out."""
        model = self.model
        sections: dict[str, Any] = {
            "cardan": Number(str(SCENE.version)),
            "name": model.name,
            "gravity": [self.value(g, "gravity") for g in model.gravity],
            "parameters": {n: self._declared(d, "value") for n, d in model.parameters.items()},
            "inputs": {n: self._declared(d, "default") for n, d in model.inputs.items()},
            "tables": {},
            "bodies": {n: self._body(body) for n, body in model.bodies.items()},
            "frames": {frame.name: self._frame(frame) for frame in self.separate},
            "superelements": {n: self._superelement(one) for n, one in model.superelements.items()},
            "beams": {n: self._beam(beam) for n, beam in model.beams.items()},
            "cables": {n: self._cable(cable) for n, cable in model.cables.items()},
            "joints": {n: self._joint(joint) for n, joint in model.joints.items()},
            "constraints": {n: self._said(c, "constraint") for n, c in model.constraints.items()},
            "forces": {n: self._force(n, f.element) for n, f in model.forces.items()},
            "outputs": {n: self._said(o, "output") for n, o in model.outputs.items()},
            "values": {n: number(value) for n, value in model.values.items()},
            "simulate": self._settings(),
            "notes": lasting(model.notes),
            "snaps": list(model.snaps),
        }
        sections["tables"] = {
            n: self._table(points) for n, points in self.expressions.tables.items()
        }
        return {name: section for name, section in sections.items() if section or name == "name"}

    # values

    def value(self, value: object, where: str) -> Any:
        """A number, an expression or rows of them, as written."""
        value = value.tolist() if hasattr(value, "tolist") else value
        if isinstance(value, (list, tuple)):
            return [self.value(entry, where) for entry in value]
        if is_number(value):
            return number(value)
        if isinstance(value, str):
            return value
        if not hasattr(value, "free_symbols"):
            raise ModelError(f"{where}: {value!r} is neither a number nor an expression")
        return self.expressions.text(value, where)

    def rotation(self, value: object, where: str) -> Any:
        """``[XYZ, a, b, c]`` or 3x3; angles keep what they are when they are read."""
        value = value.as_matrix() if hasattr(value, "as_matrix") else value
        rows = rows_of(value)
        if len(rows) == 4 and isinstance(rows[0], str):
            return [rows[0], *(self._angle(angle, where) for angle in rows[1:])]
        return [self.value(rows_of(row), where) for row in rows]

    def _angle(self, value: Any, where: str) -> Any:
        if not is_number(value):
            return self.value(value, where)
        text = repr(float(value))
        # more digits where few would be taken for a rounded quarter turn
        if snapped(text, float(value)) != value:
            text = f"{float(value):.17f}"
        return Number(text)

    def _declared(self, entry: Declared, key: str) -> Any:
        value = number(entry.value)
        return {key: value, "unit": entry.unit} if entry.stated else value

    def _table(self, points: Any) -> dict[str, Any]:
        x, y = ([number(entry) for entry in column] for column in (points.data.breaks, points.y))
        return {"x": x, "y": y, "kind": points.kind}

    # bodies and frames

    def _body(self, body: Body) -> dict[str, Any]:
        where = f"body '{body.name}'"
        entry: dict[str, Any] = {}
        if not _zero(body.mass):
            entry["mass"] = self.value(body.mass, where)
        if not all(map(_zero, body.com)):
            entry["com"] = self.value(body.com, where)
        if not all(map(_zero, body.inertia)):
            entry["inertia"] = self._inertia(body.inertia, where)
        if body.pose is not None:
            entry["pose"] = self._pose(body, where)
        if body.shapes:
            shapes = [self._shape(shape, where) for shape in body.shapes]
            entry["shape"] = shapes[0] if len(shapes) == 1 else shapes
        return entry

    def _inertia(self, entries: tuple[object, ...], where: str) -> Any:
        """Principal values where there is nothing else, entries by name otherwise."""
        xx, xy, xz, yy, yz, zz = entries
        if all(map(_zero, (xy, xz, yz))):
            return self.value((xx, yy, zz), where)
        named = zip(INERTIA_ENTRIES, entries, strict=True)
        return {name: self.value(entry, where) for name, entry in named if not _zero(entry)}

    def _pose(self, body: Body, where: str) -> dict[str, Any]:
        assert body.pose is not None
        position, rotation = body.pose
        entry = {"position": self.value(position, where)}
        if rotation is not None:
            entry["rotation"] = self.rotation(rotation, where)
        if body.base is not None:
            entry["base"] = body.base.name
        return entry

    def _shape(self, shape: Shape, where: str) -> dict[str, Any]:
        entry = {name: self.value(size, where) for name, size in shape.size}
        if "file" in entry:
            entry["file"] = self._file(entry["file"])
        if not all(map(_zero, shape.position)):
            entry["position"] = self.value(shape.position, where)
        if shape.rotation is not None:
            entry["rotation"] = self.rotation(shape.rotation, where)
        if shape.color is not None:
            entry["color"] = self.value(shape.color, where)
        return {shape.kind: entry}

    def _file(self, file: str) -> str:
        """A mesh below the folder of the scene is named from there."""
        path = Path(file)
        if not path.is_absolute():
            return file
        inside = path.is_relative_to(self.folder)
        return path.relative_to(self.folder).as_posix() if inside else file

    def _frame(self, frame: Frame) -> dict[str, Any]:
        where, entry = f"frame '{frame.name}'", {"body": (frame.base or frame.body).name}
        if not all(map(_zero, frame.coordinates)):
            entry["at"] = self.value(frame.coordinates, where)
        if frame.orientation is not None:
            entry["rotation"] = self.rotation(frame.orientation, where)
        return entry

    def _place(self, place: Place | str | None) -> Any:
        """The name of a body or frame, or the frame itself where it has none."""
        if isinstance(place, Frame) and place not in self.separate:
            return self._frame(place)
        return place if isinstance(place, str) or place is None else place.name

    # beams

    def _beam(self, beam: Beam) -> dict[str, Any]:
        where = f"beam '{beam.name}'"
        keys = self._ends(beam.ends, where)
        keys["section"] = {beam.section.kind: self._element(beam.section, where)}
        material = {
            name: self.value(entry.value, where)
            for name, entry in beam.material.quantities().items()
            if name in ("E", "nu", "G") or not _zero(entry.value)
        }
        keys |= {"material": material} if material else {}
        keys["elements"] = number(beam.elements)
        if beam.up is not None:
            keys["up"] = self._field("direction", beam.up, where)
        if beam.line.quantities():
            keys["line"] = {beam.line.kind: self._element(beam.line, where)}
        keys |= {"element": beam.element} if beam.element != ELEMENT else {}
        keys |= {"inertia": beam.inertia} if beam.inertia != INERTIA else {}
        for role, end in zip(ROLES, beam.ends, strict=True):
            keys |= {f"release_{role}": list(end.released)} if end.released else {}
        if not _zero(beam.temperature):
            keys["temperature"] = self.value(beam.temperature, where)
        if beam.prestrain:
            keys["prestrain"] = {n: self.value(x, where) for n, x in beam.prestrain.items()}
        if beam.stops:
            keys["nodes"] = {name: number(s) for name, s in beam.stops.items()}
        if beam.base is not None:
            keys["base"] = beam.base.name
        return keys

    def _cable(self, cable: Cable) -> dict[str, object]:
        where = f"cable '{cable.name}'"
        keys: dict[str, object] = self._ends(cable.ends, where)
        for name in ("EA", "rhoA", "length", "tension", "damping", "elements"):
            value = getattr(cable, name)
            if value is not None and not _zero(value):
                keys[name] = self.value(value, where)
        if cable.base is not None:
            keys["base"] = cable.base.name
        return keys | ({"compression": True} if cable.compression else {})

    def _superelement(self, one: PlacedSuperelement) -> dict[str, object]:
        keys: dict[str, object] = {"file": self.records[one.name]}
        keys |= {"interfaces": dict(one.joined)} if one.joined else {}
        keys["frame"] = one.frame
        if len({*one.weights}) > 1:
            keys["weights"] = [number(weight) for weight in one.weights]
        keys |= {"stiffening": True} if one.stiffening else {}
        keys |= {"inertia": one.inertia} if one.inertia != NODAL else {}
        where = f"superelement '{one.name}'"
        loads = {name: self.value(factor, where) for name, factor in one.loads.items()}
        return keys | ({"loads": loads} if loads else {})

    def _ends(self, ends: tuple[End, End], where: str) -> dict[str, object]:
        return {
            role: self.value(end.point, where) if end.place is None else self._place(end.place)
            for role, end in zip(ROLES, ends, strict=True)
        }

    # joints, forces, outputs

    def _element(self, element: Any, where: str) -> dict[str, Any]:
        """The fields of a joint, force element, section or line that are not at their defaults."""
        values: dict[str, Any] = {}
        self.expressions.local = tuple(n for q in element.quantities().values() for n in q.local)
        for entry, key in zip(fields(element), keys.of_element(type(element)), strict=True):
            value = getattr(element, entry.name)
            if key.required or not (value is None or value == entry.default):
                values[entry.name] = self._field(key.kind, value, where)
        self.expressions.local = ()
        return values

    def _field(self, kind: str, value: Any, where: str) -> Any:
        if kind == "place":
            return self._place(value)
        if kind == "members":
            names = [self._place(place) for place in value]
            return names[0] if len(names) == 1 else names
        if kind == "flag":
            return bool(value)
        if kind == "curves":
            return {name: self.expressions.table(points) for name, points in value}
        if kind == "direction":
            letters = [name for name, axis in AXES.items() if axis == value]
            return letters[0] if letters else self.value(value, where)
        if kind == "value" and isinstance(value, tuple):
            # one entry stands alone, nine are rows of three
            value = value[0] if len(value) == 1 else value
            value = (value[:3], value[3:6], value[6:]) if _nine(value) else value
        return self.value(value, where)

    def _joint(self, joint: Joint) -> dict[str, Any]:
        where = f"joint '{joint.name}'"
        entry: dict[str, Any] = {"type": joint.kind.kind}
        entry |= self._element(joint.kind, where)
        entry |= {"parent": self._place(joint.parent), "child": self._place(joint.child)}
        if joint.prescribed is not None:
            entry["prescribed"] = self.value(joint.prescribed, where)
        if joint.cut:
            entry["cut"] = True
        for name in ("q0", "u0"):
            values = getattr(joint, name)
            if values is not None:
                entry[name] = self.value(values[0] if len(values) == 1 else values, where)
        limits = zip(LIMITS, joint.limits, strict=True)
        entry["limits"] = {n: number(limit) for n, limit in limits if limit is not None}
        if joint.at is not None:
            entry["at"] = self.value(joint.at, where)
        if joint.base is not None:
            entry["base"] = joint.base.name
        if joint.couple is not None and joint.kind.follows is None:
            entry["couple"] = self._couple(joint.couple, where)
        if joint.friction:
            entry["friction"] = number(joint.friction)
        return {key: value for key, value in entry.items() if key != "limits" or value}

    def _couple(self, couple: Couple, where: str) -> dict[str, Any]:
        entry = {"leader": couple.leader, "ratio": self.value(couple.ratio, where)}
        if not _zero(couple.offset):
            entry["offset"] = self.value(couple.offset, where)
        return entry

    def _force(self, name: str, element: Any) -> dict[str, Any]:
        return {"type": element.kind, **self._element(element, f"force '{name}'")}

    def _said(self, entry: Output | Constraint, what: str) -> Any:
        """An expression, with its unit where it has one."""
        text = self.value(entry.expression, f"{what} '{entry.name}'")
        return {"expression": text, "unit": entry.unit} if entry.unit else text

    def _settings(self) -> dict[str, Any]:
        """Settings in the order of the keys."""
        settings = dict(self.model.settings)
        settings = ({"time": settings.pop("t")} if "t" in settings else {}) | settings
        written_settings: dict[str, Any] = {}
        for key in keys.SIMULATE:
            value = settings.pop(key.name, None)
            if isinstance(value, Mapping):
                written_settings[key.name] = {
                    n: self.value(entry, key.name) for n, entry in value.items()
                }
            elif value is not None:
                written_settings[key.name] = self.value(value, key.name)
        for name in settings:
            raise ModelError(f"settings: '{name}' cannot be said in a scene file")
        return written_settings


def number(value: Any) -> Number:
    """A number with all its digits."""
    if isinstance(value, int):
        return Number(str(int(value)))
    value = float(value)
    if math.isinf(value):
        return Number(".inf" if value > 0 else "-.inf")
    return Number(repr(value))


def _zero(value: object) -> bool:
    """True for a zero that needs no writing; -0.0 is kept."""
    return is_number(value) and value == 0 and math.copysign(1, value) > 0


def _nine(value: object) -> bool:
    return isinstance(value, tuple) and len(value) == 9 and not isinstance(value[0], tuple)
