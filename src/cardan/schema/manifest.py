"""The manifest: everything that is said about a model besides its C, as records.

Their fields are the only description of ``manifest.json``: what the compiler writes, what is
checked before anything of a file is used, and ``docs/manifest.schema.json``. Saved runs hold the
same rows. Within a version of the interface, fields are only added.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence

from ..errors import ModelError
from ..version import ABI, MANIFEST, Format
from .c_functions import FILE, HASH, IDENTIFIER, FunctionRow
from .entries import (
    CoordinateRow,
    Entry,
    EventRow,
    ForceRow,
    LimitRow,
    ModeRow,
    MultiplierRow,
    OutputRow,
    ParameterRow,
    SpeedRow,
    TickRow,
)
from .fields import (
    NOTHING,
    Kind,
    Misfit,
    Record,
    count,
    dumped,
    field,
    flag,
    listed,
    matching,
    number,
    one_of,
    table,
    text,
)
from .finite_elements import FiniteElements
from .mechanism import (
    GROUND,
    BeamRow,
    BodyRow,
    CutRow,
    ForceElementRow,
    FrameRow,
    JointRow,
    ShapeRow,
    SuperelementRow,
)
from .rows import SCHEMA, Rows, column, ends, rows_of
from .seal import unsealed
from .tree import Tree

# the entries of blocks of numbers
BLOCKS = {
    "q": "coordinates",
    "q0": "coordinates",
    "u": "speeds",
    "z": "z",
    "s": "s",
    "r": "inputs",
    "p": "parameters",
}


def _version(form: Format) -> Kind:
    """The version of a format; saved runs, which have their own, may have been written by any."""
    exact = one_of(form.version)
    return Kind(lambda value, run: (count if run else exact).read(value, run), exact.schema)


class Manifest(Record):
    """Contents of a model directory:

    names and units in the order of the arrays, the tree, and one entry per C function. Within a
    version of the interface, entries are only added.
    """

    abi: int = field(_version(ABI), "version of the calling convention in cardan.h", run=0)
    schema: int = field(_version(MANIFEST), "version of this schema", run=0)
    cardan: str = field(text, "version of cardan that wrote the model", run="")
    name: str = field(text)
    method: str = field(text, "formalism of the equations", run="")
    coordinates: Sequence[CoordinateRow] = field(rows_of(CoordinateRow), "entries of q")
    speeds: Sequence[SpeedRow] = field(rows_of(SpeedRow), "entries of u")
    z: Sequence[Entry] = field(listed(Entry), "internal continuous states", run=())
    s: Sequence[ModeRow] = field(listed(ModeRow), "discrete states", run=())
    events: Sequence[EventRow] = field(
        listed(EventRow), "what can happen, in the order of the block e", default=()
    )
    ticks: Sequence[TickRow] = field(
        listed(TickRow), "when events at known times happen", default=()
    )
    inputs: Sequence[Entry] = field(listed(Entry), "entries of r", run=())
    parameters: Sequence[ParameterRow] = field(listed(ParameterRow), "entries of p", run=())
    structural: Mapping[str, float] = field(
        table(number),
        "numbers that are part of the form of the equations, by dotted name",
        run=NOTHING,
    )
    limits: Sequence[LimitRow] = field(
        listed(LimitRow), "what parameters may be that are numbers of elements", default=()
    )
    multipliers: Sequence[MultiplierRow] = field(
        listed(MultiplierRow), "entries of lam: constraints of position level first", run=()
    )
    projected: bool = field(flag, "whether runs project states onto the constraints", default=True)
    isolated: bool = field(
        flag, "whether nothing but gravity acts from outside, so that momenta stay", default=False
    )
    finite_elements: FiniteElements | None = field(
        FiniteElements, "of a model in absolute coordinates", default=None
    )
    cuts: Sequence[CutRow] = field(listed(CutRow), "joints that close loops", run=())
    joints: Sequence[JointRow] = field(
        rows_of(JointRow), "one per moving body, in the order of the bodies", run=()
    )
    fixed: Sequence[str] = field(listed(text), "names of fixed joints, merged into bodies", run=())
    bodies: Sequence[BodyRow] = field(listed(BodyRow), "every parent before its children", run=())
    frames: Sequence[FrameRow] = field(listed(FrameRow), run=())
    beams: Sequence[BeamRow] = field(
        listed(BeamRow), "pieces of beams between named nodes", default=()
    )
    superelements: Sequence[SuperelementRow] = field(
        listed(SuperelementRow), "flexible bodies that were reduced", default=()
    )
    forces: Sequence[ForceElementRow] = field(listed(ForceElementRow), "force elements", default=())
    shapes: Sequence[ShapeRow] = field(listed(ShapeRow), "shapes for pictures", run=())
    outputs: Sequence[OutputRow] = field(listed(OutputRow), run=())
    element_forces: Sequence[ForceRow] = field(
        listed(ForceRow), "entries of element_forces: <element>.force and so on", default=()
    )
    quaternions: Sequence[int] = field(
        listed(count), "entries of q that begin a unit quaternion", run=()
    )
    notes: Sequence[str] = field(listed(text), run=())
    snaps: Sequence[str] = field(listed(text), "numbers of a file that were snapped", run=())
    available: Sequence[str] = field(
        listed(text), "functions that may be asked for while the compiler is at hand", run=()
    )
    absent: Mapping[str, str] = field(
        table(text), "functions that this system cannot have, and why", default=NOTHING
    )
    scene: Tree = field(Tree, run=Tree.read({}, run=True))
    functions: Mapping[str, FunctionRow] = field(table(FunctionRow, IDENTIFIER), run=NOTHING)
    prefix: str = field(
        matching("^([A-Za-z][A-Za-z0-9_]*)?$", "a name in C"),
        "before the names of all functions in C; in exports that were asked for one",
        default="",
    )
    precision: str = field(
        one_of("double", "single"), "of all numbers in C; single in exports only", default="double"
    )
    sha256: Mapping[str, str] = field(
        table(HASH, FILE), "hash of every other file of the directory", run=NOTHING
    )

    @property
    def absolute(self) -> bool:
        """True when its coordinates are those of nodes, its equations those of finite elements."""
        return self.method == "absolute"

    @property
    def elements(self) -> FiniteElements:
        """Elements of the model; only in finite-element coordinates."""
        assert self.finite_elements is not None
        return self.finite_elements

    @property
    def treatment(self) -> str:
        """Name of the way to make accelerations obey constraints, "" without any."""
        return self.scene.treatment.name if self.scene.treatment else ""

    def block(self, letter: str) -> Sequence[Entry]:
        """The entries of q, u, z, s, r or p."""
        rows: Sequence[Entry] = getattr(self, BLOCKS[letter])
        return rows

    def slots(self, letter: str) -> dict[str, slice]:
        """Entries of q, u or z by name: each by its own, joints for all that are theirs."""
        joints = zip(column(self.joints, "name"), column(self.joints, letter), strict=True)
        slots = {name: slice(slot[0], sum(slot)) for name, slot in joints if slot and slot[1]}
        for k, name in enumerate(column(self.block(letter), "name")):
            slots.setdefault(name, slice(k, k + 1))
        return slots

    @property
    def position_rows(self) -> int:
        """Number of constraints of positions."""
        return sum(row.level == "position" for row in self.multipliers)

    def fit(self, run: bool) -> None:
        """Names and places that rows speak of exist."""
        for problem in (*_joints(self), *_bodies(self), *_places(self), *_tree(self)):
            raise Misfit(problem)
        if not run:
            for problem in _functions(self):
                raise Misfit(problem)


def _joints(m: Manifest) -> Iterator[str]:
    """Entries of joints in q and u, and joints that follow others."""
    most = {"q": len(m.coordinates), "u": len(m.speeds)}
    # a pattern may speak of any number of rows
    if isinstance(m.coordinates, Rows) and any(x.values.size < len(x) for x in m.coordinates.runs):
        yield "it has more coordinates than numbers of where they start"
        return
    for rows in (m.joints, m.speeds):
        if isinstance(rows, Rows) and len(rows) > len(rows.listed) + most["q"]:
            yield "it has more joints and speeds than coordinates"
            return
    for row in ends(m.joints):
        for block, (start, length) in (("q", row.q or (0, 0)), ("u", row.u or (0, 0))):
            if start + length > most[block]:
                yield f"joint '{row.name}' is beyond {block}"
    leaders = {row.name: row.coupled.leader for row in ends(m.joints) if row.coupled}
    names = {row.name for row in m.joints} if leaders else set()
    for name in leaders:
        follow = name
        for _ in range(len(leaders) + 1):
            follow = leaders.get(follow, "")
            if not follow:
                break
            if follow not in names:
                yield f"joint '{name}' follows none"
        if follow:
            yield f"joint '{name}' follows itself"


def _bodies(m: Manifest) -> Iterator[str]:
    """Bodies, frames, beams and shapes."""
    nq, nu = len(m.coordinates), len(m.speeds)
    bodies, frames = ({row.name for row in rows} for rows in (m.bodies, m.frames))
    with_frames = {row.body for row in m.frames}
    if len(frames) != len(m.frames):
        yield "two frames have one name"
    for body in m.bodies:
        if body.parent not in bodies and body.parent != GROUND:
            yield f"body '{body.name}' is nowhere"
        if body.parts and not ({*body.parts} <= frames and body.name in with_frames):
            yield f"body '{body.name}' has no frame"
    for frame in m.frames:
        if frame.body not in bodies and frame.body != GROUND:
            yield f"frame '{frame.name}' is nowhere"
        if frame.node is not None and m.absolute:
            sizes = (3, 3) if frame.plane else (7, 6)
            if frame.node[0] + sizes[0] > nq or frame.node[1] + sizes[1] > nu:
                yield f"frame '{frame.name}' is beyond q"
    for beam in m.beams:
        if not {beam.start, beam.end} <= frames:
            yield f"beam '{beam.name}' has no ends"
        if beam.q[0] + (3 if beam.plane else 7) * beam.q[1] > nq:
            yield f"beam '{beam.name}' is beyond q"
    for superelement in m.superelements:
        if superelement.frame not in frames or any(k >= nq for k in superelement.q):
            yield f"superelement '{superelement.name}' is nowhere"
        if not {*superelement.outputs} <= {output.name for output in m.outputs}:
            yield f"the loads of superelement '{superelement.name}' are not among the outputs"
    if not {shape.frame for shape in m.shapes} <= frames:
        yield "a shape is nowhere"
    if not m.absolute and m.bodies and len(bodies) != len(m.joints):
        yield "it has not a joint for every body"


def _places(m: Manifest) -> Iterator[str]:
    """Places that the kernels take from rows."""
    if any(k + 4 > len(m.coordinates) for k in m.quaternions):
        yield "a quaternion is beyond q"
    if any(tick.event >= len(m.events) for tick in m.ticks):
        yield "a sample is of no event"


def _tree(m: Manifest) -> Iterator[str]:
    """Checks of the data from which poses follow."""
    tree, joints = m.scene, len(m.joints)
    if m.absolute or tree.empty:
        return
    sizes = {len(tree.parents), len(tree.kinds), len(tree.rotations)}
    if sizes != {joints} or len(tree.curves) not in (0, joints):
        yield "its tree has another number of joints"
    if not all(-1 <= parent < i for i, parent in enumerate(tree.parents)):
        yield "its tree is damaged"


def _functions(m: Manifest) -> Iterator[str]:
    """Checks of the functions of the model."""
    if m.absolute != (m.finite_elements is not None):
        yield "its method and its finite elements do not fit each other"
    if len(m.beams) != (m.elements.segments if m.absolute else 0):
        yield "its beams are not those of its finite elements"
    closed = m.functions.get("constraints")
    if closed is not None and closed.output_size != m.position_rows:
        yield f"{m.position_rows} rows tell of {closed.output_size} constraints of positions"


def checked_manifest(plain: object, where: str) -> Manifest:
    """The manifest of a model that came from outside.

    Args:
        plain: What JSON held.
        where: What to call it in errors.

    Raises:
        ModelError: it is none, of another version, or a part of it is not what it has to be.
    """
    if not isinstance(plain, dict):
        raise ModelError(f"{where} is not a manifest")
    for form in (ABI, MANIFEST):
        version = plain.get(form.word)
        if not form.reads(version):
            raise ModelError(form.refusal(where, version, plain.get("cardan")))
    try:
        return Manifest.read(plain)
    except Misfit as misfit:
        raise ModelError(f"{where}: {misfit}. Compile the model again") from None


# manifests by the content of their files, those that were read or written last
_CONTENTS: dict[bytes, Manifest] = {}
REMEMBERED = 4


def from_file(content: bytes, where: str) -> Manifest:
    """The manifest in a file, read once as long as that stays as it is.

    Args:
        content: Of the file.
        where: What to call it in errors.

    Raises:
        ValueError: it is damaged.
        ModelError: as :func:`checked_manifest`.
    """
    manifest = _CONTENTS.get(content)
    if manifest is None:
        manifest = checked_manifest(unsealed(content), where)
        remember(content, manifest)
    return manifest


def statement(manifest: Manifest) -> str:
    """Text of all that a manifest says of its model, whatever functions have been written of it."""
    return dumped(manifest.replaced(functions={}, sha256={}, available=[]))


def remember(content: bytes, manifest: Manifest) -> None:
    """Let a manifest be known by the content of its file, which need not be read then.

    Args:
        content: Exactly what was written of this manifest, or what it was read from.
        manifest: Its parts are checked.
    """
    # from a copy of the keys, as other threads add and drop some meanwhile
    for oldest in list(_CONTENTS)[: 1 - REMEMBERED]:
        _CONTENTS.pop(oldest, None)
    _CONTENTS[content] = manifest


def json_schema() -> str:
    """Text of ``docs/manifest.schema.json``."""
    digest = {
        "type": "string",
        "description": "SHA-256 of the text of this file with 64 zeros in the place of the hash; "
        "it finds damage, not malice",
    }
    said = Manifest.json_schema()
    schema = {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "manifest.json of a cardan model",
        "description": " ".join((Manifest.__doc__ or "").split()),
        **said,
        "properties": {"digest": digest, **said["properties"]},
        "$defs": {"runs": SCHEMA},
    }
    return json.dumps(schema, indent=2) + "\n"
