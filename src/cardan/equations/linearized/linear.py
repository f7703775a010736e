"""``equations.linearize``: from a reference motion to a linear model."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import Any

from ...arguments import checked
from ...errors import DerivationError, near
from ...processes import collector_paused
from ..record import EquationRecord
from . import differentiated, from_start
from .first_order import plant
from .record import Linearized
from .reduced import reduced
from .reference import Reference

ROUTES = {"from_start": from_start.full_matrices, "differentiated": differentiated.full_matrices}


def linearized(
    equations: EquationRecord,
    motion: Mapping[str, Any],
    values: Mapping[str, float] | None,
    inputs: Iterable[str] | None,
    outputs: Iterable[str] | None,
    independent: Iterable[str] | None,
    route: str,
) -> Linearized:
    """See :meth:`cardan.equations.linearized.linear.Linearizable.linearize`."""
    if route not in ROUTES:
        raise DerivationError(f"linearize: there is no route '{route}'.{near(route, ROUTES)}")
    with collector_paused():
        at = Reference(equations, **motion, values=values or {}, independent=independent)
        full = ROUTES[route](at)
        small = reduced(at, full)
        plant_matrices = plant(at, full, small, inputs, outputs)
    states = (*(at.increments[k] for k in at.y), *(at.names["u"][k] for k in at.w), *at.names["z"])

    def again(requested: list[str]) -> Linearized:
        return linearized(equations, motion, values, inputs, outputs, requested, route)

    name = equations.system.name
    return Linearized(
        name,
        states,
        plant_matrices.inputs,
        plant_matrices.outputs,
        route,
        at,
        full,
        small,
        plant_matrices,
        again,
    )


class Linearizable(EquationRecord):
    """Equations that can be linearized."""

    @checked
    def linearize(
        self,
        q: Mapping[str, object] | None = None,
        u: Mapping[str, object] | None = None,
        *,
        udot: Mapping[str, object] | str | None = None,
        z: Mapping[str, object] | None = None,
        r: Mapping[str, object] | None = None,
        s: Mapping[str, object] | None = None,
        t: float | None = None,
        values: Mapping[str, float] | None = None,
        inputs: Iterable[str] | None = None,
        outputs: Iterable[str] | None = None,
        independent: Iterable[str] | None = None,
        route: str = "from_start",
    ) -> Linearized:
        """The linear model about a reference motion as formulas, constraints eliminated.

        Args:
            q, u: The reference by name, numbers or SymPy expressions in parameters, ``t`` and other
                symbols; coordinates left out are initial values, which are assembled where
                loops are open, speeds 0 or what follows from the others.
            udot: Accelerations of the reference by name, 0 if left out: about steady motions, and
                positions that forces hold, which ``needed`` names. ``"free"``: those of the motion
                that goes through the state by itself, about which ``model.linearize`` is.
            z, r, s: Internal states, inputs, modes by name; their defaults if left out.
            t: Time [s] at which forces and motions that depend on it are taken; if left out ``t``
                stays a symbol, but 0 where it moves loops.
            values: Numbers for symbols of the reference, by name.
            inputs: Inputs, or speeds and joints along which a force acts; all inputs if left out.
            outputs: Outputs, coordinates and speeds; if left out the declared outputs, or all
                coordinates if there are none.
            independent: Coordinates or speeds from which the others are to follow; by default what
                describes the motions best, as ``model.linearize`` chooses.
            route: ``"from_start"``: every quantity is its nominal part and a part of first order
                from the start; ``"differentiated"``: the nonlinear equations are differentiated.

        Raises:
            DerivationError: unknown names, loops that stay open, speeds that constraints forbid.

        Warns:
            ModelWarning: ``udot`` is left out; a reference of numbers is not a motion by itself.

        Source: R. E. Roberson, R. Schwertassek, Dynamics of Multibody Systems (1988), chapter 13.
        """
        if t is not None and not math.isfinite(t):
            raise DerivationError(f"linearize: t={t:g}: give a finite time [s]")
        named = {"q": q or {}, "u": u or {}, "z": z or {}, "r": r or {}, "s": s or {}}
        motion = {**named, "udot": udot or {}, "t": t}
        linear = linearized(self, motion, values, inputs, outputs, independent, route)
        if udot is None:
            linear._warn_if_forced()
        return linear
