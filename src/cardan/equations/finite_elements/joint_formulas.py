"""What a joint between nodes holds, as formulas for readers.

P is the frame of the joint on its parent and C that on its child; R_P, p_P and R_C, p_C are their
poses. The rows are those of the joint itself, written out in the entries of a relative pose.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence

from ...elements.formulas import MULTIPLIERS, Lines
from ...elements.joints.joint import Component
from ...elements.joints.joint import Joint as JointElement
from ...elements.quantity import RATIO
from ...ir.arithmetic import sqrt
from ...ir.forms.python_text import formulas
from ...ir.graph import ONE
from ...ir.matrix import Matrix
from ...ir.rewrite import rebuild
from ...spatial.axis import complement, principal
from ..kinematics.kinematics import Kinematics

Directions = Mapping[str, str]

# entries of R, p and of the twist of the child
ENTRIES = (
    *(f"R_{i}{j}" for i in "123" for j in "123"),
    *(f"{letter}_{i}" for letter in ("p", "omega", "v") for i in "123"),
)
CLOSING: Lines = (
    ("pose of the child's frame C seen from the parent's frame P", "R = R_P.T @ R_C"),
    ("", "p = R_P.T @ (p_C - p_P)"),
)
RELATIVE_VELOCITY: Lines = (
    ("velocities of C against P, in axes of C", "omega = omega_C - R.T @ omega_P"),
    ("", "v = R.T @ (R_P.T @ (v_C - v_P) - skew(omega_P) @ p)"),
)
# letters of entries side by side that a narrow page has room for
WIDE = 20
# letters of an entry of a matrix that gets a line of its own where there is no room
LONG = 5
# letters of unit vectors
NORMALS = "nml"
# letters of two directions across one of them
ACROSS = ("a", "b")
TRIAD: Lines = (
    ("directions across {n}, with it a right-handed triad", "sigma = -1 if {n}_3 < 0 else 1"),
    ("", "eta = -(1 / (sigma + {n}_3))"),
    ("", "a = column(1 + sigma * eta * {n}_1 ** 2, sigma * eta * {n}_1 * {n}_2, -(sigma * {n}_1))"),
    ("", "b = column(eta * {n}_1 * {n}_2, sigma + eta * {n}_2 ** 2, -{n}_2)"),
)


class _UnreadableError(Exception):
    """Something has no formula that people read."""


def joint_lines(k: Kinematics) -> Lines:
    """Formulas of cut joint 0 of a small system; that of its balance alone where it has none."""
    try:
        return (*_Writer(k).lines(), *MULTIPLIERS)
    except _UnreadableError:
        return MULTIPLIERS


class _Writer:
    """Writes the rows of cut joint 0 of a small system."""

    def __init__(self, k: Kinematics) -> None:
        self.k, self.graph, self.cut = k, k.graph, k.system.cuts[0]
        self.atoms: dict[int, str] = {}
        self.lengths: dict[int, int] = {}
        self.across: dict[int, int] = {}
        nodes = [self._atom(name) for name in ENTRIES]
        self.R, self.p = Matrix(self.graph, 3, 3, nodes[:9]), Matrix(self.graph, 3, 1, nodes[9:12])
        self.twist = Matrix(self.graph, 6, 1, nodes[12:])
        self.definitions = 0
        self.directions: list[tuple[str, str]] = []
        self.triad: Lines = ()

    def _atom(self, name: str) -> int:
        node = self.graph.atom(f"row of a joint: {name}")
        self.atoms[node] = name
        return node

    def lines(self) -> Iterator[tuple[str, str]]:
        """Directions, poses, rows of positions, rows of velocities."""
        rows = list(self._poses_and_rows())
        read = " ".join(line for _, line in rows)
        yield from self.directions
        if re.search(r"\b[ab]_\d", read):
            yield from self.triad
        yield from rows

    def _poses_and_rows(self) -> Iterator[tuple[str, str]]:
        element, carrier = self.cut.element, self.cut.carrier
        if carrier is not None:
            yield from self._moving(carrier)
        data, _ = self._directions(
            element, {name: self.k.matrix(*entry) for name, entry in self.cut.data.items()}
        )
        if carrier is None:
            yield from CLOSING
        position = element.closure(self.R, self.p, **data)
        if position.rows:
            yield from self._column(f"what vanishes: {_rows(element.locked)}", "g", position)
        if carrier is not None:
            return
        slip = element.slip(self.R, self.p, self.twist, **data)
        if slip is not None:
            yield from RELATIVE_VELOCITY
            yield from self._column(f"velocities that vanish: {_rows(element.slips)}", "s", slip)

    def _moving(self, carrier: int) -> Iterator[tuple[str, str]]:
        """Pose of the child against that at the coordinates of the joint."""
        element, g = self.k.system.joints[carrier].element, self.graph
        q, u = self.k.coordinates[carrier], self.k.speeds[carrier]
        data, directions = self._directions(element, self.k.data[carrier])
        rotation, shift = element.pose(q, **data)
        about = "at the coordinates q of the joint, seen from the parent's frame P"
        axes, position, ahead = "R_P", "R_P.T @ (p_C - p_P)", ""
        if rotation.nodes != Matrix.identity(g, 3).nodes:
            product = self._rotations(element, q, directions)
            if product:
                yield f"rotation {about}", f"R_q = {product}"
            else:
                yield from self._matrix(f"rotation {about}", "R_q", rotation)
            axes, ahead = "(R_P @ R_q)", "R_q.T @ "
        if not shift.is_zero:
            yield from self._matrix(f"position {about}", "p_q", shift)
            position = f"({position} - p_q)" if ahead else f"{position} - p_q"
        yield "pose of the child's frame C seen from there", f"R = {axes}.T @ R_C"
        yield "", f"p = {ahead}{position}"
        if element.slips:
            slip = element.sliding(q, u, **data)
            if slip is not None:
                about = f"velocities that vanish: {_rows(element.slips)}"
                yield from self._column(about, "s", slip)

    def _directions(
        self, element: JointElement, data: Mapping[str, Matrix]
    ) -> tuple[dict[str, Matrix], Directions]:
        """Letters for unit vectors along oblique directions, and for two across.

        Returns:
            The data with the entries of the letters, and the letters by name.
        """
        replaced, letters = dict(data), dict[str, str]()
        for name, matrix in data.items():
            vector = (matrix.rows, matrix.columns) == (3, 1)
            if element.units.get(name) != RATIO or not vector or principal(matrix) is not None:
                continue
            letter = NORMALS[len(letters)]
            definitions, entries = self._texts(matrix)
            self.directions += [("", line) for line in definitions]
            self.directions.append(
                (f"unit vector ({name})", f"{letter} = unit({', '.join(entries)})")
            )
            atoms = self._vector(letter)
            self.lengths[sqrt(atoms.dot(atoms)).node] = ONE
            replaced[name], letters[name] = atoms, letter
            if len(letters) == 1:
                self._across(letter, atoms)
        return replaced, letters

    def _vector(self, letter: str) -> Matrix:
        return Matrix(self.graph, 3, 1, [self._atom(f"{letter}_{i}") for i in "123"])

    def _across(self, letter: str, n: Matrix) -> None:
        """Letters for the two directions across a unit vector that rows are told by."""
        for across, direction in zip(ACROSS, complement(n), strict=True):
            for node, entry in zip(direction.nodes, self._vector(across).nodes, strict=True):
                self.across[node] = entry
                op, *inner = self.graph.nodes[node]
                # signs are written where an entry is read
                if op == "neg" and inner[0] not in n.nodes:
                    self.across[inner[0]] = self.graph.neg(entry)
        self.triad = tuple((x.format(n=letter), line.format(n=letter)) for x, line in TRIAD)

    def _rotations(self, element: JointElement, q: Matrix, directions: Directions) -> str:
        """The rotation as a product of rotations about unit vectors; "" where it is none."""
        angles = list[tuple[str, int]]()
        if element.line in directions and element.angle is not None:
            angles = [(directions[element.line], element.angle)]
        elif element.steps() and directions:
            names = [component.name for component in element.coordinates]
            for step in element.steps():
                about = [x for name, x in directions.items() if getattr(element, name) == step.axis]
                if not about or step.slides:
                    return ""
                angles.append((about[0], names.index(step.component)))
        texts = self._texts(q)[1]
        return " @ ".join(f"rotation({letter}, {texts[n]})" for letter, n in angles)

    def _matrix(self, about: str, left: str, x: Matrix) -> Iterator[tuple[str, str]]:
        """A matrix, with entries on lines of their own where it is wide."""
        definitions, entries = self._texts(x)
        columns = [entries[j :: x.columns] for j in range(x.columns)]
        if sum(max(map(len, column)) for column in columns) > WIDE:
            for n, entry in enumerate(entries):
                if len(entry) > LONG:
                    i, j = divmod(n, x.columns)
                    name = f"Q_{i + 1}{j + 1}" if x.columns > 1 else f"d_{i + 1}"
                    definitions.append(f"{name} = {entry}")
                    entries[n] = name
        for definition in definitions:
            yield "", definition
        function = "matrix" if x.columns > 1 else "column"
        yield about, f"{left} = {function}({', '.join(entries)})"

    def _column(self, about: str, left: str, x: Matrix) -> Iterator[tuple[str, str]]:
        """Rows, each on a line of its own where they are long."""
        definitions, entries = self._texts(x)
        if any(len(entry) > WIDE for entry in entries):
            for n, entry in enumerate(entries):
                definitions.append(f"{left}_{n + 1} = {entry}")
                entries[n] = f"{left}_{n + 1}"
        for definition in definitions:
            yield "", definition
        yield about, f"{left} = column({', '.join(entries)})"

    def _texts(self, x: Matrix) -> tuple[list[str], list[str]]:
        """Definitions, and entries in terms of them."""
        nodes = rebuild(self.graph, x.nodes, self.lengths, into=self.graph)[1]
        nodes = rebuild(self.graph, nodes, self.across, into=self.graph)[1]
        result = formulas(self.graph, nodes, self._leaf, "c", self.definitions)
        if result is None:
            raise _UnreadableError
        self.definitions += len(result[0])
        return result

    def _leaf(self, i: int) -> str | None:
        """Name of a leaf."""
        op, name, *indices = self.graph.nodes[i]
        if op == "atom":
            return self.atoms.get(i)
        if name == "p":
            return self.k.system.parameters[indices[0]].name.replace(".", "_")
        if name in ("q", "u"):
            return self._coordinate(name, indices[0])
        return {"t": "t", "r": f"r_{indices[0] + 1}"}.get(name)

    def _coordinate(self, letter: str, slot: int) -> str | None:
        """Name of a coordinate or speed of the joint, or of the joint that it follows."""
        for i, joint in enumerate(self.k.system.joints):
            first = joint.q if letter == "q" else joint.u
            entries = joint.element.coordinates if letter == "q" else joint.element.speeds
            if 0 <= first <= slot < first + len(entries):
                head = letter if i == self.cut.carrier else f"{letter}_leader"
                return head if len(entries) == 1 else f"{head}_{slot - first + 1}"
        return None


def _rows(components: Sequence[Component]) -> str:
    """Names of rows."""
    return ", ".join(component.name or "itself" for component in components)
