"""Shapes of URDF and SDF links; mesh files stay below declared folders."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import field
from pathlib import Path, PurePosixPath

from ...errors import ModelError, NoteOnFiles, counted
from ...records import dataclass
from .. import shape
from ..shape import Shape
from .document import Element

Origin = Callable[[Element, str], tuple[list[float], list[float]]]
Color = tuple[float, ...]
MAX_NAMED = 4  # meshes in one note


@dataclass
class Meshes:
    """Finds mesh files below declared folders.

    Attributes:
        packages: Folders below which ``package://`` and absolute paths must lie.
        folder: Of the file that refers to them; relative paths stay below it.
        key: What a <mesh> calls its file: ``filename`` in URDF, ``uri`` in SDF.
        missing: Those not found, each with its owner.
    """

    packages: tuple[Path, ...]
    folder: Path | None
    key: str = "filename"
    missing: list[tuple[str, str]] = field(default_factory=list)

    def find(self, reference: str, where: str) -> str:
        """Path of a mesh, or the reference as written where no such file exists.

        Args:
            where: Its owner, such as ``link 'rod'``.

        Raises:
            ModelError: it leads out of the declared folders.
        """
        path = self.locate(reference, where, "mesh")
        if path is None:
            self.missing.append((reference, where))
        return reference if path is None else str(path)

    def locate(self, reference: str, where: str, what: str) -> Path | None:
        """An existing file below the declared folders, None where there is none.

        Args:
            what: Such as ``mesh``, for messages.

        Raises:
            ModelError: it leads out of the declared folders.
        """
        if "\0" in reference or len(reference) > 4096:
            raise ModelError(f"{where}: {what} {reference[:60]!r} is not a file name")
        scheme, _, remainder = reference.partition("://")
        if not remainder:
            scheme, remainder = "", reference
        elif scheme not in ("package", "model", "file"):
            raise ModelError(f"{where}: {what} '{reference[:80]}': '{scheme}' paths are not read")
        if scheme in ("package", "model"):
            # some files have three slashes there
            remainder = remainder.lstrip("/")
        parts = PurePosixPath(remainder).parts
        if ".." in parts and not self._stays(parts):
            raise ModelError(
                f"{where}: {what} '{reference[:80]}' leads out of the declared folders, "
                f"{self._searched()}; write it as package://... and name the folder that it starts "
                "from with packages="
            )
        return next((path for path in self._candidates(remainder) if path.is_file()), None)

    def _stays(self, parts: tuple[str, ...]) -> bool:
        depth = 0
        for part in parts:
            depth += -1 if part == ".." else 1
            if depth < 0 or part == "/":
                return False
        return True

    def _candidates(self, remainder: str) -> list[Path]:
        """Places to look, links followed, that lie below a declared folder."""
        roots = [*self.packages, *([self.folder] if self.folder else [])]
        candidates = []
        for root in roots:
            home = root.resolve()
            tries = [home / remainder]
            first, _, after = remainder.partition("/")
            if first == home.name:
                tries.append(home / after)
            candidates += [p for t in tries if (p := t.resolve()).is_relative_to(home)]
        return candidates

    def _searched(self) -> str:
        """The folders to look in, for messages."""
        folders = [f"'{root}'" for root in self.packages]
        if self.folder is not None:
            # a file that was named without its folder stands where the user is
            name = "" if self.folder == Path() else f" ('{self.folder}')"
            folders.append(f"the folder of the file{name}")
        return " and ".join(folders) or "no folder"

    def notes(self) -> list[str]:
        """What was not found, whose it is, where it was looked for and what to do."""
        if not self.missing:
            return []
        references = [reference for reference, _ in self.missing]
        meshes = [f"'{reference[:80]}' of {where}" for reference, where in self.missing]
        more = f" and {len(meshes) - MAX_NAMED} more" if len(meshes) > MAX_NAMED else ""
        were = "was" if len(meshes) == 1 else "were"
        named = any("://" in reference or reference.startswith("/") for reference in references)
        relative = any("://" not in reference for reference in references)
        cures = [
            *(["relative paths start at the folder of the file"] if relative else []),
            *(["packages= names the folders to look in"] if named else []),
        ]
        return [
            NoteOnFiles(
                f"{counted(len(meshes), 'mesh file')} {were} not found in {self._searched()}: "
                f"{', '.join(meshes[:MAX_NAMED])}{more}; {'; '.join(cures)}"
            )
        ]


def shapes(
    link: Element,
    meshes: Meshes,
    origin: Origin,
    color: Callable[[Element], Color | None] = lambda visual: None,
) -> tuple[Shape, ...]:
    """Shapes to draw for a link: its <visual> elements.

    Args:
        link: The link.
        meshes: Finds files.
        origin: Element that has an <origin> -> its position and angles.
        color: <visual> -> its color, None without.
    """
    shapes_read = []
    for visual in link.children("visual"):
        geometry = visual.child("geometry")
        if geometry is None:
            continue
        position, rpy = origin(visual, f"{link.where} visual")
        rotation = ("xyz", *rpy) if any(rpy) else None
        shape = _shape(geometry, meshes, position, rotation, color(visual))
        if shape is not None:
            shapes_read.append(shape)
    return tuple(shapes_read)


def _shape(
    geometry: Element, meshes: Meshes, position: list[float], rotation: object, color: Color | None
) -> Shape | None:
    box, cylinder = geometry.child("box"), geometry.child("cylinder")
    sphere, mesh, capsule = (geometry.child(tag) for tag in ("sphere", "mesh", "capsule"))
    if box is not None:
        x, y, z = box.numbers("size", 3)
        return shape.box(x, y, z, position=position, rotation=rotation, color=color)
    if cylinder is not None:
        radius, length = cylinder.number("radius"), cylinder.number("length")
        return shape.cylinder(radius, length, position=position, rotation=rotation, color=color)
    if capsule is not None:
        radius, length = capsule.number("radius"), capsule.number("length")
        return shape.capsule(radius, length, position=position, rotation=rotation, color=color)
    if sphere is not None:
        return shape.sphere(sphere.number("radius"), position=position, color=color)
    if mesh is not None:
        # the first versions of SDF had the word of URDF
        key = "filename" if mesh.word("filename") is not None else meshes.key
        file = meshes.find(mesh.text(key), geometry.where)
        scale = mesh.numbers("scale", 3, "1 1 1")
        return shape.mesh(file, scale=scale, position=position, rotation=rotation, color=color)
    return None
