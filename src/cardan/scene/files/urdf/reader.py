"""URDF -> Model: links, joints and what they carry."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING
from warnings import catch_warnings, simplefilter

from ....elements.forces.joint_damper import JointDamper
from ....elements.joints.fixed import Fixed
from ....elements.joints.free import Free
from ....elements.joints.joint import Joint as JointElement
from ....errors import ImpossibleWarning, ModelError, warn
from ....records import dataclass
from ...body import Body
from ...checks import lone_moment, unphysical
from ...scene import SceneRecord
from ..angles import rotated_inertia
from ..document import Element
from ..meshes import Meshes, shapes
from ..options import Options
from ..robot import Mimics, Remarks, announce, body_name
from ..unread import Unread
from . import constraints, loops
from .contents import CONTENTS
from .graph import Edge, base_of, edges_of, links_of
from .kinds import Origin, kind_of, omissions, origin_of
from .materials import material_colors

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element as XmlElement


MOMENTS = ("ixx", "iyy", "izz")


@dataclass
class Reader:
    """One reading."""

    root: XmlElement
    options: Options
    file: str
    folder: Path | None

    def model(self) -> SceneRecord:
        """The model; to be asked once."""
        # first: what is misspelt is often why the rest is at fault
        unread = Unread()
        unread.document(self.root, CONTENTS, self.file)
        misspelt = unread.announce()
        links, edges = links_of(self.root, self.file), edges_of(self.root, self.file)
        base = base_of(links, edges, self.file)
        self.scene = SceneRecord(self.root.get("name") or "robot")
        self.scene.of_robot = True
        self.scene.notes += misspelt
        self.remarks = Remarks()
        self.mimics = Mimics(self.options.mimic == "couple")
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
        constraints.close(self.scene, self.root, self.file, self.bodies, self.options.snap)
        self._announce()
        self.scene.notes += unread.notes()
        return self.scene

    # links

    def _body(self, name: str, link: Element) -> Body:
        inertial = link.child("inertial")
        mass: float = 0.0
        lacking = list[str]()
        com: list[float] = [0.0, 0.0, 0.0]
        tensor: tuple[float, ...] = (0.0,) * 6
        if inertial is not None:
            com, rpy = self._origin(inertial, f"{link.where} inertial", self.options.snap)
            mass_element, inertia = inertial.child("mass"), inertial.child("inertia")
            if mass_element is None:
                raise ModelError(
                    f'{link.where}: <inertial> lacks <mass value="..."/>; leave <inertial> out '
                    "where a link has no mass"
                )
            mass = mass_element.number("value")
            if inertia is not None:
                entries = [
                    inertia.number(f"i{key}", "0") for key in ("xx", "xy", "xz", "yy", "yz", "zz")
                ]
                tensor = rotated_inertia(entries, rpy)
                lacking = [key for key in MOMENTS if inertia.word(key) is None]
        keys = ("xx", "xy", "xz", "yy", "yz", "zz")
        drawn = shapes(link, self.meshes, self._origin, self.color)
        # where moments are missing, they are the reason why no body has the others
        explained = self._lacking(name, lacking, tensor)
        with catch_warnings():
            if explained:
                simplefilter("ignore", ImpossibleWarning)
            return self.scene.body(
                body_name(name), mass, com, dict(zip(keys, tensor, strict=True)), None, drawn
            )

    def _lacking(self, link: str, lacking: list[str], tensor: Sequence[float]) -> bool:
        """Say which moments of inertia are missing; True where no body has what is left."""
        if not lacking:
            return False
        what = f"<inertia> lacks {' and '.join(lacking)}"
        impossible = bool(unphysical(tensor)) and lone_moment(tensor) is None
        if impossible:
            name = body_name(link)
            text = f"{what}; with 0 in its place no body has this inertia: give {lacking[0]}"
            warn(f"body '{name}': {text}", ImpossibleWarning)
        else:
            self.remarks.add("link", link, f"{what}; 0 is taken")
        return impossible

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
        for what in omissions(element):
            self.remarks.add("joint", edge.name, what)
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

    def _mimic(self, element: Element) -> tuple[str, float, float] | None:
        mimic = element.child("mimic")
        leader = mimic.text("joint") if mimic is not None and self.mimics.followed else ""
        return self.mimics.couple(element.text("name"), mimic, leader, self.moving)

    # what a reader of the model must know

    def _announce(self) -> None:
        notes = self.scene.notes
        self.mimics.announce(notes, self.file)
        notes += self.remarks.notes()
        notes += self.meshes.notes()
        announce(self.scene, self.bodies)
