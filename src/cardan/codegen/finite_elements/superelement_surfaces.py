"""Superelements of a model for pictures: rows of the manifest, and their surfaces as a file."""

from __future__ import annotations

from collections.abc import Iterator

from ...equations.finite_elements.record import FiniteElementRecord
from ...number_file import packed
from ...schema.mechanism import SuperelementRow
from ...superelements.moving_surface import FILE, entry, moving_surface
from ...superelements.spin import spin_scale


def superelement_rows(absolute: FiniteElementRecord) -> Iterator[SuperelementRow]:
    """Where superelements are, and which entries of q are their coordinates."""
    system, places = absolute.system, absolute.places
    couples = {
        member: tuple(group.places[k].tolist())
        for group in absolute.groups
        if group.kind.part == "superelement"
        for k, member in enumerate(group.members)
    }
    for part in system.superelements:
        # its joints come last, behind the node that carries its frame
        joints = couples[part.name][-len(part.joints) :]
        interfaces = [one.name for one in part.record.interfaces]
        spin = spin_scale(part.record, {part.frame_choice}.intersection(interfaces) or interfaces)
        yield SuperelementRow(
            name=part.name,
            frame=system.frames[part.frame].name,
            q=[k for place in joints for k in range(places.q[place], places.q[place + 1])],
            bodies=list(part.bodies),
            undeformed=list(part.undeformed),
            loads=list(part.loads),
            beams=list(part.record.sections.names),
            frame_choice=part.frame_choice,
            stiffening=part.stiffening,
            fixed=spin.interface,
            first_frequency=spin.frequency,
            relative_inertia=spin.inertia.ravel().tolist(),
        )


def surface_files(absolute: FiniteElementRecord) -> dict[str, bytes]:
    """The file with the surfaces of all superelements, by its name; none without any."""
    arrays = {
        entry(name, k): values
        for k, part in enumerate(absolute.system.superelements)
        for name, values in moving_surface(part.record, part.rows, part.loads).arrays().items()
    }
    return {FILE: packed(arrays)} if arrays else {}
