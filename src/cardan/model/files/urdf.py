"""URDF robots.

Source: the URDF specification, http://wiki.ros.org/urdf/XML.
"""

from __future__ import annotations

import dataclasses
import warnings
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from ...elements.forces.damping import Damping
from ...elements.joints.fixed import Fixed
from ...elements.joints.free import Free
from ...elements.joints.joint import Joint as JointElement
from ...elements.joints.planar import Planar
from ...elements.joints.prismatic import Prismatic
from ...elements.joints.revolute import Revolute
from ...errors import ModelError, TopologyError, near
from ..body import Body
from ..model import Model
from .angles import snap_all, snap_axis, turned
from .document import Element, content, parse
from .meshes import Meshes, shapes
from .options import Options

TYPES = ("revolute", "continuous", "prismatic", "fixed", "floating", "planar")
MOST_LINKS = 100_000


@dataclass(frozen=True)
class Edge:
    """A joint element of the file with the links it joins."""

    name: str
    element: Element
    parent: str
    child: str


def read(path: Path, options: Options) -> Model:
    """The model of a URDF file, see :func:`cardan.load`."""
    return from_text(content(path), options, path.name, path.parent)


def from_text(
    text: str | bytes,
    options: Options | None = None,
    name: str = "text",
    folder: Path | None = None,
) -> Model:
    """The model of a URDF document.

    Args:
        text: The document.
        options: How to read it.
        name: Of the file, for messages.
        folder: Of the file, for relative mesh paths.

    Raises:
        ModelError: it is no URDF document, or a link or joint of it is at fault.
        TopologyError: links form a loop or nothing joins them.
    """
    return _Reader(parse(text, name), options or Options(), name, folder).model()


@dataclass
class _Reader:
    """One reading."""

    root: Any
    options: Options
    file: str
    folder: Path | None
    friction: list[str] = field(default_factory=list)
    freed: list[str] = field(default_factory=list)
    orphans: list[str] = field(default_factory=list)

    def model(self) -> Model:
        if self.root.tag != "robot":
            raise ModelError(f"file '{self.file}': the root is <{self.root.tag}>, not <robot>")
        links, edges = self._links(), self._edges()
        base = self._base(links, edges)
        self.scene = Model(self.root.get("name") or "robot")
        self.meshes = Meshes(self.options.packages, self.folder)
        self.bodies = {name: self._body(name, link) for name, link in links.items()}
        self.moving = [e.name for e in edges if e.element.text("type", "") != "fixed"]
        self._root_joint(base)
        for edge in self._in_order(base, edges):
            self._joint(edge)
        self._announce()
        return self.scene

    # the graph

    def _links(self) -> dict[str, Element]:
        links: dict[str, Element] = {}
        for raw in self.root.findall("link"):
            name = Element(raw, f"file '{self.file}'").text("name")
            if name in links:
                raise ModelError(f"link '{name}' is defined twice; rename one of them")
            links[name] = Element(raw, f"link '{name}'")
        if not links:
            hint = "; run xacro on it first" if self._is_xacro() else ""
            raise ModelError(f"file '{self.file}': the robot has no links{hint}")
        if len(links) > MOST_LINKS:
            raise ModelError(f"file '{self.file}' has {len(links)} links, at most {MOST_LINKS}")
        return links

    def _is_xacro(self) -> bool:
        return any(isinstance(child.tag, str) and "xacro" in child.tag for child in self.root)

    def _edges(self) -> list[Edge]:
        edges: dict[str, Edge] = {}
        for raw in self.root.findall("joint"):
            name = Element(raw, f"file '{self.file}'").text("name")
            if name in edges:
                raise ModelError(f"joint '{name}' is defined twice; rename one of them")
            element = Element(raw, f"joint '{name}'")
            ends = []
            for role in ("parent", "child"):
                end = element.child(role)
                if end is None:
                    raise ModelError(f"joint '{name}': <{role} link=.../> is missing")
                ends.append(end.text("link"))
            edges[name] = Edge(name, element, ends[0], ends[1])
        return list(edges.values())

    def _base(self, links: dict[str, Element], edges: list[Edge]) -> str:
        """The one link that is nobody's child."""
        inboard: dict[str, Edge] = {}
        for edge in edges:
            for role, link in (("parent", edge.parent), ("child", edge.child)):
                if link not in links:
                    listed = near(link, links).replace(" Known:", " Links:")
                    raise ModelError(f"joint '{edge.name}': {role} '{link}' is no link.{listed}")
            if edge.child in inboard:
                raise TopologyError(
                    f"link '{edge.child}' is the child of two joints, "
                    f"'{inboard[edge.child].name}' and '{edge.name}': circuits are not supported "
                    "yet by this version; leave out one of them"
                )
            inboard[edge.child] = edge
        roots = [name for name in links if name not in inboard]
        if not roots:
            raise TopologyError(
                f"file '{self.file}': every link is the child of a joint, so they form a loop; "
                "one link must be the root"
            )
        if len(roots) > 1:
            listed = ", ".join(f"'{r}'" for r in roots[:8])
            raise TopologyError(
                f"file '{self.file}' has {len(roots)} links that are nobody's child: {listed}. "
                "Join all but one of them to the rest"
            )
        return roots[0]

    def _in_order(self, base: str, edges: list[Edge]) -> list[Edge]:
        """Edges as in the file; all links hang on the root.

        Raises:
            TopologyError: some links form a loop of their own.
        """
        outboard: dict[str, list[str]] = {}
        for edge in edges:
            outboard.setdefault(edge.parent, []).append(edge.child)
        reached, stack = {base}, [base]
        while stack:
            for child in outboard.get(stack.pop(), ()):
                reached.add(child)
                stack.append(child)
        loop = [f"'{edge.child}'" for edge in edges if edge.child not in reached]
        if loop:
            raise TopologyError(
                f"file '{self.file}': links {', '.join(loop[:8])} form a loop that does not hang "
                f"on the root '{base}'"
            )
        return edges

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
                tensor = turned(entries, rpy)
        keys = ("xx", "xy", "xz", "yy", "yz", "zz")
        drawn = shapes(link, self.meshes, self._origin)
        return self.scene.body(
            self._name(name), mass, com, dict(zip(keys, tensor, strict=True)), None, drawn
        )

    def _name(self, link: str) -> str:
        """Name of the body of a link: its own, save for that of the ground."""
        return "ground_link" if link == "ground" else link

    def _origin(
        self, element: Element, who: str, snap: bool = False
    ) -> tuple[list[float], list[float]]:
        """Position and roll, pitch, yaw of <origin>; pictures need no snapping."""
        origin = element.child("origin")
        if origin is None:
            return [0.0] * 3, [0.0] * 3
        xyz = origin.numbers("xyz", 3, "0 0 0")
        rpy = origin.numbers("rpy", 3, "0 0 0")
        if snap and any(rpy):
            rpy = snap_all(origin.text("rpy").split(), rpy, who, self.scene.snaps)
        return xyz, rpy

    # joints

    def _root_joint(self, base: str) -> None:
        name = "base"
        taken = {raw.get("name") for raw in self.root.findall("joint")}
        while name in taken:
            name += "_"
        kind: JointElement = Free() if self.options.base == "free" else Fixed()
        self.scene.joint(name, kind, self.scene.ground, self.bodies[base])

    def _joint(self, edge: Edge) -> None:
        element, scene = edge.element, self.scene
        xyz, rpy = self._origin(element, element.where, self.options.snap)
        parent = self.bodies[edge.parent]
        place = parent
        if any(xyz) or any(rpy):
            place = parent.at(*xyz, rotation=("xyz", *rpy) if any(rpy) else None)  # type: ignore[assignment]
        kind = self._kind(element)
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
            return
        damping = dynamics.number("damping", "0")
        if damping:
            scene.force(f"{edge.name}.damping", Damping(edge.name, damping))
        friction = dynamics.optional("friction")
        if friction:
            scene.joints[edge.name] = dataclasses.replace(joint, friction=friction)
            self.friction.append(edge.name)

    def _kind(self, element: Element) -> JointElement:
        kind = element.text("type")
        if kind not in TYPES:
            raise ModelError(f"{element.where}: type '{kind}' is unknown." + near(kind, TYPES))
        if kind == "fixed":
            return Fixed()
        if kind == "floating":
            return Free()
        axis = element.child("axis")
        direction = [1.0, 0.0, 0.0] if axis is None else axis.numbers("xyz", 3)
        if not any(direction):
            raise ModelError(f"{element.where}: its axis is zero; give for example xyz='0 0 1'")
        if axis is not None and self.options.snap:
            words = axis.text("xyz").split()
            direction = snap_axis(words, direction, element.where, self.scene.snaps)
        if sum(x != 0 for x in direction) == 1:
            direction = [float((x > 0) - (x < 0)) for x in direction]
        family = {"prismatic": Prismatic, "planar": Planar}
        made: JointElement = family.get(kind, Revolute)(tuple(direction))
        return made

    def _limits(self, element: Element) -> dict[str, float] | None:
        limit = element.child("limit")
        if limit is None:
            return None
        names = {"lower": "lower", "upper": "upper", "speed": "velocity", "effort": "effort"}
        if element.text("type") == "continuous":
            names = {"speed": "velocity", "effort": "effort"}
        found = {key: limit.optional(name) for key, name in names.items()}
        return {key: value for key, value in found.items() if value is not None}

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
        return (
            leader,
            mimic.number("multiplier", "1"),
            mimic.number("offset", "0"),
        )

    # what a reader of the model must know

    def _announce(self) -> None:
        scene, notes = self.scene, self.scene.notes
        limited = [j.name for j in scene.joints.values() if any(v is not None for v in j.limits)]
        if self.orphans:
            lost = f"joints {', '.join(self.orphans)} mimic what is no moving joint of the file"
            notes.append(f"{lost}; they move freely")
            warnings.warn(f"file '{self.file}': {notes[-1]}", stacklevel=6)
        for what, names in (
            ("friction is stored, but does not act yet", self.friction),
            ("limits are stored, but do not act yet", limited),
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
            warnings.warn(f"{text}; forward dynamics divides by it", stacklevel=6)

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
