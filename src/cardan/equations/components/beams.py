"""From beams of a scene to a superelement in one call."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import TypeAlias, cast

import numpy as np

from ...arguments import checked
from ...arrays import Array
from ...errors import ModelError, brief
from ...scene.beam import Beam
from ...scene.body import Body
from ...scene.frame import Frame, Place
from ...scene.scene import SceneRecord
from ...superelements.interfaces import check_stiffening
from ...superelements.record import SuperelementRecord
from ...superelements.reduction import reduce as reduce_matrices
from ...superelements.surface import Surface
from ...topology.build import build
from ..finite_elements.lowering import lowered
from ..finite_elements.record import FiniteElementRecord
from .beam_system import BeamSystem, isolated, named_beams
from .element_matrices import element_matrices
from .geometric_stiffness import spin_stiffness
from .section_forces import row_names, section_operator

# an end, a node, a body or a frame; or a beam and a place in 0 ... 1 of its length
Where: TypeAlias = "Place | str | tuple[Beam | str, float]"
SAME = 1e-9  # of the length of a beam


@checked
def from_beams(
    scene: SceneRecord,
    beams: str | Beam | Sequence[str | Beam],
    interfaces: Mapping[str, Where] | None = None,
    *,
    bodies: Sequence[str | Body] = (),
    method: str = "craig_bampton",
    modes: int | None = None,
    damping: object = None,
    rayleigh: tuple[float, float] | None = None,
    static_shapes: Sequence[str] = (),
    stiffening: str | None = None,
) -> SuperelementRecord:
    """Beams of a scene, reduced to motions of their ends and some modes.

    Matrices are those of the elements of the scene, at the values of its parameters, in the
    reference configuration, in ground axes. Joints, loads and other bodies are left out. Damping of
    the material is kept.

    Args:
        scene: The scene; it is not changed.
        beams: One or several, by name.
        interfaces: By name an end or a node (``"boom.start"``, ``boom.at(0.5)``), a body, a frame,
            or a node by its place in 0 ... 1 of a beam, ``("boom", 0.5)``. Both ends, ``"start"``
            and ``"end"``, by default, if there is one beam.
        bodies: Rigid bodies that belong to the component: they have their mass, and connect the
            beams that end there.
        method, modes, damping, rayleigh, static_shapes: As for ``cd.superelement.reduce``.
        stiffening: Name of the interface that holds the beams while they spin about it: the record
            gets their geometric stiffness; none by default.

    Returns:
        A record to print, save and use in scenes.

    Raises:
        ModelError: a name that does not exist, beams that are stressed or not connected, or as for
            ``cd.superelement.reduce``.
    """
    names = [_name_of(scene, "beams", one) for one in _listed(beams)]
    named_beams(scene, names)
    body_names = [_body_name(scene, one) for one in _listed(bodies)]
    component = isolated(scene, build(scene), names, body_names)
    record = lowered(component.system)
    places = _places(component, record, names, interfaces)
    inner = [segment.line for segment in component.system.segments]
    rotations = np.concatenate([component.rotations, *(one.rotations[1:-1] for one in inner)])
    positions = np.concatenate([component.positions, *(one.positions[1:-1] for one in inner)])
    reference_state = [x for joint in component.system.joints for x in joint.q0 or ()]
    q = np.concatenate([reference_state, record.reference])
    matrices = element_matrices(record, q, rotations)
    geometric = {}
    if stiffening is not None:
        check_stiffening(stiffening, places)
        geometric = spin_stiffness(record, matrices, q, rotations, positions, *places[stiffening])
    operator, sections = section_operator(component, record, q, rotations)
    reduced = reduce_matrices(
        matrices.M,
        matrices.K,
        positions,
        {name: node for name, (node, _) in places.items()},
        C=matrices.C if matrices.C.count_nonzero() else None,
        method=method,
        modes=modes,
        at={name: position for name, (_, position) in places.items()},
        damping=damping,
        rayleigh=rayleigh,
        static_shapes=static_shapes,
        stress=operator,
        stress_names=row_names(sections),
        geometric=geometric,
    )
    surface = _centerlines(component, record, positions)
    return replace(reduced, surface=surface, sections=sections)


def _places(
    component: BeamSystem,
    record: FiniteElementRecord,
    names: Sequence[str],
    interfaces: Mapping[str, Where] | None,
) -> dict[str, tuple[int, Array]]:
    """Nodes and origins of interfaces; both ends of one beam by default.

    Raises:
        ModelError: they are not given by name, or one is on none of the beams.
    """
    if interfaces is None:
        if len(names) > 1:
            raise ModelError(
                f"interfaces: {len(names)} beams have several ends; give those that others are "
                f"connected to, such as {{'root': '{names[0]}.start', 'tip': '{names[-1]}.end'}}"
            )
        interfaces = {"start": f"{names[0]}.start", "end": f"{names[0]}.end"}
    if not isinstance(interfaces, Mapping):
        raise ModelError(
            f"interfaces={brief(interfaces)}: give them by name, such as {{'tip': "
            f"'{names[0]}.end'}}"
        )
    return {
        name: _place(component, record, names, name, where) for name, where in interfaces.items()
    }


def _centerlines(component: BeamSystem, record: FiniteElementRecord, positions: Array) -> Surface:
    """Lines along the beams, from node to node."""
    nodes, places, lines = [np.zeros(0, np.intp)], [np.zeros((0, 3))], []
    count = 0
    for segment, members in zip(component.system.segments, record.lines, strict=True):
        nodes.append(np.asarray(members, np.intp))
        # ends may lie beside the origin of the body that carries them
        places.append(segment.line.positions)
        first = count + np.arange(len(members) - 1)
        lines.append(np.stack([first, first + 1], axis=1))
        count += len(members)
    every = np.concatenate(nodes)
    arms = np.concatenate(places) - positions[every]
    return Surface(every, arms, np.zeros((0, 3), np.intp), np.concatenate(lines).astype(np.intp))


@checked
def reduce(
    scene: SceneRecord,
    beams: str | Beam | Sequence[str | Beam],
    modes: int | None = None,
    interfaces: Mapping[str, Where] | None = None,
    *,
    bodies: Sequence[str | Body] = (),
    method: str = "craig_bampton",
    damping: object = None,
    rayleigh: tuple[float, float] | None = None,
    static_shapes: Sequence[str] = (),
    stiffening: str | None = None,
    report: bool = True,
) -> SuperelementRecord:
    """Beams of the scene as a superelement; what that costs is printed.

    Args:
        scene: The scene; it is not changed.
        beams: One or several, by name.
        modes: How many, lowest first; 10 by default.
        interfaces: Ends, nodes, bodies or frames by the names of interfaces; both ends by default.
        bodies: Rigid bodies that belong to the component.
        method, damping, rayleigh, static_shapes: As for ``cd.superelement.reduce``.
        stiffening: As for ``cd.superelement.from_beams``.
        report: Whether ``cost`` of the record is printed.

    Returns:
        The record that ``cd.superelement.from_beams`` gives.

    Raises:
        ModelError: as there.
    """
    record = from_beams(
        scene,
        beams,
        interfaces,
        bodies=bodies,
        method=method,
        modes=modes,
        damping=damping,
        rayleigh=rayleigh,
        static_shapes=static_shapes,
        stiffening=stiffening,
    )
    if report:
        print(record.cost)
    return record


def _listed(value: object) -> list[object]:
    """One thing or several as a list."""
    single = isinstance(value, np.ndarray) and value.ndim == 0
    if single or isinstance(value, str | Beam | Body) or not isinstance(value, Iterable):
        return [value]
    return [*value]


def _name_of(scene: SceneRecord, who: str, beam: object) -> str:
    """Name of a beam of this scene."""
    if not isinstance(beam, Beam):
        return beam if isinstance(beam, str) else brief(beam)
    if beam.model is not scene.original:
        raise ModelError(
            f"{who}: beam '{beam.name}' belongs to model '{beam.model.name}', not to '{scene.name}'"
        )
    return beam.name


def _body_name(scene: SceneRecord, body: object) -> str:
    """Name of a rigid body of this scene."""
    place = scene.place("bodies", cast("Place | str", body), "body")
    if place.name not in scene.bodies:
        raise ModelError(
            f"bodies: '{place.name}' is not a rigid body of scene '{scene.name}'; leave it out"
        )
    return place.name


def _place(
    component: BeamSystem,
    record: FiniteElementRecord,
    beams: Sequence[str],
    name: str,
    where: object,
) -> tuple[int, Array]:
    """Node and origin of an interface.

    Raises:
        ModelError: there is no node, or several ends are meant.
    """
    scene, who = component.scene, f"interface '{name}'"
    if isinstance(where, tuple) and len(where) == 2:
        return _at_station(component, record, _name_of(scene, who, where[0]), where[1], who, beams)
    if isinstance(where, str) and where in component.ends:
        return component.ends[where]
    if not isinstance(where, Body | Frame | str):
        raise ModelError(
            f"{who}: {brief(where)}; give an end such as '{beams[0]}.end', a body, a frame, or "
            f"('{beams[0]}', 0.5)"
        )
    place = scene.place(who, where)
    # on a body of the component, or the only end that is on that body
    frames = [k for k, frame in enumerate(component.original.frames) if frame.name == place.name]
    for k in frames:
        if (on_body := component.on_body(k)) is not None:
            return on_body
    ends = [end for end in component.ends if scene.nodes[end] is place]
    ends = ends or [end for end in component.ends if scene.nodes[end].body is place.body]
    if len(ends) == 1:
        return component.ends[ends[0]]
    listed = ", ".join(f"'{end}'" for end in ends or component.ends)
    if not ends:
        raise ModelError(f"{who}: '{place.name}' is on none of the beams. Their nodes: {listed}")
    raise ModelError(
        f"{who}: {listed} are at '{place.name}'; name one of them, or make it part of the "
        f"component, bodies=['{place.body.name}']"
    )


def _at_station(
    component: BeamSystem,
    record: FiniteElementRecord,
    beam: str,
    where: object,
    who: str,
    beams: Sequence[str],
) -> tuple[int, Array]:
    """Node at a place in 0 ... 1 of the length of a beam."""
    if beam not in beams:
        raise ModelError(f"{who}: beam '{beam}' is not one of those that are reduced")
    segments = [
        (segment.line, line)
        for segment, line in zip(component.system.segments, record.lines, strict=True)
        if segment.name == beam
    ]
    length = segments[-1][0].stations[-1]
    if not isinstance(where, float | int) or isinstance(where, bool) or not 0 <= where <= 1:
        raise ModelError(f"{who}: {brief(where)} of beam '{beam}'; give a number from 0 to 1")
    every = np.concatenate([line.stations for line, _ in segments]) / length
    for line, nodes in segments:
        k = int(np.argmin(abs(line.stations / length - where)))
        if abs(line.stations[k] / length - where) < SAME:
            return int(nodes[k]), line.positions[k]
    nearest = every[np.argmin(abs(every - where))]
    raise ModelError(
        f"{who}: beam '{beam}' has no node at {where:g} of its length; the nearest is at "
        f"{nearest:.6g}. Put one there by scene.beams['{beam}'].at({where:g})"
    )
