"""URDF -> Model: links, joints and what they carry."""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ....elements.forces.joint_damper import JointDamper
from ....elements.joints.fixed import Fixed
from ....elements.joints.free import Free
from ....elements.joints.joint import Joint as JointElement
from ....errors import ModelWarning, warn
from ...body import Body
from ...scene import SceneRecord
from ..angles import rotated_inertia
from ..document import Element
from ..meshes import Meshes, shapes
from ..options import Options
from . import loops
from .graph import Edge, base_of, edges_of, links_of
from .kinds import Origin, kind_of, origin_of
from .materials import material_colors

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element as XmlElement


@dataclass
class Reader:
    """One reading."""

    root: XmlElement
    options: Options
    file: str
    folder: Path | None
    freed: list[str] = field(default_factory=list)
    orphans: list[str] = field(default_factory=list)

    def model(self) -> SceneRecord:
        """The model; to be asked once."""
        links, edges = links_of(self.root, self.file), edges_of(self.root, self.file)
        base = base_of(links, edges, self.file)
        self.scene = SceneRecord(self.root.get("name") or "robot")
        self.scene.of_robot = True
        self.meshes = Meshes(self.options.packages, self.folder)
        self.color = material_colors(self.root)
        self.bodies = {name: self._body(name, link) for name, link in links.items()}
        self.moving = [e.name for e in edges if e.element.text("type", "") != "fixed"]
        self._root_joint(base)
        origins = {edge.name: self._joint(edge) for edge in edges}
        if self.root.find("loop_joint") is not None:
            drawn = loops.reference(base, edges, origins)
            snap = self.options.snap
            loops.close(self.scene, self.root, self.file, self.bodies, drawn, snap)
        self._announce()
        return self.scene

    # links

    def _body(self, name: str, link: Element) -> Body:
        inertial = link.child("inertial")
        mass: float = 0.0
        com: list[float] = [0.0, 0.0, 0.0]
        tensor: tuple[float, ...] = (0.0,) * 6
        if inertial is not None:
            com, rpy = self._origin(inertial, f"{link.where} inertial", self.options.snap)
            mass_element, inertia = inertial.child("mass"), inertial.child("inertia")
            mass = mass_element.number("value") if mass_element is not None else 0.0
            if inertia is not None:
                entries = [
                    inertia.number(f"i{key}", "0") for key in ("xx", "xy", "xz", "yy", "yz", "zz")
                ]
                tensor = rotated_inertia(entries, rpy)
        keys = ("xx", "xy", "xz", "yy", "yz", "zz")
        drawn = shapes(link, self.meshes, self._origin, self.color)
        return self.scene.body(
            self._name(name), mass, com, dict(zip(keys, tensor, strict=True)), None, drawn
        )

    def _name(self, link: str) -> str:
        """Name of the body of a link: its own, save for that of the ground."""
        return "ground_link" if link == "ground" else link

    def _origin(self, element: Element, who: str, snap: bool = False) -> Origin:
        return origin_of(element, who, snap, self.scene.snaps)

    # joints

    def _root_joint(self, base: str) -> None:
        name = "base"
        taken = {raw.get("name") for raw in self.root.findall("joint")}
        while name in taken:
            name += "_"
        kind: JointElement = Free() if self.options.base == "free" else Fixed()
        self.scene.joint(name, kind, self.scene.ground, self.bodies[base])

    def _joint(self, edge: Edge) -> Origin:
        """Make a joint; where its frame is on the parent."""
        element, scene = edge.element, self.scene
        xyz, rpy = self._origin(element, element.where, self.options.snap)
        parent = self.bodies[edge.parent]
        place = parent
        if any(xyz) or any(rpy):
            place = parent.at(*xyz, rotation=("xyz", *rpy) if any(rpy) else None)  # type: ignore[assignment]
        kind = kind_of(element, self.options.snap, scene.snaps)
        moves = bool(kind.coordinates)
        joint = scene.joint(
            edge.name,
            kind,
            place,
            self.bodies[edge.child],
            limits=self._limits(element) if moves else None,
            couple=self._mimic(element) if moves else None,
        )
        dynamics = element.child("dynamics")
        if dynamics is None or not moves:
            return xyz, rpy
        damping = dynamics.number("damping", "0")
        if damping:
            scene.force(f"{edge.name}.damping", JointDamper(edge.name, damping))
        friction = dynamics.optional("friction")
        if friction:
            scene.joints[edge.name] = dataclasses.replace(joint, friction=friction)
        return xyz, rpy

    def _limits(self, element: Element) -> dict[str, float] | None:
        limit = element.child("limit")
        if limit is None:
            return None
        names = {"lower": "lower", "upper": "upper", "speed": "velocity", "effort": "effort"}
        if element.text("type") == "continuous":
            names = {"speed": "velocity", "effort": "effort"}
        limits = {key: limit.optional(name) for key, name in names.items()}
        return {key: value for key, value in limits.items() if value is not None}

    def _mimic(self, element: Element) -> tuple[Any, ...] | None:
        mimic = element.child("mimic")
        if mimic is None:
            return None
        if self.options.mimic == "free":
            self.freed.append(element.text("name"))
            return None
        leader = mimic.text("joint")
        if leader not in self.moving:
            self.orphans.append(f"{element.text('name')} ({leader})")
            return None
        return (leader, mimic.number("multiplier", "1"), mimic.number("offset", "0"))

    # what a reader of the model must know

    def _announce(self) -> None:
        scene, notes = self.scene, self.scene.notes
        if self.orphans:
            lost = f"joints {', '.join(self.orphans)} mimic what is not a moving joint of the file"
            notes.append(f"{lost}; they move freely")
            warn(f"file '{self.file}': {notes[-1]}", ModelWarning)
        for what, names in (
            ("mimic is not followed (mimic='free'); the joint moves freely", self.freed),
        ):
            if names:
                notes.append(f"joints {', '.join(names)}: {what}")
        if "ground_link" in scene.bodies and "ground" in self.bodies:
            notes.append("link 'ground' is body 'ground_link': 'ground' is what does not move")
        notes += self.meshes.notes()
        if scene.snaps:
            notes.append(f"{len(scene.snaps)} rounded angles were made exact; see Model.snaps")
        tips = self._massless_tips()
        if tips:
            text = f"bodies {', '.join(tips)}: nothing outboard of their joints has a mass"
            warn(f"{text}; forward dynamics divides by it", ModelWarning)

    def _massless_tips(self) -> list[str]:
        """Links moved by a joint without any mass from there outward."""
        joints = list(self.scene.joints.values())
        order = {joint.child.body: joint for joint in joints}
        heavy = {body for body in order if body.mass or any(body.inertia)}
        for body in list(heavy):
            inner = order[body].parent.body
            while inner in order and inner not in heavy:
                heavy.add(inner)
                inner = order[inner].parent.body
        return [
            joint.child.body.name
            for joint in joints
            if joint.kind.coordinates and joint.couple is None and joint.child.body not in heavy
        ]
