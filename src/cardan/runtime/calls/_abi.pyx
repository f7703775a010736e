# cython: language_level=3, boundscheck=False, wraparound=False, cdivision=True
"""Call generated functions with as little Python as possible; interface as in abi_ctypes.

Arrays are read through the buffer protocol: the extension needs Python.h, not NumPy's headers. One
build serves every Python from 3.11 on: of Python.h it uses the limited API alone.
"""

cimport cython
from cpython.buffer cimport (
    PyBUF_C_CONTIGUOUS, PyBUF_FORMAT, PyBUF_STRIDES, PyBUF_WRITABLE, PyBuffer_Release
)
from cpython.exc cimport PyErr_Clear, PyErr_Occurred
from libc.stdint cimport uintptr_t
from libc.stdlib cimport free, malloc
from libc.string cimport memcpy, memset

import numpy as np

NAME = "cython"
# of the interface it was built for
BLOCK_COUNT = BLOCKS

cdef extern from "Python.h":
    # without "except": in the limited API entering a ``try`` takes longer than this call
    int PyObject_GetBuffer(object exporter, Py_buffer *view, int flags) noexcept
    bint PyFloat_Check(object value) noexcept
    bint PyLong_CheckExact(object value) noexcept
    double PyFloat_AsDouble(object value) noexcept
    double PyLong_AsDouble(object value) noexcept

cdef extern from "map.h" nogil:
    ctypedef struct cardan_in:
        const double *t
    int cardan_map(int (*f)(const cardan_in *, double *, double *) noexcept nogil,
                   const double *const *blocks, const size_t *strides, size_t n,
                   double *out, size_t out_stride, double *work, Py_ssize_t *failed)
    int cardan_too_large(size_t rows, size_t size)
    Py_ssize_t cardan_first_bad(const double *x, size_t n)

ctypedef int (*function)(const cardan_in *, double *, double *) noexcept nogil
ctypedef void (*preparation)(const double *, double *) noexcept nogil

cdef enum:
    BLOCKS = 17
    ARGUMENTS = 12
    PLACES = 3
    AXES = 2
    # arrays of results, and pieces of an argument
    PARTS = 16
    SMALL_WORK = 512
    LONG = 20000
    # numbers of lists that are not worth more ado
    LISTED = 128
    # states from which on lanes are worth it
    VECTORS = 16

cdef object ndarray = np.ndarray
cdef object empty = np.empty
cdef object double_number = np.float64
cdef object single_number = np.float32
cdef int NUMBERS = PyBUF_C_CONTIGUOUS | PyBUF_FORMAT
cdef int STRIDED = PyBUF_STRIDES | PyBUF_FORMAT


cdef inline bint is_number(const Py_buffer *view, char kind) noexcept:
    """Whether a buffer has doubles (d) or floats (f)."""
    return view.format[0] == kind and view.format[1] == 0


cdef double *memory(Py_ssize_t size) except NULL:
    """Work memory of so many numbers, to be freed by the caller."""
    cdef double *work = NULL
    if size >= 0 and not cardan_too_large(<size_t>size + 1, 1):
        work = <double *>malloc((<size_t>size + 1) * sizeof(double))
    if work == NULL:
        raise MemoryError(f"{size} numbers of work memory")
    return work


def run(address, blocks, strides, Py_ssize_t count, out, Py_ssize_t work_size):
    """Call a function at ``count`` states; see :func:`abi_ctypes.run`."""
    cdef function f = <function><uintptr_t>address
    cdef const double *at[BLOCKS]
    cdef size_t step[BLOCKS]
    cdef Py_ssize_t failed = -1, width
    cdef int status, k
    cdef const double[::1] flat
    cdef double[:, ::1] result = out
    held = []
    for k in range(BLOCKS):
        at[k], step[k] = NULL, strides[k]
        if blocks[k] is not None:
            flat = blocks[k]
            held.append(flat)
            at[k] = &flat[0] if flat.shape[0] else NULL
    width = result.shape[1]
    if count < 0 or count > result.shape[0]:
        raise ValueError(f"{count} states do not fit into {result.shape[0]} rows")
    cdef double *work = memory(work_size)
    cdef double *first = &result[0, 0] if width else work
    with nogil:
        status = cardan_map(f, at, step, <size_t>count, first, <size_t>width, work, &failed)
    free(work)
    return status, failed


def prepare(address, const double[:, ::1] p, double[:, ::1] w):
    """Call a ``prepare_`` function for every row of p."""
    cdef preparation f = <preparation><uintptr_t>address
    cdef Py_ssize_t i
    for i in range(w.shape[0]):
        f(&p[i, 0] if p.shape[1] else NULL, &w[i, 0])


def first_bad(x):
    """Flat index of the first entry that is NaN or infinite, -1 if all are finite."""
    cdef const double[::1] flat = x.reshape(-1)
    cdef Py_ssize_t n = flat.shape[0], answer
    if n == 0:
        return -1
    with nogil:
        answer = cardan_first_bad(&flat[0], <size_t>n)
    return answer


include "_results.pxi"
include "_fast.pxi"


def fast(caller):
    """The quickest way to call one function for one state or a batch."""
    if len(caller.arguments) > ARGUMENTS:
        return caller
    return Fast(caller)
