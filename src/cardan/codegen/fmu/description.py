"""``modelDescription.xml`` and ``buildDescription.xml``: one writer for all versions of FMI."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ...records import dataclass
from ...version import VERSION
from . import units
from .variables import Variable, of_kind
from .versions import Version
from .versions.version import Structure, Unknown
from .xml import Element, document

CATEGORIES = {
    "logEvents": "events and samples, with their times",
    "logStatusWarning": "what is odd",
    "logStatusDiscard": "why a step or a value could not be computed",
    "logStatusError": "why a call was refused",
}
KINDS = {"me": "ModelExchange", "cs": "CoSimulation"}


@dataclass(frozen=True)
class FmuContent:
    """Contents of the description of a model.

    Attributes:
        name: Of the model; identifier: of its binaries.
        token: Binds description and binaries.
        kinds: ``"me"``, ``"cs"``.
        variables: By their references.
        dependencies: References of what an unknown depends on, by its own; not there: on anything.
        derivatives: Whether there are directional derivatives.
        sources: Names of the C files to compile.
        duration, tolerance: The default experiment.
    """

    name: str
    identifier: str
    token: str
    kinds: Sequence[str]
    variables: Sequence[Variable]
    dependencies: Mapping[int, Sequence[int]]
    derivatives: bool
    sources: Sequence[str]
    duration: float
    tolerance: float


def model_description(d: FmuContent, version: Version) -> str:
    """The text of ``modelDescription.xml``."""
    indicators = len(of_kind(d.variables, "indicator"))
    root: dict[str, str | None] = {
        "fmiVersion": version.name,
        "modelName": d.name,
        version.token: d.token,
        "description": "multibody model, written by cardan",
        "generationTool": f"cardan {VERSION}",
        "variableNamingConvention": "flat",
        **version.root(indicators),
    }
    experiment: dict[str, str | None] = {
        "startTime": "0",
        "stopTime": repr(d.duration),
        "tolerance": repr(d.tolerance),
    }
    categories = [Element("Category", {"name": k, "description": x}) for k, x in CATEGORIES.items()]
    return document(
        Element(
            "fmiModelDescription",
            root,
            [
                *_interfaces(d, version),
                Element(
                    "UnitDefinitions", {}, units.definitions(v.unit for v in d.variables if v.unit)
                ),
                Element("LogCategories", {}, categories),
                Element("DefaultExperiment", experiment),
                Element("ModelVariables", {}, [version.variable(v) for v in d.variables]),
                Element("ModelStructure", {}, version.structure(structure(d))),
            ],
        )
    )


def _interfaces(d: FmuContent, version: Version) -> list[Element]:
    """Abilities, one element per kind of FMU."""
    files = [Element("File", {"name": name}) for name in d.sources]
    listing = [Element("SourceFiles", {}, files)] if version.listing else []
    extra = version.derivatives if d.derivatives else {}
    return [
        Element(
            KINDS[kind],
            {
                "modelIdentifier": d.identifier,
                **version.abilities,
                **(version.stepping if kind == "cs" else version.exchanging),
                **extra,
            },
            listing,
        )
        for kind in KINDS
        if kind in d.kinds
    ]


def structure(d: FmuContent) -> Structure:
    """Unknowns, with what they depend on."""
    exchange = "me" in d.kinds

    def unknown(one: Variable) -> Unknown:
        on = d.dependencies.get(one.reference)
        return Unknown(one, None if on is None else [d.variables[k] for k in on])

    rates = of_kind(d.variables, "rate") if exchange else []
    computed = [v for v in d.variables if v.kind.causality == "output"]
    states = [v for v in of_kind(d.variables, "state") if v.kind.initial != "exact"]
    first = {v.reference: v for v in (*states, *computed, *rates) if v.kind.initial != "exact"}
    return Structure(
        [unknown(v) for v in computed],
        [unknown(v) for v in rates],
        [unknown(v) for v in of_kind(d.variables, "indicator")],
        [Unknown(v) for _, v in sorted(first.items())],
    )


def build_description(d: FmuContent, version: Version) -> str:
    """The text of ``buildDescription.xml``: how to compile the sources."""
    files = [Element("SourceFile", {"name": name}) for name in d.sources]
    sets = Element("SourceFileSet", {"language": "C99"}, files)
    libraries = [Element("Library", {"name": "m", "external": "true"})]
    configuration = Element(
        "BuildConfiguration", {"modelIdentifier": d.identifier}, [sets, *libraries]
    )
    return document(Element("fmiBuildDescription", {"fmiVersion": version.name}, [configuration]))
