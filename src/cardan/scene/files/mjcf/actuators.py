"""Actuators of joints: inputs that push them, or that a built-in controller follows.

The force of an actuator is (g0 + g1 l + g2 v) ctrl + b0 + b1 l + b2 v, where l = gear q and v =
gear u; the joint feels gear times that. ``motor``, ``position`` and ``velocity`` are short for it.

Source: MuJoCo documentation, XML reference, actuator; Computation, actuation model.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping
from dataclasses import field
from typing import TYPE_CHECKING

from ....elements.forces.joint_force import JointForce
from ....errors import ModelError, near
from ....records import dataclass
from ...scene import SceneRecord
from ..document import Element
from .compiler import chosen
from .ignored import ACTUATORS, Unread
from .joints import Hinge

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element as XmlElement

GAINS, BIASES = ("fixed", "affine", "muscle", "user"), ("none", "affine", "muscle", "user")
DYNAMICS = ("none", "integrator", "filter", "filterexact", "muscle", "user")
READ_GAINS, READ_BIASES = ("fixed", "affine"), ("none", "affine")
RANGES = ("ctrl", "force")
MOST = 10  # numbers that MuJoCo keeps of a gain


def general(element: Element, defaults: Mapping[str, str]) -> dict[str, str]:
    """Attributes of an actuator in the words of <general>, with those of its class.

    Args:
        element: Of ``ACTUATORS``, its own attributes alone.
        defaults: Those of its class, in the words of <general>.

    Raises:
        ModelError: numbers that are none.
    """
    tag = element.raw.tag
    merged = {**defaults, **element.raw.attrib}
    if tag == "general":
        return merged
    base = Element(type(element.raw)("general", dict(defaults)), element.where)
    gain, bias = _numbers(base, "gainprm", "1"), _numbers(base, "biasprm", "0")
    merged |= {"gaintype": "fixed", "biastype": "none", "biasprm": "0"}
    if tag == "motor":
        return merged | {"gainprm": "1", "dyntype": "none"}
    merged["biastype"] = "affine"
    if tag == "velocity":
        kv = element.number("kv", repr(gain[0]))
        return merged | {"gainprm": repr(kv), "biasprm": f"0 0 {-kv!r}"}
    kp = element.number("kp", repr(gain[0]))
    kv = element.number("kv", repr(-bias[2]))
    if element.number("timeconst", "0"):
        merged["dyntype"] = "filterexact"
    return merged | {"gainprm": repr(kp), "biasprm": f"0 {-kp!r} {-kv!r}"}


def _numbers(element: Element, name: str, default: str) -> list[float]:
    """The first three numbers of a gain or bias."""
    return [*element.several(name, 1, MOST, default), 0.0, 0.0][:3]


@dataclass(frozen=True)
class Actuators:
    """Makes the actuators of a file.

    Attributes:
        scene: The model.
        hinges: Joints by name.
        unread: Collects what is passed over.
        idle: What of actuators does not act -> their names.
    """

    scene: SceneRecord
    hinges: Mapping[str, Hinge]
    unread: Unread
    idle: defaultdict[str, list[str]] = field(default_factory=lambda: defaultdict(list))

    def add(self, element: Element, raw: XmlElement, number: int) -> None:
        """An actuator on a joint with one coordinate becomes an input with its force.

        An input is not called like a joint, whose coordinate has the name: ``hip`` is ``hip.motor``
        then. Without a name it is ``motor0``, after its number in the file.

        Args:
            element: In the words of <general>, its class among them.
            raw: As it is in the file.

        Raises:
            ModelError: its joint does not exist, or an unknown type.
        """
        name = raw.get("name") or f"{raw.tag}{number}"
        why = self._refusal(element)
        if why:
            self.idle[f"{raw.tag} {why} is not read, so it does nothing"].append(name)
            return
        joint = self._joint(element)
        if not self.hinges[joint].single:
            self.idle[f"on a {self.hinges[joint].kind} joint it does nothing"].append(name)
            return
        self.unread.attributes(raw)
        self._ranges(element, name)
        if name in self.scene.joints or name == "t":
            name += f".{raw.tag}"
        scene, gear = self.scene, element.several("gear", 1, 6, "1")[0]
        control = scene.input(name)
        g, b = _numbers(element, "gainprm", "1"), _numbers(element, "biasprm", "0")
        if chosen(element, "gaintype", GAINS, "fixed") == "fixed":
            g[1:] = 0.0, 0.0
        if chosen(element, "biastype", BIASES, "none") == "none":
            b = [0.0, 0.0, 0.0]
        length = gear * scene.q(joint) if g[1] or b[1] else 0
        speed = gear * scene.u(joint) if g[2] or b[2] else 0
        gain = g[0] + g[1] * length + g[2] * speed
        force = (control if gain == 1 else gain * control) + b[1] * length + b[2] * speed
        force = force + b[0] if b[0] else force
        scene.force(name, JointForce(joint, force if gear == 1 else gear * force))

    def _joint(self, element: Element) -> str:
        """The joint that it acts on."""
        for key in ("joint", "jointinparent"):
            joint = element.raw.get(key)
            if joint is not None:
                if joint not in self.hinges:
                    listed = near(joint, self.hinges).replace(" Known:", " Joints:")
                    raise ModelError(
                        f"{element.where}: {key} '{joint[:80]}' does not exist.{listed}"
                    )
                return joint
        raise AssertionError

    def _refusal(self, element: Element) -> str:
        """The part of an actuator that is not read, "" where all is."""
        raw = element.raw
        if raw.tag not in ACTUATORS:
            return "actuator"
        if raw.get("joint") is None and raw.get("jointinparent") is None:
            other = next((k for k in ("tendon", "site", "cranksite", "body") if raw.get(k)), "")
            return f"on a {other or 'joint without name'}"
        if raw.tag == "position" and raw.get("dampratio") is not None:
            return "with dampratio (give kv)"
        attributes = (
            ("dyntype", DYNAMICS, ("none",), "none"),
            ("gaintype", GAINS, READ_GAINS, "fixed"),
            ("biastype", BIASES, READ_BIASES, "none"),
        )
        for name, choices, accepted, default in attributes:
            word = chosen(element, name, choices, default)
            if word not in accepted:
                return f"with {name} {word}"
        return ""

    def _ranges(self, element: Element, name: str) -> None:
        """Ranges of control and force, which do not act."""
        for what in RANGES:
            limited = chosen(element, f"{what}limited", ("auto", "true", "false"), "auto")
            if element.raw.get(f"{what}range") is None or limited == "false":
                continue
            low, high = element.numbers(f"{what}range", 2)
            cure = "keep the input inside" if what == "ctrl" else "the force has no bounds"
            if low < high:
                self.idle[f"{what}range does not act; {cure}"].append(f"{name} ({low:g}, {high:g})")

    def notes(self) -> list[str]:
        """Notes on what does not act, with the names of the actuators."""
        return [f"actuators {', '.join(names)}: {what}" for what, names in self.idle.items()]
