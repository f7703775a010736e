"""Hexahedron with 20 nodes (serendipity), fully integrated with 27 points.

Stresses are taken at the 8 points of reduced integration, where they are most accurate.
Source: T. J. R. Hughes, The Finite Element Method, section 3.7; J. Barlow, Int. J. Numer. Methods
Eng. 10 (1976), 243-251 (points of stresses).
"""

from .cell import Cell, gauss, products, serendipity

CORNERS = ((-1, -1), (1, -1), (1, 1), (-1, 1))
MIDDLES = ((0, -1), (1, 0), (0, 1), (-1, 0))

CELL = Cell(
    kind="hex20",
    meshio="hexahedron20",
    abaqus=("C3D20", "C3D20H", "C3D20R", "C3D20RH"),
    nodes=(
        *((x, y, -1) for x, y in CORNERS),
        *((x, y, 1) for x, y in CORNERS),
        *((x, y, -1) for x, y in MIDDLES),
        *((x, y, 1) for x, y in MIDDLES),
        *((x, y, 0) for x, y in CORNERS),
    ),
    powers=serendipity(3),
    linear=products(3),
    edges=(
        *((0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6)),
        *((6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)),
    ),
    faces=(
        *((0, 3, 2, 1, 11, 10, 9, 8), (4, 5, 6, 7, 12, 13, 14, 15)),
        *((0, 1, 5, 4, 8, 17, 12, 16), (1, 2, 6, 5, 9, 18, 13, 17)),
        *((2, 3, 7, 6, 10, 19, 14, 18), (3, 0, 4, 7, 11, 16, 15, 19)),
    ),
    stiffness=gauss(3, 3),
    mass=gauss(3, 3),
    stress=gauss(2, 3),
)
