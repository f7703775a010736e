"""Beams of a system alone: their nodes are free, and all else is cut away."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import field, replace
from functools import cached_property

import numpy as np

from ...arrays import Array
from ...elements.joints.free import Free
from ...errors import ModelError, brief, near
from ...ir.function import Function, Output
from ...ir.graph import ZERO
from ...ir.interpreter import evaluate
from ...records import dataclass
from ...scene.scene import SceneRecord
from ...topology.beams.beams import quaternion
from ...topology.beams.segment_tables import Segment
from ...topology.conversion import IDENTITY, ORIGIN
from ...topology.system import GROUND, Body, Frame, Joint, Nodes, Part, System
from ..functions.blocks import parameters

LOADS = ("dead_force", "dead_moment", "follower_force", "follower_moment")
# a node of a beam by name, or a body of the scene by number
Key = str | int


@dataclass(frozen=True)
class BeamSystem:
    """Beams with free nodes in the reference configuration.

    Attributes:
        scene, original: From which they were cut.
        system: Their nodes, as free bodies, and segments.
        rotations, positions: Of these bodies (n, 3, 3) and (n, 3) [m].
        ends: Named nodes of the beams -> their body and position.
        bodies: Bodies of the original -> bodies here.
    """

    scene: SceneRecord
    original: System
    system: System
    rotations: Array
    positions: Array
    ends: Mapping[str, tuple[int, Array]]
    bodies: Mapping[int, int]

    def on_body(self, frame: int) -> tuple[int, Array] | None:
        """Body and position of a frame of the original; None where it is on no body here."""
        at = self.original.frames[frame]
        if at.body not in self.bodies:
            return None
        body = self.bodies[at.body]
        arm = numbers(self.original, at.position)
        return body, self.positions[body] + self.rotations[body] @ arm


def isolated(
    scene: SceneRecord, system: System, beams: Sequence[str], bodies: Sequence[str]
) -> BeamSystem:
    """Beams of a scene with some of its rigid bodies, free of everything else.

    Beams are joined at nodes of beams and at the bodies that are named. Other bodies, and the
    ground, are left out: each end there becomes a node of its own.

    Args:
        scene, system: The scene, and its system.
        beams, bodies: By name.

    Raises:
        ModelError: beams that are stressed, or parts that are not connected.
    """
    cut = _Cut(scene, system, frozenset(bodies))
    segments = [one for one in system.segments if one.name in beams]
    _check_unstressed(system, segments)
    chosen = tuple(cut.segment(segment, names) for segment, names in _named(scene, segments))
    cut.check_connected(segments)
    alone = System(
        name=system.name,
        graph=system.graph,
        gravity=ORIGIN,
        bodies=tuple(cut.bodies),
        joints=tuple(cut.joints),
        frames=tuple(cut.frames),
        forces=(),
        parameters=system.parameters,
        inputs=(),
        outputs=(),
        atoms={},
        nq=7 * len(cut.bodies),
        nu=6 * len(cut.bodies),
        segments=chosen,
    )
    rotations, positions = (np.array(part) for part in zip(*cut.poses, strict=True))
    at = {key: k for key, k in cut.numbers.items() if isinstance(key, int)}
    return BeamSystem(scene, system, alone, rotations, positions, cut.ends, at)


def numbers(system: System, nodes: Nodes) -> Array:
    """Expressions at the values of the parameters."""
    output = Output("data", (len(nodes),), nodes)
    function = Function("place", system.graph, (parameters(system),), (output,), ("ground",))
    p = [parameter.value for parameter in system.parameters]
    return np.array(evaluate(function, {"p": p})["data"], dtype=float)


def _named(
    scene: SceneRecord, segments: Sequence[Segment]
) -> Iterator[tuple[Segment, tuple[str, str]]]:
    """Segments with the names of their ends."""
    count: dict[str, int] = {}
    for segment in segments:
        beam, k = scene.beams[segment.name], count.get(segment.name, 0)
        stops = [name for _, name in sorted((s, name) for name, s in beam.stops.items())]
        names = (f"{beam.name}.start", *stops, f"{beam.name}.end")
        count[segment.name] = k + 1
        yield segment, (names[k], names[k + 1])


def _check_unstressed(system: System, segments: Sequence[Segment]) -> None:
    """Refuse beams with stress: their stiffness depends on what holds them.

    Raises:
        ModelError: it names the beam.
    """
    for segment in segments:
        strain = numbers(system, segment.data["strain"][2])
        if strain.any():
            raise ModelError(
                f"beam '{segment.name}': temperature= or prestrain= stress it as soon as it is "
                "held; a superelement is linear about a shape without stress. Leave them out, or "
                "keep the beam as it is"
            )


@dataclass
class _Cut:
    """Collects bodies, joints and frames of beams alone."""

    scene: SceneRecord
    system: System
    chosen: frozenset[str]
    bodies: list[Body] = field(default_factory=list)
    joints: list[Joint] = field(default_factory=list)
    frames: list[Frame] = field(
        default_factory=lambda: [Frame("ground", GROUND, 0, IDENTITY, ORIGIN)]
    )
    poses: list[tuple[Array, Array]] = field(default_factory=list)
    numbers: dict[Key, int] = field(default_factory=dict)
    ends: dict[str, tuple[int, Array]] = field(default_factory=dict)
    joined: dict[str, set[int]] = field(default_factory=dict)

    @cached_property
    def _joining(self) -> set[int]:
        """Bodies of the system at which beams are joined: nodes of beams, and those named."""
        nodes = {name for name, place in self.scene.nodes.items() if place.name == name}
        names = nodes | self.chosen
        return {k for k in range(-1, len(self.system.bodies)) if names & self._names(k)}

    def _parts(self, body: int) -> tuple[Part, ...]:
        return self.system.ground_parts if body == GROUND else self.system.bodies[body].parts

    def _names(self, body: int) -> set[str]:
        return {part.name for part in self._parts(body)}

    def segment(self, segment: Segment, names: tuple[str, str]) -> Segment:
        """A segment between free nodes, without loads."""
        frames = []
        for name, number, at in zip(
            names, (segment.frame_a, segment.frame_b), (0, -1), strict=True
        ):
            frame, line = self.system.frames[number], segment.line
            pose = line.rotations[at], line.positions[at]
            if frame.body in self._joining:
                local = frame.rotation, frame.position
                values = numbers(self.system, (*frame.rotation, *frame.position))
                R = pose[0] @ values[:9].reshape(3, 3).T
                body = self._body(frame.body, name, (R, pose[1] - R @ values[9:]))
            else:
                local = IDENTITY, ORIGIN
                body = self._body(name, name, pose)
            self.ends[name] = body, pose[1]
            self.joined.setdefault(segment.name, set()).add(body)
            frames.append(len(self.frames))
            self.frames.append(Frame(name, body, 0, *local))
        nothing = dict.fromkeys(LOADS, (3, 1, ORIGIN))
        data = {**segment.data, **{name: x for name, x in nothing.items() if name in segment.data}}
        return replace(
            segment,
            frame_a=frames[0],
            frame_b=frames[1],
            data=data,
            fields=(),
            variable_loads=nothing,
        )

    def _body(self, key: Key, name: str, pose: tuple[Array, Array]) -> int:
        """Number of the free body of a node, made at the first request."""
        if key in self.numbers:
            return self.numbers[key]
        k = self.numbers[key] = len(self.bodies)
        mass: int = ZERO
        moment: Nodes = ORIGIN
        inertia: Nodes = (ZERO,) * 9
        add = self.system.graph.add
        for part in self._parts(key) if isinstance(key, int) else ():
            if part.name in self.chosen:
                mass = add(mass, part.mass)
                moment = tuple(map(add, moment, part.first_moment))
                inertia = tuple(map(add, inertia, part.inertia))
        self.poses.append(pose)
        self.frames.append(Frame(name, k, 0, IDENTITY, ORIGIN))
        self.bodies.append(Body(name, GROUND, mass, moment, inertia, ()))
        q0 = (*quaternion(pose[0]), *(float(x) for x in pose[1]))
        self.joints.append(
            Joint(
                name=name,
                element=Free(),
                data={},
                parent_frame=0,
                child_frame=len(self.frames) - 1,
                rotation=IDENTITY,
                position=ORIGIN,
                q=7 * k,
                u=6 * k,
                q0=q0,
                implicit=True,
            )
        )
        return k

    def check_connected(self, segments: Sequence[Segment]) -> None:
        """Refuse a component in several parts, and bodies that it does not touch.

        Raises:
            ModelError: it names a beam or a body, and what would connect it.
        """
        first, *separate = self.joined
        connected = set(self.joined[first])
        while more := [name for name in separate if self.joined[name] & connected]:
            connected.update(*(self.joined[name] for name in more))
            separate = [name for name in separate if name not in more]
        if separate:
            raise ModelError(
                f"beams '{first}' and '{separate[0]}' are not connected.{self._remedy(segments)}"
            )
        touched = set[str]().union(*(self._names(k) for k in self.numbers if isinstance(k, int)))
        for name in sorted(self.chosen - touched):
            candidates = [n for n in self._touching(segments) if n != name]
            listed = f" Bodies at their ends: {', '.join(candidates)}" if candidates else ""
            raise ModelError(f"bodies: '{name}' is at no end of these beams; leave it out.{listed}")

    def _touching(self, segments: Collection[Segment]) -> list[str]:
        """Bodies of the scene at ends of beams, in their order."""
        frames = [self.system.frames[k] for s in segments for k in (s.frame_a, s.frame_b)]
        names = [part.name for frame in frames for part in self._parts(frame.body)]
        return [name for name in dict.fromkeys(names) if name in self.scene.bodies]

    def _remedy(self, segments: Sequence[Segment]) -> str:
        """Joints and elements that would connect beams."""
        beams: dict[int, set[str]] = {}
        for segment in segments:
            for number in (segment.frame_a, segment.frame_b):
                beams.setdefault(self.system.frames[number].body, set()).add(segment.name)
        common = [
            next(iter(self._parts(body))).name
            for body, names in beams.items()
            if len(names) > 1 and body not in self._joining and self._parts(body)
        ]
        if common:
            listed = ", ".join(f"'{name}'" for name in common)
            return f" They meet at a rigid body: add bodies=[{listed}]"
        return (
            " A joint between them moves, and the ground is no part of them: reduce each by itself"
        )


def named_beams(scene: SceneRecord, names: Sequence[str]) -> None:
    """Make sure that beams exist.

    Raises:
        ModelError: one does not, or none is named.
    """
    if not names:
        raise ModelError("beams: give at least one, such as 'boom'")
    for name in names:
        if name not in scene.beams:
            if not scene.beams:
                raise ModelError(
                    f"beams: scene '{scene.name}' has no beams. cd.superelement.from_mesh takes "
                    "solids, cd.superelement.reduce matrices"
                )
            listed = near(name, scene.beams).replace(" Known:", " Beams:")
            raise ModelError(f"beams: there is no beam {brief(name)}.{listed}")
