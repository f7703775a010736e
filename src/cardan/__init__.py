"""cardan: a compiler for multibody mechanics.

From a scene to equations of motion, to C, to fast simulation::

    import cardan as cd

    scene = cd.Model("pendulum", gravity=(0, 0, -9.81))
    rod = scene.body("rod", mass=1, com=(0, 0, -0.5), inertia=cd.inertia.rod(1, 1, axis="z"))
    scene.joint("pivot", cd.Revolute("y"), scene.ground, rod)
    motion = cd.compile(scene).simulate(10.0, q={"pivot": 1.0})
"""

from __future__ import annotations

from importlib import import_module
from typing import Any

from .version import VERSION as __version__

# public name -> module that holds it (None: the module itself), in the order of use
_PUBLIC: dict[str, str] = {
    "Model": "model",
    "load": "model",
    "from_dh": "model.dh",
    "from_sympy": "model.mechanics",
    "t": "model",
    "inertia": "model.inertia",
    "shape": "model.shape",
    "orbit": "model.orbit",
    "table": "elements.tables",
    "section": "elements.sections",
    "material": "elements.material",
    "arc": "elements.centerlines",
    "spline": "elements.centerlines",
    **dict.fromkeys(
        (
            "Fixed",
            "Revolute",
            "Prismatic",
            "Cylindrical",
            "Screw",
            "Universal",
            "ConstantVelocity",
            "Spherical",
            "Planar",
            "Free",
            "PointOnPlane",
            "PointOnCurve",
            "Distance",
            "Gear",
            "Wheel",
            "RollingDisk",
            "Custom",
        ),
        "elements.joints",
    ),
    **dict.fromkeys(
        (
            "Force",
            "Torque",
            "SpringDamper",
            "Maxwell",
            "TorsionSpring",
            "JointForce",
            "Damping",
            "Friction",
            "Actuator",
            "Controller",
            "Stop",
            "Lock",
            "Contact",
            "Watch",
            "Drive",
            "Rotor",
            "LineLoad",
            "CentralGravity",
            "GravityGradient",
            "J2",
        ),
        "elements.forces",
    ),
    **dict.fromkeys(
        (
            "Multipliers",
            "Elimination",
            "NullSpace",
            "Baumgarte",
            "Penalty",
            "Augmented",
            "Perturbed",
        ),
        "equations.treatments",
    ),
    "derive": "pipeline",
    "compile": "pipeline",
    "GeneralizedAlpha": "analyses.alpha",
    "Alpha": "analyses.alpha",
    "stability": "analyses.stability",
    "Equations": "equations.record",
    "CompiledModel": "runtime.compiled",
    "load_model": "runtime.saved",
    "excitation": "analyses.identification.excitation",
    "identify": "analyses.identification.identify",
    "sample": "analyses.sample",
    "Ensemble": "analyses.ensembles",
    "Trajectory": "runtime.trajectory",
    "load_motion": "runtime.storage",
    "load_ensemble": "analyses.ensembles.stored",
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
_MODULES = frozenset({"orbit", "inertia", "section", "shape", "sample", "stability"})
_RENAMED = {"load_model": "load", "load_motion": "load", "load_ensemble": "load"}

# what pickles name, for ever -> module that holds it
_PICKLED = {"_unpickled_model": "runtime.saved", "_unpickled_motion": "runtime.pickled"}

__all__ = ["__version__", *_PUBLIC]


def __getattr__(name: str) -> Any:
    """Public names are loaded when they are first used."""
    if name not in _PUBLIC and name not in _PICKLED:
        raise AttributeError(f"module 'cardan' has no attribute '{name}'")
    module = import_module(f".{_PUBLIC.get(name) or _PICKLED[name]}", __name__)
    value = module if name in _MODULES else getattr(module, _RENAMED.get(name, name))
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted(__all__)
