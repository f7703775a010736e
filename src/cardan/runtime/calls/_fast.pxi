# of _abi.pyx, which includes it: functions called for one state or a batch of them with as little
# Python as possible

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
cdef class Fast(Results):
    """One function for one state or a batch; whatever is not plain goes to the caller.

    What is handed over may come in an order of its own, one argument of it by components, and results
    may be wanted as several arrays, as a derivative gives them: see :class:`.calling.Arrangement`.
    """

    cdef Py_ssize_t offset[ARGUMENTS][PLACES]
    cdef Py_ssize_t size[ARGUMENTS]
    cdef int axes[ARGUMENTS]
    cdef Py_ssize_t length[ARGUMENTS][AXES]
    cdef bint required[ARGUMENTS]
    # where the caller has every argument, -1 for one that is left out
    cdef int place[ARGUMENTS]
    cdef Py_ssize_t handed
    # the argument that comes by components, -1 if none does
    cdef int joined, components
    cdef Py_ssize_t component_first[PARTS]
    cdef Py_ssize_t component_size[PARTS]
    cdef bint component_single[PARTS]

    def __init__(self, caller, arrangement=None):
        cdef int i, k
        Results.__init__(self, caller)
        shapes = [argument.shape for argument in caller.arguments]
        self.handed, self.joined, self.components = self.count, -1, 0
        for i in range(self.count):
            self.place[i] = i
        if arrangement is not None:
            self.arrange(arrangement, shapes)
        for i, argument in enumerate(caller.arguments):
            self.size[i], self.axes[i] = argument.size, len(shapes[i])
            for k in range(min(self.axes[i], AXES)):
                self.length[i][k] = shapes[i][k]
            self.required[i] = argument.default is None and argument.size > 0
            for k, (_, first) in enumerate(argument.blocks):
                self.offset[i][k] = first

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
        return Fast(self.caller, arrangement).attempt

    def attempt(self, tuple values):
        """Results of arguments as arranged; None where they want a closer look."""
        return self.quick(None, values) if len(values) <= self.handed else None

    cdef object quick(self, out, tuple values):
        """Results of plain arguments; None where something wants a closer look."""
        cdef reading r
        cdef int i
        cdef Py_ssize_t given = len(values)
        r.states, r.unit, r.rows, r.columns, r.used, r.listed = -1, 0, False, False, 0, 0
        memcpy(r.at, self.constant[0], sizeof(r.at))
        memset(r.stride, 0, sizeof(r.stride))
        memset(r.taken, 0, sizeof(r.taken))
        result = None
        try:
            for i in range(self.count):
                # those at the end that are left out have their defaults too
                value = values[self.place[i]] if 0 <= self.place[i] < given else None
                if not self.take(&r, i, value):
                    break
            else:
                if r.states < 0:
                    result = self.evaluate_parts(&r) if self.parts else self.evaluate(&r, out)
                else:
                    result = self.evaluate_batch(&r, out)
        finally:
            for i in range(r.used):
                PyBuffer_Release(&r.views[i])
        return result

    cdef bint take(self, reading *r, int i, value):
        """Let the blocks of argument i start where a value is; False where it is not a plain one."""
        cdef const char *start
        if value is None:
            return not self.required[i]
        if type(value) is ndarray and i != self.joined:
            if PyObject_GetBuffer(value, &r.views[r.used], STRIDED):
                PyErr_Clear()
                return False
            r.owner[r.used] = i
            r.used += 1
            return self.take_array(r, i, &r.views[r.used - 1])
        if r.listed + self.size[i] > ARGUMENTS + LISTED:
            return False
        start = <const char *>&r.number[r.listed]
        if i == self.joined:
            if not self.join(value, &r.number[r.listed]):
                return False
            r.listed += self.size[i]
        elif self.axes[i] == 0:
            if not read(value, &r.number[r.listed]):
                return False
            r.listed += 1
        elif self.axes[i] == 1 and (type(value) is list or type(value) is tuple):
            if len(value) != self.size[i]:
                return False
            for one in value:
                # a list may change while its numbers are read
                if r.listed >= ARGUMENTS + LISTED or not read(one, &r.number[r.listed]):
                    return False
                r.listed += 1
        else:
            return False
        self.point(r, i, start, 8, 0, 1)
        return True

    cdef bint take_array(self, reading *r, int i, const Py_buffer *view) noexcept:
        """The same for an array: of one state, or of a batch row by row or column by column."""
        cdef int lead = view.ndim - self.axes[i], k
        cdef Py_ssize_t unit, states = 1, size = self.size[i], next
        cdef bint by_row = True, by_entry
        r.batch[r.used - 1] = lead == 1
        if lead < 0 or lead > 1 or self.axes[i] > AXES:
            return False
        unit = 8 if is_number(view, c"d") else 4 if is_number(view, c"f") else 0
        for k in range(self.axes[i]):
            if view.shape[lead + k] != self.length[i][k] and self.length[i][k] >= 0:
                return False
        if lead:
            states = view.shape[0]
        if unit == 0 or states < 1 or view.len != states * size * unit:
            return False
        next = unit
        for k in range(view.ndim - 1, -1, -1):
            by_row = by_row and (view.strides[k] == next or view.shape[k] == 1 or size == 0)
            next *= view.shape[k]
        if not lead:
            self.point(r, i, <const char *>view.buf, unit, 0, 1)
            return by_row and unit == 8 and is_finite(view)
        if (r.states >= 0 and r.states != states) or (r.unit and r.unit != unit):
            return False
        by_entry = self.axes[i] == 1 and view.strides[0] == unit and view.strides[1] == unit * states
        r.states, r.unit = states, unit
        if size > 1:
            r.rows, r.columns = r.rows or by_row, r.columns or not by_row
        if by_row:
            self.point(r, i, <const char *>view.buf, unit, <size_t>size, 1)
        else:
            self.point(r, i, <const char *>view.buf, unit, 1, <size_t>states)
        return by_row or by_entry

    cdef inline void point(self, reading *r, int i, const char *start, Py_ssize_t unit,
                           size_t stride, size_t spacing) noexcept:
        """Let the blocks of argument i start there and go on like that."""
        cdef int k, slot
        for k in range(self.places[i]):
            slot = self.slot[i][k]
            r.at[slot] = start + self.offset[i][k] * <Py_ssize_t>spacing * unit
            r.stride[slot], r.spacing[slot], r.taken[slot] = stride, spacing, True

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
            fits = view.ndim == 1 and is_number(&view, c"d") and view.shape[0] == self.component_size[k]
            fits = fits and cardan_first_bad(<const double *>view.buf, <size_t>view.shape[0]) < 0
            if fits:
                memcpy(start, view.buf, <size_t>self.component_size[k] * sizeof(double))
            PyBuffer_Release(&view)
            if not fits:
                return False
        return True
