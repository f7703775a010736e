"""Shapes of URDF and SDF links; mesh files stay below declared folders."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath

from ...errors import ModelError, counted
from .. import shape
from ..shape import Shape
from .document import Element

Origin = Callable[[Element, str], tuple[list[float], list[float]]]
Color = tuple[float, ...]


@dataclass
class Meshes:
    """Finds mesh files below declared folders.

    Attributes:
        packages: Folders below which ``package://`` and absolute paths must lie.
        folder: Of the file that refers to them; relative paths stay below it.
        missing: What was not found.
    """

    packages: tuple[Path, ...]
    folder: Path | None
    missing: list[str] = field(default_factory=list)

    def find(self, reference: str, where: str) -> str:
        """Path of a mesh, or the reference as written where no such file exists.

        Raises:
            ModelError: it leads out of the declared folders.
        """
        path = self.locate(reference, where, "mesh")
        if path is None:
            self.missing.append(reference)
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
                f"{where}: {what} '{reference[:80]}' leads out of the declared folders (packages=)"
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

    def notes(self) -> list[str]:
        if not self.missing:
            return []
        many = len(self.missing) > 1
        were, more = ("were", ", ...") if many else ("was", "")
        return [
            f"{counted(len(self.missing), 'mesh file')} {were} not found "
            f"({self.missing[0]}{more}); "
            "packages= names the folders to look in"
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
        # URDF and SDF have different words for it
        key = "filename" if mesh.word("uri") is None else "uri"
        file = meshes.find(mesh.text(key), geometry.where)
        scale = mesh.numbers("scale", 3, "1 1 1")
        return shape.mesh(file, scale=scale, position=position, rotation=rotation, color=color)
    return None
