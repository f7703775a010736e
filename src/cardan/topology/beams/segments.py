"""Segments of beams: their ends on bodies, what they are made of, and what acts along them."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace

from ...elements.forces.line_load import LineLoad
from ...elements.limits import NumberLimits, check
from ...elements.material import LIMITS
from ...elements.sections.section import Outline, SectionProperties
from ...errors import ModelError, near
from ...ir.arithmetic import Scalar
from ...ir.function import live
from ...ir.graph import ZERO
from ...records import dataclass
from ...scene.beam import Beam
from ...scene.beam_arguments import STRAINS
from ...scene.scene import SceneRecord
from ..assembly import Assembly
from ..conversion import ORIGIN, Converter, parameters_only
from ..system import Nodes
from .beams import Laid
from .segment_tables import Segment

Data = dict[str, tuple[int, int, Nodes]]
# of a shape with numbers of its own
PAIRS = ("shear", "GA", "EI", "rhoI")
LOADS = ("dead_force", "dead_moment", "follower_force", "follower_moment")


def segments(
    scene: SceneRecord, assembly: Assembly
) -> tuple[tuple[Segment, ...], tuple[NumberLimits, ...]]:
    """The segments of all beams without loads, in the order of the beams, from start to end.

    Returns:
        The segments, and the limits of the numbers of their sections and materials.

    Raises:
        ModelError: numbers that no beam has.
    """
    materials = [_properties(beam, assembly.convert) for beam in scene.beams.values()]
    limits = tuple(one for beam in materials for one in _limits(beam))
    check(limits, assembly.graph, assembly.convert.defaults)
    outlines = _outlines(materials, assembly.convert)
    segments_built: list[Segment] = []
    for one, outline in zip(materials, outlines, strict=True):
        beam, laid = one.beam, assembly.beams.laid(one.beam)
        data = _data(one, assembly.convert)
        frames = [_frame(beam, name, laid, assembly) for name in laid.names]
        segments_built += [
            Segment(
                *(beam.name, beam.element, beam.inertia, frames[k], frames[k + 1], data, line),
                outline,
            )
            for k, line in enumerate(laid.lines)
        ]
    return tuple(segments_built), limits


def settle(assembly: Assembly) -> None:
    """Nodes, and bodies that only beams hold, begin where they are in the reference."""
    for name in assembly.beams.nodes.implicit:
        k = assembly.joint_number[name]
        pose = assembly.reference.poses[assembly.model.joints[name].child.body]
        q0 = assembly.beams.coordinates(pose)
        assembly.joints[k] = replace(assembly.joints[k], implicit=True, q0=q0)


def _frame(beam: Beam, name: str, laid: Laid, assembly: Assembly) -> int:
    """Number of the frame at a named node: of the node itself, or on the body it is clamped to."""
    place = beam.model.nodes[name]
    if place.name == name:
        return assembly.frame(place, name)
    beams, body = assembly.beams, place.body
    with assembly.graph.made_by(beam.name, "placement"):
        pose = beams.numbers(assembly.reference.poses[body])
        # where the user said; only the axes are those of the section
        where = beams.numbers(assembly.placement_of(place, name))[1]
        local = beams.constant(pose[0].T @ laid.pose(name)[0], where)
        number, home = assembly.home[body]
        part = assembly.rigid(number).index[body.name]
        frame_pose = home.then(assembly.graph, local)
        return assembly.new_frame((beam, name), assembly.unwritten(name), number, part, frame_pose)


@dataclass(frozen=True)
class BeamProperties:
    """Section and material of a beam as expressions: the written ones, and derived ones."""

    beam: Beam
    section: Mapping[str, Scalar]
    material: Mapping[str, Scalar]
    stiffness: SectionProperties


def _properties(beam: Beam, convert: Converter) -> BeamProperties:
    with convert.graph.made_by(beam.name, "section"):
        section = _scalars(beam.section.quantities(), f"{beam.name}.section", convert)
        material = _material(beam, convert)
        return BeamProperties(beam, section, material, beam.section.properties(section, material))


def _data(properties: BeamProperties, convert: Converter) -> Data:
    """Stiffness, inertia, damping and strain without stress."""
    beam, graph = properties.beam, convert.graph
    with graph.made_by(beam.name, "strain"):
        strain = dict.fromkeys(STRAINS, Scalar(graph, ZERO))
        for name, value in beam.prestrain.items():
            unit = "" if name in ("stretch", "shear2", "shear3") else "1/m"
            node = convert.scalar(value, f"{beam.name}.prestrain.{name}", unit)
            strain[name] = Scalar(graph, node)
        rise = Scalar(graph, convert.scalar(beam.temperature, f"{beam.name}.temperature", "K"))
        strain["stretch"] = strain["stretch"] + properties.material["expansion"] * rise
    numbers = {**vars(properties.stiffness), "damping": properties.material["damping"]}
    data: Data = {name: (1, 1, (value.node,)) for name, value in numbers.items()}
    return data | {"strain": (6, 1, tuple(value.node for value in strain.values()))}


def _scalars(quantities: Mapping[str, object], name: str, convert: Converter) -> dict[str, Scalar]:
    """Quantities by name; those of both directions as ``name.e2`` and ``name.e3``."""
    scalars = {}
    for key, entry in quantities.items():
        *_, nodes = convert.quantity(entry, f"{name}.{key}")  # type: ignore[arg-type]
        if key in PAIRS:
            for label, node in zip(("e2", "e3"), nodes * (3 - len(nodes)), strict=True):
                scalars[f"{key}.{label}"] = Scalar(convert.graph, node)
        else:
            scalars[key] = Scalar(convert.graph, nodes[0])
    return scalars


def _material(beam: Beam, convert: Converter) -> dict[str, Scalar]:
    """``E G nu rho damping expansion``, as far as they are told."""
    constants = _scalars(beam.material.quantities(), f"{beam.name}.material", convert)
    if "G" in constants:
        constants["nu"] = constants["E"] / (2 * constants["G"]) - 1
    elif "E" in constants:
        constants["G"] = constants["E"] / (2 * (1 + constants["nu"]))
    return constants


def _limits(properties: BeamProperties) -> tuple[NumberLimits, NumberLimits]:
    """Limits of the numbers of a section and of a material, as they were written."""
    beam, section = properties.beam, dict[str, tuple[int, ...]]()
    for key, value in properties.section.items():
        name = key.partition(".")[0]
        section[name] = (*section.get(name, ()), value.node)
    material = {name: (properties.material[name].node,) for name in beam.material.quantities()}
    return (
        NumberLimits(f"beam '{beam.name}': {beam.section.kind}", beam.section.limits(), section),
        NumberLimits(f"beam '{beam.name}': material", LIMITS, material),
    )


def _outlines(properties: Sequence[BeamProperties], convert: Converter) -> list[Outline]:
    """Outlines of the sections at the defaults of the parameters.

    Raises:
        ModelError: a stiffness of a beam is not a positive number there.
    """
    # all at once: a walk through the graph for each of many beams would take long
    named = [each for one in properties for each in (one.section, vars(one.stiffness))]
    values = iter(convert.defaults([x.node for each in named for x in each.values()]))
    values_of_beam = iter([{key: next(values) for key in each} for each in named])
    outlines = []
    for one in properties:
        section, stiffness = next(values_of_beam), next(values_of_beam)
        for name, value in stiffness.items():
            least = 0.0 if name.startswith("rho") else math.ulp(0.0)
            if not (math.isfinite(value) and value >= least):
                raise ModelError(
                    f"beam '{one.beam.name}': {name} comes out as {value:g}; check the numbers of "
                    "its section"
                )
        outline = one.beam.section.outline(section)
        outlines.append(outline)
    return outlines


def with_line_loads(
    segments: Sequence[Segment], scene: SceneRecord, convert: Converter
) -> tuple[Segment, ...]:
    """Segments with what acts along their beams, per length.

    Raises:
        ModelError: a load along what is not a beam, or with components that cannot be converted.
    """
    names = scene.beams
    fixed, variable = ({beam: dict.fromkeys(LOADS, ORIGIN) for beam in names} for _ in range(2))
    for name, force in scene.forces.items():
        element = force.element
        if not isinstance(element, LineLoad):
            continue
        _check_beam(scene, name, element)
        axes = "follower" if element.follower else "dead"
        with convert.graph.made_by(name, "data"):
            for key, entry in element.quantities().items():
                *_, nodes = convert.quantity(entry, f"{name}.{key}")
                constant = parameters_only(convert.graph, live(convert.graph, nodes))
                for sums, chosen in ((fixed, True), (variable, False)):
                    added = [n if (n in constant) == chosen else ZERO for n in nodes]
                    before = sums[element.beam][f"{axes}_{key}"]
                    total = tuple(map(convert.graph.add, before, added))
                    sums[element.beam][f"{axes}_{key}"] = total
    return tuple(
        replace(
            segment,
            data={**segment.data, **_columns(fixed[segment.name])},
            variable_loads=_columns(variable[segment.name]),
        )
        for segment in segments
    )


def _columns(loads: dict[str, Nodes]) -> dict[str, tuple[int, int, Nodes]]:
    return {key: (3, 1, nodes) for key, nodes in loads.items()}


def _check_beam(scene: SceneRecord, name: str, element: LineLoad) -> None:
    if element.beam in scene.beams:
        return
    listed = near(element.beam, scene.beams).replace(" Known:", " Beams:")
    what = f"'{element.beam}' is a body, and there is no such beam"
    if element.beam not in scene.bodies:
        what = f"there is no beam '{element.beam}'"
    raise ModelError(f"force '{name}' (line_load): {what}.{listed}")
