"""The file of an FMU: a zip, the same bytes for the same contents."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Mapping
from pathlib import Path

from ...atomic_file import replaced
from ...errors import CodegenError, ModelError

# the first time that a zip can name
DATE = (1980, 1, 1, 0, 0, 0)
PERMISSIONS, PROGRAM = 0o100644, 0o100755


def packed(files: Mapping[str, str | bytes]) -> bytes:
    """The zip of files by their paths."""
    room = io.BytesIO()
    with zipfile.ZipFile(room, "w", zipfile.ZIP_DEFLATED) as archive:
        # importers read the description first
        for name in sorted(files, key=lambda name: (name != "modelDescription.xml", name)):
            entry = zipfile.ZipInfo(name, DATE)
            entry.compress_type = zipfile.ZIP_DEFLATED
            mode = PROGRAM if name.startswith("binaries/") else PERMISSIONS
            entry.external_attr = mode << 16
            entry.create_system = 3
            archive.writestr(entry, files[name])
    return room.getvalue()


def write(path: Path, content: bytes) -> Path:
    """Write the file whole or not at all; its directory is made where there is none.

    Raises:
        CodegenError: there is no room, or nothing may be written there.
    """
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with replaced(path) as new:
            Path(new).write_bytes(content)
    except (ModelError, OSError) as error:
        raise CodegenError(str(error)) from error
    return path
