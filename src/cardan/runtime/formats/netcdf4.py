"""netCDF-4 files, written through h5netcdf: compressed, without a limit of size.

They are written only: ``.nc`` is netCDF-3 on every machine, so that a run that was saved where
h5netcdf is installed is read where it is not.

Source: Unidata, The NetCDF-4 File Format Specification (HDF5).
"""

from __future__ import annotations

import io
from pathlib import Path

from .contents import Attributes, FileFormat, Variables

SMALL = 1 << 16  # bytes


def _written(path: Path, attributes: Attributes, variables: Variables) -> None:
    import h5netcdf

    # in memory first: HDF5 does not survive a disk that gets full
    stream = io.BytesIO()
    with h5netcdf.File(stream, "w") as file:
        file.attrs.update(attributes)
        for name, one in variables.items():
            for axis, size in zip(one.dimensions, one.values.shape, strict=True):
                if axis not in file.dimensions:
                    file.dimensions[axis] = size
            # pieces that are packed one by one cost more than small arrays take
            packed = {"compression": "gzip"} if one.values.nbytes > SMALL else {}
            variable = file.create_variable(
                name, one.dimensions, one.values.dtype, data=one.values, **packed
            )
            variable.attrs.update(one.attributes)
    path.write_bytes(stream.getbuffer())


NETCDF4 = FileFormat(
    "netCDF-4", (".nc4",), _written, (b"\x89HDF",), packages=("h5netcdf", "h5py"), extra="data"
)
