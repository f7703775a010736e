"""Equality constraints: joints that close loops, and couplings of coordinates."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ....elements.joints.fixed import Fixed
from ....elements.joints.joint import Joint as JointElement
from ....elements.joints.spherical import Spherical
from ....errors import ModelError, near
from ....records import dataclass
from ....spatial.numbers import UPRIGHT, of_quaternion
from ...body import Body
from ...frame import Place
from ...scene import SceneRecord
from ..document import Element
from ..pose import HERE, Pose, written
from .compiler import chosen
from .joints import Hinge

if TYPE_CHECKING:
    import sympy

READ = ("connect", "weld", "joint")


@dataclass(frozen=True, eq=False)
class Law:
    """y - y_ref = c0 + c1 (x - x_ref) + ... + c4 (x - x_ref)^4 between two joints.

    Attributes:
        name: Of the constraint.
        element: Where it stands.
        follower, leader: Joints with one coordinate; no leader: y stays.
        coefficients: c0 to c4.
        refs: y_ref and x_ref.
    """

    name: str
    element: Element
    follower: str
    leader: str | None
    coefficients: tuple[float, ...]
    refs: tuple[float, float]

    @property
    def couple(self) -> tuple[Any, ...] | None:
        """The law as a coupling of joints, None where it is none."""
        c0, c1, *higher = self.coefficients
        if self.leader is None or any(higher) or c1 == 0 or self.leader == self.follower:
            return None
        return self.leader, c1, self.refs[0] + c0 - c1 * self.refs[1]

    def expression(self, scene: SceneRecord) -> sympy.Expr:
        """Expression that vanishes, in coordinates of the model."""
        y = scene.q(self.follower) - self.refs[0]
        if self.leader is None:
            return y - self.coefficients[0]
        x = scene.q(self.leader) - self.refs[1]
        return y - sum(c * x**k for k, c in enumerate(self.coefficients) if c)


def law(element: Element, name: str, hinges: dict[str, Hinge]) -> Law:
    """An equality of joints.

    Raises:
        ModelError: a joint that does not exist or has several coordinates.
    """
    joints = []
    for key in ("joint1", "joint2"):
        joint = element.text(key) if key == "joint1" else element.raw.get(key)
        if joint is not None:
            if joint not in hinges:
                listed = near(joint, hinges).replace(" Known:", " Joints:")
                raise ModelError(f"{element.where}: {key} '{joint[:80]}' is not a joint.{listed}")
            if not hinges[joint].single:
                kind = hinges[joint].kind
                raise ModelError(
                    f"{element.where}: {key} '{joint}' is a {kind} joint; hinges and slides can "
                    "follow each other"
                )
        joints.append(joint)
    polynomial = element.several("polycoef", 1, 5, "0 1 0 0 0")
    coefficients = (*polynomial, *(0.0, 1.0, 0.0, 0.0, 0.0)[len(polynomial) :])
    follower, leader = joints
    refs = (hinges[str(follower)].ref, hinges[leader].ref if leader is not None else 0.0)
    return Law(name, element, str(follower), leader, coefficients, refs)


@dataclass(frozen=True)
class Parts:
    """Bodies, sites and joints that constraints may refer to.

    Attributes:
        scene: The model.
        bodies: By name of the file.
        drawn: Poses of bodies in the drawn configuration, in ground axes.
        sites: By name of the file: body and pose on it.
    """

    scene: SceneRecord
    bodies: dict[str, Body]
    drawn: dict[Body, Pose]
    sites: dict[str, tuple[Body, Pose]]

    def close(self, element: Element, name: str) -> None:
        """A <connect> or <weld>: a joint that closes a loop.

        Raises:
            ModelError: bodies or sites that do not exist, or both the same.
        """
        welds = element.raw.tag == "weld"
        sites = element.raw.get("site1") is not None or element.raw.get("site2") is not None
        ends = self._sites(element) if sites else self._bodies(element, welds)
        kind: JointElement = Fixed() if welds else Spherical()
        parent, child = (self._place(*end, welds) for end in ends)
        self.scene.joint(name, kind, parent, child, cut=True)

    def _place(self, body: Body, pose: Pose, with_rotation: bool) -> Place:
        turn = written(pose.rotation) if with_rotation else None
        if turn is None and not any(pose.position):
            return body
        return body.at(*pose.position, rotation=turn)

    def _sites(self, element: Element) -> list[tuple[Body, Pose]]:
        sites = []
        for key in ("site1", "site2"):
            name = element.text(key)
            if name not in self.sites:
                listed = near(name, self.sites).replace(" Known:", " Sites:")
                raise ModelError(f"{element.where}: {key} '{name[:80]}' is not a site.{listed}")
            sites.append(self.sites[name])
        return sites

    def _bodies(self, element: Element, welds: bool) -> list[tuple[Body, Pose]]:
        one = self._body(element, "body1", element.text("body1"))
        other = self._body(element, "body2", element.text("body2", "world"))
        relative = self.drawn[one].inverse().then(self.drawn[other])
        if not welds:
            x, y, z = element.numbers("anchor", 3)
            anchor = Pose(UPRIGHT, (x, y, z))
            return [(one, anchor), (other, relative.inverse().then(anchor))]
        # a quaternion of zeros means: as drawn
        px, py, pz, *quaternion = element.numbers("relpose", 7, "0 0 0 0 0 0 0")
        if any(quaternion):
            relative = Pose(of_quaternion(*quaternion), (px, py, pz))
        return [(one, relative), (other, HERE)]

    def _body(self, element: Element, key: str, name: str) -> Body:
        if name not in self.bodies:
            listed = near(name, self.bodies).replace(" Known:", " Bodies:")
            raise ModelError(f"{element.where}: {key} '{name[:80]}' is not a body.{listed}")
        return self.bodies[name]


def active(element: Element) -> bool:
    """True when a constraint acts from the start."""
    return chosen(element, "active", ("true", "false"), "true") == "true"
