"""SDF -> Model: links, joints and what they carry."""

from __future__ import annotations

import dataclasses
from dataclasses import field
from pathlib import Path
from typing import TYPE_CHECKING

from ....elements.forces.joint_damper import JointDamper
from ....elements.forces.joint_spring import JointSpring
from ....elements.joints.fixed import Fixed
from ....elements.joints.free import Free
from ....errors import ModelError
from ....records import dataclass
from ....spatial.numbers import Rows, Vector, congruent, product, to_quaternion, transposed
from ...body import Body
from ...scene import SceneRecord
from ..document import place
from ..meshes import Color, Meshes, shapes
from ..options import Options
from ..pose import HERE, Pose, written
from ..robot import Mimics, announce, body_name, frame_at
from ..unread import Unread
from . import components
from .frames import WORLD, Node, Poses, link_of, tree
from .kinds import AXES, SINGLE, AxisData, data_of, kind_of, type_of
from .values import Item, pose_of, swept, swept_rows

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element as XmlElement

    from ..document import Element

ENTRIES = ("xx", "xy", "xz", "yy", "yz", "zz")
# what is read of these elements; what else they contain is named
READ = {
    "link": {"pose", "inertial", "visual"},
    "joint": {"pose", "parent", "child", "axis", "axis2", "screw_thread_pitch", "thread_pitch"},
    "axis": {"xyz", "limit", "dynamics", "mimic", "use_parent_model_frame", "initial_position"},
    "model": {"pose", "static"},
    "world": {"gravity"},
}


@dataclass
class Edge:
    """A joint with the links it joins; None is the ground."""

    node: Node
    kind: str
    parent: Node | None
    child: Node | None


@dataclass
class Reader:
    """One reading."""

    root: XmlElement
    options: Options
    file: str
    folder: Path | None
    bodies: dict[Node, Body] = field(default_factory=dict)
    unread: Unread = field(default_factory=Unread)
    # what does not act -> the joints, or links, that it is said of
    idle: dict[str, list[str]] = field(default_factory=dict)

    def model(self) -> SceneRecord:
        """The model; to be asked once."""
        version = self._version()
        top = tree(self.root, self.file, self._passed)
        name = top.item.raw.get("name") or Path(self.file).stem
        self.scene = SceneRecord(name)
        self.scene.of_robot = True
        self.mimics = Mimics(self.options.mimic == "couple")
        self.meshes = Meshes(self.options.packages, self.folder, "uri")
        self.poses = Poses(lambda item: self._pose(item))
        self.in_model = version < (1, 5)
        if top.kind == WORLD:
            x, y, z = top.item.numbers("gravity", 3, "0 0 -9.81")
            self.scene.gravity = (x, y, z)
        nodes = [top, *top.walk()]
        links = [node for node in nodes if node.kind == "link"]
        if not links:
            raise ModelError(f"file '{self.file}': the model has no links")
        for node in links:
            self._body(node)
        edges = [self._edge(n) for n in nodes if n.kind == "joint" and not n.fixed]
        self.moving = {edge.node.name for edge in edges if edge.kind in SINGLE}
        self._root_joints(nodes, links, edges)
        for edge in edges:
            self._joint(edge)
        for node in nodes:
            if node.kind == "frame":
                self._frame(node)
        self._announce()
        return self.scene

    def _version(self) -> tuple[int, ...]:
        text = self.root.get("version") or ""
        parts = text.split(".")
        if not all(part.isascii() and part.isdigit() and len(part) < 5 for part in parts):
            raise ModelError(f"file '{self.file}': the version of <sdf> is {text[:40]!r}, not 1.7")
        version = tuple(int(part) for part in parts)
        if version[0] != 1:
            raise ModelError(f"file '{self.file}': SDF {text} is not read; versions 1.0 and on are")
        return version

    def _passed(self, raw: XmlElement, inside: str) -> None:
        if raw.tag not in READ.get(inside, ()) and isinstance(raw.tag, str):
            self.unread.element(raw, inside)

    def _look(self, item: Item, kind: str) -> None:
        """Name what of an element is not read."""
        for raw in item.raw:
            self._passed(raw, kind)

    def _pose(self, item: Item) -> Pose:
        return pose_of(item, self.options.snap, self.scene.snaps)

    # links

    def _body(self, node: Node) -> None:
        item = node.item
        self._look(item, "link")
        if not item.flag("gravity", True):
            self.idle.setdefault("links {}: <gravity>false</gravity> does not act", []).append(
                node.name
            )
        mass, com, tensor = self._inertial(node)
        drawn = shapes(item, self.meshes, _origin, _color)
        body = self.scene.body(body_name(node.name), mass, com, tensor, None, drawn)
        self.scene.origins["body", body.name] = place(item.raw, self.file)
        self.bodies[node] = body

    def _inertial(self, node: Node) -> tuple[float, Vector, dict[str, float]]:
        """Mass, center of mass and inertia; where they are missing those that SDF assumes."""
        inertial = node.item.child("inertial")
        if inertial is not None and inertial.flag("auto"):
            raise ModelError(
                f"{node.item.where}: <inertial auto='true'> is not read; give mass and inertia"
            )
        missing = inertial is None or inertial.child("inertia") is None
        if missing or (inertial is not None and inertial.word("mass") is None):
            what = "links {}: mass or inertia are missing and 1 kg, 1 kg m^2, as SDF has it"
            self.idle.setdefault(what, []).append(node.name)
        if inertial is None:
            return 1.0, (0.0, 0.0, 0.0), {"xx": 1.0, "yy": 1.0, "zz": 1.0}
        who = f"{node.item.where} inertial"
        pose = pose_of(inertial, self.options.snap, self.scene.snaps, who)
        inertia = inertial.child("inertia")
        entries = {key: 1.0 if key[0] == key[1] else 0.0 for key in ENTRIES}
        if inertia is not None:
            entries = {key: inertia.number(f"i{key}", str(entries[key])) for key in ENTRIES}
        xx, xy, xz, yy, yz, zz = (entries[key] for key in ENTRIES)
        rows = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
        if pose.rotation != HERE.rotation:
            rows = congruent(pose.rotation, rows)
        tensor = [rows[i][j] for i in range(3) for j in range(i, 3)]
        return inertial.number("mass", "1"), pose.position, dict(zip(ENTRIES, tensor, strict=True))

    # joints

    def _edge(self, node: Node) -> Edge:
        self._look(node.item, "joint")
        kind = type_of(node.item)
        for tag in ("axis", "axis2"):
            axis = node.item.child(tag)
            if axis is not None:
                self._look(axis, "axis")
        ends: list[Node | None] = []
        for role in ("parent", "child"):
            name, model = node.item.text(role), node.model
            assert model is not None
            outside = name == WORLD and WORLD not in model.members
            frame = None if outside else model.find(name, role, node.item.where)
            ends.append(None if frame is None else link_of(frame))
        if ends[0] is ends[1]:
            raise ModelError(f"{node.item.where}: it joins a link to itself")
        return Edge(node, kind, ends[0], ends[1])

    def _root_joints(self, nodes: list[Node], links: list[Node], edges: list[Edge]) -> None:
        """Fix the models to the ground, or let them float."""
        scene, free = self.scene, self.options.base == "free"
        pairs = [(edge.parent, edge.child) for edge in edges]
        roots = components.roots(nodes, links, pairs)
        taken = {edge.node.name for edge in edges}
        for node in roots:
            name = "base" if len(roots) == 1 else f"{node.name}.base"
            while name in taken:
                name += "_"
            taken.add(name)
            pose, body = swept(self.poses.of(node)), self.bodies[node]
            if free and not node.fixed:
                # its coordinates say where the link is on the ground
                q0 = (*to_quaternion(pose.rotation), *pose.position)
                scene.joint(name, Free(), scene.ground, body, q0=q0)
            else:
                scene.joint(name, Fixed(), frame_at(scene.ground, pose), body)
        if free and not any(not node.fixed for node in roots):
            scene.notes.append("base='free' changes nothing: joints of the file hold all to world")

    def _joint(self, edge: Edge) -> None:
        """Make a joint: its frames coincide in the configuration of the file."""
        node, scene, item = edge.node, self.scene, edge.node.item
        world = self.poses.of(node)
        ends = []
        for link in (edge.parent, edge.child):
            body = scene.ground if link is None else self.bodies[link]
            outer = HERE if link is None else self.poses.of(link)
            ends.append(frame_at(body, swept(outer.inverse().then(world))))
        kind = kind_of(item, edge.kind, lambda axis: self._turn(axis, node))
        single = edge.kind in SINGLE
        data = data_of(item.child("axis"), edge.kind == "continuous")
        joint = scene.joint(
            node.name,
            kind,
            ends[0],
            ends[1],
            limits=data.limits if single and data.limits else None,
            couple=self._mimic(node) if single else None,
        )
        scene.origins["joint", node.name] = place(item.raw, self.file)
        if single and joint.couple is None:
            if data.friction:
                scene.joints[node.name] = dataclasses.replace(joint, friction=data.friction)
            self._forces(node.name, data)
        else:
            self._several(edge, data)

    def _turn(self, axis: Item, node: Node) -> Rows:
        """R from the axes that an <axis> is expressed in to those of its joint."""
        xyz = axis.raw.find("xyz")
        name = None if xyz is None else xyz.get("expressed_in")
        model = node.model
        assert model is not None
        if not name and (self.in_model or axis.flag("use_parent_model_frame")):
            name = "__model__" if model.kind == "model" else None
        if not name:
            return HERE.rotation
        other = self.poses.of(model.find(name, "expressed_in", node.item.where))
        back = transposed(self.poses.of(node).rotation)
        return swept_rows(product(back, other.rotation))

    def _mimic(self, node: Node) -> tuple[str, float, float] | None:
        axis = node.item.child("axis")
        mimic = None if axis is None else axis.child("mimic")
        if mimic is None or node.model is None:
            return None
        name = mimic.raw.get("joint") or ""
        leader = node.model.find(name, "joint to mimic", node.item.where).name
        return self.mimics.couple(node.name, mimic, leader, self.moving)

    def _forces(self, name: str, data: AxisData) -> None:
        """Spring and damper of a joint."""
        where = self.scene.origins["joint", name]
        if data.damping:
            self.scene.force(f"{name}.damping", JointDamper(name, data.damping))
            self.scene.origins["force", f"{name}.damping"] = where
        if data.stiffness:
            spring = JointSpring(name, data.stiffness, rest=data.reference)
            self.scene.force(f"{name}.spring", spring)
            self.scene.origins["force", f"{name}.spring"] = where

    def _several(self, edge: Edge, data: AxisData) -> None:
        """Joints of several coordinates or none: equal damping acts, and nothing else."""
        axes = [data, data_of(edge.node.item.child("axis2"), False)]
        damping = {one.damping for one in axes}
        name = edge.node.name
        if AXES.get(edge.kind) == 2 and len(damping) == 1 and data.damping:
            self._forces(name, AxisData({}, data.damping, 0.0, 0.0, 0.0))
            axes = [dataclasses.replace(one, damping=0.0) for one in axes]
        if edge.kind in SINGLE:
            # it follows another joint: its damping acts, its limits and friction are listed
            self._forces(name, data)
            return
        named = list(dict.fromkeys(what for one in axes for what in one.named))
        if named:
            what = f"joints {{}} ({edge.kind}): {', '.join(named)} does not act"
            self.idle.setdefault(what, []).append(name)

    def _frame(self, node: Node) -> None:
        """A <frame> is a frame on its link."""
        link = link_of(node)
        body = self.scene.ground if link is None else self.bodies[link]
        outer = HERE if link is None else self.poses.of(link)
        pose = swept(outer.inverse().then(self.poses.of(node)))
        name = node.name
        while name in self.scene.bodies or name in self.scene.frames or name == "ground":
            name += "_"
        body.at(*pose.position, rotation=written(pose.rotation), name=name)

    # what a reader of the model must know

    def _announce(self) -> None:
        notes = self.scene.notes
        self.mimics.announce(notes, self.file)
        notes += [what.format(", ".join(names)) for what, names in self.idle.items()]
        notes += self.meshes.notes()
        if self.unread.counts["link collision"]:
            notes.append(
                "no contacts are read: bodies pass through each other and nothing holds them up; "
                "add cd.Contact where something touches"
            )
        notes += self.unread.notes()
        announce(self.scene, [node.name for node in self.bodies])


def _origin(visual: Element, who: str) -> tuple[list[float], list[float]]:
    """Position and angles of a <visual>; pictures need no snapping."""
    pose = pose_of(Item(visual.raw, visual.where), False, [], who)
    turn = written(pose.rotation)
    return list(pose.position), [0.0] * 3 if turn is None else list(turn[1:])


def _color(visual: Element) -> Color | None:
    """Diffuse color of a <visual>, or else its ambient one."""
    material = visual.child("material")
    for key in ("diffuse", "ambient"):
        if material is not None and material.word(key) is not None:
            red, green, blue, *alpha = material.several(key, 3, 4)
            return red, green, blue, alpha[0] if alpha else 1.0
    return None
