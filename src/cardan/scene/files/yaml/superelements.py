"""Superelements of a scene file: records, matrices and meshes in files beside it."""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING

from ....errors import ArgumentError, ModelError, SolveError
from ....superelements.readers import companions, read_files
from ....superelements.readers.matrix_files import reduced
from ....superelements.record import SuperelementRecord
from ....superelements.storage import load
from ...scene import SceneRecord
from ...superelement_arguments import add_superelement
from ..options import Options
from . import keys
from .item import Item

if TYPE_CHECKING:
    from .values import Values

ROLES = ("mass", "nodes", "dofs")
SOURCES = ("file", "matrices", "mesh")
# other files of meshes may name further files
MESHES = (".inp", ".msh")
EXAMPLE = "a superelement such as {file: boom.npz, interfaces: {hinge: link}}"
# what names of files do without, and how long they are at most
UNUSUAL = re.compile(r"[^A-Za-z0-9_.-]")
MOST_LETTERS = 80


class Superelements:
    """The section of a file: its items are read as soon as what they are fixed to is there.

    Attributes:
        waiting: Those that are not read yet, by name.
        names: Of all of them.
        records: Those of files, by the file.
    """

    def __init__(self, values: Values, options: Options) -> None:
        self.values = values
        self.options = options
        self.waiting: dict[str, Item] = {}
        self.names: tuple[str, ...] = ()
        self.records: dict[Path, SuperelementRecord] = {}

    def enter(self, section: Item) -> None:
        """The items of the section wait."""
        self.waiting = dict(section.items())
        self.names = tuple(self.waiting)

    def add_ready(self, last: bool = False) -> bool:
        """Read those whose interfaces have their places, or all of them.

        Returns:
            True if one was read: others may wait for its interfaces.
        """
        ready = [n for n, item in self.waiting.items() if last or self._is_ready(item)]
        for name in ready:
            self._add(name, self.waiting.pop(name))
        if last:
            # in the order of the file
            added = self.values.model.superelements
            added.update({name: added.pop(name) for name in self.names})
        return bool(ready)

    def _is_ready(self, item: Item) -> bool:
        joined = item.items(EXAMPLE).get("interfaces")
        if joined is None or joined.is_text or joined.is_list:
            return True
        return all(self.values.has_place(place) for place in joined.items().values())

    def _add(self, name: str, item: Item) -> None:
        model = self.values.model
        model.origins["superelement", name] = item.spot
        arguments = self.values.record(keys.SUPERELEMENT, item, "a superelement")
        sources = [key for key in SOURCES if key in arguments]
        if len(sources) != 1:
            raise item.error(
                "a superelement has one of file (a record), matrices and mesh; "
                f"this one has {' and '.join(sources) or 'none'}"
            )
        del arguments[sources[0]]
        record = self._record(sources[0], item.items()[sources[0]])
        if "loads" in arguments:
            factors = arguments["loads"].items("factors by name")
            arguments["loads"] = {load: self.values.motion(one) for load, one in factors.items()}
        with item.at_item():
            add_superelement(model, name, record, **arguments)

    def _record(self, source: str, item: Item) -> SuperelementRecord:
        """The record that a file has, or that matrices or a mesh are reduced to."""
        self.options.budget.take()
        try:
            with item.at_item():
                if source == "file":
                    return self._saved(self._file(item))
                if source == "matrices":
                    return self._from_matrices(item)
                return self._from_mesh(item)
        except (ArgumentError, SolveError, ModuleNotFoundError) as problem:
            raise item.at_key(str(problem)) from problem

    def _saved(self, path: Path) -> SuperelementRecord:
        """The record of a file, the same for all who name it."""
        if path not in self.records:
            self.records[path] = load(path)
        return self.records[path]

    def _from_matrices(self, item: Item) -> SuperelementRecord:
        arguments = self.values.record(keys.MATRICES, item, "matrices")
        items, files = item.items(), dict[str, Path]()
        main = self._file(items["file"])
        # what a program writes beside a file lies below the folder, too
        for role, companion in companions(Path(arguments.pop("file"))).items():
            path = self.values.meshes.locate(companion.as_posix(), item.path, "file")
            files |= {} if path is None else {role: path}
        for role in ROLES:
            if arguments.pop(role, None):
                files[role] = self._file(items[role])
        return reduced(read_files(main, files), **arguments)

    def _from_mesh(self, item: Item) -> SuperelementRecord:
        arguments = self.values.record(keys.SOLID_MESH, item, "a mesh")
        del arguments["file"]
        where = item.items()["file"]
        path = self._file(where)
        if path.suffix.lower() not in MESHES:
            raise where.error(f"meshes of scene files are read from {' and '.join(MESHES)} files")
        if self.options.mesh_reduction is None:
            raise where.error("meshes are reduced where cardan.load reads the scene")
        return self.options.mesh_reduction()(path, **arguments)

    def _file(self, item: Item) -> Path:
        """An existing file below the folder of the scene.

        Raises:
            ModelError: there is none.
        """
        path = self.values.meshes.locate(item.text(), item.path, "file")
        if path is None:
            raise ModelError(
                f"{item.path}: there is no file '{item.text()[:80]}' below the folder of the scene"
            )
        return path


EXAMPLE = "a superelement such as {file: boom.npz, interfaces: {hinge: link}}"


def record_files(model: SceneRecord, stem: str) -> dict[str, str]:
    """File of the record of each superelement, beside the scene; one where it is the same record.

    Args:
        model: The scene.
        stem: Name of its file, without ending.
    """
    files: dict[int, str] = {}
    for name, one in model.superelements.items():
        if id(one.record) in files:
            continue
        # some systems take crane.A.npz for crane.a.npz
        taken = {file.lower() for file in files.values()}
        plain = f"{stem}.{UNUSUAL.sub('_', name)[:MOST_LETTERS]}"
        numbered = (f"{plain}_{count}.npz" for count in range(2, len(taken) + 3))
        candidates = (f"{plain}.npz", *numbered)
        files[id(one.record)] = next(file for file in candidates if file.lower() not in taken)
    return {name: files[id(one.record)] for name, one in model.superelements.items()}
