"""Quadrilateral with 8 nodes: a face of a hex20.

Source: T. J. R. Hughes, The Finite Element Method, chapter 3.
"""

from .cell import Cell, gauss, products, serendipity

CELL = Cell(
    kind="quad8",
    meshio="quad8",
    abaqus=("CPS8", "CPE8", "CAX8", "S8", "S8R", "M3D8", "SFM3D8"),
    nodes=((-1, -1), (1, -1), (1, 1), (-1, 1), (0, -1), (1, 0), (0, 1), (-1, 0)),
    powers=serendipity(2),
    linear=products(2),
    edges=((0, 1), (1, 2), (2, 3), (3, 0)),
    faces=(),
    stiffness=gauss(3, 2),
    mass=gauss(3, 2),
    stress=gauss(3, 2),
    triangles=((0, 4, 7), (4, 1, 5), (5, 2, 6), (6, 3, 7), (4, 5, 7), (5, 6, 7)),
)
