"""Requirements of the integrators on a model: a table of the conditions that their records name."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from ...errors import ModelError
from ...runtime.models.loaded_model import LoadedModel
from ...schema.integrators import Integrator
from .alpha_methods import Alpha
from .energy_momentum import conservative

# constraints are oscillators of infinite frequency: what does not damp them lets errors grow
MOST = 0.95
# events that leave the motion as it is: they are noted, or end it
NOTED = ("mark", "halt")


def suited(model: LoadedModel, method: Integrator) -> tuple[Integrator, str]:
    """A method as it is for a model, and what there is to say about it.

    Raises:
        ModelError: the model is not one for it.
    """
    said = ""
    for name in method.conditions:
        method, more = CONDITIONS[name](model, method)
        # what was chosen for the model is said first, and alone
        said = said or more
    return method, said


def _damping_capped(model: LoadedModel, method: Integrator) -> tuple[Integrator, str]:
    """With constraints rho_inf is at most what damps them."""
    if not model.nlam or Alpha(*method.options[:4]).rho_inf <= MOST:
        return method, ""
    capped = Alpha.chung_hulbert(MOST)
    options = (capped.am, capped.af, capped.beta, capped.gamma, *method.options[4:])
    reason = f"rho_inf {MOST:g} as constraints ask for damping"
    return replace(method, options=options), reason


def _assembled(model: LoadedModel, method: Integrator) -> tuple[Integrator, str]:
    """Tangents of elements in tables are assembled where the elements are."""
    needs = method.called(model.manifest.absolute, bool(model.manifest.z))
    return (method if needs == method.needs else replace(method, needs=needs)), ""


def _joint_speeds(model: LoadedModel, method: Integrator) -> tuple[Integrator, str]:
    """Nobody chose other speeds than those of the joints."""
    if not model._layout.of_joints:
        raise ModelError(
            f"method '{method.name}' moves along the speeds of the joints, and those of model "
            f"'{model.name}' were chosen: derive without speeds="
        )
    return method, ""


def _increments(model: LoadedModel, method: Integrator) -> tuple[Integrator, str]:
    """Increments along the speeds are the unknowns of a step over elements."""
    return _joint_speeds(model, method) if model.manifest.absolute else (method, "")


def _user_constraints(model: LoadedModel, method: Integrator) -> tuple[Integrator, str]:
    """The model leaves its constraints to the method."""
    if model.nlam and not model.manifest.projected:
        treatment = model.manifest.treatment
        raise ModelError(
            f"method '{method.name}' keeps constraints itself, and model '{model.name}' has "
            f"constraints='{treatment}': compile with constraints='multipliers'"
        )
    return method, ""


def _damped(model: LoadedModel, method: Integrator) -> tuple[Integrator, str]:
    """Replace the coefficients by damping ones where there are constraints."""
    alpha, index = Alpha(*method.options[:4]), int(method.options[4])
    newton = ", full Newton steps" if method.options[5] else ""
    if not model.nlam:
        return method, f"rho_inf {alpha.rho_inf:.3g}{newton}"
    if alpha.rho_inf > MOST + 1e-9:
        raise ModelError(
            f"method '{method.name}' with {alpha} keeps {alpha.rho_inf:.3g} of an error of the "
            f"constraints of model '{model.name}' in every step: it needs damping, at most "
            f"{MOST:g}, such as cd.GeneralizedAlpha(rho_inf=0.8) or cd.stability.Alpha.hht(-0.1)"
        )
    return method, f"rho_inf {alpha.rho_inf:.3g}, index {index}{newton}"


def _in_elements(model: LoadedModel, method: Integrator) -> tuple[Integrator, str]:
    """The model is in absolute coordinates."""
    if not model.manifest.absolute:
        raise ModelError(
            f"method '{method.name}' moves bodies as such, and model '{model.name}' is in relative "
            "coordinates: cd.compile(scene, coordinates='absolute'), or method='EnergyMidpoint'"
        )
    return method, ""


def _nothing_discrete(model: LoadedModel, method: Integrator) -> tuple[Integrator, str]:
    """There is nothing but motion: no internal states, modes or events that change it."""
    rows = model.manifest
    changes = [row for row in rows.events if row.kind not in NOTED]
    for present, what in ((rows.z, "internal states"), (rows.s, "modes"), (changes, "events")):
        if present:
            raise ModelError(
                f"method '{method.name}' keeps what is conserved, and model '{model.name}' has "
                f"{what}: take method='auto'"
            )
    return method, ""


CONDITIONS: dict[str, Callable[[LoadedModel, Integrator], tuple[Integrator, str]]] = {
    "damping_capped": _damping_capped,
    "assembled": _assembled,
    "joint_speeds": _joint_speeds,
    "increments": _increments,
    "own_constraints": _user_constraints,
    "damped": _damped,
    "in_elements": _in_elements,
    "nothing_discrete": _nothing_discrete,
    "conservative": conservative,
}
