"""Rotation formulas of the checker: proper, of the right angle, about the right axis."""

from __future__ import annotations

import numpy as np
from scipy.spatial.transform import Rotation

from cardan.runtime.verification.rotations import PARAMETERS, SEQUENCES, about, rotation_vector
from table import each


def vectors(reach: float) -> np.ndarray:
    rng = np.random.default_rng(11)
    n = rng.normal(size=(40, 3))
    return n / np.linalg.norm(n, axis=1, keepdims=True) * rng.uniform(0.05, reach, (40, 1))


def test_all_sequences_are_there():
    assert len(SEQUENCES) == len(set(SEQUENCES)) == 24


@each("name", PARAMETERS)
def test_proper_orthogonal(name):
    kind = PARAMETERS[name]
    q = kind.of_vector(vectors(kind.reach))
    assert q.shape == (40, kind.size)
    R = kind.matrix(q)
    assert np.abs(np.swapaxes(R, -1, -2) @ R - np.eye(3)).max() < 20 * np.finfo(float).eps
    assert np.abs(np.linalg.det(R) - 1).max() < 20 * np.finfo(float).eps


@each("name", [n for n in PARAMETERS if n not in SEQUENCES])
def test_same_rotation_as_scipy(name):
    kind = PARAMETERS[name]
    v = vectors(kind.reach)
    # tan(phi/2) is 2 and cos(phi) 0.36 at the ends of the ranges: errors grow less than tenfold
    expected = Rotation.from_rotvec(v).as_matrix()
    assert np.abs(kind.matrix(kind.of_vector(v)) - expected).max() < 40 * np.finfo(float).eps


@each("sequence", SEQUENCES)
def test_sequences_follow_the_case_rule_of_scipy(sequence):
    q = PARAMETERS[sequence].of_vector(vectors(3.0))
    expected = Rotation.from_euler(sequence, q).as_matrix()
    assert np.abs(PARAMETERS[sequence].matrix(q) - expected).max() < 20 * np.finfo(float).eps


def test_small_rotation_vectors():
    v = np.array([[0.0, 0.0, 0.0], [1e-9, 0.0, 0.0], [1e-5, -2e-5, 1e-5]])
    expected = Rotation.from_rotvec(v).as_matrix()
    assert np.abs(rotation_vector(v) - expected).max() < 1e-16


def test_about_an_axis():
    R = about(np.array([0.0, 0.0, 1.0]), np.array([np.pi / 2]))[0]
    assert np.allclose(R @ [1, 0, 0], [0, 1, 0], atol=2e-16)


@each("name", PARAMETERS)
def test_complex_step_is_the_derivative(name):
    kind = PARAMETERS[name]
    q = kind.of_vector(vectors(0.8 * kind.reach))
    d = np.random.default_rng(2).uniform(-1, 1, q.shape)
    exact = kind.matrix(q + 1e-30j * d).imag / 1e-30
    h = 1e-5
    difference = (kind.matrix(q + h * d) - kind.matrix(q - h * d)) / (2 * h)
    # central differences: h² times the third derivative, which the rotations keep below 100
    assert np.abs(exact - difference).max() < 100 * h**2
