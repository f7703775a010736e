/* Sensitivities of a motion: see tangent.h.
 *
 * Part of cardan. Caller owns all memory.
 */
#include "side_by_side.h"
#include "tangent.h"
#include <math.h>
#include <string.h>

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

/* Fill `moved` behind the changes of the state, which are there. */
static void complete(const cardan_tangent *tangent, real t)
{
    const cardan_run *run = tangent->steps->run;
    const ptrdiff_t wide = tangent->wide;
    real *next = tangent->moved + run->nx * wide;

    for (ptrdiff_t k = 0; k < tangent->columns && run->ns + run->nr; k++) {
        for (ptrdiff_t i = 0; i < run->ns; i++)
            next[i * wide + k] = tangent->by_s[k * run->ns + i];
        inputs_of(tangent, k, t, tangent->along);
        for (ptrdiff_t i = 0; i < run->nr; i++)
            next[(run->ns + i) * wide + k] = tangent->along[i];
    }
}

/* First `taken` of the `rows` results of a function changed: its derivative in `out` times `moved`. */
static void multiply(const cardan_tangent *tangent, ptrdiff_t rows, ptrdiff_t taken)
{
    const cardan_run *run = tangent->steps->run;
    const ptrdiff_t sizes[5] = {run->nq, run->nu, run->nz, run->ns, run->nr}, wide = tangent->wide;
    const real *by = tangent->out, *moved = tangent->moved;
    real *changed = tangent->changed;

    memset(changed, 0, (size_t)(taken * wide) * sizeof(real));
    for (int block = 0; block < 5; block++) {
        add_product(wide, taken, sizes[block], by, moved, changed);
        by += rows * sizes[block];
        moved += sizes[block] * wide;
    }
    for (ptrdiff_t k = 0, n = 0; k < tangent->named; k++, by += rows)
        for (; n < tangent->named_ends[k]; n++)
            for (ptrdiff_t i = 0; i < taken; i++)
                changed[i * wide + tangent->named_columns[n]] += tangent->named_changes[n] * by[i];
}

/* A column of a table (size, wide) into `along`. */
static void take(const cardan_tangent *tangent, ptrdiff_t column, const real *table, ptrdiff_t size)
{
    for (ptrdiff_t i = 0; i < size; i++)
        tangent->along[i] = table[i * tangent->wide + column];
}

/* Changes by a function that gives them along one column, at a stage; of passes and projections 0. */
static int push(const cardan_tangent *tangent, const cardan_call *call, cardan_in in, ptrdiff_t stage,
                ptrdiff_t taken)
{
    const cardan_steps *steps = tangent->steps;
    const cardan_repeated *repeated = steps->repeated;
    real *room = repeated ? steps->factored + stage * steps->factored_length : NULL;
    const cardan_run *run = tangent->steps->run;
    const ptrdiff_t size = run->nx + run->ns + run->nr, wide = tangent->wide;
    real *along = tangent->along;

    in.v = along;
    if (repeated && repeated->enter(&in, room) != 0)
        return CARDAN_MODEL;
    for (ptrdiff_t column = 0; column < tangent->columns; column++) {
        take(tangent, column, tangent->moved, size);
        for (ptrdiff_t k = 0, n = 0; k < tangent->named; k++)
            for (along[size + k] = 0; n < tangent->named_ends[k]; n++)
                if (tangent->named_columns[n] == column)
                    along[size + k] = tangent->named_changes[n];
        if ((repeated ? repeated->push(room, along, tangent->out)
                      : call->function(&in, tangent->out, steps->work))
            != 0)
            return CARDAN_MODEL;
        for (ptrdiff_t i = 0; i < taken; i++)
            tangent->changed[i * wide + column] = tangent->out[i];
    }
    return 0;
}

/* Changes (taken, wide) of the first of the `rows` results of a function at t, x, in `changed`. */
static int change(const cardan_tangent *tangent, const cardan_call *call, real t, const real *x, ptrdiff_t stage,
                  ptrdiff_t rows, ptrdiff_t taken)
{
    cardan_in in = cardan_step_in(tangent->steps, &t, x);

    in.w = call->w;
    if (tangent->pushed)
        return push(tangent, call, in, stage, taken);
    if (call->function(&in, tangent->out, tangent->steps->work) != 0)
        return CARDAN_MODEL;
    multiply(tangent, rows, taken);
    return 0;
}

/* changes (columns, nx) = old + h sum of w times what slopes change by. */
static void rise(const cardan_tangent *tangent, const real *w, real h, const real *old, real *changes)
{
    const ptrdiff_t nx = tangent->steps->run->nx, wide = tangent->wide;

    for (ptrdiff_t i = 0; i < nx; i++)
        for (ptrdiff_t k = 0; k < wide; k += CARDAN_SIDE_BY_SIDE) {
            side_by_side sum = {0};
            for (ptrdiff_t s = 0; s < tangent->steps->stages; s++)
                sum += w[s] * OF(tangent->rising + (s * nx + i) * wide + k);
            for (ptrdiff_t j = 0; j < CARDAN_SIDE_BY_SIDE && k + j < tangent->columns; j++)
                changes[(k + j) * nx + i] = old[(k + j) * nx + i] + h * sum[j];
        }
}

/* Of which step the Jacobians of stages are multiplied with. */
typedef struct stage_times {
    const cardan_tangent *tangent;
    real t, h;
} stage_times;

/* Products with the Jacobians of the rates at the stages: stored ones, or changes along x. */
static int times_stages(const void *context, const real *x, real *out)
{
    const stage_times *of = context;
    const cardan_tangent *tangent = of->tangent;
    const cardan_steps *steps = tangent->steps;
    const ptrdiff_t nx = steps->run->nx, behind = steps->run->ns + steps->run->nr + tangent->named;

    if (!tangent->pushed) {
        for (ptrdiff_t i = 0; i < steps->stages * nx; i++)
            out[i] = cardan_dot(steps->jacobians + i * nx, x + i / nx * nx, nx);
        return 0;
    }
    memset(tangent->along + nx, 0, (size_t)behind * sizeof(real));
    for (ptrdiff_t s = 0; s < steps->stages; s++) {
        const real t = of->t + steps->nodes[s] * of->h;
        cardan_in in = cardan_step_in(steps, &t, steps->states + s * nx);
        memcpy(tangent->along, x + s * nx, (size_t)nx * sizeof(real));
        cardan_stage_lengths(steps, s, tangent->along);
        in.v = tangent->along;
        in.w = tangent->rates.w;
        /* the room is that of the change with the states of stages as they are */
        if ((steps->repeated
                 ? steps->repeated->push(steps->factored + s * steps->factored_length, in.v, tangent->out)
                 : tangent->rates.function(&in, tangent->out, steps->work))
            != 0)
            return CARDAN_MODEL;
        memcpy(out + s * nx, tangent->out, (size_t)nx * sizeof(real));
    }
    return 0;
}

/* Slopes of coupled stages changed along a column, with the states of all stages following. */
static int follow(const cardan_tangent *tangent, ptrdiff_t column, real t, real h)
{
    const cardan_steps *steps = tangent->steps;
    const ptrdiff_t size = steps->stages * steps->run->nx;
    const stage_times stages = {tangent, t, h};
    real *rising = tangent->rising + column;

    for (ptrdiff_t i = 0; i < size; i++)
        tangent->coupled[i] = rising[i * tangent->wide];
    const int status = cardan_stages_forward(steps, tangent->coupled, times_stages, &stages);
    for (ptrdiff_t i = 0; i < size; i++)
        rising[i * tangent->wide] = tangent->coupled[i];
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

/* The state's part of `moved` at a stage. */
static void move(const cardan_tangent *tangent, ptrdiff_t stage, real h)
{
    const cardan_steps *steps = tangent->steps;
    const ptrdiff_t nx = steps->run->nx, size = nx * tangent->wide;
    const real *a = steps->matrix + stage * steps->stages;

    for (ptrdiff_t i = 0; i < size; i += CARDAN_SIDE_BY_SIDE) {
        side_by_side sum = {0};
        for (ptrdiff_t j = 0; j < stage && steps->kind == CARDAN_EXPLICIT; j++)
            sum += a[j] * OF(tangent->rising + j * size + i);
        AT(tangent->moved + i) = OF(tangent->before + i) + h * sum;
    }
    for (ptrdiff_t k = 0; k < tangent->columns && steps->kind == CARDAN_COUPLED; k++) {
        take(tangent, k, tangent->moved, nx);
        cardan_stage_lengths(steps, stage, tangent->along);
        for (ptrdiff_t i = 0; i < nx; i++)
            tangent->moved[i * tangent->wide + k] = tangent->along[i];
    }
}

/* A table (nx, wide) from changes (columns, nx). */
static void stand(const cardan_tangent *tangent, const real *changes, real *table)
{
    const ptrdiff_t nx = tangent->steps->run->nx;

    for (ptrdiff_t k = 0; k < tangent->columns; k++)
        for (ptrdiff_t i = 0; i < nx; i++)
            table[i * tangent->wide + k] = changes[k * nx + i];
}

/* Changes (columns, nx) at the end of a step, before projections. */
static int step(const cardan_tangent *tangent, real t, real h, const real *old, real *changes)
{
    const cardan_steps *steps = tangent->steps;
    const ptrdiff_t nx = steps->run->nx, size = tangent->wide * nx;
    const int coupled = steps->kind == CARDAN_COUPLED;
    int status = 0;

    stand(tangent, old, tangent->before);
    for (ptrdiff_t s = 0; s < steps->stages; s++) {
        const real time = t + steps->nodes[s] * h;
        move(tangent, s, h);
        complete(tangent, time);
        if (change(tangent, &tangent->rates, time, steps->states + s * nx, s, nx, nx) != 0)
            return CARDAN_MODEL;
        if (coupled && steps->jacobians)
            store(tangent, s);
        memcpy(tangent->rising + s * size, tangent->changed, (size_t)size * sizeof(real));
    }
    for (ptrdiff_t k = 0; k < tangent->columns && coupled && status == 0; k++)
        status = follow(tangent, k, t, h);
    rise(tangent, steps->weights, h, old, changes);
    return status;
}

/* Changes behind a function that projects `size` entries of the state from `first` on. */
static int project(const cardan_tangent *tangent, const cardan_call *call, real t, const real *x,
                   ptrdiff_t first, ptrdiff_t size, ptrdiff_t rows, real *changes)
{
    const ptrdiff_t nx = tangent->steps->run->nx;

    stand(tangent, changes, tangent->moved);
    complete(tangent, t);
    if (change(tangent, call, t, x, 0, size + rows, size) != 0)
        return CARDAN_MODEL;
    for (ptrdiff_t k = 0; k < tangent->columns; k++)
        for (ptrdiff_t i = 0; i < size; i++)
            changes[k * nx + first + i] = tangent->changed[i * tangent->wide + k];
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
        && project(tangent, &tangent->close_position, t, end, 0, run->nq, run->positions, changes) != 0)
        return CARDAN_MODEL;
    if (tangent->close_velocity.function
        && project(tangent, &tangent->close_velocity, t, place, run->nq, run->nu, run->rates, changes) != 0)
        return CARDAN_MODEL;
    return 0;
}

/* One sweep over the stages of a pass; `by` and `size` receive the changes of what slopes change by. */
static int pass_sweep(const cardan_tangent *tangent, real t, real h, const real *old, real *by, real *size)
{
    const cardan_steps *steps = tangent->steps;
    const ptrdiff_t nx = steps->run->nx, nq = steps->run->nq, wide = tangent->wide;

    *by = *size = 0;
    for (ptrdiff_t s = 0; s < steps->stages; s++) {
        const real *x = steps->states + s * nx, *open = steps->open + s * nx;
        const real time = t + steps->nodes[s] * h;
        real *rising = tangent->rising + s * nx * wide;
        rise(tangent, steps->matrix + s * steps->stages, h, old, tangent->coupled);
        /* as in the run: positions first, then speeds at these */
        for (ptrdiff_t i = 0; i < nx; i++)
            steps->place[i] = i < nq ? x[i] : open[i];
        if (projected(tangent, time, open, steps->place, tangent->coupled) != 0)
            return CARDAN_MODEL;
        stand(tangent, tangent->coupled, tangent->moved);
        complete(tangent, time);
        if (change(tangent, &tangent->rates, time, x, 0, nx, nx) != 0)
            return CARDAN_MODEL;
        for (ptrdiff_t i = 0; i < nx; i++)
            for (ptrdiff_t k = 0; k < tangent->columns; k++) {
                const real now = tangent->changed[i * wide + k];
                *by = cardan_worst(*by, fabs(h * (now - rising[i * wide + k])));
                *size = fmax(*size, fmax(fabs(h * now), fabs(old[k * nx + i])));
                rising[i * wide + k] = now;
            }
    }
    return 0;
}

/* Changes at all rows of a pass; `changes`: at its first one. */
static int pass_over(const cardan_tangent *tangent, const cardan_pass *pass, real t, real h,
                     real *changes)
{
    const ptrdiff_t nx = tangent->steps->run->nx, count = tangent->columns * nx;
    real by, size, last = INFINITY, w[CARDAN_MOST_STAGES];

    memset(tangent->rising, 0, (size_t)(tangent->steps->stages * nx * tangent->wide) * sizeof(real));
    for (int n = 0; n < MOST_SWEEPS; n++) {
        if (pass_sweep(tangent, t, h, changes, &by, &size) != 0)
            return CARDAN_MODEL;
        if (!cardan_swept_enough(by, size, &last))
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

    if (status == 0 && pass >= 0 && again.from != *k)
        status = CARDAN_CONSTRAINT_OPEN;
    if (status != 0)
        return status;
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
