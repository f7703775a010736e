"""``fmu_model.c``: the variables of an FMU as one constant for the core."""

from __future__ import annotations

from collections.abc import Sequence

from ...schema.manifest import Manifest
from ..export.constants import Constants, Name, Value
from ..program.naming import comment
from .slopes import FUNCTIONS, Slopes
from .variables import KINDS, SIGNED, Variable, of_kind


def text(
    manifest: Manifest,
    variables: Sequence[Variable],
    slopes: Slopes,
    token: str,
    kinds: Sequence[str],
    experiment: tuple[float, float],
) -> str:
    """The file.

    Args:
        manifest: Of the model.
        variables: By their references.
        slopes: Derivatives.
        token: Of the FMU.
        kinds: ``"me"``, ``"cs"``.
        experiment: Duration [s] and tolerance where none are asked for.
    """
    c = Constants(
        "/*",
        f" * fmu_model.c: the variables of the FMU of model '{comment(manifest.name)}'.",
        " */",
        '#include "functions.h"',
        '#include "fmu_core.h"',
    )
    c.say("names by value reference")
    names = c.records("char *const", "variable_names", [v.name for v in variables])
    beyond = [f"{row.beyond} ('{row.element}')" if row.beyond else None for row in manifest.events]
    signs = [k for k, row in enumerate(manifest.events) if row.kind in SIGNED]
    exchange = "me" in kinds
    c.say("all that the core must know")
    fields: dict[str, Value] = {
        "scene": Name("&cardan_scene"),
        "token": token,
        "exchange": int(exchange),
        "simulates": int("cs" in kinds),
        "names": names,
        "blocks": _blocks(variables),
        "slopes": _slopes(variables, slopes),
        "beyond": c.records("char *const", "beyond", beyond) if any(beyond) else None,
        "indicators": c.numbers("indicators", signs, "ptrdiff_t") if exchange else None,
        "limits": c.records("fmu_limit", "limits", limits(manifest)),
        "limit_count": len(limits(manifest)),
        "duration": float(experiment[0]),
        "tolerance": float(experiment[1]),
    }
    c.record("const fmu_model cardan_fmu", fields)
    return c.text


def _blocks(variables: Sequence[Variable]) -> Value:
    """First reference and number of the variables of every kind."""
    first, entries = 0, []
    for kind in KINDS:
        count = len(of_kind(variables, kind.name))
        entries.append(f"[FMU_{kind.name.upper()}] = {{{first}, {count}}}")
        first += count
    return Name("{" + ", ".join(entries) + "}")


def _slopes(variables: Sequence[Variable], slopes: Slopes) -> Value:
    """Functions of every kind, and of their derivatives."""
    entries = []
    for kind in ("state", *FUNCTIONS):
        functions = {
            "function": FUNCTIONS.get(kind) if of_kind(variables, kind) else None,
            "by_state": slopes.by_state.get(kind),
            "by_parameters": slopes.by_parameters.get(kind),
        }
        texts = [f'.{name} = "{value}"' for name, value in functions.items() if value]
        if texts:
            entries.append(f"[FMU_{kind.upper()}] = {{{', '.join(texts)}}}")
    return Name("{" + ", ".join(entries or ["{0}"]) + "}")


def limits(manifest: Manifest) -> list[Value]:
    """Limits of parameters, but for those that are other parameters."""
    places = {row.name: k for k, row in enumerate(manifest.parameters)}
    return [
        {
            "parameter": places[row.parameter],
            "scale": float(row.scale),
            "least": Name("-HUGE_VAL") if row.least is None else float(row.least),
            "most": Name("HUGE_VAL") if row.most is None else float(row.most),
            "open": int(row.open),
            "below": int(row.below),
            "nonzero": int(row.nonzero),
        }
        for row in manifest.limits
        if row.parameter in places and not isinstance(row.least, str)
    ]
