"""FMI 3.0: variables by their value reference, the sources in ``buildDescription.xml``.

Source: Modelica Association, Functional Mock-up Interface 3.0.
"""

from __future__ import annotations

from ..variables import Variable
from ..xml import Element
from .version import Structure, Unknown, Version, common, value


def _variable(one: Variable) -> Element:
    derivative = {"derivative": str(one.state.reference)} if one.state else {}
    return Element("Float64", {**common(one), **value(one), **derivative})


def _unknown(tag: str, one: Unknown) -> Element:
    on = one.dependencies
    return Element(
        tag,
        {
            "valueReference": str(one.variable.reference),
            "dependencies": None if on is None else " ".join(str(x.reference) for x in on),
        },
    )


def _structure(s: Structure) -> list[Element]:
    return [
        *(_unknown("Output", one) for one in s.outputs),
        *(_unknown("ContinuousStateDerivative", one) for one in s.rates),
        *(_unknown("InitialUnknown", one) for one in s.initial),
        *(_unknown("EventIndicator", one) for one in s.indicators),
    ]


VERSION = Version(
    name="3.0",
    sources=("fmi3.c", "fmi3_simulation.c"),
    headers=("fmi3Functions.h", "fmi3FunctionTypes.h", "fmi3PlatformTypes.h"),
    token="instantiationToken",
    platforms={
        "linux": "x86_64-linux",
        "linux-aarch64": "aarch64-linux",
        "windows": "x86_64-windows",
        "macos": "aarch64-darwin",
        "macos-x86_64": "x86_64-darwin",
    },
    abilities={"canGetAndSetFMUState": "true", "canSerializeFMUState": "true"},
    exchanging={"needsCompletedIntegratorStep": "true"},
    stepping={"canHandleVariableCommunicationStepSize": "true"},
    derivatives={"providesDirectionalDerivatives": "true", "providesAdjointDerivatives": "true"},
    variable=_variable,
    structure=_structure,
    listing=False,
)
