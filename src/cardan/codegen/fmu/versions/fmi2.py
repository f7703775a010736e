"""FMI 2.0: variables by their index, ``<SourceFiles>`` in the description.

Source: Modelica Association, Functional Mock-up Interface for Model Exchange and Co-Simulation,
version 2.0.4.
"""

from __future__ import annotations

from collections.abc import Iterable

from ..variables import Variable
from ..xml import Element
from .version import Structure, Unknown, Version, common, value


def _index(one: Variable) -> str:
    """Place in the list of variables, from 1."""
    return str(one.reference + 1)


def _variable(one: Variable) -> Element:
    derivative = {"derivative": _index(one.state)} if one.state else {}
    return Element("ScalarVariable", common(one), [Element("Real", {**value(one), **derivative})])


def _unknowns(tag: str, unknowns: Iterable[Unknown]) -> list[Element]:
    listed = [
        Element(
            "Unknown",
            {
                "index": _index(one.variable),
                "dependencies": None
                if one.dependencies is None
                else " ".join(map(_index, one.dependencies)),
            },
        )
        for one in unknowns
    ]
    return [Element(tag, {}, listed)] if listed else []


def _structure(s: Structure) -> list[Element]:
    return [
        *_unknowns("Outputs", s.outputs),
        *_unknowns("Derivatives", s.rates),
        *_unknowns("InitialUnknowns", s.initial),
    ]


VERSION = Version(
    name="2.0",
    sources=("fmi2.c",),
    headers=("fmi2Functions.h", "fmi2FunctionTypes.h", "fmi2TypesPlatform.h"),
    token="guid",
    platforms={"linux": "linux64", "windows": "win64", "macos-x86_64": "darwin64"},
    abilities={"canGetAndSetFMUstate": "true", "canSerializeFMUstate": "true"},
    exchanging={"completedIntegratorStepNotNeeded": "false"},
    stepping={"canHandleVariableCommunicationStepSize": "true", "canInterpolateInputs": "true"},
    derivatives={"providesDirectionalDerivative": "true"},
    variable=_variable,
    structure=_structure,
    listing=True,
    root=lambda indicators: {"numberOfEventIndicators": str(indicators)},
)
