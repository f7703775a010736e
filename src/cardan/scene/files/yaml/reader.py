"""Scene file -> Model: section by section, in the order in which names are needed."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from pathlib import Path
from typing import Any

from ....elements.forces import FORCES
from ....elements.joints import JOINTS
from ....errors import ModelError, near
from ....version import SCENE
from ...checks import triple
from ...dh import add_dh
from ...frame import Frame
from ...scene import SceneRecord
from ..document import content
from ..meshes import Meshes
from ..options import Options
from . import keys, tables
from .item import Item
from .scope import FIXED, MOVING
from .superelements import Superelements
from .tree import FIRST_LINE, decoded, parse, renamed
from .values import Values

MOST_BODIES = 100_000


def read(path: Path, options: Options) -> SceneRecord:
    """The model of a scene file, see :func:`cardan.load`."""
    if options.base != "fixed" or options.mimic != "couple":
        raise ModelError(
            f"file '{path.name}': base= and mimic= are for robots; a scene says it in its joints"
        )
    try:
        here = path.resolve()
    except (OSError, RuntimeError) as problem:
        raise ModelError(
            f"file '{path.name}' cannot be read: its links go in a circle"
        ) from problem
    if here in options.parents:
        circle = " -> ".join(p.name for p in (*options.parents, here))
        raise ModelError(f"file '{path.name}' includes itself: {circle}; break the circle")
    inner = dataclasses.replace(options, parents=(*options.parents, here))
    return from_text(decoded(content(path), path.name), inner, path.name, path.parent)


def from_text(
    text: str, options: Options | None = None, name: str = "text", folder: Path | None = None
) -> SceneRecord:
    """The model of a scene.

    Args:
        text: The document.
        options: How to read it.
        name: Of the file, for messages; the model is called by its stem unless it says.
        folder: Of the file; what it refers to lies below.

    Raises:
        ModelError, TopologyError: no scene, or one of its items is at fault; with file, line and
            column.
    """
    return _Reader(Item(parse(text, name), "", name), options or Options(), folder).model


class _Reader:
    """One reading. ``model`` is complete when this is made."""

    def __init__(self, root: Item, options: Options, folder: Path | None) -> None:
        self.options = options
        root, version = self._today(root)
        sections = self._sections(root)
        title = sections["name"].text() if "name" in sections else Path(root.file).stem
        with sections.get("name", root).at_item():
            self.model = SceneRecord(title)
        self.meshes = Meshes(options.packages, folder)
        self.values = Values(self.model, self.meshes, options.snap, version)
        self.waiting: list[tuple[str, Item]] = []
        self.names: list[str] = []
        self.flexible = Superelements(self.values, options)
        for section, scope in _ORDER.items():
            self.values.scope = scope
            if section in sections:
                getattr(self, f"_{section}")(sections[section])
            if section in ("include", "superelements", "beams", "cables"):
                self._late_places(last=section == "cables")
        self.model.notes += self.meshes.notes()

    def _sections(self, root: Item) -> dict[str, Item]:
        """The keys of the document.

        Raises:
            ModelError: an unknown key.
        """
        return root.fields(keys.TOP, "a scene")

    @staticmethod
    def _today(root: Item) -> tuple[Item, int]:
        """The document under the names that keys have today, and the version of its format.

        Raises:
            ModelError: no mapping, no version, or one that is not read.
        """
        version = root.items(f"a scene, '{FIRST_LINE}' and more keys,").get("cardan")
        if version is None:
            raise root.error(f"the key 'cardan' is missing; a scene begins with '{FIRST_LINE}'")
        number = version.number()
        if not isinstance(number, int):
            raise version.error(f"version {version.description()} is not read; say '{FIRST_LINE}'")
        if not SCENE.reads(number):
            raise version.error(SCENE.refusal("the scene", number, ""))
        return dataclasses.replace(root, node=renamed(root.node, (), number)), number

    def _each(self, section: Item, kind: str, read: Callable[[str, Item], None]) -> None:
        """Read the items of a section and remember where they stand."""
        for name, item in section.items().items():
            read(name, item)
            self.model.origins[kind, name] = item.spot

    # what expressions are made of

    def _parameters(self, section: Item) -> None:
        self._each(section, "parameter", self._parameter)

    def _parameter(self, name: str, item: Item) -> None:
        values = self._short(item, "value", keys.PARAMETER, "a parameter")
        with item.at_item(named=True):
            self.model.parameter(name, values["value"], values.get("unit"))

    def _inputs(self, section: Item) -> None:
        self._each(section, "input", self._input)

    def _input(self, name: str, item: Item) -> None:
        values = {} if item.is_null else self._short(item, "default", keys.INPUT, "an input")
        with item.at_item(named=True):
            self.model.input(name, values.get("default", 0.0), values.get("unit"))

    def _short(
        self, item: Item, key: str, key_table: tuple[keys.Key, ...], what: str
    ) -> dict[str, Any]:
        """A mapping, or a bare value that stands for the key of that name."""
        if item.is_text:
            entry = next(entry for entry in key_table if entry.name == key)
            return {key: self.values.read(entry, item)}
        return self.values.record(key_table, item, what)

    def _gravity(self, item: Item) -> None:
        self.model.gravity = triple(self.values.vector(item), "gravity")

    def _tables(self, section: Item) -> None:
        for name, item in section.items().items():
            if name in self.model.parameters or name in self.model.inputs:
                raise item.at_key("the name is taken by a parameter or an input")
            self.values.tables[name] = tables.table(self.values, item)

    # bodies and frames

    def _bodies(self, section: Item) -> None:
        self._each(section, "body", self._body)

    def _body(self, name: str, item: Item) -> None:
        values = self.values.record(keys.BODY, item, "a body")
        pose, base = values.pop("pose", (None, None))
        with item.at_item():
            body = self.model.body(name, pose=pose, **values)
            if base is not None:
                home = self.model.place(f"body '{name}'", base, "base").body
                self.model.bodies[name] = dataclasses.replace(body, base=home)

    def _dh(self, section: Item) -> None:
        self._each(section, "dh", self._chain)

    def _chain(self, name: str, item: Item) -> None:
        values = self.values.record(keys.DH, item, "a table")
        with item.at_item():
            add_dh(self.model, prefix=f"{name}.", snap=self.options.snap, **values)

    def _frames(self, section: Item) -> None:
        """Frames on the bodies that are known by now; the others wait for bodies and nodes."""
        self.waiting = list(section.items().items())
        self.names = [name for name, _ in self.waiting]
        self._late_frames(last=False)

    def _late_places(self, last: bool) -> None:
        """Frames and superelements whose places are known by now; they may wait for each other."""
        self._late_frames(last=False)
        while self.flexible.add_ready():
            self._late_frames(last=False)
        if last:
            self._late_frames(last=True)
            self.flexible.add_ready(last=True)
            # in the order of the file, too
            frames = self.model.frames
            frames.update({name: frames.pop(name) for name in self.names if name in frames})

    def _late_frames(self, last: bool) -> None:
        """Frames whose body is known by now; all that are left where no more bodies come."""
        waiting, self.waiting = self.waiting, []
        for name, item in waiting:
            body = item.items("a frame such as {body: ...}").get("body")
            if last or (body is not None and body.is_text and self.values.has_place(body)):
                self._frame(name, item)
            else:
                self.waiting.append((name, item))

    def _frame(self, name: str, item: Item) -> None:
        frame = self.values.frame(item, name)
        body, _, count = name.rpartition(".at")
        if isinstance(frame, Frame) and body == frame.body.name and count.isdigit():
            # a made name, such as those of Body.at: it names no place of the system
            self.model.frames[name] = dataclasses.replace(frame, named=False)
        self.model.origins["frame", name] = item.spot

    def _include(self, section: Item) -> None:
        self._each(section, "include", self._subsystem)

    def _subsystem(self, name: str, item: Item) -> None:
        values = self.values.record(keys.INCLUDE, item, "an included file")
        where = item.items()["file"]
        how = {key: values[key] for key in ("base", "mimic") if key in values}
        with where.at_item():
            path = self.meshes.locate(values["file"], where.path, "file")
            if path is None or self.options.load is None:
                raise ModelError(
                    f"{where.path}: there is no file '{values['file'][:80]}' below the folder of "
                    "the scene; packages= names other folders"
                )
            other = self.options.load(path, dataclasses.replace(self.options, **how))
            other.values.update(values.get("parameters", {}))
        with item.at_item():
            self.model.include(other, values.get("prefix", name), values.get("at"))
            if len(self.model.bodies) > MOST_BODIES:
                raise ModelError(f"more than {MOST_BODIES} bodies; make the scene smaller")

    # flexible bodies

    def _superelements(self, section: Item) -> None:
        self.flexible.enter(section)

    def _beams(self, section: Item) -> None:
        for name, item in section.items().items():
            self._beam(name, item)
            # the next beam may begin at a frame on a node of this one
            self._late_places(last=False)

    def _beam(self, name: str, item: Item) -> None:
        self.model.origins["beam", name] = item.spot
        values = self.values.record(keys.BEAM, item, "a beam")
        nodes = values.pop("nodes", {})
        with item.at_item():
            beam = self.model.beam(name, **values)
            for node, s in nodes.items():
                beam.at(s, name=node)

    def _cables(self, section: Item) -> None:
        self._each(section, "cable", self._cable)

    def _cable(self, name: str, item: Item) -> None:
        values = self.values.record(keys.CABLE, item, "a cable")
        with item.at_item():
            self.model.cable(name, **values)

    # joints, forces, outputs

    def _joints(self, section: Item) -> None:
        self._each(section, "joint", self._joint)
        for name, item in section.items().items():
            couple = self.model.joints[name].couple
            if couple is not None and couple.leader not in self.model.joints:
                listed = near(couple.leader, self.model.joints).replace(" Known:", " Joints:")
                said = "couple" if "couple" in item.items() else "leader"
                raise item.items()[said].error(f"'{couple.leader}' is not a joint.{listed}")

    def _joint(self, name: str, item: Item) -> None:
        kind = self._type(item, JOINTS, "joint")
        self.values.local = ()
        arguments = self.values.record(keys.of_joint(kind), item, f"a {kind} joint")
        element_values = {key.name: arguments.pop(key.name) for key in keys.of_element(JOINTS[kind])
               if key.name in arguments}  # fmt: skip
        base, friction = arguments.pop("base", None), arguments.pop("friction", 0.0)
        del arguments["type"]
        with item.at_item(named=True):
            element = JOINTS[kind](**element_values)
        with item.at_item():
            joint = self.model.joint(name, element, **arguments)
            home = None
            if base is not None:
                home = self.model.place(f"joint '{name}'", base, "base").body
            if home is not None or friction:
                joint = dataclasses.replace(joint, base=home, friction=float(friction))
                self.model.joints[name] = joint

    def _forces(self, section: Item) -> None:
        self._each(section, "force", self._force)

    def _force(self, name: str, item: Item) -> None:
        kind = self._type(item, FORCES, "force")
        arguments = self.values.record(keys.of_force(kind), item, f"a {kind}")
        del arguments["type"]
        with item.at_item(named=True):
            element = FORCES[kind](**arguments)
        joint_kinds = self.model.joint_kinds() if element.joints() else {}
        for role, joint in element.joints().items():
            if joint not in joint_kinds:
                listed = near(joint, joint_kinds).replace(" Known:", " Joints:")
                raise item.items()[role].error(f"there is no joint '{joint[:80]}'.{listed}")
        with item.at_item():
            self.model.force(name, element)

    def _type(self, item: Item, family: dict[str, Any], what: str) -> str:
        """The member of a family that an item is.

        Raises:
            ModelError: no type, or one that does not exist.
        """
        word = item.items(f"a {what} such as {{type: {next(iter(family))}}}").get("type")
        if word is None:
            raise item.error(f"a {what} needs the key 'type'." + near("", family))
        if word.text() not in family:
            listed = near(word.text(), family).replace(" Known:", " Types:")
            raise word.error(f"there is no {what} '{word.text()[:80]}'.{listed}")
        return word.text()

    def _constraints(self, section: Item) -> None:
        self._each(section, "constraint", self._constraint)

    def _constraint(self, name: str, item: Item) -> None:
        values = self._short(item, "expression", keys.OUTPUT, "a constraint")
        with item.at_item():
            self.model.constraint(name, values["expression"], values.get("unit", ""))

    def _outputs(self, section: Item) -> None:
        self._each(section, "output", self._output)

    def _output(self, name: str, item: Item) -> None:
        values = self._short(item, "expression", keys.OUTPUT, "an output")
        with item.at_item():
            self.model.output(name, values["expression"], values.get("unit", ""))

    # what the reader of the model must know

    def _values(self, item: Item) -> None:
        self.model.values.update(self.values.reals(item))

    def _simulate(self, item: Item) -> None:
        settings = self.values.record(keys.SIMULATE, item, "simulate")
        model = self.model
        joints = [*model.joint_kinds(), *model.superelements]
        joints += [*model.bodies, *model.nodes] if model.nodes else []
        for block in ("q", "u"):
            for name, entry in item.items()[block].items().items() if block in settings else ():
                if not any(name == j or name.startswith(f"{j}.") for j in joints):
                    listed = near(name, joints).replace(" Known:", " Joints:")
                    raise entry.at_key(f"'{name[:80]}' is not a joint.{listed}")
        if "time" in settings:
            settings = {"t": settings.pop("time")} | settings
        self.model.settings.update(settings)

    def _notes(self, item: Item) -> None:
        self.model.notes += self.values.texts(item)

    def _snaps(self, item: Item) -> None:
        self.model.snaps += self.values.texts(item)


# sections in the order in which they are read, and what their expressions may speak of
_ORDER = {
    "notes": FIXED,
    "snaps": FIXED,
    "parameters": FIXED,
    "inputs": FIXED,
    "tables": FIXED,
    "gravity": FIXED,
    "bodies": FIXED,
    "dh": FIXED,
    "frames": FIXED,
    "include": FIXED,
    "superelements": FIXED,
    "beams": FIXED,
    "cables": FIXED,
    "joints": FIXED,
    "constraints": MOVING,
    "forces": MOVING,
    "outputs": MOVING,
    "values": FIXED,
    "simulate": FIXED,
}
