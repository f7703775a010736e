"""Arguments of beams and cables, checked where they are written, and nodes of flexible bodies."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from typing import TYPE_CHECKING, Any, cast

from ..elements.centerlines import Centerline, Straight
from ..elements.flexible import BEAMS, INERTIAS
from ..elements.limits import judge
from ..elements.material import Material
from ..elements.quantity import Value
from ..elements.sections import Section
from ..elements.validation import axis, is_expression, number, vector
from ..errors import ModelError, brief, near
from . import checks
from .beam import RELEASED, Beam, Cable, End, node
from .body import Body
from .frame import Frame, Place

if TYPE_CHECKING:
    from .scene import SceneRecord
    from .superelement import PlacedSuperelement

# of one beam, as bodies of one scene
MOST_ELEMENTS = 100_000
ROLES = ("start", "end")
# what a beam is made of unless it says
ELEMENT, INERTIA = "hellinger_reissner", "linked"
# what an end may be let go in: displacements along and rotations about e1, e2, e3
RELEASES = ("x", "y", "z", "rx", "ry", "rz")
# what a beam may have without stress: its names in the order of the house, rotations first
STRAINS = ("twist", "curvature2", "curvature3", "stretch", "shear2", "shear3")


def add_beam(
    model: SceneRecord,
    name: str,
    ends: Sequence[tuple[object, object]],
    section_and_material: tuple[object, object],
    elements: object,
    up: object,
    line: object,
    kinds: tuple[object, object],
    temperature: object,
    prestrain: Mapping[str, object] | None,
    base: object,
) -> Beam:
    """The work of :meth:`Model.beam`.

    Args:
        ends: What the start and the end are joined to, and what is released there.
        section_and_material: Both.
        kinds: Of element and inertia.
    """
    checks.new("beam", name, model.beams)
    who = f"beam '{name}'"
    first, last = (end_of(model, who, role, *end) for role, end in zip(ROLES, ends, strict=True))
    section, material = materialized(who, *section_and_material)
    rise = number(who, "temperature", temperature)
    if not _zero(rise) and _zero(material.expansion):
        raise ModelError(
            f"{who}: temperature= acts through the expansion of the material; give "
            "cd.material(expansion=...)"
        )
    beam = Beam(
        model,
        name,
        (first, last),
        section,
        material,
        count_of(who, elements),
        None if up is None else axis(who, "up", up),
        line_of(who, line),
        chosen(who, "element", kinds[0], BEAMS),
        chosen(who, "inertia", kinds[1], INERTIAS),
        rise,
        prestrain_of(who, prestrain),
        base_of(model, who, base),
    )
    add_nodes(beam)
    return beam


def add_nodes(beam: Beam) -> None:
    """Put a beam and its nodes into its model: an end that is clamped has none of its own.

    Raises:
        ModelError: a name is taken.
    """
    model = beam.model
    checks.new("beam", beam.name, model.beams)
    names = [f"{beam.name}.{role}" for role in ROLES]
    for name in (*names, *beam.stops):
        model.new_place("beam", name)
    for name, end in zip(names, beam.ends, strict=True):
        clamped = end.place if not end.released else None
        model.nodes[name] = clamped or node(model, name)
    for name in beam.stops:
        model.nodes[name] = node(model, name)
    model.beams[beam.name] = beam


def end_of(model: SceneRecord, who: str, role: str, value: object, released: object) -> End:
    """An end as written: a frame, a body, a name, or three numbers for a free end.

    Raises:
        ModelError: none of these, or a release of what nothing holds.
    """
    letting = _released(who, role, released)
    if letting and frozenset(letting) not in RELEASED:
        listed = ", ".join("+".join(sorted(directions)) for directions in RELEASED)
        raise ModelError(
            f"{who}: release_{role} of {'+'.join(letting)} is not a joint. Known: {listed}. For "
            "all six let the end be free: give its point"
        )
    if isinstance(value, (Body, Frame, str)):
        return End(model.place(who, value, role), None, letting)
    if letting:
        raise ModelError(f"{who}: release_{role}: that end is free, nothing holds it; leave it out")
    return End(None, _triple(model, who, role, value))


def base_of(model: SceneRecord, who: str, base: object) -> Body | None:
    """The body in whose axes points are told; None for the ground.

    Raises:
        ModelError: there is none of that name, or it is a frame.
    """
    if base is None:
        return None
    place = model.place(who, cast("Place | str", base), "base")
    if not isinstance(place, Body):
        raise ModelError(
            f"{who}: base is the frame '{place.name}'; give its body, '{place.body.name}', and "
            "points in axes of that"
        )
    return None if place is model.ground else place


def _released(who: str, role: str, value: object) -> tuple[str, ...]:
    """Directions in which an end is let go; one may stand alone."""
    listed = (value,) if isinstance(value, str) else value
    if not isinstance(listed, (tuple, list, set, frozenset)):
        raise ModelError(
            f"{who}: release_{role} is {brief(value)}; give directions, such as 'ry' "
            "or ('ry', 'rz')"
        )
    for one in listed:
        if one not in RELEASES:
            raise ModelError(
                f"{who}: release_{role} has no direction {brief(one)}." + near(one, RELEASES)
            )
    return tuple(listed)


def _triple(model: SceneRecord, who: str, role: str, value: object) -> tuple[Value, Value, Value]:
    try:
        x, y, z = vector(who, role, value, 3)
    except ModelError as problem:
        raise ModelError(
            f"{problem}. An end is a frame, a body, a name or three numbers in axes of base="
        ) from problem
    written = (x for x in (x, y, z) if is_expression(x))
    for symbol in sorted(str(one) for entry in written for one in entry.free_symbols):
        if symbol in model.atoms:
            raise ModelError(
                f"{who}: {role} reads '{symbol}', which moves. A free end is a point of the "
                "reference configuration: give three numbers and base=, the body in whose axes "
                "they are"
            )
    return x, y, z


def count_of(who: str, elements: Any) -> int:
    """A number of elements.

    Raises:
        ModelError: not a whole number above 0, or an absurd one.
    """
    number = checks.is_number(elements) and not isinstance(elements, bool)
    if not (number and elements >= 1 and elements % 1 == 0):
        raise ModelError(f"{who}: elements is {brief(elements)}; give a whole number, 1 or more")
    if elements > MOST_ELEMENTS:
        raise ModelError(f"{who}: {brief(elements)} elements; a beam has at most {MOST_ELEMENTS}")
    return int(elements)


def chosen(who: str, what: str, value: object, choices: Collection[str]) -> str:
    """A word of a list.

    Raises:
        ModelError: another one, with the near ones.
    """
    if not isinstance(value, str) or value not in choices:
        raise ModelError(f"{who}: {what} {brief(value)} does not exist." + near(value, choices))
    return str(value)


def line_of(who: str, line: object) -> Centerline:
    """The centerline as written; straight where none is given.

    Raises:
        ModelError: it is none.
    """
    if line is None:
        return Straight()
    if not isinstance(line, Centerline):
        raise ModelError(
            f"{who}: line is {brief(line)}; give cd.arc(...), cd.spline(points) or nothing"
        )
    return line


def materialized(who: str, section: object, material: object) -> tuple[Section, Material]:
    """Section and material as written; a general section needs no material.

    Raises:
        ModelError: they are none, or do not say how stiff the beam is.
    """
    if not isinstance(section, Section):
        raise ModelError(
            f"{who}: section is {brief(section)}; give one of cd.section, such as "
            "cd.section.circle(radius=0.01)"
        )
    if material is None and not section.shaped:
        material = Material()
    if not isinstance(material, Material):
        raise ModelError(
            f"{who}: material is {brief(material)}; give cd.material(E=..., nu=..., rho=...)"
        )
    if section.shaped and not material.elastic:
        raise ModelError(f"{who}: its section is a shape; the material must say E and nu (or G)")
    if not section.shaped and (material.E is not None or not _zero(material.rho)):
        raise ModelError(
            f"{who}: a general section says stiffness and mass itself; leave E, nu, G and rho out "
            "of the material"
        )
    return section, material


def prestrain_of(who: str, strains_named: Mapping[str, object] | None) -> dict[str, Value]:
    """Strains by name.

    Raises:
        ModelError: an unknown name, or what is not a number.
    """
    if strains_named is not None and not isinstance(strains_named, Mapping):
        raise ModelError(
            f"{who}: prestrain is {brief(strains_named)}; give strains by name, {{'twist': 0.1}}"
        )
    strains = {}
    for name, value in (strains_named or {}).items():
        if name not in STRAINS:
            raise ModelError(f"{who}: prestrain has no '{name}'." + near(name, STRAINS))
        strains[name] = number(who, f"prestrain {name}", value)
    return strains


def _zero(value: object) -> bool:
    return not is_expression(value) and value == 0


def add_cable(
    model: SceneRecord,
    name: str,
    ends: Sequence[object],
    numbers: dict[str, Value],
    unloaded: tuple[Value | None, float | None],
    elements: int,
    base: object,
    compression: bool,
) -> Cable:
    """The work of :meth:`Scene.cable`.

    Args:
        ends: What the start and the end are joined to.
        numbers: ``EA``, ``rhoA`` and ``damping``.
        unloaded: ``length`` and ``tension``, of which one is None.
    """
    length, tension = unloaded
    checks.new("cable", name, model.cables)
    who = f"cable '{name}'"
    first, last = (end_of(model, who, role, end, ()) for role, end in zip(ROLES, ends, strict=True))
    values = {key: number(who, key, value) for key, value in numbers.items()}
    count = count_of(who, elements)
    if length is not None and tension is not None:
        raise ModelError(f"{who}: length and tension exclude each other; give one")
    if length is not None:
        length = number(who, "length", length)
    pull = 0.0 if tension is None else checks.number(f"{who}: tension", tension)
    if pull < 0 and not compression:
        raise ModelError(
            f"{who}: tension is {pull:g}; a cable does not push: give 0 or more, or "
            "compression=True for a bar"
        )
    if pull < 0 and not is_expression(values["EA"]) and pull <= -values["EA"]:
        raise ModelError(f"{who}: tension is {pull:g}; no bar is that short: give more than -EA")
    cable = Cable(
        model=model,
        name=name,
        ends=(first, last),
        EA=values["EA"],
        rhoA=values["rhoA"],
        length=length,
        tension=pull,
        damping=values["damping"],
        elements=count,
        compression=compression,
        base=base_of(model, who, base),
    )
    judge(who, cable.limits(), vars(cable))
    add_cable_nodes(cable)
    return cable


def add_cable_nodes(cable: Cable) -> None:
    """Put a cable and its nodes into its model.

    Raises:
        ModelError: a name is taken.
    """
    model = cable.model
    checks.new("cable", cable.name, model.cables)
    names = [cable.node_name(k) for k in range(cable.elements + 1)]
    for name in names:
        model.new_place("cable", name)
    places = {names[0]: cable.ends[0].place, names[-1]: cable.ends[1].place}
    for k, name in enumerate(names):
        mass = cable.node_mass(k)
        model.nodes[name] = places.get(name) or Body(model, name, mass, (0, 0, 0), (0,) * 6)
    model.cables[cable.name] = cable


def add_interfaces(model: SceneRecord, superelement: PlacedSuperelement) -> None:
    """Put a superelement and its interfaces into a scene.

    Raises:
        ModelError: a name is taken.
    """
    for name in superelement.places:
        model.new_place("interface", name)
    for name in superelement.places:
        model.nodes[name] = node(model, name)
    model.superelements[superelement.name] = superelement
