"""Nodes carried to where the coordinates of the joints say, for the start of runs and searches."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from functools import cached_property
from itertools import islice
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ....arrays import Array
from ....schema.finite_elements import GROUND, ON_TREE
from ....schema.rows import column
from . import table_loading
from .dependent_nodes import Motion, displacement, joined, motion_of, still, trailed
from .node_pose import pose, speeds
from .tables import Integers, Tables

if TYPE_CHECKING:
    from ..loaded_model import LoadedModel

Mask = NDArray[np.bool_]
SAVED, REFERENCE = "states", "states of nodes with all joints at their defaults"
# states of joints whose states of nodes are remembered, and where
REMEMBERED, LATEST = 2, "latest states of nodes"
ENDS = "ends_q", "ends_u"
ASSEMBLY_SIGNS = "assembly_signs "  # before the joint whose axes the numbers are about
ROUNDING = 1e-14
# cosines of exchanged axes are 0 but for rounding; as kernels/solve/position.c has it
SIGN_TOL = 1e-6
# entries of the coordinates and speeds of a node in space
POSE, MOTION = ("qw", "qx", "qy", "qz", "px", "py", "pz"), ("x", "y", "z", "px", "py", "pz")


def follow_joints(
    model: LoadedModel,
    x: Array,
    changeable: Collection[str],
    t: float = 0.0,
    r: Array | None = None,
) -> Array:
    """A state with its nodes where the joints carry them from the ground, and moving so.

    Args:
        model: In absolute coordinates.
        x: State (nx,) whose coordinates and speeds of joints hold.
        changeable: Names of the entries that may change; all others were given.
        t, r: Time [s] and inputs (nr,), where something is prescribed; 0 and their defaults.
    """
    names, changes = (*model.coordinates, *model.speeds), set(changeable)
    # by default everything may change: names need not be compared then
    fixed = np.zeros(len(names), dtype=bool)
    if not changes.issuperset(names):
        fixed[:] = [name not in changes for name in names]
    return Carrier(model, fixed, t, r).at(x)


class JointSources(NamedTuple):
    """What is the same for all parameters and starts of a model.

    Attributes:
        function: The saved function, read anew where its file has changed.
        blocks: Names of the entries of the blocks that the saved function of the tree reads.
        sources: Of every coordinate and of every speed of the tree its entry in those of the model.
        planes: Places told in a plane, with the entries of their pose and speeds in those of the
            tree.
        leads: Mask of the speeds of joints (nu,).
    """

    function: object
    blocks: Mapping[str, Sequence[str]]
    sources: tuple[Integers, Integers]
    planes: list[tuple[int, Integers, Integers]]
    leads: Mask


class Carrier:
    """Motion of the nodes of a model with its joints.

    Args:
        model: In absolute coordinates.
        fixed: Mask (nq + nu,) of the coordinates and speeds that stay what they are: what was
            given, nodes between others too.
        t, r: Time [s] and inputs (nr,), where something is prescribed; 0 and their defaults.
    """

    def __init__(
        self, model: LoadedModel, fixed: Mask, t: float = 0.0, r: Array | None = None
    ) -> None:
        self.model, self.t, self.fixed = model, t, fixed
        self.r = model._layout.start("r") if r is None else r
        self.tables = table_loading.tables_of(model)
        _, self._blocks, self._sources, self._planes, _ = _joint_sources(model, self.tables)
        # nodes that only beams hold go along, unless somebody says where they are
        self.free_nodes = {
            k
            for k in model.manifest.elements.beam_nodes
            if not self.fixed[self.tables.q[k] : self.tables.q[k + 1]].any()
        }

    def at(self, x: Array) -> Array:
        """A state (nx,) with its nodes where joints and beams carry them."""
        moved, tables = self._by_joints(x), self.tables
        if not tables.beams:
            return moved
        located = set(range(len(tables.kind))) - self.free_nodes
        count = len(self.fixed)
        # bodies that joints hold on the end of a beam follow it, and carry the next beam
        for _ in range(len(self.free_nodes) + 1):
            ends = self._tree_ends(*self.model.split(moved)[:2])
            trail = trailed(tables, tables.beams, self.reference, moved, located, ends)
            trail[:count][self.fixed] = moved[:count][self.fixed]
            before, moved = moved, self._by_joints(trail)
            # the joints round what beams said: the same again is all there is
            if np.allclose(moved, before, rtol=ROUNDING, atol=ROUNDING):
                break
        return moved

    def node_positions(self, q: Array) -> Array:
        """Coordinates (nq,) with nodes where joints and beams carry them."""
        nq = len(q)
        if self.tables.beams or self._planes:
            return self.at(np.concatenate([q, np.zeros(self.model.nx - nq)]))[:nq]
        located = self._located(q)
        stays = self.fixed[: len(located)]
        located = np.where(stays, q[: len(located)], located)
        return np.concatenate([located, q[len(located) :]])

    def moving(self, q: Array, u: Array) -> Array:
        """Speeds (..., nu) of everything at one position (nq,), for speeds of joints (..., nu)."""
        stays, tables, nq = self.fixed[len(q) :], self.tables, len(q)
        moved = np.where(stays, u, _wide(self._nodes(q, u)["u"], u))
        if not tables.beams:
            return moved
        located = set(range(len(tables.kind))) - self.free_nodes
        for _ in range(len(self.free_nodes) + 1):
            rows = moved.reshape(-1, self.model.nu)
            trails = [
                trailed(
                    tables,
                    tables.beams,
                    self.reference,
                    x=np.concatenate([q, row]),
                    located=located,
                    tree_ends=self._tree_ends(q, row),
                )[nq:]
                for row in rows
            ]
            trail = np.where(stays, moved, np.reshape(trails, moved.shape))
            before, moved = moved, np.where(stays, u, _wide(self._nodes(q, trail)["u"], trail))
            if np.allclose(moved, before, rtol=ROUNDING, atol=ROUNDING):
                break
        return moved

    def reversed_axis(self, q: Array) -> str:
        """The joint closing a loop that stands with an axis turned round at q (nq,); "" if none."""
        names = [o.name for o in self.model._objects.form(SAVED).outputs]
        if not any(name.startswith(ASSEMBLY_SIGNS) for name in names):
            return ""
        values = self._nodes(q, np.zeros(self.model.nu))
        wrong = [n for n in names if n.startswith(ASSEMBLY_SIGNS) and np.any(values[n] <= SIGN_TOL)]
        return wrong[0].removeprefix(ASSEMBLY_SIGNS) if wrong else ""

    @cached_property
    def links(self) -> list[tuple[int, int]]:
        """Ends of the lines of beams both of which joints carry; GROUND for the ground."""
        tables = self.tables
        ends = {int(place) for line in tables.beams for place in (line[0], line[-1])}
        joined_places = {GROUND, *(ends - self.free_nodes)}
        lines = [(int(line[0]), int(line[-1])) for line in joined(tables.beams, joined_places)]
        return [(a, b) for a, b in lines if a in joined_places and b in joined_places and a != b]

    def displaced(self, q: Array, u: Array, one: int, other: int) -> tuple[Motion, Motion, Array]:
        """Displacements of two places from the reference configuration, and the second one's place
        there.

        Args:
            q, u: Coordinates (nq,) and speeds (nu,) of everything.
            one, other: The places.

        Returns:
            Motion of what each place carries, and a position (3,).
        """
        x, ends = np.concatenate([q, u]), {GROUND: still(), **self._tree_ends(q, u)}
        first, second = (
            motion_of(self.tables, self.reference, x, place) if place >= 0 else ends[place]
            for place in (one, other)
        )
        place = one if other == GROUND else other
        on_node = place >= 0
        home = self.tables.pose(self.reference, place) if on_node else self._homes[ON_TREE - place]
        return first, second, home[4:]

    def _tree_ends(self, q: Array, u: Array) -> dict[int, Motion]:
        """Displacements of the bodies of rigid trees that beams end at, by place."""
        if not len(self._homes):
            return {}
        at = self._nodes(q, u)
        poses, speeds = at[ENDS[0]].reshape(-1, 7), at[ENDS[1]].reshape(-1, 6)
        bodies = zip(poses, speeds, self._homes, strict=True)
        return {ON_TREE - k: displacement(*body) for k, body in enumerate(bodies)}

    @cached_property
    def _home(self) -> Mapping[str, Array]:
        """States of nodes with all joints at their own defaults; those of one time stay there."""
        key, stored = (self.t, self.r.tobytes()), self.model._derived
        if stored.get(REFERENCE, ((),))[0] != key:
            joint_coordinates = np.array(self.model.manifest.elements.reference, dtype=np.float64)
            home = self._evaluated(joint_coordinates, np.zeros(len(self._blocks["u"])))
            stored[REFERENCE] = key, home
        home_states: Mapping[str, Array] = stored[REFERENCE][1]
        return home_states

    @cached_property
    def _homes(self) -> Array:
        """Poses (n, 7) of the bodies of rigid trees that beams end at, in the reference."""
        return np.reshape(self._home.get(ENDS[0], np.zeros(0)), (-1, 7))

    @cached_property
    def reference(self) -> Array:
        """Coordinates (nq,) at which beams are without stress: all joints at their own defaults."""
        located = self._home["q"]
        reference: Array = self.model._layout.start("q").copy()
        reference[: len(located)] = located
        return reference

    def _by_joints(self, x: Array) -> Array:
        q, u = self.model.split(x)[:2]
        by_joints, moved = self._nodes(q, u), x.copy()
        for first, values in ((0, by_joints["q"]), (len(q), by_joints["u"])):
            part = moved[first : first + len(values)]
            stays = self.fixed[first : first + len(values)]
            moved[first : first + len(values)] = np.where(stays, part, values)
        return moved

    def _nodes(self, q: Array, u: Array) -> Mapping[str, Array]:
        """The states of nodes by the coordinates and speeds of joints among (..., n)."""
        tree = [values[..., sources] for values, sources in
                zip((q, u), self._sources, strict=True)]  # fmt: skip
        for place, at, along in self._planes:
            # nodes of a plane told in space
            plane, tables = self.tables.plane(place), self.tables
            tree[0][..., at] = pose(plane, q[..., tables.q[place] : tables.q[place + 1]])
            tree[1][..., along] = speeds(plane, u[..., tables.u[place] : tables.u[place + 1]])
        return self._evaluated(*tree)

    def _located(self, q: Array) -> Array:
        """Coordinates of nodes by those of joints among q (nq,), at one position after another."""
        return self._at_once(q[self._sources[0]], np.zeros(len(self._blocks["u"])))["q"]

    def _blocks_of(self, q: Array, u: Array) -> dict[str, list[float]]:
        """Numbers of the blocks of the saved function: they are faster than arrays."""
        r = self.r[: len(self._blocks["r"])].tolist()
        return {"t": [self.t], "q": q.tolist(), "u": u.tolist(), "r": r, "p": self._parameters}

    @cached_property
    def _parameters(self) -> list[float]:
        numbers: list[float] = self.model.parameters.vector.tolist()
        return numbers

    def _evaluated(self, q: Array, u: Array) -> Mapping[str, Array]:
        if q.ndim == u.ndim == 1:
            return self._at_once(q, u)
        inputs: dict[str, Any] = {
            "t": np.array([self.t]),
            "q": q,
            "u": u,
            "p": self.model.parameters.vector,
            "r": self.r[: len(self._blocks["r"])],
        }
        evaluated: Mapping[str, Array] = self.model._evaluate_saved(SAVED, **inputs)
        return evaluated

    def _at_once(self, q: Array, u: Array) -> Mapping[str, Array]:
        """The states of nodes at one state of the joints.

        The last ones are remembered: a start asks for the same again and again.
        """
        latest = self.model._derived.setdefault(LATEST, {})
        key = (self.t, self.r.tobytes(), q.tobytes(), u.tobytes())
        results: Mapping[str, Array] | None = latest.get(key)
        if results is None:
            one = self.model._evaluate_saved(SAVED, **self._blocks_of(q, u))
            results = {name: np.array(values, dtype=np.float64) for name, values in one.items()}
            for oldest in list(latest)[: 1 - REMEMBERED]:
                latest.pop(oldest, None)
            latest[key] = results
        return {name: values.copy() for name, values in results.items()}


def _joint_sources(model: LoadedModel, tables: Tables) -> JointSources:
    """Where the saved function finds the joints: looked up by name once for all parameters."""
    function, stored = model._objects.form(SAVED), model._objects.joint_sources
    if not isinstance(stored, JointSources) or stored.function is not function:
        # coordinates of the tree have the same names here
        blocks = {block.name: block.entries for block in function.inputs}
        q, u = (_positions(names, blocks[letter]) for letter, names in
                (("q", model.coordinates), ("u", model.speeds)))  # fmt: skip
        planes = _planes(model, tables, blocks)
        stored = JointSources(
            function, blocks, (q, u), planes, _leading(model, tables, blocks["u"])
        )
        model._objects.joint_sources = stored
    return stored


def _positions(names: Collection[str], names_sought: Collection[str]) -> Integers:
    """Places of names; 0 for those of nodes that are told in a plane."""
    at = {name: k for k, name in enumerate(names)}
    return np.array([at.get(name, 0) for name in names_sought], dtype=np.intp)


def _wide(values: Array, like: Array) -> Array:
    """Values of the first entries (..., n), then those of another array (..., m)."""
    count = values.shape[-1]
    head = np.broadcast_to(values, (*like.shape[:-1], count))
    return np.concatenate([head, like[..., count:]], axis=-1)


def _planes(
    model: LoadedModel, tables: Tables, blocks: Mapping[str, Any]
) -> list[tuple[int, Integers, Integers]]:
    """Places told in a plane, with the entries of their pose and speeds in those of the tree."""
    at = {block: {name: k for k, name in enumerate(blocks[block])} for block in "qu"}
    # nodes inside of beams are the last places and no joints
    named = len(tables.kind) - sum(len(line) - 2 for line in tables.beams)
    planes = []
    for place, row in enumerate(islice(model.manifest.joints, named)):
        first = f"{row.name}.{POSE[0]}"
        if tables.plane(place) is not None and first in at["q"]:
            columns = [at["q"][f"{row.name}.{x}"] for x in POSE]
            along = [at["u"][f"{row.name}.u.{x}"] for x in MOTION]
            planes.append((place, np.array(columns), np.array(along)))
    return planes


def leading(model: LoadedModel) -> Mask:
    """Mask of the speeds of joints (nu,): nodes of bodies and beams follow those."""
    return _joint_sources(model, table_loading.tables_of(model)).leads.copy()


def _leading(model: LoadedModel, tables: Tables, names: Sequence[str]) -> Mask:
    """Same as :func:`leading`, from the names of the speeds of the tree."""
    speeds_read = set(names)
    beam_nodes, leads = set(model.manifest.elements.beam_nodes), np.zeros(model.nu, dtype=bool)
    on_node = np.array([kind.node for kind in tables.kinds], dtype=bool)
    rows = zip(
        column(model.manifest.joints, "name"),
        model._layout.joint_slots["u"].tolist(),
        on_node[tables.kind[: len(model.manifest.joints)]].tolist(),
        strict=True,
    )
    for place, (name, (start, count), node) in enumerate(rows):
        free = f"{name}.u.px" in speeds_read and place not in beam_nodes
        if count and (free or not node):
            leads[start : start + count] = True
    return leads
