# cython: language_level=3
"""stewart_platform: C functions of a multibody model.

22 coordinates, 21 speeds, 96 parameters.

States are arrays with leading axes that broadcast; speeds u are what robotics calls v, quaternions
are (w, x, y, z), 6-vectors have the angular part first, units are SI and radians. ``parameters``
is a mapping of names to new values, or None for those of the model.
"""

from cpython.buffer cimport PyBUF_C_CONTIGUOUS, PyBUF_FORMAT, PyBuffer_Release
from cpython.exc cimport PyErr_Clear
from libc.stdlib cimport free, malloc
from libc.string cimport memset

import numpy as np

cdef extern from "Python.h":
    int PyObject_GetBuffer(object exporter, Py_buffer *view, int flags) noexcept


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
 'lam': 15,
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
    # of all blocks, and those of a state
    PLACES = 19
    W = 7
    SMALL_WORK = 512

cdef object ndarray = np.ndarray
cdef object empty = np.empty
cdef int NUMBERS = PyBUF_C_CONTIGUOUS | PyBUF_FORMAT


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


# numbers that the state is made of, in their order
_STATE = ("q", "u", "z")


def _array(block, value, Py_ssize_t size):
    """A block (..., n) of a function as contiguous numbers."""
    if block == "t":
        return np.asarray(value, dtype=float)[..., None]
    if block in ("v", "x"):
        found = np.asarray(value, dtype=float)
    else:
        found = _entries(block, value, _NAMES.get(block, ()), _defaults(block))
    if found.ndim == 0 or found.shape[-1] != size:
        raise ValueError(f"{block} must have shape (..., {size}), not {found.shape}")
    return found


cdef class _Function:
    """A function of the model: for one state in plain arrays by pointers, else for all states."""

    cdef const cardan_exported_function *f
    cdef tuple arguments, shape
    cdef list held
    cdef int count
    cdef int first[BLOCKS]
    cdef int last[BLOCKS]
    cdef int slot[PLACES]
    cdef Py_ssize_t offset[PLACES]
    cdef Py_ssize_t size[BLOCKS]
    cdef bint scalar[BLOCKS]
    cdef const double *start[BLOCKS]
    cdef const double *w

    def __init__(self, bytes name, tuple arguments, tuple shape):
        cdef int i, place = 0
        cdef Py_ssize_t at
        self.f = cardan_scene.functions
        while name != <bytes>self.f.name:
            self.f += 1
        self.arguments, self.shape, self.count, self.held = arguments, shape, len(arguments), []
        for i, argument in enumerate(arguments):
            self.first[i], at = place, 0
            for block in _STATE if argument == "x" else (argument,):
                self.slot[place], self.offset[place] = _SLOTS[block], at
                at += _VECTORS[name.decode()] if block == "v" else _SIZES.get(block, 1)
                place += 1
            self.last[i], self.size[i] = place, at
            self.scalar[i], self.start[i] = argument == "t", NULL
            if argument not in ("t", "v", "x"):
                self.start[i] = self.hold(_defaults(argument))
        self.w = self.prepared(_defaults("p"))

    cdef const double *hold(self, numbers):
        """Where numbers start that live as long as the function."""
        cdef const double[::1] flat = np.append(np.asarray(numbers, dtype=float), 0.0)
        self.held.append(flat)
        return &flat[0]

    cdef const double *prepared(self, parameters):
        """What the function has of parameters."""
        cdef double[::1] p = np.append(parameters, 0.0)
        cdef double[::1] w = np.zeros(self.f.w + 1)
        self.f.prepare(&p[0], &w[0])
        self.held.append(w)
        return &w[0]

    cdef object call(self, tuple values, parameters):
        result = self.at_one_state(values) if parameters is None else None
        return self.at_states(values, parameters) if result is None else result

    cdef object at_one_state(self, tuple values):
        """The result at one state; None where that takes a closer look."""
        cdef const double *at[BLOCKS]
        cdef double number[BLOCKS]
        cdef Py_buffer views[BLOCKS + 1]
        cdef double small[SMALL_WORK]
        cdef double *work = small
        cdef int used = 0, i, status
        cdef bint plain = True
        memset(at, 0, sizeof(at))
        at[W] = self.w
        for i in range(self.count):
            value = values[i]
            if value is None:
                plain = self.start[i] != NULL
                self.point(at, i, self.start[i])
            elif self.scalar[i]:
                plain = type(value) is float
                if plain:
                    number[i] = value
                    self.point(at, i, &number[i])
            elif type(value) is ndarray and PyObject_GetBuffer(value, &views[used], NUMBERS) == 0:
                used += 1
                plain = self.fits(&views[used - 1], self.size[i])
                self.point(at, i, <const double *>views[used - 1].buf)
            else:
                PyErr_Clear()
                plain = False
            if not plain:
                break
        status = 0
        result = empty(self.shape) if plain else None
        if plain and self.f.work > SMALL_WORK:
            work = <double *>malloc(self.f.work * sizeof(double))
        if plain and work != NULL and PyObject_GetBuffer(result, &views[used], NUMBERS) == 0:
            used += 1
            with nogil:
                status = self.f.function(<const cardan_in *>at, <double *>views[used - 1].buf, work)
        if work != small:
            free(work)
        for i in range(used):
            PyBuffer_Release(&views[i])
        if plain and work == NULL:
            raise MemoryError()
        if status:
            raise SingularError(f"a linear system has no solution (status {status})")
        return result

    cdef inline void point(self, const double **at, int i, const double *start) noexcept:
        """Let the blocks of argument i start there."""
        cdef int k
        for k in range(self.first[i], self.last[i]):
            at[self.slot[k]] = start + self.offset[k]

    cdef inline bint fits(self, const Py_buffer *view, Py_ssize_t size) noexcept:
        """Whether a buffer is a vector of so many doubles."""
        return (view.ndim == 1 and view.shape[0] == size and view.itemsize == 8
                and view.format[0] == c"d" and view.format[1] == 0)

    cdef object at_states(self, tuple values, parameters):
        """The results at states of any leading shape."""
        cdef const cardan_exported_function *f = self.f
        cdef Py_ssize_t count, i, k
        cdef const double *at[BLOCKS]
        cdef Py_ssize_t step[BLOCKS]
        cdef double[::1] flat
        arrays = [
            _array(argument, value, self.size[i])
            for i, (argument, value) in enumerate(zip(self.arguments, values))
        ]
        lead = np.broadcast_shapes(*(a.shape[:-1] for a in arrays))
        count = int(np.prod(lead, dtype=np.intp))
        given = _entries("parameters", parameters, PARAMETERS, _defaults("p"))
        if given.shape != (len(PARAMETERS),):
            raise ValueError(f"parameters must have shape ({len(PARAMETERS)},), not {given.shape}")
        cdef double[::1] p = np.append(given, 0.0)
        cdef double[::1] w = np.zeros(f.w + 1)
        f.prepare(&p[0], &w[0])
        result = np.empty((count, f.out))
        cdef double[::1] out = result.reshape(-1) if count * f.out else np.empty(1)
        for k in range(BLOCKS):
            at[k], step[k] = NULL, 0
        held = []
        for i, array in enumerate(arrays):
            wide = np.broadcast_to(array, lead + array.shape[-1:])
            flat = np.append(np.ascontiguousarray(wide).reshape(-1), 0.0)
            held.append(flat)
            self.point(at, <int>i, &flat[0])
            for k in range(self.first[i], self.last[i]):
                step[self.slot[k]] = array.shape[-1]
        at[W] = &w[0]
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
        return result.reshape(lead + self.shape)


cdef _Function _forward_dynamics = _Function(b"forward_dynamics", ("t", "q", "u", "r", "tau", ), (21,))


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
    return _forward_dynamics.call((t, q, u, r, tau, ), parameters)


cdef _Function _inverse_dynamics = _Function(b"inverse_dynamics", ("t", "q", "u", "udot", "r", ), (21,))


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
    return _inverse_dynamics.call((t, q, u, udot, r, ), parameters)


cdef _Function _mass_matrix = _Function(b"mass_matrix", ("t", "q", "r", ), (21, 21))


def mass_matrix(q, *, t=0.0, r=None, parameters=None):
    """M: kinetic energy is 1/2 uᵀ M u.

    Args:
        t: time [s], (...)
        q: coordinates, (..., nq)
        r: inputs, (..., nr); by default those of the model

    Returns:
        Array (..., 21, 21)
    """
    return _mass_matrix.call((t, q, r, ), parameters)
