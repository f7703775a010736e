"""Arguments of superelements in scenes, checked where they are written."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import field

import numpy as np

from ..arguments import checked
from ..elements.quantity import Value
from ..elements.superelement_joints import ROTATIONS
from ..errors import ModelError, brief, near
from ..records import dataclass
from ..superelements.additions import GRAVITY
from ..superelements.record import SuperelementRecord
from . import checks
from .beam_arguments import add_interfaces
from .frame import Place
from .scene import SceneRecord
from .superelement import CHORD, INERTIAS, MEAN, NODAL, PlacedSuperelement, frame_condition

# by which a sum of weights may differ from 1 and is 1
ROUNDED = 1e-12
# of the largest one, what a singular value of the condition of a frame has at least
RANK = 1e-9
# of angular velocities, whose geometric stiffness a record may have
PRODUCTS = frozenset({"xx", "yy", "zz", "yz", "zx", "xy"})


@dataclass(frozen=True, eq=False, repr=False)
class FlexibleBody:
    """A superelement in a scene; made by :meth:`Scene.superelement`.

    Attributes:
        model: The scene it belongs to.
        name: Its name.
        record: Its matrices.
    """

    model: SceneRecord = field(repr=False)
    name: str
    record: SuperelementRecord

    def at(self, interface: str) -> Place:
        """An interface as a frame, which moves with the deformed body.

        Raises:
            ModelError: there is no interface of this name.
        """
        return self.model.nodes[f"{self.name}.{self.record.interface(interface).name}"]

    def __repr__(self) -> str:
        return f"FlexibleBody({self.name!r}, {self.record.n} coordinates)"


@checked
def add_superelement(
    model: SceneRecord,
    name: str,
    record: SuperelementRecord,
    interfaces: Mapping[str, Place | str] | None = None,
    *,
    frame: str | None = None,
    weights: Sequence[float] | None = None,
    stiffening: bool = False,
    inertia: str = NODAL,
    loads: Mapping[str, Value] | None = None,
) -> FlexibleBody:
    """Add a flexible body that was reduced from finite elements: see ``cd.superelement``.

    It moves as far as it likes and deforms by little: displacements and rotations of its
    interfaces against a frame that goes along with them are linear in the forces, which turn with
    the frame. Its inertia is that of all its nodes.

    Args:
        model: The scene.
        name: Its name; that of an interface is ``<name>.<interface>``.
        record: Its matrices.
        interfaces: Frames or bodies that interfaces are fixed to; joints and forces hold others
            at ``at(interface)``, as they do bodies.
        frame: An interface that the frame is fixed to; ``"mean"``, the default of several
            interfaces: the weighted mean of their displacements and rotations vanishes;
            ``"chord"``: of rotations only those about the line from the first to the last count.
        weights: Of the interfaces in the mean, equal ones by default.
        stiffening: Whether the centrifugal forces of its rotation stiffen it; needs a record with
            the geometric stiffness by these.
        inertia: ``"nodal"``: of all nodes, whatever the velocity of the frame; ``"projected"``:
            by projection of the mass matrix as it is, which for beams and shells depends on that
            velocity a little; ``"corotated"``: by the velocities of interfaces and modal rates
            alone, the simpler form of the source. Its modal coordinates feel neither their
            centrifugal force nor that the frame moves, so that a spin beside a velocity of the
            body bends it.
        loads: Factors of loads of the record, by name: numbers, parameters, inputs or expressions
            in these and t. The loads act where the body is without deformation and turn with its
            frame. ``scene.superelement("arm", link, loads={"temperature": 40.0})``.

    Returns:
        The superelement; ``at`` gives its interfaces as frames.

    Raises:
        ModelError: unknown interfaces, a frame that they leave loose, or a name that is taken.

    Source: Géradin and Cardona, Flexible Multibody Dynamics (2001), chapter 8.
    """
    checks.new("superelement", name, model.superelements)
    who = f"superelement '{name}'"
    names = [one.name for one in record.interfaces]
    if "frame" in names:
        raise ModelError(f"{who}: an interface is called 'frame', which its frame is called")
    joined = {}
    for interface, place in (interfaces or {}).items():
        if interface not in names:
            swapped = isinstance(place, str) and place in names
            cure = f" Interfaces come first: {{{place!r}: ...}}" if swapped else ""
            raise ModelError(
                f"{who}: there is no interface {brief(interface)}.{near(interface, names)}{cure}"
            )
        joined[interface] = model.place(who, place, interface).name
    superelement = PlacedSuperelement(
        name=name,
        record=record,
        joined=joined,
        frame=frame or (MEAN if len(names) > 1 else names[0]),
        weights=_weights(who, weights, len(names)),
        stiffening=stiffening,
        inertia=chosen("inertia", who, inertia, INERTIAS),
        loads=_loads(model, who, record, loads or {}),
    )
    _check_frame(who, superelement)
    add_interfaces(model, superelement)
    return FlexibleBody(model, name, record)


def _loads(
    model: SceneRecord, who: str, record: SuperelementRecord, loads: Mapping[str, Value]
) -> dict[str, Value]:
    """Factors of loads that the record has.

    Raises:
        ModelError: it has none of a name, or a factor is of what moves.
    """
    names = [one.name for one in record.interfaces]
    for name, factor in loads.items():
        if name == GRAVITY:
            raise ModelError(f"{who}: loads: its weight acts by gravity= of the scene already")
        if name not in record.loads:
            cure = near(name, record.loads) if record.loads else ""
            raise ModelError(
                f"{who}: its record has no load {brief(name)}.{cure} Give loads= to the reduction"
            )
        if name in (*names, "frame", "modes", "axes"):
            raise ModelError(f"{who}: a load and a part of it are called '{name}'; rename the load")
        checks.quantity(f"{who}: load '{name}'", factor)
        symbols = getattr(factor, "free_symbols", ())
        for symbol in sorted(map(str, symbols)):
            if symbol in model.atoms:
                raise ModelError(
                    f"{who}: load '{name}' reads '{symbol}', which moves; give numbers, "
                    "parameters, inputs and t"
                )
        if not symbols:
            checks.number(f"{who}: load '{name}'", factor)
    return dict(loads)


def chosen(what: str, who: str, value: str, names: Collection[str]) -> str:
    """A value that is one of some names.

    Raises:
        ModelError: it is none.
    """
    if value not in names:
        raise ModelError(f"{who}: there is no {what} {brief(value)}.{near(value, names)}")
    return value


def _weights(who: str, weights: Sequence[float] | None, count: int) -> tuple[float, ...]:
    if weights is None:
        return (1 / count,) * count
    values = [checks.number(f"{who}: weights", x) for x in weights]
    if len(values) != count or min(values) < 0 or not sum(values) > 0:
        raise ModelError(
            f"{who}: weights are {brief(weights)}; give {count} numbers of at least 0, in the "
            "order of the interfaces, one of them positive"
        )
    # weights of a saved scene stay what they are, bit by bit
    total = 1.0 if abs(sum(values) - 1) < ROUNDED else sum(values)
    return tuple(x / total for x in values)


def _check_frame(who: str, superelement: PlacedSuperelement) -> None:
    """The interfaces say where a frame is.

    Raises:
        ModelError: there is no such frame, or they leave it loose.
    """
    record, frame = superelement.record, superelement.frame
    names = [one.name for one in record.interfaces]
    chosen("frame", who, frame, (MEAN, CHORD, *names))
    if superelement.stiffening and not PRODUCTS.intersection(record.geometric):
        raise ModelError(
            f"{who}: stiffening=True, and its record has no geometric stiffness by rotation; "
            "reduce it with stiffening='<interface that holds it>'"
        )
    if superelement.stiffening and frame not in names:
        raise ModelError(
            f"{who}: the geometric stiffness of its record is that of a body which an interface "
            f"holds, and a frame '{frame}' has some of it already; take frame='<that interface>'"
        )
    if record.massless:
        raise ModelError(
            f"{who}: {record.massless} of its coordinates have no mass, so that their "
            "accelerations are not determined. Reduce it with method='rubin', which costs as little"
        )
    moving = {motion for one in record.interfaces for motion in one.components}
    for one in record.interfaces:
        if len({*ROTATIONS}.intersection(one.components)) == 2:
            raise ModelError(
                f"{who}: interface '{one.name}' turns about two axes alone; reduce it with all "
                "rotations, one or none"
            )
        if frame == one.name and (missing := sorted(moving.difference(one.components))):
            raise ModelError(
                f"{who}: interface '{one.name}' has no motion {' and '.join(missing)}, so that a "
                f"frame fixed to it would be loose; take frame='{MEAN}'"
            )
    if frame in names:
        return
    values = np.linalg.svd(frame_condition(superelement), compute_uv=False)
    if len(values) < len(moving) or values[len(moving) - 1] < RANK * values[0]:
        cure = f"take frame='{MEAN}'" if frame == CHORD else "it needs more motions of interfaces"
        raise ModelError(f"{who}: its interfaces leave the frame '{frame}' loose; {cure}")
