"""Scene -> URDF: links, joints, and a list of what URDF cannot say.

The axes of a link are those of its body. A joint frame beside them, and every named frame, is a
link without mass on a fixed joint; joints with several coordinates are joints in a row, named after
the coordinates. Loops are closed by <loop_joint>, see :mod:`cardan.scene.files.urdf.loops`.

Source: the URDF specification, http://wiki.ros.org/urdf/XML.
"""

from __future__ import annotations

from pathlib import Path
from xml.etree import ElementTree as xml

import numpy as np

from ...arrays import Array
from ...atomic_file import written
from ...elements.forces.joint_damper import JointDamper
from ...elements.joints.joint import Reversed
from ...errors import ModelError, counted
from ...scene.scene import SceneRecord
from ..internal_states import dotted
from ..system import GROUND, Cut, Joint
from .movements import Movement, movements_of
from .numeric_scene import NumericScene, roll_pitch_yaw
from .omissions import of_scene
from .visuals import ShapeNumbers, origin, text, visual

# where a limit is required and the scene has none
NO_LIMIT = 1e9
WORLD = "world"
# joints that close loops by kind, with the quantities that are their directions
LOOPS = {
    "revolute": ("axis",),
    "prismatic": ("axis",),
    "cylindrical": ("axis",),
    "planar": ("normal",),
    "universal": ("axis1", "axis2"),
    "spherical": (),
    "fixed": (),
}
# without limits of position; a turn that has some is "revolute"
TYPES = {"turn": "continuous", "slide": "prismatic"}
ENDS = {"joint": ("parent", "child"), "loop_joint": ("link1", "link2")}


def write(scene: SceneRecord, path: Path, strict: bool) -> tuple[str, ...]:
    """Write a scene as URDF.

    Args:
        scene: The scene.
        path: The file.
        strict: Refuse what URDF cannot say.

    Returns:
        What it cannot say.

    Raises:
        ModelError: there is such a thing, and ``strict``; or the file cannot be written.
    """
    robot = _Robot(scene, path.parent)
    root = robot.document()
    if strict and robot.losses:
        listed = "".join(f"\n  - {loss}" for loss in robot.losses)
        said = counted(len(robot.losses), "thing")
        raise ModelError(f"file '{path.name}': URDF cannot say {said} of '{scene.name}':{listed}")
    xml.indent(root)
    text = xml.tostring(root, encoding="unicode")
    written(path, f'<?xml version="1.0" encoding="utf-8"?>\n{text}\n')
    return tuple(robot.losses)


class _Robot:
    """One writing."""

    def __init__(self, scene: SceneRecord, folder: Path) -> None:
        self.scene, self.folder = scene, folder.resolve()
        self.numeric = NumericScene(scene)
        self.system = self.numeric.system
        self.losses: list[str] = []
        # forces that <dynamics> says
        self.dampers: set[str] = set()
        self.root = xml.Element("robot", name=scene.name)
        self.shapes: dict[str, list[ShapeNumbers]] = {}
        for frame, shape in self.system.shapes:
            self.shapes.setdefault(self.numeric.part(frame).name, []).append(shape)
        self.taken = {*scene.bodies, *scene.joints, *scene.frames}
        self.world = "" if self._is_rooted() else self._new(WORLD)

    def document(self) -> xml.Element:
        """The <robot>; to be asked once."""
        if self.world:
            self._link(self.world, "ground")
        self._parts(GROUND)
        for k, body in enumerate(self.system.bodies):
            # what has no parts stands for a node of a beam, or for the far side of a cut joint
            if body.parts:
                self._joint(self.system.joints[k], k)
                self._parts(k)
        for cut in self.system.closing:
            self._loop(cut)
        self._frames()
        self.losses += of_scene(self.scene, self.numeric, self.dampers)
        return self.root

    def _is_rooted(self) -> bool:
        """True if a single body stands on the ground, right where that is."""
        parts, frames = self.system.ground_parts, self.system.frames
        on_ground = {k for k, row in enumerate(frames) if row.body == GROUND and row.part == 0}
        joined = {joint.parent_frame for joint in self.system.joints}
        joined |= {f for cut in self.system.closing for f in (cut.parent_frame, cut.child_frame)}
        named = {k for k in on_ground if frames[k].name in self.scene.frames}
        first = [part for part in parts[1:] if part.inboard == 0]
        return (
            len(first) == 1
            and not on_ground & (joined | {k for k in named if k})
            and "ground" not in self.shapes
            and bool((self.numeric.against(first[0].frame, 0) == np.eye(4)).all())
        )

    def _new(self, name: str) -> str:
        """A name that nothing has."""
        while name in self.taken:
            name += "_"
        self.taken.add(name)
        return name

    def _of(self, body: str) -> str:
        """The link of a body."""
        return self.world if body == "ground" else body

    # links

    def _link(self, name: str, body: str | None = None) -> None:
        """A link; of a body with its mass and shapes."""
        link = xml.SubElement(self.root, "link", name=name)
        if body in self.scene.bodies:
            mass, com, inertia = self.numeric.mass(self.scene.bodies[body])
            if mass or any(inertia):
                inertial = xml.SubElement(link, "inertial")
                origin(inertial, com, (0, 0, 0))
                xml.SubElement(inertial, "mass", value=repr(mass))
                keys = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")
                entries = dict(zip(keys, map(repr, inertia), strict=True))
                xml.SubElement(inertial, "inertia", entries)
        for shape in self.shapes.get(body or "", ()):
            visual(link, shape, self.folder)

    def _parts(self, body: int) -> None:
        """The links that are fixed to each other."""
        parts = self.numeric.parts(body)
        for part in parts[1:]:
            self._link(part.name, part.name)
            inner = parts[part.inboard]
            if inner.name == "ground" and not self.world:
                continue
            pose = self.numeric.against(part.frame, inner.frame)
            self._fixed(part.joint, self._of(inner.name), part.name, pose)

    def _fixed(self, name: str, parent: str, child: str, pose: Array) -> None:
        self._element("joint", name, "fixed", (parent, child), pose)

    def _frames(self) -> None:
        """Named frames as links without mass."""
        for k, row in enumerate(self.system.frames):
            frame = self.scene.frames.get(row.name)
            if frame is None or not frame.named or not self.numeric.parts(row.body):
                continue
            self._link(row.name)
            part = self.numeric.part(k)
            joint = self._new(f"{row.name}.fixed")
            self._fixed(joint, self._of(part.name), row.name, self.numeric.on_part(k))

    # joints

    def _joint(self, joint: Joint, body: int) -> None:
        """A joint of the tree, and the first link of the body that it moves."""
        part = self.numeric.parts(body)[0]
        parent = self.numeric.part(joint.parent_frame)
        pose = self.numeric.in_body(joint.rotation, joint.position, parent.frame)
        movements = self._movements(joint)
        inner = self._of(parent.name)
        # the axes of a body of the system are those of its joint
        place = self.numeric.in_axes(part.frame)
        is_at_origin = bool((place == np.eye(4)).all())
        names = [self._new(f"{movement.name}.link") for movement in movements[:-1]]
        names.append(part.name if is_at_origin else self._new(f"{joint.name}.child"))
        for movement, name in zip(movements, names, strict=True):
            if name != part.name:
                self._link(name)
            element = self._element("joint", movement.name, movement.kind, (inner, name), pose)
            if len(movement.axis):
                xml.SubElement(element, "axis", xyz=text(movement.axis))
            self._properties(element, joint, movement, alone=len(movements) == 1)
            inner, pose = name, np.eye(4)
        self._link(part.name, part.name)
        if not is_at_origin:
            self._fixed(self._new(f"{joint.name}.fixed"), inner, part.name, place)

    def _movements(self, joint: Joint) -> tuple[Movement, ...]:
        """The <joint>s that stand for a joint; what they do not say is listed."""
        movements, losses = movements_of(joint, self.numeric)
        who = f"joint '{joint.name}' ({joint.element.kind})"
        if joint.motion is not None:
            losses += ("its prescribed motion; it moves freely",)
        if (joint.q0 is not None or joint.u0 is not None) and not joint.implicit:
            losses += ("its initial values",)
        self.losses += [f"{who}: {loss}" for loss in losses]
        return movements

    def _element(
        self, tag: str, name: str, kind: str, links: tuple[str, str], pose: Array
    ) -> xml.Element:
        """A <joint> with its ends and its origin."""
        element = xml.SubElement(self.root, tag, name=name, type=TYPES.get(kind, kind))
        for role, link in zip(ENDS[tag], links, strict=True):
            xml.SubElement(element, role, link=link)
        if not (pose == np.eye(4)).all():
            origin(element, pose[:3, 3], roll_pitch_yaw(pose[:3, :3]))
        return element

    def _properties(
        self, element: xml.Element, joint: Joint, movement: Movement, alone: bool
    ) -> None:
        """Limits, damping, friction, and the joint that it follows."""
        lower, upper, speed, effort = joint.limits if alone else (None,) * 4
        bounded = lower is not None and upper is not None
        if (lower is None) != (upper is None):
            self.losses.append(f"joint '{joint.name}': a limit on one side alone")
        if movement.kind == "turn" and bounded:
            element.set("type", "revolute")
        if movement.kind in ("turn", "slide") and (
            bounded or movement.kind == "slide" or speed is not None or effort is not None
        ):
            numbers = {"effort": effort, "velocity": speed}
            if bounded or movement.kind == "slide":
                ends = (lower, upper) if bounded else (-NO_LIMIT, NO_LIMIT)
                numbers = dict(zip(("lower", "upper"), ends, strict=True)) | numbers
            texts = {n: repr(NO_LIMIT if x is None else float(x)) for n, x in numbers.items()}
            xml.SubElement(element, "limit", texts)
        if movement.kind in ("turn", "slide") and joint.element.kind != "spherical":
            self._dynamics(element, joint)
        if joint.coupling is not None:
            ratio, offset = self.numeric.numbers([joint.coupling.ratio, joint.coupling.offset])
            leader = self.system.joints[joint.coupling.leader].name
            texts = {"multiplier": repr(float(ratio)), "offset": repr(float(offset))}
            xml.SubElement(element, "mimic", {"joint": leader, **texts})

    def _dynamics(self, element: xml.Element, joint: Joint) -> None:
        """Viscous and dry friction."""
        damping = 0.0
        for name, force in self.scene.forces.items():
            damper = force.element
            if isinstance(damper, JointDamper) and damper.joint == joint.name:
                value = self.numeric.constant(damper.damping, dotted(name, "damping"))
                if value is not None:
                    damping += value
                    self.dampers.add(name)
        declared = self.scene.joints.get(joint.name)
        values = {"damping": damping, "friction": declared.friction if declared else 0.0}
        texts = {name: repr(float(x)) for name, x in values.items() if x}
        if texts:
            xml.SubElement(element, "dynamics", texts)

    def _loop(self, cut: Cut) -> None:
        """A joint that closes a loop."""
        who = f"joint '{cut.name}' ({cut.element.kind})"
        element = cut.element
        if cut.carrier is not None or element.kind not in LOOPS or isinstance(element, Reversed):
            self.losses.append(f"{who}: it closes a loop, which is open in the file")
            return
        self.losses.append(
            f"{who}: it closes a loop; <loop_joint> says so, which cardan reads and URDF does not "
            "have: other programs leave the loop open"
        )
        links = [self._of(self.numeric.part(f).name) for f in (cut.parent_frame, cut.child_frame)]
        one, two = (self.numeric.on_part(f) for f in (cut.parent_frame, cut.child_frame))
        joint = self._element("loop_joint", cut.name, element.kind, (links[0], links[1]), one)
        second = joint.find("link2")
        assert second is not None
        origin(second, two[:3, 3], roll_pitch_yaw(two[:3, :3]))
        for tag, quantity in zip(("axis", "axis2"), LOOPS[element.kind], strict=False):
            axis = self.numeric.numbers(cut.data[quantity][2]).tolist()
            xml.SubElement(joint, tag, xyz=text(axis))
