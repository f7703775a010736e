"""MJCF -> Model: the bodies of the file with their joints, masses and frames."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from ....errors import ModelError
from ...body import Body
from ...checks import triple
from ...scene import SceneRecord
from ...shape import Shape
from ..document import Element
from ..options import Options
from ..pose import HERE, Pose, written
from . import contacts, equality, joints, masses
from .actuators import Actuators
from .compiler import Compiler
from .defaults import Defaults
from .document import BodyElement, Document, expanded
from .equality import Law, Parts
from .ignored import Unread
from .joints import Chain, Hinge

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element as XmlElement

SECTIONS = ("compiler", "default", "option", "worldbody", "equality", "actuator")
ENTRIES = ("xx", "xy", "xz", "yy", "yz", "zz")


class Reader:
    """One reading. ``scene`` is complete when this is made."""

    def __init__(self, root: XmlElement, options: Options, file: str, folder: Path | None) -> None:
        self.unread, self.options = Unread(), options
        self.document = Document(expanded(root, options, file, folder), file, self.unread)
        self._sections(root)
        self.compiler = Compiler.read(self.document.section("compiler"))
        self.defaults = Defaults(file, self.unread)
        for raw in root.findall("default"):
            self.defaults.read(raw)
        self.scene = SceneRecord(root.get("model") or Path(file).stem or "mujoco", self._gravity())
        self.scene.of_robot = True
        bodies = list(self.document.bodies(self.compiler))
        hinges = [self._hinges(body) for body in bodies]
        self.hinges = {hinge.name: hinge for row in hinges for hinge in row}
        self.closing: list[tuple[Element, str]] = []
        self.laws: list[Law] = []
        self._equalities()
        self._build(bodies, hinges)
        self._close()
        self.actuators = Actuators(self.scene, self.hinges, self.unread)
        for number, raw in enumerate(self.document.section("actuator").raw):
            with self.document.at_element(raw):
                element = self.defaults.actuator(raw, self.document.where(raw))
                self.actuators.add(element, raw, number)
        self._announce()

    # the document

    def _sections(self, root: XmlElement) -> None:
        self.unread.attributes(root)
        for raw in root:
            if raw.tag in ("compiler", "option"):
                self.unread.attributes(raw)
            elif raw.tag not in SECTIONS:
                self.unread.element(raw)
        if root.find("worldbody") is None:
            raise ModelError(f"file '{self.document.file}': there is no <worldbody>, so no body")

    def _element(self, raw: XmlElement, style: str, kind: str | None = None) -> Element:
        """An element with what its default class adds."""
        self.unread.attributes(raw, kind)
        return self.defaults.of(raw, self.document.where(raw), style)

    def _children(self, section: str) -> list[Element]:
        """The items of a section with their defaults."""
        kind = "equality" if section == "equality" else None
        return [
            self.defaults.of(raw, self.document.where(raw), "main", kind)
            for raw in self.document.section(section).raw
        ]

    def _gravity(self) -> tuple[float, float, float]:
        option = self.document.section("option")
        gravity = option.numbers("gravity", 3, "0 0 -9.81")
        for child in option.raw:
            for name, word in child.attrib.items():
                if (child.tag, name, word) == ("flag", "gravity", "disable"):
                    gravity = [0.0, 0.0, 0.0]
                else:
                    self.unread.counts[f"{child.tag} {name}="] += 1
        return triple(gravity, "gravity")

    # bodies

    def _hinges(self, body_element: BodyElement) -> list[Hinge]:
        """The joints of a body, named.

        Raises:
            ModelError: joints of the world, a free joint among others or inside another body.
        """
        hinges: list[Hinge] = []
        rows = [part for part in body_element.parts if part[0].tag in ("joint", "freejoint")]
        for raw, around, style in rows:
            element = self._element(raw, style)
            if body_element.parent < 0:
                raise ModelError(f"{element.where}: the world has no joints")
            name = (
                raw.get("name") or f"{body_element.name}.joint{len(hinges) + 1 if rows[1:] else ''}"
            )
            hinge = joints.read(element, name, self.compiler, around)
            if hinge.kind == "free" and (body_element.parent > 0 or len(rows) > 1):
                raise ModelError(
                    f"{element.where}: a free joint is the only one of a body of the world"
                )
            hinges.append(hinge)
        return hinges

    def _equalities(self) -> None:
        """Laws between joints, and what closes loops."""
        for number, element in enumerate(self._children("equality")):
            tag = element.raw.tag
            name = element.raw.get("name") or f"{tag}{number}"
            if tag not in equality.READ or not equality.active(element):
                self.unread.element(element.raw, "equality")
            elif tag == "joint":
                self.unread.attributes(element.raw, "equality joint")
                self.laws.append(equality.law(element, name, self.hinges))
            else:
                self.unread.attributes(element.raw)
                self.closing.append((element, name))

    def _build(self, bodies: list[BodyElement], hinges: list[list[Hinge]]) -> None:
        """Bodies, joints, pictures and sites."""
        scene = self.scene
        self.parts = Parts(scene, {"world": scene.ground}, {scene.ground: HERE}, {})
        # a joint follows one other by its coupling; what more is asked of it is a constraint
        followers: dict[str, Law] = {}
        for law in self.laws:
            if law.couple is not None:
                followers.setdefault(law.follower, law)
        couples = {name: law.couple for name, law in followers.items() if law.couple is not None}
        self.laws = [law for law in self.laws if law not in followers.values()]
        self.chain = Chain(scene, self.compiler, couples, self._free, self._origin)
        self.names = {one.name for one in bodies}
        self.touching = [
            contacts.Geom(number, one.parent, kind, geom.text("name", ""))
            for number, one in enumerate(bodies)
            for geom, kind, _ in self._geoms(one)
            if contacts.collides(geom)
        ]
        weights = masses.scaled([self._weight(one) for one in bodies], self.compiler.total)
        built: list[Body] = []
        for one, body_hinges, weight in zip(bodies, hinges, weights, strict=True):
            with self.document.at_element(one.raw):
                body = scene.ground if one.parent < 0 else self._body(one, weight)
                built.append(body)
                if one.parent >= 0:
                    parent = built[one.parent]
                    self.parts.bodies[one.raw.get("name") or one.name] = body
                    self.parts.drawn[body] = self.parts.drawn[parent].then(one.pose)
                    self.chain.join(parent, one.pose, body, body_hinges, f"{one.name}.weld")
            for raw, around, style in one.parts:
                with self.document.at_element(raw):
                    self._part(body, raw, around, style)

    def _origin(self, kind: str, name: str, element: Element) -> None:
        self.scene.origins[kind, name] = self.document.place(element.raw)

    def _free(self, name: str) -> str:
        """A name that no body or frame has, or will have."""
        scene = self.scene
        while name in self.names or name in scene.bodies or name in scene.frames:
            name += "_"
        return name

    def _weight(self, body_element: BodyElement) -> masses.Mass:
        """Mass and inertia of a body: as written, or of its geoms."""
        inertial = None
        for raw, around, style in body_element.parts:
            if raw.tag == "inertial":
                element = self._element(raw, style)
                inertial = masses.written(element, self.compiler, around)
        # geoms say the mass where nothing else does, or where the file wants it
        policy = self.compiler.masses
        if body_element.parent < 0 or (
            policy != "true" and (inertial is not None or policy == "false")
        ):
            return inertial or masses.NOTHING
        compiler = self.compiler
        geom_masses = [
            masses.of_geom(g, kind, compiler, around)
            for g, kind, around in self._geoms(body_element)
        ]
        return masses.combined([part for part in geom_masses if part is not None])

    def _geoms(self, body_element: BodyElement) -> Iterator[tuple[Element, str, Pose]]:
        """The geoms of a body, their types and the poses of the frames around them."""
        for raw, around, style in body_element.parts:
            if raw.tag == "geom":
                geom = self.defaults.of(raw, self.document.where(raw), style)
                yield geom, masses.kind_of(geom), around

    def _body(self, body_element: BodyElement, mass: masses.Mass) -> Body:
        """A body with its mass and what is drawn of it."""
        drawn: list[Shape] = []
        for geom, kind, around in self._geoms(body_element):
            self.unread.attributes(geom.raw)
            drawn += masses.picture(geom, kind, self.compiler, around)
        rows = mass.inertia
        tensor = [rows[i][j] for i in range(3) for j in range(i, 3)]
        body = self.scene.body(
            body_element.name,
            mass.mass,
            mass.com,
            dict(zip(ENTRIES, tensor, strict=True)),
            None,
            drawn,
        )
        self.scene.origins["body", body_element.name] = self.document.place(body_element.raw)
        return body

    def _part(self, body: Body, raw: XmlElement, around: Pose, style: str) -> None:
        """Sites are frames; the rest was read before, or is not."""
        if raw.tag == "site":
            element = self._element(raw, style)
            pose = around.then(self.compiler.pose(element))
            name = raw.get("name")
            if name in self.parts.sites:
                raise ModelError(f"{element.where}: another site has this name; rename one of them")
            if name:
                self.parts.sites[name] = body, pose
                turn = written(pose.rotation)
                body.at(*pose.position, rotation=turn, name=self._free(name))
        elif raw.tag not in ("inertial", "geom", "joint", "freejoint"):
            self.unread.element(raw)

    def _close(self) -> None:
        """Loops, and the laws that are not couplings."""
        for element, name in self.closing:
            with self.document.at_element(element.raw):
                self.parts.close(element, name)
            self._origin("joint", name, element)
        for law in self.laws:
            with self.document.at_element(law.element.raw):
                self.scene.constraint(law.name, law.expression(self.scene))
            self._origin("constraint", law.name, law.element)

    def _announce(self) -> None:
        """Notes for the reader of the model."""
        chain, notes = self.chain, self.scene.notes
        notes += contacts.notes(self.touching)
        notes += self.actuators.notes()
        notes += self.unread.notes()
        if chain.ignored:
            notes.append(f"not acted on: {', '.join(chain.ignored)}")
