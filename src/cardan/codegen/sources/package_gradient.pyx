from libc.string cimport memset

cdef extern from "motion_gradient.h" nogil:
    ctypedef struct cardan_simulation:
        const char *method
        const double *p
        const double *x
        const double *r
        double start, end, step, rtol, atol, t
        Py_ssize_t steps
    ctypedef struct cardan_gradient:
        cardan_simulation run
        Py_ssize_t most_steps
        double cost
        const double *by_x
        const double *by_p
        const double *by_r
        const char *refused
        const char *event
    size_t cardan_gradient_size(const cardan_export *, const cardan_gradient *)
    int cardan_gradient_of(const cardan_export *, cardan_gradient *, void *)


class GradientError(ArithmeticError):
    """A motion has no gradient, or broke down."""


def gradient(
    end, x=None, *, start=0.0, r=None, method=None, step=0.0, rtol=0.0, atol=0.0,
    most_steps=0, parameters=None,
):
    """Cost of a motion and its gradient, by a sweep back over the steps.

    Args:
        end, start: Times [s].
        x: State (nx,) at the start; by default that of the scene.
        r: Inputs (nr,), constant along the motion.
        method: One of METHODS, by default the first one.
        step: Of every step [s]; 0: as the tolerances ask for.
        rtol, atol: Tolerances; 0: 1e-9 and 1e-12.
        most_steps: For whose rows there is room; 0: as a fixed step takes, else 10000.

    Returns:
        The cost, and its gradient by name: ``"x"`` (nx,), ``"r"`` (nr,), ``"p"`` (np,).

    Raises:
        GradientError: an event changes the motion, or the run breaks down.
    """
    method = METHODS[0] if method is None else method
    if method not in METHODS:
        raise ValueError(f"there is no method {method!r}. There are: {', '.join(METHODS)}")
    cdef Py_ssize_t nx = len(COORDINATES) + len(SPEEDS) + cardan_scene.nz
    cdef cardan_gradient of
    cdef double[::1] x0 = np.zeros(1), r0, p0
    cdef bytes name = method.encode()
    memset(&of, 0, sizeof(of))
    if x is not None:
        x0 = _row("x", x, nx)
        of.run.x = &x0[0]
    r0 = _row("r", _entries("r", r, INPUTS, _defaults("r")), len(INPUTS))
    p0 = _row("parameters", _entries("parameters", parameters, PARAMETERS, _defaults("p")),
              len(PARAMETERS))
    of.run.method, of.run.r, of.run.p = name, &r0[0], &p0[0]
    of.run.start, of.run.end, of.run.step = start, end, step
    of.run.rtol, of.run.atol, of.most_steps = rtol, atol, most_steps
    cdef void *memory = malloc(cardan_gradient_size(&cardan_scene, &of))
    cdef int status
    if memory == NULL:
        raise MemoryError()
    try:
        with nogil:
            status = cardan_gradient_of(&cardan_scene, &of, memory)
        if status:
            event = of.event.decode() + ": " if of.event != NULL else ""
            why = of.refused.decode() if of.refused != NULL else "run.h says what that is"
            raise GradientError(f"status {status} at t = {of.run.t:.6g} s: {event}{why}")
        sizes = (nx, len(INPUTS), len(PARAMETERS))
        parts = (_numbers(of.by_x, sizes[0]), _numbers(of.by_r, sizes[1]),
                 _numbers(of.by_p, sizes[2]))
        return of.cost, dict(zip("xrp", map(np.array, parts)))
    finally:
        free(memory)


def _row(name, values, size):
    """Numbers (size,) with one more behind them, so that there is a first one."""
    row = np.asarray(values, dtype=float)
    if row.shape != (size,):
        raise ValueError(f"{name} must have shape ({size},), not {row.shape}")
    return np.append(row, 0.0)
