# cython: language_level=3, boundscheck=False, wraparound=False, cdivision=True
"""Call generated functions with as little Python as possible; interface as in abi_ctypes.

Arrays are read through the buffer protocol: the extension needs Python.h, not NumPy's headers. One
build serves every Python from 3.11 on: of Python.h it uses the limited API alone.
"""

cimport cython
from cpython.buffer cimport PyBUF_C_CONTIGUOUS, PyBUF_FORMAT, PyBUF_WRITABLE, PyBuffer_Release
from cpython.exc cimport PyErr_Clear, PyErr_Occurred
from libc.stdint cimport uintptr_t
from libc.stdlib cimport free, malloc
from libc.string cimport memset

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
    SMALL_WORK = 512
    LONG = 20000
    # numbers of lists that are not worth more ado
    LISTED = 128

cdef object ndarray = np.ndarray
cdef object empty = np.empty
cdef int NUMBERS = PyBUF_C_CONTIGUOUS | PyBUF_FORMAT


cdef inline bint is_double(const Py_buffer *view) noexcept:
    return view.itemsize == 8 and view.format[0] == c"d" and view.format[1] == 0


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


cdef inline bint read(value, double *number) noexcept:
    """Whether a value is a finite number, and the number."""
    if PyFloat_Check(value):
        number[0] = PyFloat_AsDouble(value)
    elif PyLong_CheckExact(value):
        number[0] = PyLong_AsDouble(value)
        if number[0] == -1 and PyErr_Occurred():
            PyErr_Clear()
            return False
    else:
        return False
    return number[0] - number[0] == 0


@cython.final
cdef class Fast:
    """One function for one state or a few of them; everything else goes to the caller."""

    cdef function f
    cdef int count
    cdef int places[ARGUMENTS]
    cdef int slot[ARGUMENTS][PLACES]
    cdef Py_ssize_t offset[ARGUMENTS][PLACES]
    cdef Py_ssize_t size[ARGUMENTS]
    cdef int axes[ARGUMENTS]
    cdef const double *fallback[ARGUMENTS]
    cdef const double *w
    cdef int w_slot
    cdef Py_ssize_t operations, few
    cdef Py_ssize_t out_size, work_size
    cdef object caller, shape, held
    cdef tuple empty_arguments

    def __init__(self, caller, int w_slot):
        cdef int i, k
        cdef const double[::1] flat
        self.caller, self.held = caller, []
        self.f = <function><uintptr_t>caller.address
        self.count, self.w_slot = len(caller.arguments), w_slot
        self.out_size, self.work_size, self.shape = caller.size, caller.work_size, caller.shape
        self.empty_arguments = (self.shape,)
        self.operations = caller.operations
        self.few = caller.few
        self.w = self.hold(caller.w)
        for i, argument in enumerate(caller.arguments):
            self.size[i], self.axes[i] = argument.size, len(argument.shape)
            self.fallback[i] = NULL
            if argument.default is not None:
                self.fallback[i] = self.hold(argument.default)
            self.places[i] = len(argument.blocks)
            for k, (slot, first) in enumerate(argument.blocks):
                self.slot[i][k], self.offset[i][k] = slot, first

    cdef const double *hold(self, array) except? NULL:
        """Where a constant array starts; NULL if it is empty."""
        cdef const double[::1] flat = np.ascontiguousarray(array, dtype=np.float64).reshape(-1)
        self.held.append(flat)
        return &flat[0] if flat.shape[0] else NULL

    def __call__(self, out, *values):
        cdef const double *at[BLOCKS]
        cdef size_t step[BLOCKS]
        cdef double number[ARGUMENTS + LISTED]
        cdef Py_buffer views[ARGUMENTS]
        cdef int used = 0, listed = 0, i, ready
        # of a batch
        cdef Py_ssize_t states = -1, rows
        cdef Py_ssize_t given = len(values)
        if given > self.count:
            return self.caller(out, *values)
        memset(at, 0, sizeof(at))
        memset(step, 0, sizeof(step))
        at[self.w_slot] = self.w
        ready = 1
        result = None
        try:
            # every argument becomes a pointer, or the call is not a plain one
            for i in range(self.count):
                # those at the end that are left out have their defaults too
                value = values[i] if i < given else None
                if value is None:
                    if self.fallback[i] == NULL and self.size[i]:
                        ready = 0
                        break
                    self.point(at, i, self.fallback[i])
                elif type(value) is ndarray:
                    if PyObject_GetBuffer(value, &views[used], NUMBERS):
                        PyErr_Clear()
                        ready = 0
                        break
                    used += 1
                    rows = self.rows(&views[used - 1], i)
                    if rows < 0 or (rows > 0 and states >= 0 and rows != states):
                        ready = 0
                        break
                    if rows:
                        states = rows
                        self.walk(step, i)
                    self.point(at, i, <const double *>views[used - 1].buf)
                elif self.axes[i] == 0:
                    if not read(value, &number[listed]):
                        ready = 0
                        break
                    self.point(at, i, &number[listed])
                    listed += 1
                elif self.axes[i] == 1 and (type(value) is list or type(value) is tuple):
                    if listed + self.size[i] > LISTED or len(value) != self.size[i]:
                        ready = 0
                        break
                    self.point(at, i, &number[listed])
                    for one in value:
                        if listed >= ARGUMENTS + LISTED or not read(one, &number[listed]):
                            ready = 0
                            break
                        listed += 1
                    if not ready:
                        break
                else:
                    ready = 0
                    break
            if ready and states < 0:
                result = self.evaluate(at, out)
            elif ready and out is None and states <= self.few:
                result = self.evaluate_few(at, step, states)
        finally:
            for i in range(used):
                PyBuffer_Release(&views[i])
        return self.caller(out, *values) if result is None else result

    cdef inline void point(self, const double **at, int i, const double *start) noexcept:
        """Let the blocks of argument i start there."""
        cdef int k
        for k in range(self.places[i]):
            at[self.slot[i][k]] = start + self.offset[i][k] if start != NULL else NULL

    cdef inline void walk(self, size_t *step, int i) noexcept:
        """Let the blocks of argument i go on from state to state."""
        cdef int k
        for k in range(self.places[i]):
            step[self.slot[i][k]] = <size_t>self.size[i]

    cdef inline Py_ssize_t rows(self, const Py_buffer *view, int i) noexcept:
        """States of a buffer of finite doubles as argument i has them.

        0 if it has no leading axis; negative if it fits in no simple way.
        """
        cdef int lead = view.ndim - self.axes[i]
        cdef Py_ssize_t count = 1
        if lead < 0 or lead > 1 or self.axes[i] > 1 or not is_double(view):
            return -1
        if lead:
            count = view.shape[0]
            if count < 1:
                return -1
        if self.axes[i] and view.shape[lead] != self.size[i]:
            return -1
        if cardan_first_bad(<const double *>view.buf, <size_t>(count * self.size[i])) >= 0:
            return -1
        return count if lead else 0

    cdef object evaluate(self, const double **at, out):
        """The result as an array; None where ``out`` or the numbers want a closer look."""
        cdef double small[SMALL_WORK]
        cdef double *work = small
        cdef Py_buffer view
        cdef int status
        cdef Py_ssize_t bad
        if out is None:
            result = empty(*self.empty_arguments)
        elif type(out) is ndarray and out.shape == self.shape:
            result = out
        else:
            return None
        if PyObject_GetBuffer(result, &view, NUMBERS | PyBUF_WRITABLE):
            PyErr_Clear()
            return None
        if not is_double(&view):
            PyBuffer_Release(&view)
            return None
        if self.work_size > SMALL_WORK:
            try:
                work = memory(self.work_size)
            except MemoryError:
                PyBuffer_Release(&view)
                raise
        if self.operations > LONG:
            with nogil:
                status = self.f(<const cardan_in *>at, <double *>view.buf, work)
        else:
            status = self.f(<const cardan_in *>at, <double *>view.buf, work)
        bad = cardan_first_bad(<const double *>view.buf, <size_t>self.out_size)
        if work != small:
            free(work)
        PyBuffer_Release(&view)
        return result if status == 0 and bad < 0 else None

    cdef object evaluate_few(self, const double **at, const size_t *step, Py_ssize_t states):
        """The results at some states, (states, ...); None where the numbers want a closer look."""
        cdef Py_buffer view
        cdef int status
        cdef Py_ssize_t bad, failed = -1
        cdef double *work = memory(self.work_size)
        result = empty((states, *self.shape))
        if PyObject_GetBuffer(result, &view, NUMBERS | PyBUF_WRITABLE):
            PyErr_Clear()
            free(work)
            return None
        with nogil:
            status = cardan_map(self.f, at, step, <size_t>states, <double *>view.buf,
                                <size_t>self.out_size, work, &failed)
            bad = cardan_first_bad(<const double *>view.buf, <size_t>(states * self.out_size))
        free(work)
        PyBuffer_Release(&view)
        return result if status == 0 and bad < 0 else None


def fast(caller):
    """The quickest way to call one function for one state."""
    if len(caller.arguments) > ARGUMENTS:
        return caller
    return Fast(caller, caller.w_slot)
