"""cardan: a compiler for multibody mechanics.

From a scene to equations of motion, to C, to fast simulation::

    import cardan as cd

    scene = cd.Scene("pendulum", gravity=(0, 0, -9.81))
    rod = scene.body("rod", mass=1, com=(0, 0, -0.5), inertia=cd.inertia.rod(1, 1, axis="z"))
    scene.joint("pivot", cd.Revolute("y"), scene.ground, rod)
    motion = cd.compile(scene).simulate(10.0, q={"pivot": 1.0})
"""

from __future__ import annotations

from importlib import import_module
from typing import Any

from . import notebooks
from .version import VERSION

__version__ = VERSION

# public name -> module that holds it (None: the module itself), in the order of use
_PUBLIC: dict[str, str] = {
    "Scene": "api.scene",
    "load": "api.scene_file",
    "examples": "api.scene_file",
    "from_dh": "scene.dh",
    "from_sympy": "scene.sympy_import",
    "t": "scene",
    "inertia": "scene.inertia",
    "shape": "scene.shape",
    "orbit": "scene.orbit",
    "table": "elements.tables",
    "section": "elements.sections",
    "material": "elements.material",
    "arc": "elements.centerlines",
    "spline": "elements.centerlines",
    "superelement": "api.superelement",
    "derive": "pipeline",
    "compile": "compilation",
    "page": "live",
    "CFunction": "analyses.simulation.input_functions",
    "GeneralizedAlpha": "analyses.simulation.alpha_methods",
    "constraints": "equations.constraints.treatments",
    "stability": "analyses.simulation.precision.method_stability",
    "Equations": "api.equations",
    "vectors": "equations.reading.vectors",
    "CompiledModel": "api.compiled_model",
    "load_model": "api.saved_model",
    "excitation": "analyses.identification.excitation",
    "identify": "analyses.identification.identify",
    "convert": "analyses.conversion.convert",
    "sample": "analyses.ensembles.sampling",
    "parts": "parts",
    "Ensemble": "api.results",
    "Trajectory": "api.trajectory",
    "load_motion": "runtime.trajectory.storage",
    "load_ensemble": "analyses.ensembles.ensemble_file",
    "load_linear": "analyses.linear.linear_file",
    "cost": "schema.cost",
    **dict.fromkeys(
        (
            "CardanError",
            "ModelError",
            "TopologyError",
            "DerivationError",
            "CodegenError",
            "BuildError",
            "CompilerMissing",
            "ArgumentError",
            "FunctionError",
            "SolveError",
            "ModelWarning",
            "BuildWarning",
            "SolveWarning",
        ),
        "errors",
    ),
}
# families whose members are public by the names of their classes: module -> table of them
_FAMILIES = {"elements.joints": "JOINTS", "elements.forces": "FORCES"}
# functions of lower rooms whose results have verbs
_FACED = frozenset(
    {
        *("from_dh", "from_sympy", "excitation", "identify"),
        *("load_motion", "load_ensemble", "load_linear"),
    }
)
_MODULES = frozenset(
    {
        *("constraints", "convert", "inertia", "orbit", "parts", "sample", "section", "shape"),
        *("stability", "superelement"),
    }
)
_RENAMED = dict.fromkeys(("load_model", "load_motion", "load_ensemble", "load_linear"), "load")

# what pickles name, for ever -> module that holds it
_PICKLED = {"_unpickled_model": "api.saved_model", "_unpickled_motion": "api.trajectory"}


def _members(module: str) -> dict[str, type]:
    """The classes of a family by their names."""
    table = getattr(import_module(f".{module}", __name__), _FAMILIES[module])
    return {member.__name__: member for member in table.values()}


def _named(name: str) -> object:
    """Object behind a public name; None where there is none."""
    if name == "__all__":
        return ["__version__", *_PUBLIC, *(one for module in _FAMILIES for one in _members(module))]
    if name in _PUBLIC or name in _PICKLED:
        module = import_module(f".{_PUBLIC.get(name) or _PICKLED[name]}", __name__)
        value = module if name in _MODULES else getattr(module, _RENAMED.get(name, name))
        return _faced(value) if name in _FACED else value
    # names of classes begin with a capital: others may be modules that Python asks for
    matches = (_members(module).get(name) for module in _FAMILIES if name[0].isupper())
    return next(filter(None, matches), None)


def __getattr__(name: str) -> Any:
    """Public names are loaded when they are first used."""
    value = _named(name)
    if value is None:
        raise AttributeError(f"module 'cardan' has no attribute '{name}'")
    globals()[name] = value
    return value


def _faced(function: Any) -> object:
    from .api.faces import faced

    return faced(function)


def _html(result: object) -> str:
    from .explain.notebook import html

    return html(result)


notebooks.WRITERS["html"] = _html


def __dir__() -> list[str]:
    return sorted(__getattr__("__all__"))
