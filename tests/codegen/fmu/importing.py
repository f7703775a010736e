"""FMUs of the scenes, each built once, and one way to drive both versions of FMI by fmpy."""

from __future__ import annotations

import ctypes
from collections.abc import Iterable, Mapping, Sequence
from functools import cache
from pathlib import Path
from tempfile import mkdtemp
from typing import Any

import numpy as np
import pytest

import cardan as cd
from codegen.fmu.scenes import CASES

fmpy = pytest.importorskip("fmpy")
pytest.importorskip("fmpy.simulation")
VERSIONS = ("3.0", "2.0")
TYPES = {"cs": "CoSimulation", "me": "ModelExchange"}


@cache
def folder() -> Path:
    return Path(mkdtemp(prefix="cardan-fmu-test-"))


@cache
def equations_of(name: str) -> Any:
    return cd.derive(CASES[name].build())


@cache
def model_of(name: str) -> cd.CompiledModel:
    return cd.compile(equations_of(name))


@cache
def unit(name: str, version: str = "3.0") -> Path:
    """The FMU of a scene."""
    case, path = CASES[name], folder() / f"{name}_{version}.fmu"
    start = {"q": dict(case.q) or None, "u": dict(case.u) or None}
    made: Path = equations_of(name).export(path, fmi=version, **start)
    return made


@cache
def description(path: Path) -> Any:
    return fmpy.read_model_description(str(path), validate=False)


@cache
def unpacked(path: Path) -> str:
    return str(fmpy.extract(str(path), mkdtemp(prefix="cardan-fmu-unpacked-")))


class Instance:
    """An instance of an FMU, by names of variables.

    Args:
        path: Of the FMU.
        kind: ``"cs"`` or ``"me"``.
    """

    def __init__(self, path: Path, kind: str = "cs") -> None:
        self.about, self.messages = description(path), list[str]()
        self.three = self.about.fmiVersion.startswith("3")
        self.fmu = fmpy.simulation.instantiate_fmu(
            unpacked(path),
            self.about,
            TYPES[kind],
            debug_logging=True,
            logger=lambda *given: self.messages.append(_text(given[-1])),
        )
        self.references = {v.name: v.valueReference for v in self.about.modelVariables}

    def __enter__(self) -> Instance:
        return self

    def __exit__(self, *_: object) -> None:
        self.fmu.freeInstance()

    def enter(self, tolerance: float | None = None, stop: float | None = None) -> Instance:
        """Enter the initialization."""
        if self.three:
            self.fmu.enterInitializationMode(tolerance=tolerance, startTime=0.0, stopTime=stop)
        else:
            self.fmu.setupExperiment(tolerance=tolerance, startTime=0.0, stopTime=stop)
            self.fmu.enterInitializationMode()
        return self

    def begin(self, tolerance: float | None = None, stop: float | None = None) -> Instance:
        """Go through the initialization, and to where the motion begins."""
        self.enter(tolerance, stop)
        self.fmu.exitInitializationMode()
        return self

    def update(self) -> tuple[Any, ...]:
        """What happens now: needs update, terminate, nominals, values changed, next time."""
        names = "updateDiscreteStates" if self.three else "newDiscreteStates"
        return tuple(getattr(self.fmu, names)())

    def get(self, *names: str) -> list[float]:
        references = [self.references[name] for name in names]
        call = self.fmu.getFloat64 if self.three else self.fmu.getReal
        return list(call(references))

    def set(self, values: Mapping[str, float]) -> None:
        references = [self.references[name] for name in values]
        call = self.fmu.setFloat64 if self.three else self.fmu.setReal
        call(references, list(values.values()))

    def step(self, t: float, h: float) -> Any:
        return self.fmu.doStep(currentCommunicationPoint=t, communicationStepSize=h)

    def derivative(
        self, unknowns: Sequence[str], knowns: Sequence[str], seed: Sequence[float]
    ) -> np.ndarray:
        a, b = ([self.references[name] for name in names] for names in (unknowns, knowns))
        return np.array(self.fmu.getDirectionalDerivative(a, b, list(seed)))

    def states(self) -> np.ndarray:
        """The continuous states, of model exchange."""
        x = np.zeros(len(self.state_names()))
        self.fmu.getContinuousStates(_pointer(x), len(x))
        return x

    def set_states(self, x: Iterable[float]) -> None:
        array = np.array(list(x), dtype=float)
        self.fmu.setContinuousStates(_pointer(array), len(array))

    def rates(self) -> np.ndarray:
        dx = np.zeros(len(self.state_names()))
        call = self.fmu.getContinuousStateDerivatives if self.three else self.fmu.getDerivatives
        call(_pointer(dx), len(dx))
        return dx

    def state_names(self) -> list[str]:
        return [v.derivative.name for v in self.about.modelVariables if v.derivative]

    def outputs(self) -> list[str]:
        return [v.name for v in self.about.modelVariables if v.causality == "output"]

    def save(self) -> Any:
        return self.fmu.getFMUState() if self.three else self.fmu.getFMUstate()

    def restore(self, state: Any) -> None:
        (self.fmu.setFMUState if self.three else self.fmu.setFMUstate)(state)

    def free(self, state: Any) -> None:
        (self.fmu.freeFMUState if self.three else self.fmu.freeFMUstate)(state)

    def bytes_of(self, state: Any) -> bytes:
        call = self.fmu.serializeFMUState if self.three else self.fmu.serializeFMUstate
        return bytes(call(state))

    def state_of(self, content: bytes) -> Any:
        call = self.fmu.deserializeFMUState if self.three else self.fmu.deSerializeFMUstate
        return call(content)


def _pointer(x: np.ndarray) -> Any:
    return x.ctypes.data_as(ctypes.POINTER(ctypes.c_double))


def _text(message: object) -> str:
    return message.decode() if isinstance(message, bytes) else str(message)


def names_of(name: str) -> list[str]:
    """Coordinates, speeds and outputs of a scene."""
    model = model_of(name)
    return [*model.coordinates, *model.speeds, *(row.name for row in model.manifest.outputs)]


def simulated(name: str, times: np.ndarray, rtol: float) -> np.ndarray:
    """What ``simulate`` says of them (nt, n)."""
    case = CASES[name]
    motion = model_of(name).simulate(
        times,
        q=dict(case.q),
        u=dict(case.u),
        inputs=dict(case.inputs),
        rtol=rtol,
        method="Radau" if case.elements else "DOP853",
    )
    return np.array([motion[one] for one in names_of(name)]).T


def played(
    path: Path, kind: str, name: str, times: np.ndarray, rtol: float
) -> tuple[np.ndarray, list[str]]:
    """What fmpy says of them, behind the events of a time (nt, n), and messages of the FMU."""
    messages: list[str] = []
    rows = fmpy.simulate_fmu(
        str(path),
        fmi_type=TYPES[kind],
        stop_time=float(times[-1]),
        output_interval=float(times[1] - times[0]),
        relative_tolerance=rtol,
        output=names_of(name),
        start_values=dict(CASES[name].inputs),
        logger=lambda *given: messages.append(_text(given[-1])),
    )
    at = [int(np.flatnonzero(np.abs(rows["time"] - t) < 1e-9)[-1]) for t in times]
    return np.array([rows[one][at] for one in names_of(name)]).T, messages


def problems(path: Path) -> list[str]:
    """What fmpy finds wrong with an FMU."""
    from fmpy.validation import validate_fmu

    return list(validate_fmu(str(path)))
