# of _abi.pyx, which includes it: functions called for one state or a few, numbers from Python

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


cdef inline bint overlap(const Py_buffer *one, const Py_buffer *other) noexcept:
    """Whether two contiguous arrays have memory in common."""
    cdef const char *first = <const char *>one.buf
    cdef const char *second = <const char *>other.buf
    return first < second + other.len and second < first + one.len


@cython.final
cdef class Fast:
    """One function for one state or a few of them; everything else goes to the caller.

    What is handed over may come in an order of its own, one argument of it by components, and results
    may be wanted as several arrays, as a derivative gives them: see :class:`.calling.Arrangement`.
    """

    cdef function f
    cdef int count
    cdef int places[ARGUMENTS]
    cdef int slot[ARGUMENTS][PLACES]
    cdef Py_ssize_t offset[ARGUMENTS][PLACES]
    cdef Py_ssize_t size[ARGUMENTS]
    cdef int axes[ARGUMENTS]
    cdef Py_ssize_t length[ARGUMENTS][AXES]
    cdef const double *fallback[ARGUMENTS]
    # where the caller has every argument, -1 for one that is left out
    cdef int place[ARGUMENTS]
    cdef Py_ssize_t handed
    # the argument that comes by components, -1 if none does
    cdef int joined, components
    cdef Py_ssize_t component_first[PARTS]
    cdef Py_ssize_t component_size[PARTS]
    cdef bint component_single[PARTS]
    # results as several arrays, 0 for one
    cdef int parts
    cdef Py_ssize_t part_first[PARTS]
    cdef Py_ssize_t part_size[PARTS]
    cdef tuple part_shapes
    cdef const double *w
    cdef int w_slot
    cdef Py_ssize_t operations, few
    cdef Py_ssize_t out_size, work_size
    cdef object caller, shape, held
    cdef tuple empty_arguments

    def __init__(self, caller, int w_slot, arrangement=None):
        cdef int i, k
        self.caller, self.held = caller, []
        self.f = <function><uintptr_t>caller.address
        self.count, self.w_slot = len(caller.arguments), w_slot
        self.out_size, self.work_size, self.shape = caller.size, caller.work_size, caller.shape
        self.empty_arguments = (self.shape,)
        self.operations = caller.operations
        self.few = caller.few
        self.w = self.hold(caller.w)
        shapes = [argument.shape for argument in caller.arguments]
        self.handed, self.joined, self.components, self.parts = self.count, -1, 0, 0
        for i in range(self.count):
            self.place[i] = i
        if arrangement is not None:
            self.arrange(arrangement, shapes)
        for i, argument in enumerate(caller.arguments):
            self.size[i], self.axes[i] = argument.size, len(shapes[i])
            for k in range(min(self.axes[i], AXES)):
                self.length[i][k] = shapes[i][k]
            self.fallback[i] = NULL
            if argument.default is not None:
                self.fallback[i] = self.hold(argument.default)
            self.places[i] = len(argument.blocks)
            for k, (slot, first) in enumerate(argument.blocks):
                self.slot[i][k], self.offset[i][k] = slot, first

    cdef object arrange(self, arrangement, list shapes):
        """Take over places, shapes, components and parts."""
        cdef int i, k
        self.handed = arrangement.handed
        for i in range(self.count):
            self.place[i] = arrangement.places[i]
        for i, shape in arrangement.shapes.items():
            shapes[i] = shape
        if arrangement.components:
            self.joined, self.components = arrangement.joined, len(arrangement.components)
            for k, (first, size, single) in enumerate(arrangement.components):
                self.component_first[k], self.component_size[k] = first, size
                self.component_single[k] = single
        self.parts = len(arrangement.parts)
        self.part_shapes = tuple([tuple(shape) for _, _, shape in arrangement.parts])
        for k, (first, size, _) in enumerate(arrangement.parts):
            self.part_first[k], self.part_size[k] = first, size

    cdef const double *hold(self, array) except? NULL:
        """Where a constant array starts; NULL if it is empty."""
        cdef const double[::1] flat = np.ascontiguousarray(array, dtype=np.float64).reshape(-1)
        self.held.append(flat)
        return &flat[0] if flat.shape[0] else NULL

    def __call__(self, out, *values):
        result = None
        if len(values) <= self.handed:
            result = self.quick(out, values)
        return self.caller(out, *values) if result is None else result

    def arranged(self, arrangement):
        """Another way into the function; called with all its arguments as one tuple, it gives
        None where they want a closer look."""
        if max(len(arrangement.parts), len(arrangement.components)) > PARTS:
            return self.caller.arranged(arrangement)
        return Fast(self.caller, self.w_slot, arrangement).attempt

    def attempt(self, tuple values):
        """Results of arguments as arranged; None where they want a closer look."""
        return self.quick(None, values) if len(values) <= self.handed else None

    cdef object quick(self, out, tuple values):
        """Results of plain arguments; None where something wants a closer look."""
        cdef const double *at[BLOCKS]
        cdef size_t step[BLOCKS]
        cdef double number[ARGUMENTS + LISTED]
        cdef Py_buffer views[ARGUMENTS]
        cdef int used = 0, listed = 0, i, ready
        # of a batch
        cdef Py_ssize_t states = -1, rows
        cdef Py_ssize_t given = len(values)
        memset(at, 0, sizeof(at))
        memset(step, 0, sizeof(step))
        at[self.w_slot] = self.w
        ready = 1
        result = None
        try:
            # every argument becomes a pointer, or the call is not a plain one
            for i in range(self.count):
                # those at the end that are left out have their defaults too
                value = values[self.place[i]] if 0 <= self.place[i] < given else None
                if value is None:
                    if self.fallback[i] == NULL and self.size[i]:
                        ready = 0
                        break
                    self.point(at, i, self.fallback[i])
                elif i == self.joined:
                    if listed + self.size[i] > LISTED or not self.join(value, &number[listed]):
                        ready = 0
                        break
                    self.point(at, i, &number[listed])
                    listed += self.size[i]
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
                if self.parts:
                    result = self.evaluate_parts(at)
                else:
                    result = self.evaluate(at, out, views, used)
            elif ready and out is None and states <= self.few:
                result = self.evaluate_few(at, step, states)
        finally:
            for i in range(used):
                PyBuffer_Release(&views[i])
        return result

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
        cdef int lead = view.ndim - self.axes[i], k
        cdef Py_ssize_t count = 1
        if lead < 0 or lead > 1 or self.axes[i] > AXES or not is_double(view):
            return -1
        if lead:
            # of more states the numbers are looked at elsewhere
            count = view.shape[0]
            if count < 1 or count > self.few:
                return -1
        for k in range(self.axes[i]):
            if view.shape[lead + k] != self.length[i][k] and self.length[i][k] >= 0:
                return -1
        if view.len != count * self.size[i] * <Py_ssize_t>sizeof(double):
            return -1
        if cardan_first_bad(<const double *>view.buf, <size_t>(count * self.size[i])) >= 0:
            return -1
        return count if lead else 0

    cdef bint join(self, value, double *numbers):
        """Put the components of an argument in their places; False if they fit in no simple way."""
        cdef Py_buffer view
        cdef double *start
        cdef int k
        cdef bint fits
        if (type(value) is not tuple and type(value) is not list) or len(value) != self.components:
            return False
        for k in range(self.components):
            component, start = value[k], numbers + self.component_first[k]
            if self.component_single[k]:
                if not read(component, start):
                    return False
                continue
            if type(component) is not ndarray:
                return False
            if PyObject_GetBuffer(component, &view, NUMBERS):
                PyErr_Clear()
                return False
            fits = view.ndim == 1 and is_double(&view) and view.shape[0] == self.component_size[k]
            fits = fits and cardan_first_bad(<const double *>view.buf, <size_t>view.shape[0]) < 0
            if fits:
                memcpy(start, view.buf, <size_t>self.component_size[k] * sizeof(double))
            PyBuffer_Release(&view)
            if not fits:
                return False
        return True

    cdef int call(self, const double **at, double *result) except -1:
        """Whether the function has given finite numbers for one state."""
        cdef double small[SMALL_WORK]
        cdef double *work = small
        cdef int status
        if self.work_size > SMALL_WORK:
            work = memory(self.work_size)
        if self.operations > LONG:
            with nogil:
                status = self.f(<const cardan_in *>at, result, work)
        else:
            status = self.f(<const cardan_in *>at, result, work)
        if work != small:
            free(work)
        return status == 0 and cardan_first_bad(result, <size_t>self.out_size) < 0

    cdef object evaluate(self, const double **at, out, const Py_buffer *read_views, int used):
        """The result as an array; None where ``out`` or the numbers want a closer look."""
        cdef Py_buffer view
        cdef bint good
        cdef int i
        if out is None:
            result = empty(*self.empty_arguments)
        elif type(out) is ndarray and out.shape == self.shape:
            result = out
        else:
            return None
        if PyObject_GetBuffer(result, &view, NUMBERS | PyBUF_WRITABLE):
            PyErr_Clear()
            return None
        good = is_double(&view)
        if out is not None:
            # loops over bodies write results before they have read everything
            for i in range(used):
                good = good and not overlap(&view, &read_views[i])
        if not good:
            PyBuffer_Release(&view)
            return None
        try:
            good = self.call(at, <double *>view.buf)
        finally:
            PyBuffer_Release(&view)
        return result if good else None

    cdef object evaluate_parts(self, const double **at):
        """The results as arrays of their own; None where the numbers want a closer look."""
        cdef double small[SMALL_WORK]
        cdef double *flat = small
        cdef object result = None
        if self.out_size > SMALL_WORK:
            flat = memory(self.out_size)
        try:
            if self.call(at, flat):
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
        if status != 0 or bad >= 0:
            return None
        return self.columns(result, states) if self.parts else result

    cdef object columns(self, flat, Py_ssize_t states):
        """The parts of results at some states, (states, ...) each."""
        cdef int k
        arrays = []
        for k in range(self.parts):
            part = flat[:, self.part_first[k] : self.part_first[k] + self.part_size[k]]
            arrays.append(part.reshape((states, *self.part_shapes[k])))
        return tuple(arrays)

