"""Terms of the expressions of a scene: parameters, inputs, coordinates, motions of frames."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from typing import TYPE_CHECKING

from ..arguments import checked
from ..elements.forces.force import ForceElement
from ..elements.joints.joint import Joint as JointElement
from ..elements.joints.revolute import Revolute
from ..elements.joints.translation import Translation
from ..elements.quantity import Value
from ..errors import ModelError, near
from . import checks
from .beam import Beam, Cable
from .connections import Force, Joint
from .frame import Located, Place
from .parameters import Constraint, Declared, Output, Placeholder
from .units import unit as unit_of

if TYPE_CHECKING:
    import sympy

COMPONENTS = {1: ("",), 3: ("x", "y", "z"), 9: tuple(f"{i}{j}" for i in "xyz" for j in "xyz")}


class Vocabulary(ABC):
    """The declarations of a model; the model holds what is declared."""

    name: str
    joints: dict[str, Joint]
    beams: dict[str, Beam]
    cables: dict[str, Cable]
    forces: dict[str, Force]
    parameters: dict[str, Declared]
    inputs: dict[str, Declared]
    outputs: dict[str, Output]
    constraints: dict[str, Constraint]
    atoms: dict[str, Placeholder]

    @abstractmethod
    def place(self, who: str, place: Place | str, role: str = "frame") -> Place:
        """A frame or body of the model."""

    def parameter(self, name: str, value: float, unit: str | None = None) -> sympy.Symbol:
        """Declare a parameter.

        Args:
            name: Its name.
            value: Default value in the given unit.
            unit: Such as "kg" or "mm"; the value is converted to SI. Without one the parameter
                fits anywhere.

        Returns:
            Its SymPy symbol.

        Raises:
            ModelError: the name is taken, the value is not a finite number or the unit is unknown.
        """
        self._declare(self.parameters, "parameter", name, value, unit)
        return _symbol(name)

    def input(self, name: str, default: float = 0.0, unit: str | None = None) -> sympy.Symbol:
        """Declare an input: a control or a prescribed signal.

        Returns:
            Its SymPy symbol.

        Raises:
            ModelError: the name is taken, the default is not a finite number or the unit unknown.
        """
        self._declare(self.inputs, "input", name, default, unit)
        return _symbol(name)

    def _declare(
        self, where: dict[str, Declared], what: str, name: str, value: float, unit: str | None
    ) -> None:
        checks.name(what, name)
        if name == "t":
            raise ModelError(f"{what} 't': t is the time; choose another name")
        if name in self.parameters or name in self.inputs:
            raise ModelError(f"{what} '{name}': the name is taken by a parameter or an input")
        measured = unit_of("" if unit is None else unit)
        number = checks.number(f"{what} '{name}'", value) * measured.factor
        where[name] = Declared(name, number, measured.si, unit is not None)

    def output(self, name: str, expression: Value, unit: str = "") -> None:
        """Name an expression to be computed along with the motion.

        Args:
            unit: What the value is measured in, for the reader. It is computed in SI: an output
                declared in mm comes in m.

        Raises:
            ModelError: the name is taken or the unit unknown.
        """
        checks.new("output", name, self.outputs)
        checks.quantity(f"output '{name}'", expression)
        self.outputs[name] = Output(name, expression, unit_of(unit).si)

    def constraint(self, name: str, expression: Value, unit: str = "") -> None:
        """Keep an expression at 0: a relation between coordinates, frames or speeds, and t.

        An expression without speeds and velocities holds at position level and is differentiated;
        one with them must be linear in the speeds and holds at velocity level: it is
        nonholonomic, or said to be integrable. One that contains t or an input is rheonomic;
        the input then has a rate and an acceleration, like one that prescribes a motion.

        Args:
            name: Its name, that of its multiplier.
            expression: In coordinates (:meth:`q`), speeds (:meth:`u`), motions of frames and t.
            unit: What it is measured in, for the reader of residuals and multipliers.

        Raises:
            ModelError: the name is taken or the unit unknown.

        Source: Roberson and Schwertassek, Dynamics of Multibody Systems, chapter 5.
        """
        checks.new("constraint", name, self.constraints)
        if name in self.joints:
            raise ModelError(f"constraint '{name}': a joint has this name; rename one of them")
        if getattr(expression, "is_Relational", False) or isinstance(expression, bool):
            raise ModelError(
                f"constraint '{name}': an expression that is kept at 0 is wanted, not the "
                f"condition {expression}; write left side - right side"
            )
        checks.quantity(f"constraint '{name}'", expression)
        self.constraints[name] = Constraint(name, expression, unit_of(unit).si)

    @checked
    def q(self, coordinate: str) -> sympy.Symbol:
        """Symbol of a coordinate: ``"elbow"``, or ``"joint.angle"`` where there are several.

        Coordinates of written equations (:func:`cardan.from_sympy`) have names of their own.
        """
        return self._coordinate("q", coordinate, coordinate)

    @checked
    def u(self, speed: str) -> sympy.Symbol:
        """Symbol of a speed: ``"elbow"``, or ``"joint.x"`` where the joint has several.

        Its name in results, ``"elbow.u"`` or ``"joint.u.x"``, is taken too.
        """
        kinds = self.joint_kinds()
        if speed not in kinds:
            joints = [j for j in kinds if f"{speed}.".startswith(f"{j}.u.")]
            name = max(joints, key=len, default="")
            speed = name + speed[len(name) + 2 :] if name else speed
        joint, _, component = speed.partition(".")
        if speed in kinds:
            joint, component = speed, ""
        return self._coordinate("u", speed, f"{joint}.u" + (f".{component}" if component else ""))

    @checked
    def state(self, name: str) -> sympy.Symbol:
        """Symbol of a state that a force element keeps itself, such as ``"motor.force"``.

        Args:
            name: Of the element, a dot and the name of the state; the bare name of an element with
                one mode, such as a :class:`~cardan.Friction`.
        """
        self.atoms[name] = Placeholder("state", name, None, None, "")
        return _symbol(name)

    def joint_kinds(self) -> dict[str, JointElement]:
        """Kinds of the joints by name, those of released ends and of free rotors included."""
        released = (beam.releases() for beam in self.beams.values())
        named = {name: kind for kinds in released for name, kind in kinds.items()}
        nodes = (name for cable in self.cables.values() for name in cable.inner_nodes())
        named |= dict.fromkeys(nodes, Translation())
        rotors = {f"{n}.rotor": Revolute() for n, f in self.forces.items() if _turns(f.element)}
        return named | rotors | {name: joint.kind for name, joint in self.joints.items()}

    def _coordinate(self, quantity: str, full_name: str, symbol: str) -> sympy.Symbol:
        kinds = self.joint_kinds()
        for joint, kind in kinds.items():
            # names of written equations stand alone
            for part in kind.coordinates if quantity == "q" else kind.speeds:
                if part.alone and part.name == full_name:
                    self.atoms[full_name] = Placeholder(quantity, joint, None, None, full_name)
                    return _symbol(full_name)
        fitting = [j for j in kinds if full_name == j or full_name.startswith(j + ".")]
        name = max(fitting, key=len, default="")
        if not name:
            raise ModelError(f"{quantity}('{full_name}'): no such joint." + near(full_name, kinds))
        kind = kinds[name]
        parts = [c.name for c in (kind.coordinates if quantity == "q" else kind.speeds)]
        component = full_name[len(name) + 1 :]
        if component not in parts:
            components = [f"{name}.{c}" if c else name for c in parts]
            raise ModelError(
                f"{quantity}('{full_name}'): no such component." + near(full_name, components)
            )
        self.atoms[symbol] = Placeholder(quantity, name, None, None, component)
        return _symbol(symbol)

    def placeholders(
        self, place: Located, quantity: str, count: int, observers: Sequence[sympy.Symbol]
    ) -> list[sympy.Symbol]:
        """Symbols that stand for the motion of a frame, see :class:`Located`."""
        names = [
            self.place(f"{place.name}.{quantity}", o) if o is not None else "" for o in observers
        ]
        suffix = "".join(f"@{n}" if n else "" for n in names)
        if names[1] and not names[0]:
            suffix = "@" + suffix
        symbols = []
        for k, component in enumerate(COMPONENTS[count]):
            text = f"{place.name}.{quantity}{suffix}.{component}"
            self.atoms[text] = Placeholder(quantity, place, observers[0], observers[1], k)
            symbols.append(_symbol(text))
        return symbols


def _turns(element: ForceElement) -> bool:
    """True when an element has a rotor with a coordinate of its own."""
    rotor = element.rotor()
    return rotor is not None and rotor.ratio is None and rotor.speed is None


def _symbol(name: str) -> sympy.Symbol:
    from sympy import Symbol

    return Symbol(name)
