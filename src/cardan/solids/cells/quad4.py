"""Quadrilateral with 4 nodes: a face of a hex8.

Source: T. J. R. Hughes, The Finite Element Method, chapter 3.
"""

from .cell import Cell, gauss, products

CELL = Cell(
    kind="quad4",
    meshio="quad",
    abaqus=("CPS4", "CPE4", "CAX4", "S4", "S4R", "M3D4", "R3D4", "SFM3D4"),
    nodes=((-1, -1), (1, -1), (1, 1), (-1, 1)),
    powers=products(2),
    linear=products(2),
    edges=(),
    faces=(),
    stiffness=gauss(2, 2),
    mass=gauss(2, 2),
    stress=gauss(2, 2),
    triangles=((0, 1, 2), (0, 2, 3)),
)
