/* The implicit midpoint rule on which the energy balance is imposed: order 2, fixed step.
 *
 * Part of cardan. Caller owns all memory; k holds the derivatives at the start, the middle and the
 * end of a step.
 *
 * A step solves  x1 = x0 + h f(xm) + mu (0, um)  with xm = (x0 + x1) / 2, um its speeds, and
 *   E(x1) = E(start) + work of all sources without a potential, taken at the middles,
 * where mu is as unknown as x1. It is a discrete gradient along the speeds, and symmetric:
 * exchanging the ends turns mu round. The balance holds at every step size, from the start of the
 * segment on, so that roundings do not add up. Quaternions go by their increments, loops are
 * closed before the energy counts.
 *
 * Where the motion turns round, um vanishes, and so does, in proportion, the error of the energy
 * without mu: both are divided by s, um along a direction d that is fixed in the step, and the
 * unknown is nu = mu s.
 *
 * Source: O. Gonzalez, Time integration and discrete Hamiltonian systems, J. Nonlinear Sci. 6
 * (1996) 449-467; E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration, 2nd ed., sections V.3
 * and V.4.
 */
#include "midpoint.h"
#include <math.h>

static const real MIN_DIRECTION = 1e-9; /* um along d, of the speeds, below which energies only round */
enum { SHORTEST = 64 /* parts of a step */ };

static ptrdiff_t length(const cardan_run *run)
{
    const ptrdiff_t size = run->nx + 1;

    return MEMORY + 3 * size * size + 4 * size + run->nu + run->n;
}

static room room_of(const cardan_run *run)
{
    const ptrdiff_t size = run->nx + 1;
    real *inverse = run->method_memory + MEMORY, *z = inverse + 3 * size * size;
    const room at = {size,         run->method_memory, inverse,
                     inverse + size * size, z, z + size, z + 2 * size,
                     z + 3 * size, z + 4 * size, z + 4 * size + run->nu};

    return at;
}

static int init(cardan_run *run)
{
    room_of(run).memory[FASTEST] = 0;
    return cardan_fixed_init(run);
}

static real work_of(const cardan_run *run, const real *y)
{
    real sum = 0;

    for (ptrdiff_t i = run->nx; i < run->n; i++)
        sum += y[i];
    return sum;
}

/* Total energy and that of motion at t, y (n). */
static int energy_at(cardan_run *run, real t, const real *y, real *total, real *kinetic)
{
    real energies[3];
    cardan_in in;
    int status;

    cardan_inputs_at(run, t, y);
    in = cardan_at(run, &t, y);
    status = cardan_call_model(run, &run->energy, &in, energies);
    *kinetic = energies[0];
    *total = energies[2];
    return status;
}

/* Residuals of the equations of a step for z. */
int cardan_midpoint_residual(cardan_run *run, const room *at, problem *step, real *residual)
{
    const ptrdiff_t n = run->n, nx = run->nx, nq = run->nq;
    const real *base = step->base;
    real *middle = run->trial, *f = run->k + n, total = 0, kinetic = 0, s = 0;
    int status;

    for (ptrdiff_t i = 0; i < n; i++)
        middle[i] = i < nx ? 0.5 * (base[i] + at->z[i]) : base[i];
    status = cardan_slope(run, step->t_new - 0.5 * step->h, middle, f);
    if (status != 0)
        return status;
    for (ptrdiff_t i = 0; i < run->nu; i++)
        s += at->direction[i] * middle[nq + i];
    step->motionless = fabs(s) <= MIN_DIRECTION * step->speed;
    if (!(fabs(s) > MIN_DIRECTION * step->speed))
        s = 0;
    for (ptrdiff_t i = 0; i < nx; i++) {
        const int is_speed = i >= nq && i < nq + run->nu && s != 0;
        residual[i] = at->z[i] - base[i] - step->h * f[i]
                      - (is_speed ? at->z[nx] * middle[i] / s : 0);
    }
    /* the energy counts where the step will end: with unit quaternions and closed loops */
    for (ptrdiff_t i = 0; i < n; i++)
        at->end[i] = i < nx ? at->z[i] : base[i] + step->h * f[i];
    cardan_leave(run, at->end);
    cardan_normalize(run, at->end);
    status = cardan_close(run, step->t_new, at->end, 0);
    if (status == 0)
        status = energy_at(run, step->t_new, at->end, &total, &kinetic);
    at->memory[SIZE] = fabs(kinetic) + fabs(total - kinetic) + fabs(at->memory[ENERGY]);
    at->memory[KINETIC] = fabs(kinetic);
    step->missing = total - at->memory[ENERGY] - (work_of(run, at->end) - at->memory[WORK]);
    step->lever = s != 0 ? step->speed / (at->memory[SCALE] * s) : 0;
    residual[nx] = s != 0 ? step->missing * step->lever * step->speed : at->z[nx];
    return status;
}

/* Energy and work at the start of a segment, which all its steps refer to. */
static int begin(cardan_run *run, const room *at)
{
    real total = 0, kinetic = 0;
    int status = energy_at(run, run->t, run->y, &total, &kinetic);

    at->memory[ENERGY] = total;
    for (ptrdiff_t i = 0; i < run->n; i++)
        at->end[i] = run->y[i] * (1 + BALANCED);
    if (status == 0)
        status = energy_at(run, run->t, at->end, &total, &at->memory[NOISE]);
    at->memory[NOISE] = fabs(total - at->memory[ENERGY]);
    at->memory[WORK] = work_of(run, run->y);
    at->memory[SCALE] = fmax(kinetic, 1e-3 * fabs(total));
    if (!(at->memory[SCALE] > 0))
        at->memory[SCALE] = 1;
    at->memory[INVERTED] = 0;
    return status;
}

/* One step from t, y; half of it, a quarter, ... where the equations have no solution near by. */
static int step(cardan_run *run)
{
    const room at = room_of(run);
    const real interval = cardan_grid(run) - run->t;
    problem step = {run->y, interval, run->t + interval, 0, 0, 0, 0};
    int status = cardan_refresh(run);

    run->culprit = -1;
    if (status == 0 && run->in_segment == 0)
        status = begin(run, &at);
    if (status != 0)
        return status;
    step.base = cardan_enter(run, run->y, run->f, run->k);
    for (int part = 1; part <= SHORTEST; part *= 2) {
        step.t_new = part == 1 ? cardan_grid(run) : run->t + interval / part;
        step.h = step.t_new - run->t;
        status = cardan_midpoint_solve(run, &at, &step, part == 1);
        if (status == 0) {
            for (ptrdiff_t i = 0; i < run->n; i++)
                run->trial[i] = at.end[i];
            status = cardan_commit(run, step.t_new, run->trial);
        }
        if (status == 0) {
            for (ptrdiff_t i = run->nq; i < run->nq + run->nu; i++)
                at.memory[FASTEST] = fmax(at.memory[FASTEST], fabs(run->y[i]));
            return 0;
        }
        run->rejections++;
    }
    return status;
}

/* Cubic through values and derivatives at both ends of the last step. */
static int dense(cardan_run *run)
{
    cardan_hermite(run, run->k, run->k + 2 * run->n);
    run->is_dense = 1;
    return 0;
}

const cardan_method cardan_midpoint_method
    = {init, step, dense, length, NULL, 3, 3, NULL, 0};
