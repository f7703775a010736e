"""The scenes that faults are put into, with all of their functions evaluated in NumPy."""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import cardan as cd
from cardan.api.compiled_model import CompiledModel
from cardan.errors import CompilerMissing, DerivationError
from cardan.ir.serialize import from_dict
from cardan.runtime.calls.code import Code
from cardan.runtime.calls.interpreted import Interpreted
from cardan.runtime.calls.objects import Key
from mechanisms import ZOO, flexible
from mechanisms.closed import CLOSED

RIGID = (
    *("pendulum", "double_pendulum", "cart_pole", "spatial_chain", "cylindrical", "screw"),
    *("universal", "planar", "parabola", "constant_velocity", "point_on_plane", "roller_coaster"),
    *("distance", "gear", "backwards", "branched", "satellite", "point_masses", "heavy_tip"),
    *("spherical_XYZ", "spherical_zxz", "spherical_mrp", "spherical_rotation_vector"),
    *("spherical_dcm", "free_ZYX", "free_quaternion", "gripper", "crane", "springs", "damped"),
    *("drives", "driven", "orbiter", "gyrostat"),
)
CIRCUITS = ("four_bar", "slider_crank", "parallelogram")
BEAMS = ("folding_arm", "bend45", "slider_crank")
SCENES = (*RIGID, *CIRCUITS, *(f"beam {name}" for name in BEAMS))
# of a frame: the last, whose way from the ground is the longest
FRAMES = ("pose", "velocity", "acceleration", "frame_jacobian")
DERIVATIVE = "forward_dynamics: q u tau"


@dataclass(frozen=True, eq=False)
class Loaded:
    """A scene with its functions as expressions.

    Attributes:
        name: Of the scene.
        model: All functions loaded, evaluated in NumPy.
        keys: Its functions; none in absolute coordinates.
        texts: C name -> the saved Function of every function, as plain data.
        equations: What they were derived from.
    """

    name: str
    model: CompiledModel
    keys: tuple[Key, ...]
    texts: dict[str, dict[str, Any]]
    equations: Any

    def symbol(self, key: Key) -> str:
        """C name of a function."""
        return str(self.model._objects.symbol(*key))


def without_compiler() -> None:
    """Have every function evaluated in NumPy from here on."""
    from cardan.runtime.build import cache as objects

    def none(*given: Any, **named: Any) -> Any:
        # kernels, which are compiled another way, call the expressions
        raise CompilerMissing("faults are put into expressions")

    objects.compiled_separately = none


@cache
def loaded(name: str, folder: Path) -> Loaded:
    """A scene of :data:`SCENES` in a folder of its own."""
    beams = name.startswith("beam ")
    scene = getattr(flexible, name.removeprefix("beam "))() if beams else _rigid(name)
    equations = cd.derive(scene)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        model = cd.compile(equations, directory=folder / name.replace(" ", "_"))
        keys = () if beams else tuple(_keys(model))
        if beams:
            model.verify()
    saved = model._objects.saved()
    judged = [f for f in saved if f in model.manifest["functions"]]
    kinds = model.manifest["finite_elements"]["kinds"] if beams else []
    own = {symbol for kind in kinds for symbol in kind["functions"].values()}
    wanted = [f for f in judged if not beams or f in own]
    return Loaded(name, model, keys, {f: saved[f] for f in wanted}, equations)


def _rigid(name: str) -> cd.Scene:
    return (ZOO[name] if name in ZOO else CLOSED[name]).build()


def _keys(model: CompiledModel) -> Any:
    """Every function there is: of the last frame and of every joint."""
    manifest = model.manifest
    for name in manifest["available"]:
        asked: list[str | None] = [None]
        if name in FRAMES:
            asked = [manifest["frames"][-1]["name"]]
        elif name == "reaction":
            asked = [row["name"] for row in (*manifest["cuts"], *manifest["joints"])]
        elif name == "derivative":
            asked = [DERIVATIVE]
        for of in asked:
            try:
                model._load([(name, of)])
            except DerivationError:
                continue
            yield name, of


def with_fault(base: Loaded, symbol: str, text: dict[str, Any] | None, code: Code) -> CompiledModel:
    """The model with one function exchanged.

    Args:
        base: The scene.
        symbol: C name of the function.
        text: Its saved Function with the fault; None where only its C has one.
        code: What is called.
    """
    model = CompiledModel(base.model.directory)
    old, new = base.model._objects, model._objects
    new._loaded = {**old._loaded, symbol: code}
    new._saved = dict(old.saved()) if text is None else {**old.saved(), symbol: text}
    new._saved_mark = old._saved_mark
    new.manifest = old.manifest
    if base.keys:
        model._load(base.keys)
    return model


def expressions(base: Loaded, symbol: str, text: dict[str, Any]) -> Code:
    """A function with a fault, evaluated in NumPy."""
    entry = base.model.manifest["functions"][symbol]
    found = Interpreted(from_dict(text))
    return Code(symbol, entry, False, found.address, interpreted=found)
