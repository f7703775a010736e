"""Eigenvalues of x' = A x with right and left vectors, and what can be said where they meet.

Where as many eigenvalues meet as vectors, each still has its own left vector; where vectors meet
too, the matrix is defective: motions grow with time there, and an eigenvalue moves with the root of
what disturbs it. Such eigenvalues are marked, and what follows from left vectors is not a number.

Source: G. H. Golub, C. F. Van Loan, Matrix Computations, 4th ed. (2013), sections 7.1, 7.2 and 7.5.
"""

from __future__ import annotations

import numpy as np
from scipy.linalg import eig, matrix_balance

from ...arrays import Array, Booleans, Complex, Integers
from ...records import dataclass

# entries below this part of the largest are rounding: what nothing depends on is told apart exactly
ROUNDED = 4e-15
ALIKE = 1e-9  # of the largest modulus: eigenvalues that meet
DEFECTIVE = 1e-6  # cosines between left and right vectors of values without vectors of their own
RELATIVE_ERROR = (
    1e-10  # of the largest modulus: what states that were searched for leave of matrices
)
NONE = 1e-13  # of the largest entry of a vector: entries that are none


@dataclass(frozen=True, eq=False)
class Spectrum:
    """Eigenvalues and vectors of a matrix, those that grow fastest first.

    Attributes:
        values: Eigenvalues (n,), of pairs that above the axis first.
        right: A v = v value, columns (n, n), the largest entry of each 1.
        left: wᴴ A = value wᴴ, columns (n, n), with wᴴ v = 1; NaN where defective.
        defective: Which of them have no vectors of their own (n,).
        groups: Places of eigenvalues that meet, of one each where they do not.
        rounding: How far eigenvalues may be off (n,) where matrices are known to
            :data:`RELATIVE_ERROR`: much where they are nearly defective.
    """

    values: Complex
    right: Complex
    left: Complex
    defective: Booleans
    groups: tuple[Integers, ...]
    rounding: Array

    @property
    def unstable(self) -> Booleans:
        """Mask of the motions that grow exponentially (n,), beyond all rounding."""
        return np.asarray(self.values.real > self.rounding)

    @property
    def size(self) -> float:
        """The largest modulus."""
        return float(np.abs(self.values).max(initial=0.0))

    def derivative(self, dA: Array) -> Complex:
        """Derivatives of the eigenvalues (n,) with respect to a matrix; NaN where defective.

        Args:
            dA: Derivative of the matrix (n, n).

        Those that meet leave each other along the eigenvalues of what couples them.
        """
        rates = np.einsum("ik,ij,jk->k", self.left.conj(), dA.astype(np.complex128), self.right)
        for group in self.groups:
            if len(group) > 1 and not self.defective[group].any():
                inner = self.left[:, group].conj().T @ dA @ self.right[:, group]
                rates[group] = np.linalg.eigvals(inner)
        return np.asarray(rates)


def spectrum(A: Array, units: Array) -> Spectrum:
    """Eigenvalues and vectors of a matrix (n, n).

    Args:
        A: The matrix.
        units: Of x (n,), in which motions are alike: angles between vectors depend on them.
    """
    n = len(A)
    if n == 0:
        none = np.zeros((0, 0), dtype=np.complex128)
        return Spectrum(none.diagonal(), none, none, np.zeros(0, bool), (), np.zeros(0))
    scaled = A * units / units[:, None]
    least = ROUNDED * float(np.abs(scaled).max())
    balanced, scaling = matrix_balance(np.where(np.abs(scaled) > least, scaled, 0.0), permute=False)
    units = units * np.diag(scaling)
    values, left, right = eig(balanced, left=True)
    order = _order(values)
    values, left, right = values[order], left[:, order], right[:, order]
    groups = _groups(values)
    cosines = _cosines(left, right)
    defective = cosines < DEFECTIVE
    for group in groups:
        if len(group) > 1:
            left, defective = _paired(left, right, group, defective)
    weight = np.einsum("ik,ik->k", left.conj(), right)
    left = np.where(defective, np.nan, left / np.where(defective, 1.0, weight.conj()))
    off = RELATIVE_ERROR * float(np.abs(values).max()) / np.maximum(cosines, 1e-300)
    # back to the units of the matrix, the largest entry of a right vector 1
    right, left = right * units[:, None], left / units[:, None]
    top = np.take_along_axis(right, np.abs(right).argmax(axis=0)[None], axis=0)
    return Spectrum(values, right / top, left * top.conj(), defective, groups, off)


def _order(values: Complex) -> Integers:
    size = max(float(np.abs(values).max()), 1e-300)
    return np.lexsort((-values.imag, np.abs(values.imag), -np.round(values.real / size, 9)))


def _groups(values: Complex) -> tuple[Integers, ...]:
    """Places of eigenvalues that meet."""
    close = ALIKE * float(np.abs(values).max())
    left, groups = list(range(len(values))), list[Integers]()
    while left:
        here = [k for k in left if abs(values[k] - values[left[0]]) <= close]
        left = [k for k in left if k not in here]
        groups.append(np.array(here, dtype=np.intp))
    return tuple(groups)


def _cosines(left: Complex, right: Complex) -> Array:
    """Between left and right vectors (n,), where both are something.

    What a motion drives without being driven, as position by speed, disturbs no eigenvalue.
    """
    sizes = np.abs(left), np.abs(right)
    some = [x > NONE * x.max(axis=0) for x in sizes]
    lengths = [
        np.linalg.norm(x * other, axis=0) for x, other in zip(sizes, some[::-1], strict=True)
    ]
    inner = np.abs(np.einsum("ik,ik->k", left.conj(), right))
    product = lengths[0] * lengths[1]
    return np.asarray(np.divide(inner, product, out=np.zeros(len(inner)), where=product > 1e-300))


def _paired(
    left: Complex, right: Complex, group: Integers, defective: Booleans
) -> tuple[Complex, Booleans]:
    """Left vectors that belong to right ones where eigenvalues meet; or the group is defective."""
    inner = left[:, group].conj().T @ right[:, group]
    left, defective = left.copy(), defective.copy()
    defective[group] = float(np.linalg.svd(inner, compute_uv=False)[-1]) < DEFECTIVE
    if not defective[group[0]]:
        left[:, group] = left[:, group] @ np.linalg.inv(inner).conj().T
    return left, defective
