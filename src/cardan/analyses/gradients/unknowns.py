"""What a motion is differentiated by: names of starts, parameters and inputs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from ...arrays import Array
from ...errors import ArgumentError, ModelError, brief, near
from ...records import dataclass
from ...runtime.models.loaded_model import LoadedModel
from ...runtime.models.node_names import nodes_last
from ..simulation.signals import Signals
from ..simulation.signals import signals as signals_of

BLOCKS = ("x0", "q0", "u0", "z0", "p")
Slope = float | Array


@dataclass(frozen=True)
class Unknowns:
    """Names by which a motion is differentiated.

    Attributes:
        model: Whose motion.
        names: As they were given.
        values: Inputs by name, as they were given.
    """

    model: LoadedModel
    names: tuple[str, ...]
    values: Mapping[str, object]

    @property
    def parameters(self) -> bool:
        """True where a parameter is among them."""
        parameters = self.model.parameters
        return "p" in self.names or any(name in parameters for name in self.names)

    def table(self, name: str) -> tuple[Array, Array] | None:
        """Times and values of an input that was given by them; None of another one."""
        value = self.values.get(name)
        if not isinstance(value, tuple | list):
            return None
        times, values = (np.asarray(one, dtype=float) for one in value)
        return times, values

    def slopes(
        self, start: Array, by_p: Array, signals: Signals, inputs: InputSlopes
    ) -> dict[str, Slope]:
        """Gradients by name.

        Args:
            start: Gradient by the start, along the speeds, by speeds, by internal states.
            by_p: By the parameters.
            signals: The inputs of the run.
            inputs: Gradients by them.
        """
        model, slopes = self.model, dict[str, Slope]()
        blocks, places = start_blocks(model), start_places(model)
        parameters = {name: k for k, name in enumerate(model.parameters)}
        for name in self.names:
            if name in blocks:
                slopes[name] = start[blocks[name]].copy()
            elif name == "p":
                slopes[name] = by_p.copy()
            elif name in places:
                part = start[places[name]]
                slopes[name] = float(part[0]) if len(part) == 1 else part.copy()
            elif name in parameters:
                slopes[name] = float(by_p[parameters[name]])
            else:
                slopes[name] = inputs.by_values(name, signals, self.values.get(name))
        return slopes


@dataclass(frozen=True)
class InputSlopes:
    """Gradients by inputs.

    Attributes:
        model: Whose.
        by_constants: By each as a constant (nr,).
        by_coefficients: By the coefficients (coefficients, 4) of those that are tabulated.
    """

    model: LoadedModel
    by_constants: Array
    by_coefficients: Sequence[Array]

    def by_values(self, name: str, signals: Signals, value: object) -> Slope:
        """Gradient by a constant, or by the values of a table (n,)."""
        place = self.model.inputs.index(name)
        tables = [k for k, one in enumerate(signals.tabulated) if one.input == place]
        if not tables or not isinstance(value, tuple | list):
            return float(self.by_constants[place])
        times = np.asarray(value[0], dtype=float)
        # coefficients are linear in the values: those of units are their derivatives
        rows, span = self.model.manifest.inputs, (float(times[0]), float(times[-1]))
        slope = np.zeros(len(times))
        for k in range(len(times)):
            unit = signals_of(rows, {name: (times, np.eye(len(times))[k])}, None, span)
            for one in unit.tabulated:
                at = next(i for i, s in enumerate(signals.tabulated) if s.input == one.input)
                slope[k] += float(np.sum(self.by_coefficients[at] * one.coefficients))
        return slope


def start_blocks(model: LoadedModel) -> dict[str, slice]:
    """Where ``x0``, ``q0``, ``u0`` and ``z0`` are in gradients by the start."""
    nu, end = model.nu, 2 * model.nu + model.nz
    parts = (slice(0, end), slice(0, nu), slice(nu, 2 * nu), slice(2 * nu, end))
    return dict(zip(("x0", "q0", "u0", "z0"), parts, strict=True))


def start_places(model: LoadedModel) -> dict[str, slice]:
    """Where ``q0.elbow``, ``u0.elbow.u``, ``z0.motor.current`` are in gradients by the start."""
    nu, places = model.nu, {}
    speeds = model._layout.places["u"]
    for joint in model.manifest.joints:
        if joint.u is not None and joint.u[1]:
            first, size = joint.u
            places[f"q0.{joint.name}"] = slice(first, first + size)
            places[f"u0.{joint.name}"] = slice(nu + first, nu + first + size)
            # an angle of a rotation is no direction of its speeds
            q = joint.q
            if q is not None and q[1] == size:
                for k in range(size):
                    places.setdefault(
                        f"q0.{model.coordinates[q[0] + k]}", slice(first + k, first + k + 1)
                    )
    for name, place in speeds.items():
        places.setdefault(f"u0.{name}", slice(nu + place.start, nu + place.stop))
    for k, name in enumerate(model.internals):
        places[f"z0.{name}"] = slice(2 * nu + k, 2 * nu + k + 1)
    return places


def listed(model: LoadedModel, places: Mapping[str, slice]) -> list[str]:
    """All names for people: of two names of one thing the shorter one, nodes of beams last."""
    short = {(x.start, x.stop): name for name, x in reversed(list(places.items()))}
    names = [*BLOCKS, *(name for name in places if name in short.values())]
    return nodes_last(model.manifest, [*names, *model.inputs, *model.parameters])


def unknowns(model: LoadedModel, wrt: object, values: Mapping[str, object]) -> Unknowns:
    """Checked names.

    Raises:
        ArgumentError: no names. ModelError: an unknown one.
    """
    names = (wrt,) if isinstance(wrt, str) else wrt
    if (
        not isinstance(names, tuple | list)
        or not names
        or not all(isinstance(n, str) for n in names)
    ):
        raise ArgumentError(
            f"gradient: wrt={brief(wrt)}: give names, such as ('x0', 'p', 'elbow.damping', 'tau')"
        )
    refuse_two_meanings("gradient: wrt", model, names)
    places = start_places(model)
    available = [*BLOCKS, *places, *model.parameters, *model.inputs]
    for name in names:
        if name not in available:
            raise ModelError(
                f"gradient: wrt: '{name}' is not a start (x0, q0, u0, z0, or one such as "
                f"'q0.{model.joints[0] if model.joints else 'elbow'}'), parameter or input."
                f"{near(name, listed(model, places))}"
            )
    return Unknowns(model, tuple(dict.fromkeys(names)), values)


def refuse_two_meanings(
    what: str, model: LoadedModel, names: Sequence[str], blocks: Sequence[str] = ()
) -> None:
    """Refuse names that a start, or all parameters, and a parameter or input have.

    Args:
        what: Who asks.
        model, names: Whose names.
        blocks: Names of blocks of functions that are taken too.

    Raises:
        ModelError: with the cure.
    """
    starts = {*BLOCKS, *start_places(model)}
    for listed, kind in ((model.parameters, "parameter"), (model.inputs, "input")):
        for name in names:
            if (name in starts or name in blocks) and name in listed:
                other = "a start of the motion" if name in starts else "a block of all functions"
                other = "all parameters" if name == "p" else other
                raise ModelError(
                    f"{what}: '{name}' is {other} and a {kind} of '{model.name}', and cannot be "
                    f"told from it: rename the {kind}"
                )
