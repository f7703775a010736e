"""Matrices of single cells by other routes: closed forms of simplices, tensors and other formulas.

Nothing here is shared with cardan: shape functions are written out, derivatives are by complex
step, and elasticity is a tensor of rank four.
"""

from __future__ import annotations

from itertools import product
from math import factorial

import numpy as np

EDGES = ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3))


def tensor(E, nu):
    """Elasticity C_ijkl of an isotropic material."""
    lame, shear = E * nu / (1 + nu) / (1 - 2 * nu), E / 2 / (1 + nu)
    d = np.eye(3)
    return lame * np.einsum("ij,kl->ijkl", d, d) + shear * (
        np.einsum("ik,jl->ijkl", d, d) + np.einsum("il,jk->ijkl", d, d)
    )


# polynomials in barycentric coordinates: {exponents: coefficient}
def times(a, b):
    result: dict = {}
    for (p, x), (q, y) in product(a.items(), b.items()):
        key = tuple(i + j for i, j in zip(p, q, strict=True))
        result[key] = result.get(key, 0) + x * y
    return result


def integral(a, volume):
    """Over a tetrahedron: a! b! c! d! 6 V / (a + b + c + d + 3)!"""
    return sum(
        x * 6 * volume * np.prod([factorial(i) for i in p]) / factorial(sum(p) + 3)
        for p, x in a.items()
    )


def unit(k):
    return {tuple(int(i == k) for i in range(4)): 1.0}


def derivative(a, k):
    result: dict = {}
    for p, x in a.items():
        if p[k]:
            key = tuple(e - (i == k) for i, e in enumerate(p))
            result[key] = result.get(key, 0) + x * p[k]
    return result


def simplex_functions(nodes):
    L = [unit(k) for k in range(4)]
    if nodes == 4:
        return L
    corners = [
        {k: v for part in (times(l, {(0,) * 4: -1.0}), times(l, l)) for k, v in part.items()}
        for l in L
    ]
    for c, l in zip(corners, L, strict=True):
        for key in times(l, l):
            c[key] *= 2
    return corners + [{k: 4 * v for k, v in times(L[a], L[b]).items()} for a, b in EDGES]


def simplex_matrices(x, E, nu, rho):
    """Stiffness and mass of a tetrahedron with straight edges, exactly."""
    corners = np.hstack([np.ones((4, 1)), x[:4]])
    volume = np.linalg.det(corners) / 6
    slopes = np.linalg.inv(corners)[1:]  # of the barycentric coordinates, (3, 4)
    functions = simplex_functions(len(x))
    gradients = []
    for f in functions:
        parts = [derivative(f, k) for k in range(4)]
        gradient = []
        for i in range(3):
            total: dict = {}
            for k in range(4):
                for p, v in parts[k].items():
                    total[p] = total.get(p, 0) + slopes[i, k] * v
            gradient.append(total)
        gradients.append(gradient)
    n = len(x)
    products = np.array(
        [
            [
                [[integral(times(g[j], h[l]), volume) for l in range(3)] for j in range(3)]
                for h in gradients
            ]
            for g in gradients
        ]
    )
    K = np.einsum("ijkl,abjl->aibk", tensor(E, nu), products).reshape(3 * n, 3 * n)
    M = rho * np.array([[integral(times(f, g), volume) for g in functions] for f in functions])
    return K, M


def hex_function(node, nodes, xi):
    """Shape functions of the hexahedra as books print them."""
    a = np.array(node)
    u = 1 + a * xi
    if nodes == 8:
        return u.prod() / 8
    if not (a == 0).any():
        return u.prod() * ((a * xi).sum() - 2) / 8
    k = int(np.flatnonzero(a == 0)[0])
    return (1 - xi[k] ** 2) * np.delete(u, k).prod() / 4


def hex_matrices(x, reference, E, nu, rho, count):
    """Stiffness and mass of a hexahedron by a product rule with so many points."""
    points, weights = np.polynomial.legendre.leggauss(count)
    n = len(x)
    K, M = np.zeros((n, 3, n, 3)), np.zeros((n, n))
    C = tensor(E, nu)
    for at in product(range(count), repeat=3):
        xi, w = points[list(at)], weights[list(at)].prod()
        values = np.array([hex_function(a, n, xi) for a in reference])
        slopes = np.array(
            [
                [hex_function(a, n, xi + 1e-30j * np.eye(3)[k]).imag / 1e-30 for k in range(3)]
                for a in reference
            ]
        )
        jacobian = x.T @ slopes
        gradients = np.linalg.solve(jacobian.T, slopes.T).T
        volume = w * np.linalg.det(jacobian)
        K += volume * np.einsum("ijkl,aj,bl->aibk", C, gradients, gradients)
        M += volume * rho * np.outer(values, values)
    return K.reshape(3 * n, 3 * n), M
