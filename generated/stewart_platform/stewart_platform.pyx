# cython: language_level=3
"""stewart_platform: C functions of a multibody model.

22 coordinates, 21 speeds, 96 parameters.

States are arrays with leading axes that broadcast; speeds u are what robotics calls v, quaternions
are (w, x, y, z), 6-vectors have the angular part first, units are SI and radians. ``parameters``
is a mapping of names to new values, or None for those of the model.
"""

from libc.stdlib cimport free, malloc

import numpy as np

cdef extern from "functions.h" nogil:
    ctypedef struct cardan_in:
        const double *t
    ctypedef struct cardan_exported_function:
        const char *name
        int (*function)(const cardan_in *, double *, double *) noexcept nogil
        void (*prepare)(const double *, double *) noexcept nogil
        Py_ssize_t out, work, w
    ctypedef struct cardan_export:
        Py_ssize_t nq, nz, ns, nr
        const double *p
        const double *q
        const double *z
        const double *s
        const double *r
        const cardan_exported_function *functions
    const cardan_export cardan_scene

NAME = 'stewart_platform'
COORDINATES = ('hooke0.angle1', 'hooke0.angle2', 'slide0', 'ball0.qw', 'ball0.qx', 'ball0.qy', 'ball0.qz',
 'hooke1.angle1', 'hooke1.angle2', 'slide1', 'hooke2.angle1', 'hooke2.angle2', 'slide2',
 'hooke3.angle1', 'hooke3.angle2', 'slide3', 'hooke4.angle1', 'hooke4.angle2', 'slide4',
 'hooke5.angle1', 'hooke5.angle2', 'slide5')
SPEEDS = ('hooke0.u.angle1', 'hooke0.u.angle2', 'slide0.u', 'ball0.u.x', 'ball0.u.y', 'ball0.u.z',
 'hooke1.u.angle1', 'hooke1.u.angle2', 'slide1.u', 'hooke2.u.angle1', 'hooke2.u.angle2',
 'slide2.u', 'hooke3.u.angle1', 'hooke3.u.angle2', 'slide3.u', 'hooke4.u.angle1',
 'hooke4.u.angle2', 'slide4.u', 'hooke5.u.angle1', 'hooke5.u.angle2', 'slide5.u')
INPUTS = ('drive0', 'drive1', 'drive2', 'drive3', 'drive4', 'drive5')
PARAMETERS = ('gravity.z', 'hooke0.position.x', 'hooke0.position.y', 'tube0.mass', 'tube0.com.z',
 'tube0.inertia.xx', 'tube0.inertia.yy', 'tube0.inertia.zz', 'slide0.position.z', 'rod0.mass',
 'rod0.com.z', 'rod0.inertia.xx', 'rod0.inertia.yy', 'rod0.inertia.zz',
 'ball0.child.position.x', 'ball0.child.position.y', 'platform.mass', 'platform.com.z',
 'platform.inertia.xx', 'platform.inertia.yy', 'platform.inertia.zz', 'hooke1.position.x',
 'hooke1.position.y', 'tube1.mass', 'tube1.com.z', 'tube1.inertia.xx', 'tube1.inertia.yy',
 'tube1.inertia.zz', 'slide1.position.z', 'rod1.mass', 'rod1.com.z', 'rod1.inertia.xx',
 'rod1.inertia.yy', 'rod1.inertia.zz', 'hooke2.position.x', 'hooke2.position.y', 'tube2.mass',
 'tube2.com.z', 'tube2.inertia.xx', 'tube2.inertia.yy', 'tube2.inertia.zz', 'slide2.position.z',
 'rod2.mass', 'rod2.com.z', 'rod2.inertia.xx', 'rod2.inertia.yy', 'rod2.inertia.zz',
 'hooke3.position.x', 'hooke3.position.y', 'tube3.mass', 'tube3.com.z', 'tube3.inertia.xx',
 'tube3.inertia.yy', 'tube3.inertia.zz', 'slide3.position.z', 'rod3.mass', 'rod3.com.z',
 'rod3.inertia.xx', 'rod3.inertia.yy', 'rod3.inertia.zz', 'hooke4.position.x',
 'hooke4.position.y', 'tube4.mass', 'tube4.com.z', 'tube4.inertia.xx', 'tube4.inertia.yy',
 'tube4.inertia.zz', 'slide4.position.z', 'rod4.mass', 'rod4.com.z', 'rod4.inertia.xx',
 'rod4.inertia.yy', 'rod4.inertia.zz', 'hooke5.position.x', 'hooke5.position.y', 'tube5.mass',
 'tube5.com.z', 'tube5.inertia.xx', 'tube5.inertia.yy', 'tube5.inertia.zz', 'slide5.position.z',
 'rod5.mass', 'rod5.com.z', 'rod5.inertia.xx', 'rod5.inertia.yy', 'rod5.inertia.zz',
 'ball1.child.position.x', 'ball1.child.position.y', 'ball2.child.position.x',
 'ball2.child.position.y', 'ball3.child.position.x', 'ball3.child.position.y',
 'ball4.child.position.x', 'ball4.child.position.y', 'ball5.child.position.x',
 'ball5.child.position.y')
BODIES = ('tube0', 'rod0', 'platform', 'tube1', 'rod1', 'tube2', 'rod2', 'tube3', 'rod3', 'tube4',
 'rod4', 'tube5', 'rod5')

_SIZES = {'q': 22,
 'q0': 22,
 'r': 6,
 'wrench': 78,
 'u': 21,
 'udot': 21,
 'tau': 21,
 'du': 21,
 'z': 0,
 's': 0,
 'e': 0}
_SLOTS = {'t': 0,
 'q': 1,
 'u': 2,
 'z': 3,
 's': 4,
 'r': 5,
 'p': 6,
 'w': 7,
 'udot': 8,
 'zdot': 9,
 'lam': 10,
 'tau': 11,
 'wrench': 12,
 'du': 13,
 'q0': 14,
 'e': 15,
 'v': 16}
# lengths of v, in which every function has entries of its own
_VECTORS = {}

cdef enum:
    BLOCKS = 17


class SingularError(ArithmeticError):
    """A linear system of the model has no solution at the given state."""


def _entries(block, value, names, start):
    """A block as numbers: a mapping changes some of the entries, None leaves them as they are."""
    if value is not None and not hasattr(value, "items"):
        return np.asarray(value, dtype=float)
    found = np.array(start, dtype=float)
    for name, number in dict(value or {}).items():
        if name not in names:
            raise KeyError(f"{block}: there is no {name!r}. Known: {', '.join(names)}")
        found[names.index(name)] = number
    return found


cdef object _numbers(const double *values, Py_ssize_t count):
    cdef Py_ssize_t k
    return [values[k] for k in range(count)]


def _defaults(block):
    """Where the scene starts; zeros where it says nothing."""
    if block == "p":
        return _numbers(cardan_scene.p, len(PARAMETERS))
    if block in ("q", "q0"):
        return _numbers(cardan_scene.q, cardan_scene.nq)
    if block == "r":
        return _numbers(cardan_scene.r, cardan_scene.nr)
    if block == "z":
        return _numbers(cardan_scene.z, cardan_scene.nz)
    if block == "s":
        return _numbers(cardan_scene.s, cardan_scene.ns)
    return np.zeros(_SIZES[block])


_NAMES = {"q": COORDINATES, "q0": COORDINATES, "u": SPEEDS, "r": INPUTS}


def _array(name, block, value):
    """A block (..., n) of a function as contiguous numbers."""
    if block == "t":
        return np.asarray(value, dtype=float)[..., None]
    if block == "v":
        found, size = np.asarray(value, dtype=float), _VECTORS[name]
    else:
        found = _entries(block, value, _NAMES.get(block, ()), _defaults(block))
        size = _SIZES[block]
    if found.ndim == 0 or found.shape[-1] != size:
        raise ValueError(f"{block} must have shape (..., {size}), not {found.shape}")
    return found


cdef object _call(bytes name, tuple blocks, tuple values, object parameters, tuple shape):
    """Run a function at every state."""
    cdef const cardan_exported_function *f = cardan_scene.functions
    while name != <bytes>f.name:
        f += 1
    arrays = [_array(name.decode(), block, value) for block, value in zip(blocks, values)]
    lead = np.broadcast_shapes(*(a.shape[:-1] for a in arrays))
    cdef Py_ssize_t count = int(np.prod(lead, dtype=np.intp)), i, k
    given = _entries("parameters", parameters, PARAMETERS, _defaults("p"))
    if given.shape != (len(PARAMETERS),):
        raise ValueError(f"parameters must have shape ({len(PARAMETERS)},), not {given.shape}")
    cdef double[::1] p = np.append(given, 0.0)
    cdef double[::1] w = np.zeros(f.w + 1)
    f.prepare(&p[0], &w[0])
    result = np.empty((count, f.out))
    cdef double[::1] out = result.reshape(-1) if count * f.out else np.empty(1)
    cdef const double *at[BLOCKS]
    cdef Py_ssize_t step[BLOCKS]
    cdef double[::1] flat
    for k in range(BLOCKS):
        at[k], step[k] = NULL, 0
    held = []
    for block, array in zip(blocks, arrays):
        wide = np.broadcast_to(array, lead + array.shape[-1:])
        flat = np.append(np.ascontiguousarray(wide).reshape(-1), 0.0)
        held.append(flat)
        k = _SLOTS[block]
        at[k], step[k] = &flat[0], array.shape[-1]
    at[_SLOTS["w"]] = &w[0]
    cdef double *work = <double *>malloc((f.work + 1) * sizeof(double))
    cdef int status = 0, one
    if work == NULL:
        raise MemoryError()
    with nogil:
        for i in range(count):
            one = f.function(<const cardan_in *>at, &out[0] + i * f.out, work)
            status |= one
            for k in range(BLOCKS):
                if at[k] != NULL:
                    at[k] += step[k]
    free(work)
    if status:
        raise SingularError(f"a linear system has no solution (status {status})")
    return result.reshape(lead + shape)


def forward_dynamics(q, u, *, t=0.0, r=None, tau=None, parameters=None):
    """udot with M udot + h = f + tau.

    Args:
        t: time [s], (...)
        q: coordinates, (..., nq)
        u: speeds, (..., nu)
        r: inputs, (..., nr); by default those of the model
        tau: generalized applied forces, (..., nu); by default none

    Returns:
        Array (..., 21)
    """
    return _call(
        b"forward_dynamics", ("t", "q", "u", "r", "tau",), (t, q, u, r, tau,), parameters, (21,),
    )


def inverse_dynamics(q, u, udot, *, t=0.0, r=None, parameters=None):
    """tau with M udot + h = f + tau.

    Args:
        t: time [s], (...)
        q: coordinates, (..., nq)
        u: speeds, (..., nu)
        udot: derivatives of the speeds, (..., nu)
        r: inputs, (..., nr); by default those of the model

    Returns:
        Array (..., 21)
    """
    return _call(
        b"inverse_dynamics", ("t", "q", "u", "udot", "r",), (t, q, u, udot, r,), parameters, (21,),
    )


def mass_matrix(q, *, t=0.0, r=None, parameters=None):
    """M: kinetic energy is 1/2 uᵀ M u.

    Args:
        t: time [s], (...)
        q: coordinates, (..., nq)
        r: inputs, (..., nr); by default those of the model

    Returns:
        Array (..., 21, 21)
    """
    return _call(
        b"mass_matrix", ("t", "q", "r",), (t, q, r,), parameters, (21, 21),
    )
