/* Sensitivities of a motion: see tangent.h.
 *
 * Part of cardan. Caller owns all memory.
 */
#include "tangent.h"
#include <math.h>

enum { MOST_SWEEPS = 100 };

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

/* The same at t, x, with a derivative or by a function that gives the change along the column. */
static int change_along(const cardan_tangent *tangent, const cardan_call *call, real t, const real *x,
                        ptrdiff_t column, ptrdiff_t rows, ptrdiff_t taken, real *change)
{
    const cardan_run *run = tangent->steps->run;
    cardan_in in = cardan_step_in(tangent->steps, &t, x);
    real *named = tangent->moved + run->nx + run->ns + run->nr;

    if (!tangent->pushed) {
        multiply(tangent, column, rows, taken, change);
        return 0;
    }
    for (ptrdiff_t k = 0; k < tangent->named; k++)
        named[k] = tangent->by_named[column * tangent->named + k];
    in.v = tangent->moved;
    in.w = call->w;
    if (call->function(&in, tangent->out, tangent->steps->work) != 0)
        return CARDAN_MODEL;
    for (ptrdiff_t i = 0; i < taken; i++)
        change[i] = tangent->out[i];
    return 0;
}

/* The derivative of a function at t, x, where there is one for all columns. */
static int derivative(const cardan_tangent *tangent, const cardan_call *call, real t, const real *x)
{
    cardan_in in = cardan_step_in(tangent->steps, &t, x);

    if (tangent->pushed)
        return 0;
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

/* changes (columns, nx) = old + h sum of w times what slopes change by. */
static void rise(const cardan_tangent *tangent, const real *w, real h, const real *old, real *changes)
{
    const ptrdiff_t size = tangent->columns * tangent->steps->run->nx;

    for (ptrdiff_t i = 0; i < size; i++) {
        real sum = 0;
        for (ptrdiff_t s = 0; s < tangent->steps->stages; s++)
            sum += w[s] * tangent->rising[s * size + i];
        changes[i] = old[i] + h * sum;
    }
}

/* Slopes of the stages of an implicit method changed along a column, with the states of all stages
 * following. */
static int follow(const cardan_tangent *tangent, ptrdiff_t column)
{
    const cardan_steps *steps = tangent->steps;
    const ptrdiff_t nx = steps->run->nx, size = tangent->columns * nx;
    real *rising = tangent->rising + column * nx;
    int status;

    for (ptrdiff_t s = 0; s < steps->stages; s++)
        for (ptrdiff_t i = 0; i < nx; i++)
            tangent->coupled[s * nx + i] = rising[s * size + i];
    status = cardan_stages_forward(steps, tangent->coupled);
    for (ptrdiff_t s = 0; s < steps->stages; s++)
        for (ptrdiff_t i = 0; i < nx; i++)
            rising[s * size + i] = tangent->coupled[s * nx + i];
    return status;
}

/* Keep the Jacobian of the rates at a stage, which `out` has by blocks. */
static void store(const cardan_tangent *tangent, ptrdiff_t stage)
{
    const cardan_steps *steps = tangent->steps;
    const cardan_run *run = steps->run;
    const ptrdiff_t nx = run->nx, sizes[3] = {run->nq, run->nu, run->nz};
    const real *by = tangent->out;

    for (ptrdiff_t block = 0, first = 0; block < 3; first += sizes[block++])
        for (ptrdiff_t i = 0; i < nx; i++)
            for (ptrdiff_t j = 0; j < sizes[block]; j++)
                steps->jacobians[(stage * nx + i) * nx + first + j] = *by++;
    for (ptrdiff_t i = 0; i < nx; i++)
        cardan_stage_lengths(steps, stage, steps->jacobians + (stage * nx + i) * nx);
}

/* Changes (columns, nx) at the end of a step, before projections. */
static int step(const cardan_tangent *tangent, real t, real h, const real *old, real *changes)
{
    const cardan_steps *steps = tangent->steps;
    const ptrdiff_t nx = steps->run->nx, size = tangent->columns * nx;
    const int coupled = steps->kind == CARDAN_COUPLED;
    int status = 0;

    for (ptrdiff_t s = 0; s < steps->stages; s++) {
        const real time = t + steps->nodes[s] * h, *a = steps->matrix + s * steps->stages;
        if (derivative(tangent, &tangent->rates, time, steps->states + s * nx) != 0)
            return CARDAN_MODEL;
        if (coupled && steps->jacobians)
            store(tangent, s);
        for (ptrdiff_t k = 0; k < tangent->columns; k++) {
            for (ptrdiff_t i = 0; i < nx; i++) {
                real sum = 0;
                for (ptrdiff_t j = 0; j < s && !coupled; j++)
                    sum += a[j] * tangent->rising[j * size + k * nx + i];
                tangent->moved[i] = old[k * nx + i] + h * sum;
            }
            cardan_stage_lengths(steps, s, tangent->moved);
            complete(tangent, k, time);
            if (change_along(tangent, &tangent->rates, time, steps->states + s * nx, k, nx, nx,
                             tangent->rising + s * size + k * nx) != 0)
                return CARDAN_MODEL;
        }
    }
    for (ptrdiff_t k = 0; k < tangent->columns && coupled && status == 0; k++)
        status = follow(tangent, k);
    rise(tangent, steps->weights, h, old, changes);
    return status;
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
        if (change_along(tangent, call, t, x, k, size + rows, size, changes + k * nx + first) != 0)
            return CARDAN_MODEL;
    }
    return 0;
}

/* Changes behind the projections of the state `end`; `place`: it, with the positions behind. */
static int projected(const cardan_tangent *tangent, real t, const real *end, const real *place,
                     real *changes)
{
    const cardan_run *run = tangent->steps->run;

    for (ptrdiff_t k = 0; k < run->quaternion_count * tangent->columns; k++) {
        const ptrdiff_t at = run->quaternions[k % run->quaternion_count];
        const real *q = end + at;
        cardan_unit_change(q, sqrt(cardan_dot(q, q, 4)),
                           changes + k / run->quaternion_count * run->nx + at);
    }
    if (tangent->close_position.function
        && project(tangent, &tangent->close_position, t, end, 0, run->nq, run->positions,
                   changes) != 0)
        return CARDAN_MODEL;
    if (tangent->close_velocity.function
        && project(tangent, &tangent->close_velocity, t, place, run->nq, run->nu,
                   run->rates, changes) != 0)
        return CARDAN_MODEL;
    return 0;
}

/* One sweep over the stages of a pass; `change` and `size` receive those of what slopes change by. */
static int pass_sweep(const cardan_tangent *tangent, real t, real h, const real *old, real *change,
                      real *size)
{
    const cardan_steps *steps = tangent->steps;
    const ptrdiff_t nx = steps->run->nx, nq = steps->run->nq, count = tangent->columns * nx;

    *change = *size = 0;
    for (ptrdiff_t s = 0; s < steps->stages; s++) {
        const real *x = steps->states + s * nx, *open = steps->open + s * nx;
        const real time = t + steps->nodes[s] * h;
        real *rising = tangent->rising + s * count;
        rise(tangent, steps->matrix + s * steps->stages, h, old, tangent->coupled);
        /* as in the run: positions first, then speeds at these */
        for (ptrdiff_t i = 0; i < nx; i++)
            steps->place[i] = i < nq ? x[i] : open[i];
        if (projected(tangent, time, open, steps->place, tangent->coupled) != 0
            || derivative(tangent, &tangent->rates, time, x) != 0)
            return CARDAN_MODEL;
        for (ptrdiff_t k = 0; k < tangent->columns; k++) {
            for (ptrdiff_t i = 0; i < nx; i++)
                tangent->moved[i] = tangent->coupled[k * nx + i];
            complete(tangent, k, time);
            if (change_along(tangent, &tangent->rates, time, x, k, nx, nx, steps->end) != 0)
                return CARDAN_MODEL;
            for (ptrdiff_t i = 0; i < nx; i++) {
                real *by = rising + k * nx + i;
                *change = fmax(*change, fabs(h * (steps->end[i] - *by)));
                *size = fmax(*size, fmax(fabs(h * steps->end[i]), fabs(old[k * nx + i])));
                *by = steps->end[i];
            }
        }
    }
    return 0;
}

/* Changes at all rows of a pass; `changes`: at its first one. */
static int pass_over(const cardan_tangent *tangent, const cardan_pass *pass, real t, real h,
                     real *changes)
{
    const ptrdiff_t count = tangent->columns * tangent->steps->run->nx;
    real change, size, last = INFINITY, w[CARDAN_MOST_STAGES];

    for (ptrdiff_t i = 0; i < tangent->steps->stages * count; i++)
        tangent->rising[i] = 0;
    for (int n = 0; n < MOST_SWEEPS; n++) {
        if (pass_sweep(tangent, t, h, changes, &change, &size) != 0)
            return CARDAN_MODEL;
        if (!cardan_swept_enough(change, size, &last))
            continue;
        for (ptrdiff_t row = pass->from + 1; row <= pass->to; row++) {
            cardan_pass_part(pass, row, w);
            rise(tangent, w, h, changes, changes + (row - pass->from) * count);
        }
        return 0;
    }
    return CARDAN_CONSTRAINT_OPEN;
}

/* Changes behind the step from row *k, or at all rows of the pass that begins there; then *k is the
 * row before its last one. */
static int push_step(const cardan_tangent *tangent, ptrdiff_t *k)
{
    cardan_steps *steps = tangent->steps;
    const ptrdiff_t width = cardan_row_width(steps->run), pass = cardan_pass_of(steps, *k);
    const ptrdiff_t size = tangent->columns * steps->run->nx;
    const real t = steps->rows[*k * width];
    real *changes = tangent->changes + *k * size, end;
    cardan_tangent over = *tangent;
    cardan_pass again;
    int status = pass < 0 ? cardan_step_again(steps, *k) : cardan_pass_again(steps, pass, *k, &again);

    if (status != 0)
        return status;
    if (pass >= 0 && again.from != *k)
        return CARDAN_CONSTRAINT_OPEN;
    if (pass >= 0) {
        over.steps = &again.steps;
        *k = again.to - 1;
    }
    end = steps->rows[(*k + 1) * width];
    status = pass < 0 ? step(tangent, t, end - t, changes, changes + size)
                      : pass_over(&over, &again, t, end - t, changes);
    /* sweeps have used what the end was */
    if (status == 0 && pass >= 0)
        cardan_end_step(&again.steps, steps->rows + again.from * width + 1, end - t,
                        steps->rows + again.to * width + 1);
    return status != 0 ? status : projected(tangent, end, steps->end, steps->place,
                                            tangent->changes + (*k + 1) * size);
}

/* Sweep over all steps between the rows. Returns 0 or a status. */
int cardan_tangent_sweep(cardan_tangent *tangent)
{
    cardan_steps *steps = tangent->steps;

    steps->failed = -1;
    /* a pass takes several rows at once */
    for (ptrdiff_t k = 0; k + 1 < steps->count; k++) {
        const ptrdiff_t first = k;
        const int status = push_step(tangent, &k);
        if (status != 0) {
            steps->failed = first;
            return status;
        }
    }
    return 0;
}
