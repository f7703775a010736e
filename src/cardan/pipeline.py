"""The whole way, one named value per stage."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, overload

from . import topology
from .api.compiled_model import CompiledModel
from .api.equations import Equations, FiniteElementEquations
from .api.faces import face
from .arguments import checked
from .build_progress import stage
from .codegen import CFile, generate, layout, manifest
from .codegen.fingerprint import fingerprint
from .codegen.finite_elements import model_folder
from .equations.constraints.assembly_branches import with_branches
from .equations.constraints.feasibility import feasibility
from .equations.constraints.treatments import Treatment, treatment
from .equations.finite_elements.lowering import lowered
from .equations.finite_elements.nodal_scene import ends_with_nodes
from .equations.finite_elements.record import FiniteElementRecord
from .equations.formalism_choice import (
    check_chooses,
    chosen_by,
    chosen_options,
    coordinates_with,
    element_reason,
    requested,
)
from .equations.record import EquationRecord
from .errors import BuildError, CodegenError, DerivationError, SolveWarning, near, warn
from .processes import collector_paused
from .runtime.build import cache_folder as cache
from .runtime.verification.closed_states import unjudged
from .schema.functions import OF_ELEMENTS

if TYPE_CHECKING:
    from .ir.trees.assembly import Form
    from .scene.scene import SceneRecord
    from .topology.system import Named, System

COORDINATES = ("auto", "relative", "absolute")
PLANES = ("auto", "x", "y", "z")
CLOSES = "closes"  # an empty file beside the C of a system whose loops can close


@overload
def derive(
    scene: SceneRecord,
    coordinates: Literal["auto", "relative"] = "auto",
    method: str = "auto",
    speeds: Mapping[str, object] | None = None,
    rewrites: Sequence[str] | None = None,
    specialize: bool | Sequence[str] | Mapping[str, float] = False,
    constraints: str | Treatment = "auto",
    branches: Mapping[str, str] | None = None,
    independent: Sequence[str] | None = None,
) -> Equations: ...


@overload
def derive(
    scene: SceneRecord,
    coordinates: Literal["absolute"],
    *,
    specialize: bool | Sequence[str] | Mapping[str, float] = False,
    plane: Literal["auto", "x", "y", "z"] | None = None,
) -> FiniteElementEquations: ...


@checked
def derive(
    scene: SceneRecord,
    coordinates: str = "auto",
    method: str = "auto",
    speeds: Mapping[str, object] | None = None,
    rewrites: Sequence[str] | None = None,
    specialize: bool | Sequence[str] | Mapping[str, float] = False,
    constraints: str | Treatment = "auto",
    branches: Mapping[str, str] | None = None,
    independent: Sequence[str] | None = None,
    plane: str | None = None,
) -> Equations | FiniteElementEquations:
    """Equations of motion of a scene.

    Args:
        scene: The model.
        coordinates: ``"relative"``: joint coordinates over the spanning tree; ``"absolute"``: every
            body has six of its own and joints hold them, element by element; ``"auto"``: nodes for
            beams and cables and joint coordinates for rigid trees; every body its own in long
            rigid loops (more than 16 speeds in one, or 60 in all); else relative.
        method: Formalism: ``"kane"``, ``"newton_euler"``, ``"composite"``, ``"articulated"``,
            ``"lagrange"``, ``"hamilton"``, ``"gibbs_appell"``, ``"barycentric"``, or ``"auto"``:
            of composite and articulated bodies what takes the fewest operations.
        speeds: Generalized speeds: name -> SymPy expression, linear in the joint speeds
            ``scene.u(...)``; as many as the system has speeds. By Kane's method unless another is
            named; ``articulated`` takes none.
        rewrites: Of the system graph, before equations are derived from it: ``"axes"``,
            ``"origins"``, ``"parallel"``, ``"base_parameters"``; () for none. By default what
            leaves the fewest operations and no more rounding.
        specialize: Parameters whose values are built into the equations: names, or values by
            name; True for all. They cannot be changed afterwards; ``print(equations)`` says what
            it saves.
        constraints: How they are treated: ``"multipliers"`` (what ``"auto"`` takes),
            ``"elimination"``, ``"null_space"``, ``"baumgarte"``, ``"penalty"``, ``"augmented"``,
            ``"perturbed"``, or one with numbers, such as ``cd.constraints.Penalty(1e9)``; or
            ``"closed_form"``: loops that can be are solved by formulas, which leaves their
            independent coordinates only, and multipliers serve for the rest.
        branches: Of loops in closed form: joint that closes one -> ``"+"`` or ``"-"``; by
            default what is nearest to the initial values of its joints.
        independent: Joints whose coordinates stay in closed form, such as that of a crank.
        plane: Of absolute coordinates: normal of the plane that the scene stays in, ``"x"``,
            ``"y"`` or ``"z"``; nodes then have the coordinates x, y, angle of a planar joint with
            that normal. ``"auto"`` takes the plane that there is, if any, which is the default
            where absolute coordinates are chosen for rigid loops.

    Returns:
        The record that says everything else: matrices, counts, functions; in absolute coordinates
        the kinds of elements, their members and functions.

    Raises:
        ModelError, TopologyError: the scene is at fault.
        DerivationError: no such method, or it does not take this system.
    """
    if coordinates not in COORDINATES:
        listed = near(coordinates, COORDINATES)
        raise DerivationError(f"coordinates '{coordinates}' do not exist.{listed}")
    if speeds and method != "auto":
        check_chooses(method)
    solved = branches is not None or independent or constraints == "closed_form"
    with stage(f"model '{scene.name}': numbering bodies and joints"):
        system = topology.build(
            scene, specialize, (branches or {}) if solved else None, independent
        )
    named_options = chosen_options(
        {"method": method, "constraints": constraints},
        {"speeds": speeds, "rewrites": rewrites, "branches": branches, "independent": independent},
    )
    reason, trees = "", False
    if coordinates == "auto":
        reason, trees = element_reason(system, scene.cables.values(), bool(named_options))
    if coordinates == "absolute" or reason:
        with stage(f"model '{scene.name}': deriving equations"):
            return _absolute(system, named_options, plane, trees, reason)
    if plane not in (None, "auto"):
        raise DerivationError(
            f"plane='{plane}' belongs to absolute coordinates: take coordinates='absolute'"
        )
    with stage(f"model '{scene.name}': deriving equations"):
        equations = _relative(scene, system, method, speeds, rewrites, treatment(constraints))
    return replace(equations, free=topology.build(scene)) if specialize else equations


def _relative(
    scene: SceneRecord,
    system: System,
    method: str,
    speeds: Mapping[str, object] | None,
    rewrites: Sequence[str] | None,
    bound: Treatment,
) -> Equations:
    """Equations in joint coordinates.

    Raises:
        DerivationError: beams, or a formalism that does not take the system.
    """
    flexible = [f"beam '{one.name}'" for one in system.segments]
    flexible += [f"superelement '{one.name}'" for one in system.superelements]
    if flexible:
        raise DerivationError(
            f"{flexible[0]}: relative coordinates take rigid bodies only. A scene with flexible "
            "ones needs coordinates='absolute', or leave coordinates= out"
        )
    system = with_branches(system) if system.closures else system
    chosen: tuple[Named, ...] = ()
    if speeds:
        chosen = topology.named_speeds(scene, system, speeds)
        method = "kane" if method == "auto" else method
    equations: Equations = face(chosen_by(system, method, chosen, rewrites, bound))
    return equations


def _absolute(
    system: System, named_options: Sequence[str], plane: str | None, trees: bool, reason: str = ""
) -> FiniteElementEquations:
    """Equations in absolute coordinates, and why they were chosen.

    Raises:
        DerivationError: options of joint coordinates, no such plane, or a scene that leaves it.
    """
    if plane not in (None, *PLANES):
        raise DerivationError(f"plane '{plane}' does not exist.{near(plane, PLANES)}")
    if named_options:
        raise DerivationError(
            f"{', '.join(f'{name}=' for name in named_options)}: for joint coordinates only. Leave "
            "out such arguments, or take coordinates='relative'"
        )
    plane = "auto" if reason and not trees and plane is None else plane
    nodes = ends_with_nodes(system) if trees else None
    record = replace(lowered(system, plane, nodes), reason=reason)
    equations: FiniteElementEquations = face(record)
    return equations


@collector_paused()
def compile_scene(
    scene: SceneRecord | EquationRecord | FiniteElementRecord,
    functions: Sequence[str],
    directory: str | Path | None,
    options: Mapping[str, object],
    loops: bool | None,
    threads: int | None,
    reproducible: bool,
    dtype: str,
) -> CompiledModel:
    """The whole way to compiled functions; :func:`cardan.compile` tells the arguments.

    Args:
        options: Of :func:`derive`, None for its default.
        dtype: As :func:`cardan.compile` takes it.

    Raises:
        DerivationError: an unknown function, or options for equations that are derived already.
        ModelError: no such dtype, or float32 in absolute coordinates.
        BuildError: no compiler, or a build that failed its check.
    """
    named_options = {name: x for name, x in options.items() if x is not None}
    if not isinstance(scene, (EquationRecord, FiniteElementRecord)):
        beams = bool(scene.beams or scene.superelements)
        coordinates = coordinates_with(functions, beams)
        if coordinates is not None:
            named_options.setdefault("coordinates", coordinates)
    equations = _derived(scene, **named_options)
    model_from = partial(CompiledModel, threads=threads, reproducible=reproducible, dtype=dtype)
    if isinstance(equations, FiniteElementRecord):
        folder = _of_elements(equations, directory)
        write = partial(model_folder.add_requested, folder, equations)
        return model_from(folder, write)
    functions = requested(equations, functions)
    base = manifest.base(equations, functions)
    folder = Path(directory) if directory is not None else _workspace(equations, loops)
    closes = _loops_close(equations, folder if directory is None else None)
    write_base = partial(layout.write_model, base=base)
    folder = _written(folder, directory is not None, write_base)
    if closes and equations.system.closed and directory is None:
        with suppress(OSError):  # else it is found out again
            (folder / CLOSES).touch()

    def provide(keys: Sequence[tuple[str, str | None]]) -> list[str]:
        """Write the C of functions unless it is there."""
        for name, _ in keys:
            if name not in functions:
                requested(equations, (name,))  # raises where the system has no such function
                raise DerivationError(
                    f"function '{name}' was not asked for: compile(..., functions=[..., '{name}'])"
                )
        names = [equations.c_name(*key) for key in keys]
        by_name = dict(zip(names, keys, strict=True))
        missing = [by_name[c_name] for c_name in layout.missing(folder, names)]
        _add(folder, base, [_c_of(equations, key, loops) for key in missing])
        return names

    model = model_from(folder, provide, available=functions)
    _say_what_is_not_checked(model)
    return model


def _c_of(
    equations: EquationRecord, key: tuple[str, str | None], loops: bool | None
) -> tuple[CFile, Form]:
    """A function as C, and as what was written so."""
    name, of = equations.system.name, key[1]
    with stage(f"model '{name}': deriving and writing {' of '.join(filter(None, key))}"):
        function = equations.form(*key, loops)
        notes = equations.notes(*key, function)
        return generate(function, model=name, notes=notes, of=of), function


def _add(folder: Path, base: manifest.Base, functions: Sequence[tuple[CFile, Form]]) -> None:
    """Write functions into the folder of their model."""
    if not functions:
        return
    try:
        try:
            layout.add_functions(folder, functions)
        except (CodegenError, FileNotFoundError):
            # a folder that was removed or damaged meanwhile is made again
            layout.write_model(folder, base)
            layout.add_functions(folder, functions)
    except OSError as error:
        raise _unwritable(folder, error) from error


def _say_what_is_not_checked(model: CompiledModel) -> None:
    """Warn where builds of a model are compared with nothing but what they were written from."""
    if why := unjudged(model):
        warn(
            f"model '{model.name}': its builds are {why}. They are compared with the expressions "
            "they were written from alone; model.verify() says so function by function",
            SolveWarning,
        )


def _loops_close(equations: EquationRecord, folder: Path | None) -> bool:
    """True if all loops can close, with a warning if not.

    Args:
        equations: Whose loops.
        folder: Of the cache, which may say that they do; None for one that a user named, as what
            stands there may be of another system.
    """
    if not equations.system.closed or (folder is not None and (folder / CLOSES).exists()):
        return True
    closure = feasibility(equations)
    if not closure.closes:
        warn(f"model '{equations.system.name}', at its parameters: {closure}", SolveWarning)
    return closure.closes


def _of_elements(equations: FiniteElementRecord, directory: str | Path | None) -> Path:
    """Folder of equations in absolute coordinates: C of their kinds of elements, and tables."""
    folder = Path(directory) if directory is not None else _workspace(equations, None)
    write = partial(model_folder.write, absolute=equations, available=OF_ELEMENTS)
    with stage(f"model '{equations.system.name}': writing the functions of elements"):
        return _written(folder, directory is not None, write)


def _derived(
    scene: SceneRecord | EquationRecord | FiniteElementRecord, **options: Any
) -> EquationRecord | FiniteElementRecord:
    """The equations of a scene by the options that are given.

    Raises:
        DerivationError: options for equations that are derived already.
    """
    named_options = {name: x for name, x in options.items() if x is not None}
    if not isinstance(scene, (EquationRecord, FiniteElementRecord)):
        equations: EquationRecord | FiniteElementRecord = derive(scene, **named_options)
        return equations
    if named_options:
        raise DerivationError(
            f"{', '.join(named_options)}: the equations are derived already; give it to derive()"
        )
    return scene


def _workspace(equations: EquationRecord | FiniteElementRecord, loops: bool | None) -> Path:
    """Folder of the cache for the C of these equations."""
    return cache.directory() / "models" / fingerprint(equations, loops)[:32]


def _written(folder: Path, named: bool, write: Callable[[Path], object]) -> Path:
    """The folder that a model was written to.

    Args:
        folder: Where it belongs; where there is no room in the cache, another one of this process.
        named: Whether a user named it.
        write: Writes the model to a folder.

    Raises:
        BuildError: there is no room.
    """
    try:
        try:
            write(folder)
        except OSError as error:
            if named:
                raise
            folder = cache.instead(cache.directory(), str(error.strerror)) / folder.name
            write(folder)
    except OSError as error:
        raise _unwritable(folder, error) from error
    cache.used(folder)
    return folder


def _unwritable(folder: Path, error: OSError) -> BuildError:
    return BuildError(
        f"the C of the model cannot be written to {folder} ({error.strerror}). "
        f"{cache.cure(error)}, or name another directory="
    )
