/* Sensitivities of a motion: see tangent.h.
 *
 * Part of cardan. Caller owns all memory.
 */
#include "tangent.h"
#include <math.h>

/* Change of inputs (nr) at t along a column, as far as signals and constants change them. */
static void inputs_of(const cardan_tangent *tangent, ptrdiff_t column, real t, real *change)
{
    const cardan_run *run = tangent->steps->run;
    const real *block = tangent->by_coefficients + column * tangent->segments * 4;

    for (ptrdiff_t i = 0; i < run->nr; i++)
        change[i] = tangent->by_input[column * run->nr + i];
    for (ptrdiff_t k = 0; k < run->signal_count; k++) {
        const cardan_signal *s = run->signals + k;
        const real *c = block + 4 * s->where, d = t - s->breaks[s->where];
        change[s->input] = ((c[3] * d + c[2]) * d + c[1]) * d + c[0];
        block += s->pieces * 4;
    }
}

/* First `taken` of the `rows` results of a function changed along a column: the derivative in `out`
 * times the change in `moved`. */
static void multiply(const cardan_tangent *tangent, ptrdiff_t column, ptrdiff_t rows,
                     ptrdiff_t taken, real *change)
{
    const cardan_run *run = tangent->steps->run;
    const ptrdiff_t sizes[5] = {run->nq, run->nu, run->nz, run->ns, run->nr};
    const real *by = tangent->out, *moved = tangent->moved;
    const real *named = tangent->by_named + column * tangent->named;

    for (ptrdiff_t i = 0; i < taken; i++)
        change[i] = 0;
    for (int block = 0; block < 5; block++) {
        for (ptrdiff_t i = 0; i < taken; i++)
            change[i] += cardan_dot(by + i * sizes[block], moved, sizes[block]);
        by += rows * sizes[block];
        moved += sizes[block];
    }
    /* most columns change one parameter at most */
    for (ptrdiff_t k = 0; k < tangent->named; k++, by += rows)
        for (ptrdiff_t i = 0; i < taken && named[k] != 0; i++)
            change[i] += named[k] * by[i];
}

/* The derivative of a function at t, x. */
static int derivative(const cardan_tangent *tangent, const cardan_call *call, real t, const real *x)
{
    cardan_in in = cardan_step_in(tangent->steps, &t, x);

    in.w = call->w;
    return call->function(&in, tangent->out, tangent->steps->work) == 0 ? 0 : CARDAN_MODEL;
}

/* Fill `moved` behind the change of the state, which is there. */
static void complete(const cardan_tangent *tangent, ptrdiff_t column, real t)
{
    const cardan_run *run = tangent->steps->run;
    real *next = tangent->moved + run->nx;

    for (ptrdiff_t i = 0; i < run->ns; i++)
        next[i] = tangent->by_s[column * run->ns + i];
    inputs_of(tangent, column, t, next + run->ns);
}

/* Slopes of the stages of an implicit method changed along a column, with the states of all stages
 * following. */
static void follow(const cardan_tangent *tangent, ptrdiff_t column)
{
    const cardan_steps *steps = tangent->steps;
    const ptrdiff_t nx = steps->run->nx, size = tangent->columns * nx;
    real *rising = tangent->rising + column * nx;

    for (ptrdiff_t s = 0; s < steps->stages; s++)
        for (ptrdiff_t i = 0; i < nx; i++)
            tangent->coupled[s * nx + i] = rising[s * size + i];
    cardan_stages_forward(steps, tangent->coupled);
    for (ptrdiff_t s = 0; s < steps->stages; s++)
        for (ptrdiff_t i = 0; i < nx; i++)
            rising[s * size + i] = tangent->coupled[s * nx + i];
}

/* Changes (columns, nx) at the end of a step, before projections. */
static int step(const cardan_tangent *tangent, real t, real h, const real *old, real *changes)
{
    const cardan_steps *steps = tangent->steps;
    const ptrdiff_t nx = steps->run->nx, size = tangent->columns * nx;

    for (ptrdiff_t s = 0; s < steps->stages; s++) {
        const real time = t + steps->nodes[s] * h, *a = steps->matrix + s * steps->stages;
        if (derivative(tangent, &tangent->rates, time, steps->states + s * nx) != 0)
            return CARDAN_MODEL;
        for (ptrdiff_t k = 0; k < tangent->columns; k++) {
            for (ptrdiff_t i = 0; i < nx; i++) {
                real sum = 0;
                for (ptrdiff_t j = 0; j < s && !steps->implicit; j++)
                    sum += a[j] * tangent->rising[j * size + k * nx + i];
                tangent->moved[i] = old[k * nx + i] + h * sum;
            }
            cardan_stage_lengths(steps, s, tangent->moved);
            complete(tangent, k, time);
            multiply(tangent, k, nx, nx, tangent->rising + s * size + k * nx);
        }
    }
    for (ptrdiff_t k = 0; k < tangent->columns && steps->implicit; k++)
        follow(tangent, k);
    for (ptrdiff_t i = 0; i < size; i++) {
        real sum = 0;
        for (ptrdiff_t s = 0; s < steps->stages; s++)
            sum += steps->weights[s] * tangent->rising[s * size + i];
        changes[i] = old[i] + h * sum;
    }
    return 0;
}

/* Changes behind a function that projects `size` entries of the state from `first` on. */
static int project(const cardan_tangent *tangent, const cardan_call *call, real t, const real *x,
                   ptrdiff_t first, ptrdiff_t size, ptrdiff_t rows, real *changes)
{
    const ptrdiff_t nx = tangent->steps->run->nx;

    if (derivative(tangent, call, t, x) != 0)
        return CARDAN_MODEL;
    for (ptrdiff_t k = 0; k < tangent->columns; k++) {
        for (ptrdiff_t i = 0; i < nx; i++)
            tangent->moved[i] = changes[k * nx + i];
        complete(tangent, k, t);
        multiply(tangent, k, size + rows, size, changes + k * nx + first);
    }
    return 0;
}

/* Changes of the state behind the projections of a step. */
static int projected(const cardan_tangent *tangent, real t, real *changes)
{
    const cardan_steps *steps = tangent->steps;
    const cardan_run *run = steps->run;

    for (ptrdiff_t k = 0; k < run->quaternion_count * tangent->columns; k++) {
        const ptrdiff_t at = run->quaternions[k % run->quaternion_count];
        const real *q = steps->end + at;
        cardan_unit_change(q, sqrt(cardan_dot(q, q, 4)),
                           changes + k / run->quaternion_count * run->nx + at);
    }
    if (tangent->close_position.function
        && project(tangent, &tangent->close_position, t, steps->end, 0, run->nq, run->positions,
                   changes) != 0)
        return CARDAN_MODEL;
    if (tangent->close_velocity.function
        && project(tangent, &tangent->close_velocity, t, steps->place, run->nq, run->nu,
                   run->rates, changes) != 0)
        return CARDAN_MODEL;
    return 0;
}

/* Sweep over all steps between the rows. Returns 0 or a status. */
int cardan_tangent_sweep(cardan_tangent *tangent)
{
    cardan_steps *steps = tangent->steps;
    const ptrdiff_t width = cardan_row_width(steps->run);
    const ptrdiff_t size = tangent->columns * steps->run->nx;

    steps->failed = -1;
    for (ptrdiff_t k = 0; k + 1 < steps->count; k++) {
        const real *row = steps->rows + k * width;
        real *changes = tangent->changes + k * size;
        int status = cardan_step_again(steps, k);
        if (status == 0)
            status = step(tangent, row[0], row[width] - row[0], changes, changes + size);
        if (status == 0)
            status = projected(tangent, row[width], changes + size);
        if (status != 0) {
            steps->failed = k;
            return status;
        }
    }
    return 0;
}
