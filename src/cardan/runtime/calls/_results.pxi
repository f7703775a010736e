# of _abi.pyx, which includes it: results of one function, for what is read

cdef inline bint is_finite(const Py_buffer *view) noexcept:
    """Whether all numbers of a buffer of doubles without gaps are."""
    return cardan_first_bad(<const double *>view.buf, <size_t>(view.len // 8)) < 0


cdef inline bint meet(const Py_buffer *one, const Py_buffer *other) noexcept:
    """Whether two buffers without gaps share memory."""
    return (<const char *>one.buf < <const char *>other.buf + other.len
            and <const char *>other.buf < <const char *>one.buf + one.len)


# what a call reads
cdef struct reading:
    # where every block starts, and how many numbers it is from one of its states and of its entries
    # to the next
    const char *at[BLOCKS]
    size_t stride[BLOCKS]
    size_t spacing[BLOCKS]
    # blocks that were handed over
    bint taken[BLOCKS]
    # of a batch, -1 for one state; bytes of its numbers, 0 before they are known
    Py_ssize_t states, unit
    # whether it lies state by state, whether entry by entry
    bint rows, columns
    # arrays, the arguments that they are, and whether they are batches
    Py_buffer views[ARGUMENTS]
    int owner[ARGUMENTS]
    bint batch[ARGUMENTS]
    int used
    # numbers that came one by one
    double number[ARGUMENTS + LISTED]
    int listed


ctypedef int (*batch_driver)(const void *f, const void *single, const char *const *blocks,
                             const size_t *strides, const size_t *spacings, const size_t *sizes,
                             size_t n, char *out, size_t work_size, char *room,
                             Py_ssize_t *failed, int *finite) noexcept nogil


@cython.final
cdef class Lanes:
    """A lane build that batches go through in one call; see :class:`.lanes.Direct`."""

    cdef object direct
    cdef batch_driver driver
    cdef const void *f
    cdef const void *single
    cdef size_t sizes[BLOCKS + 1]
    cdef Py_ssize_t room, vector

    def __init__(self, direct, Py_ssize_t out_size, Py_ssize_t work_size):
        cdef int k
        self.direct = direct
        self.driver = <batch_driver><uintptr_t>direct.driver
        self.f = <const void *><uintptr_t>direct.address
        self.single = <const void *><uintptr_t>direct.single
        for k in range(BLOCKS):
            self.sizes[k] = direct.sizes[k]
        self.sizes[BLOCKS] = <size_t>out_size
        self.room, self.vector = direct.room(out_size, work_size), direct.vector


cdef class Results:
    """One function: what it is called with, and how its results are handed on."""

    cdef function f
    cdef int count
    cdef int places[ARGUMENTS]
    cdef int slot[ARGUMENTS][PLACES]
    # blocks that are not handed over, as doubles and as floats
    cdef const char *constant[2][BLOCKS]
    # results as several arrays, 0 for one
    cdef int parts
    cdef Py_ssize_t part_first[PARTS]
    cdef Py_ssize_t part_size[PARTS]
    cdef tuple part_shapes
    cdef Py_ssize_t operations, few
    cdef Py_ssize_t out_size, work_size
    cdef object caller, shape, held
    # whether constant blocks are there as floats
    cdef bint constant_singles
    cdef tuple empty_arguments
    # what batches go through, and its lane builds as they were last seen, of doubles and of floats
    cdef tuple batches
    cdef list lanes

    def __init__(self, caller):
        cdef int i, k
        self.caller, self.held = caller, []
        self.f = <function><uintptr_t>caller.address
        self.count = len(caller.arguments)
        self.out_size, self.work_size, self.shape = caller.size, caller.work_size, caller.shape
        self.empty_arguments = (self.shape,)
        self.operations, self.few, self.parts = caller.operations, caller.few, 0
        self.batches, self.lanes = (caller.batch, caller.single), [None, None]
        self.hold(0, caller.constants(np.float64))
        self.constant_singles = False
        for i, argument in enumerate(caller.arguments):
            self.places[i] = len(argument.blocks)
            for k, (slot, first) in enumerate(argument.blocks):
                self.slot[i][k] = slot

    cdef object hold(self, int kind, blocks):
        """Take over where constant blocks start; NULL for empty ones."""
        cdef int k
        for k in range(BLOCKS):
            self.constant[kind][k] = NULL
            if blocks[k] is not None and blocks[k].size:
                self.constant[kind][k] = <const char *><uintptr_t>blocks[k].ctypes.data
        self.held.append(blocks)

    cdef int call(self, reading *r, double *result) except -1:
        """Whether the function has given finite numbers for one state."""
        cdef double small[SMALL_WORK]
        cdef double *work = small
        cdef int status
        if self.work_size > SMALL_WORK:
            work = memory(self.work_size)
        if self.operations > LONG:
            with nogil:
                status = self.f(<const cardan_in *>r.at, result, work)
        else:
            status = self.f(<const cardan_in *>r.at, result, work)
        if work != small:
            free(work)
        return status == 0 and cardan_first_bad(result, <size_t>self.out_size) < 0

    cdef object evaluate(self, reading *r, out):
        """The result as an array; None where ``out`` or the numbers want a closer look."""
        cdef Py_buffer view
        cdef bint good
        if out is None:
            result = empty(*self.empty_arguments)
        elif type(out) is ndarray and out.shape == self.shape:
            result = out
        else:
            return None
        if PyObject_GetBuffer(result, &view, NUMBERS | PyBUF_WRITABLE):
            PyErr_Clear()
            return None
        try:
            good = is_number(&view, c"d") and (out is None or self.disjoint(r, &view))
            good = good and self.call(r, <double *>view.buf)
        finally:
            PyBuffer_Release(&view)
        return result if good else None

    cdef object evaluate_parts(self, reading *r):
        """The results as arrays of their own; None where the numbers want a closer look."""
        cdef double small[SMALL_WORK]
        cdef double *flat = small
        cdef object result = None
        if self.out_size > SMALL_WORK:
            flat = memory(self.out_size)
        try:
            if self.call(r, flat):
                result = self.divided(flat)
        finally:
            if flat != small:
                free(flat)
        return result

    cdef object divided(self, const double *flat):
        """A tuple of new arrays with the parts of a result; None where there is no writing."""
        cdef Py_buffer view
        cdef int k
        cdef list arrays = []
        for k in range(self.parts):
            array = empty(self.part_shapes[k])
            if PyObject_GetBuffer(array, &view, NUMBERS | PyBUF_WRITABLE):
                PyErr_Clear()
                return None
            memcpy(view.buf, flat + self.part_first[k],
                   <size_t>self.part_size[k] * sizeof(double))
            PyBuffer_Release(&view)
            arrays.append(array)
        return tuple(arrays)

    cdef object evaluate_batch(self, reading *r, out):
        """The results at some states, (states, ...); None where something wants a closer look."""
        cdef Py_buffer view
        cdef int k, kind = r.unit == 4
        cdef bint columns = r.columns and not r.rows, good
        cdef Lanes lanes = self.lane_build(kind, r.states)
        if lanes is None and (kind or r.columns or r.states > self.few):
            return None
        if columns and self.parts:
            return None
        for k in range(r.used):
            # lanes look at the numbers while they have them at hand
            if r.batch[k] and not (lanes is not None and self.reads_all(lanes, r.owner[k])):
                if kind or not is_finite(&r.views[k]):
                    return None
        result = out if out is not None else self.room(r.states, kind, columns)
        if type(result) is not ndarray or PyObject_GetBuffer(result, &view, STRIDED | PyBUF_WRITABLE):
            PyErr_Clear()
            return None
        try:
            good = out is None or self.takes(r, out, &view)
            if good and lanes is not None:
                good = self.call_lanes(r, lanes, kind, columns, &view)
            elif good:
                good = self.call_each(r, &view)
        finally:
            PyBuffer_Release(&view)
        if not good:
            return None
        return self.columns(result, r.states) if self.parts else result

    cdef Lanes lane_build(self, int kind, Py_ssize_t states):
        """The lane build for so many states, None where there is none or one is not enough."""
        cdef Lanes lanes
        if states < VECTORS or self.batches[kind] is None:
            return None
        direct = self.batches[kind].direct
        if direct is None or states > direct.most:
            return None
        # once the caller has refused what floats cannot hold, and said what they lose
        if kind and not self.constant_singles:
            if not self.caller.compared:
                return None
            self.hold(1, self.caller.constants(np.float32))
            self.constant_singles = True
        lanes = self.lanes[kind]
        if lanes is None or lanes.direct is not direct:
            lanes = Lanes(direct, self.out_size, self.work_size)
            self.lanes[kind] = lanes
        return lanes

    cdef bint reads_all(self, Lanes lanes, int i) noexcept:
        """Whether lanes read all blocks of argument i."""
        cdef int k
        for k in range(self.places[i]):
            if lanes.sizes[self.slot[i][k]] == 0:
                return False
        return True

    cdef object room(self, Py_ssize_t states, int kind, bint columns):
        """A new array for results, row by row or column by column."""
        numbers = single_number if kind else double_number
        if columns:
            return empty((self.out_size, states), numbers).T.reshape((states, *self.shape))
        return empty((states, *self.shape), numbers)

    cdef bint takes(self, reading *r, out, const Py_buffer *view):
        """Whether results may be written to an array: row by row, to memory that is not read."""
        if self.parts or not out.flags.c_contiguous or out.shape != (r.states, *self.shape):
            return False
        if (r.columns and not r.rows) or not is_number(view, c"d" if r.unit == 8 else c"f"):
            return False
        return self.disjoint(r, view)

    cdef bint disjoint(self, reading *r, const Py_buffer *view) noexcept:
        """Whether none of the arrays that are read shares memory with a buffer."""
        cdef int k
        for k in range(r.used):
            if meet(view, &r.views[k]):
                return False
        return True

    cdef bint call_lanes(self, reading *r, Lanes lanes, int kind, bint columns, Py_buffer *view) except -1:
        """Whether the lane build has given finite numbers for finite ones."""
        cdef int k, status, finite = 0
        cdef Py_ssize_t failed = -1
        cdef const char *at[BLOCKS]
        cdef size_t stride[BLOCKS + 1]
        cdef size_t spacing[BLOCKS + 1]
        cdef char *begin
        for k in range(BLOCKS):
            at[k] = NULL
            stride[k], spacing[k] = 0, 1
            if lanes.sizes[k] and r.taken[k]:
                at[k], stride[k], spacing[k] = r.at[k], r.stride[k], r.spacing[k]
            elif lanes.sizes[k]:
                at[k] = self.constant[kind][k]
            # one number, not of a batch, is a double
            if kind and at[k] != NULL and r.taken[k] and r.stride[k] == 0:
                return False
        stride[BLOCKS] = 1 if columns else <size_t>self.out_size
        spacing[BLOCKS] = <size_t>r.states if columns else 1
        cdef char *room = <char *>memory((lanes.room + lanes.vector) // 8 + 1)
        begin = room + (lanes.vector - <Py_ssize_t>(<uintptr_t>room) % lanes.vector) % lanes.vector
        with nogil:
            status = lanes.driver(lanes.f, lanes.single, at, stride, spacing, lanes.sizes,
                                  <size_t>r.states, <char *>view.buf, <size_t>self.work_size, begin,
                                  &failed, &finite)
        free(room)
        return status == 0 and finite

    cdef bint call_each(self, reading *r, Py_buffer *view) except -1:
        """Whether the function has given finite numbers state by state."""
        cdef int status
        cdef Py_ssize_t failed = -1
        cdef double *work = memory(self.work_size)
        with nogil:
            status = cardan_map(self.f, <const double *const *>r.at, r.stride, <size_t>r.states,
                                <double *>view.buf, <size_t>self.out_size, work, &failed)
        free(work)
        return status == 0 and is_finite(view)

    cdef object columns(self, flat, Py_ssize_t states):
        """The parts of results at some states, (states, ...) each."""
        cdef int k
        arrays = []
        for k in range(self.parts):
            part = flat[:, self.part_first[k] : self.part_first[k] + self.part_size[k]]
            arrays.append(part.reshape((states, *self.part_shapes[k])))
        return tuple(arrays)
