"""Hexahedron with 8 nodes, fully integrated.

Source: T. J. R. Hughes, The Finite Element Method, section 3.5. It is stiff in bending: hex20 is
the better choice for thin parts.
"""

from .cell import Cell, gauss, products

CORNERS = ((-1, -1), (1, -1), (1, 1), (-1, 1))

CELL = Cell(
    kind="hex8",
    meshio="hexahedron",
    abaqus=("C3D8", "C3D8H", "C3D8I", "C3D8IH", "C3D8R", "C3D8RH"),
    nodes=(*((x, y, -1) for x, y in CORNERS), *((x, y, 1) for x, y in CORNERS)),
    powers=products(3),
    linear=products(3),
    edges=(),
    faces=(
        *((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4)),
        *((1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)),
    ),
    stiffness=gauss(2, 3),
    # 3 points: moments of inertia are exact also for distorted cells
    mass=gauss(3, 3),
    stress=gauss(2, 3),
)
