"""Measured signals: low-pass filters without delay, derivatives, Fourier series through them.

Source: Gautier, Dynamic Identification of Robots with Power Model, IEEE ICRA (1997), for filters
and decimation; Swevers, Ganseman, De Schutter and Van Brussel, IEEE Trans. Robotics and Automation
13 (1997), for series.
"""

from __future__ import annotations

import numpy as np

from ...arrays import Array
from ...errors import ArgumentError

ORDER = 4  # of the filter, which runs forward and backward
DEGREE = 5  # of splines
FULL_PERIOD = 0.9  # of a period: the least data for a series
EVEN = 1e-6  # steps of time that differ by less, relative to them, are equal
PASSED = 1.8  # samples per period of the cutoff that are left: their noise is independent


def step_of(t: Array, who: str) -> float:
    """The step of evenly spaced times.

    Raises:
        ArgumentError: they are not.
    """
    steps = np.diff(t)
    step = float(np.mean(steps)) if len(steps) else 0.0
    if not len(steps) or step <= 0 or np.abs(steps - step).max() > EVEN * step:
        raise ArgumentError(f"{who} needs times at equal steps; resample the data")
    return step


def lowpass(t: Array, values: Array, cutoff: float) -> Array:
    """Values (nt, ...) without what is faster than ``cutoff`` [Hz], and without delay.

    Raises:
        ArgumentError: uneven times, too few of them, or a cutoff beyond half the sampling rate.
    """
    from scipy.signal import butter, sosfiltfilt

    rate = 1 / step_of(t, "cutoff=")
    if not 0 < cutoff < rate / 2:
        raise ArgumentError(
            f"cutoff={cutoff:g} Hz is not below half the sampling rate, {rate / 2:g} Hz"
        )
    padding = int(np.ceil(2 * rate / cutoff))
    if len(t) <= padding:
        raise ArgumentError(f"cutoff={cutoff:g} Hz needs more than {padding} samples, not {len(t)}")
    sections = butter(ORDER, cutoff, fs=rate, output="sos")
    return np.asarray(sosfiltfilt(sections, values, axis=0, padlen=padding))


def every(t: Array, cutoff: float) -> int:
    """Stride between the filtered samples that are kept, so that their noise is independent."""
    return max(1, int(1 / (step_of(t, "cutoff=") * PASSED * cutoff)))


def derivative(t: Array, values: Array) -> Array:
    """Time derivative (nt, ...) of a spline through values.

    Raises:
        ArgumentError: too few values.
    """
    from scipy.interpolate import make_interp_spline

    if len(t) <= DEGREE:
        raise ArgumentError(f"{len(t)} samples have no derivatives; give more than {DEGREE}")
    return np.asarray(make_interp_spline(t, values, k=DEGREE).derivative()(t))


def series(t: Array, values: Array, period: float, harmonics: int) -> tuple[Array, Array, Array]:
    """Values (nt, k) as a Fourier series, with its first two derivatives.

    Raises:
        ArgumentError: fewer samples than coefficients, or less than a period.
    """
    if not period >= step_of(t, "period="):
        raise ArgumentError(
            f"period={period:g} s: give the period of the motion, longer than a step of the data"
        )
    if t[-1] - t[0] < FULL_PERIOD * period:
        raise ArgumentError(
            f"period={period:g} s: the data are of {t[-1] - t[0]:.4g} s, less than a period"
        )
    if len(t) <= 2 * harmonics + 1:
        raise ArgumentError(
            f"harmonics={harmonics}: {len(t)} samples do not determine "
            f"{2 * harmonics + 1} coefficients of a series"
        )
    angles = 2 * np.pi / period * np.arange(1, harmonics + 1)
    sine, cosine = np.sin(np.outer(t, angles)), np.cos(np.outer(t, angles))
    terms = np.column_stack([np.ones_like(t), sine, cosine])
    coefficients = np.linalg.lstsq(terms, values, rcond=None)[0]
    rates = np.column_stack([0 * t, cosine * angles, -sine * angles])
    accelerations = np.column_stack([0 * t, -sine * angles**2, -cosine * angles**2])
    return terms @ coefficients, rates @ coefficients, accelerations @ coefficients
