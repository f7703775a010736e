/* Gradient of a cost along a motion: see adjoint.h.
 *
 * Part of cardan. Caller owns all memory.
 */
#include "adjoint.h"
#include <float.h>
#include <math.h>

/* memory of a sweep */
typedef struct scratch {
    real *states; /* (stages, nx) at which the stages were taken */
    real *slopes; /* (stages, nx) */
    real *pulled; /* (stages, nx) gradients by the states of the stages */
    real *end;    /* (nx) state before projections */
    real *place;  /* (nx) the same at the positions behind them */
    real *v;      /* weights of a product */
    real *out;    /* its result */
    real *work;
} scratch;

/* Longest vector of weights, and longest result of a product. */
static ptrdiff_t most_weights(const cardan_run *run)
{
    ptrdiff_t most = cardan_larger_of(run->nq + run->positions, run->nu + run->rates);

    return cardan_larger_of(most, run->nx + 1);
}

ptrdiff_t cardan_adjoint_length(const cardan_adjoint *adjoint, ptrdiff_t work)
{
    const cardan_run *run = adjoint->run;

    return (3 * adjoint->stages + 2) * run->nx + most_weights(run) + run->nx + run->ns
           + run->nr + adjoint->np + work;
}

static scratch scratch_of(const cardan_adjoint *adjoint)
{
    const cardan_run *run = adjoint->run;
    ptrdiff_t used = 0;
    scratch at;

    at.states = cardan_reserve(adjoint->memory, &used, adjoint->stages * run->nx);
    at.slopes = cardan_reserve(adjoint->memory, &used, adjoint->stages * run->nx);
    at.pulled = cardan_reserve(adjoint->memory, &used, adjoint->stages * run->nx);
    at.end = cardan_reserve(adjoint->memory, &used, run->nx);
    at.place = cardan_reserve(adjoint->memory, &used, run->nx);
    at.v = cardan_reserve(adjoint->memory, &used, most_weights(run));
    at.out = cardan_reserve(adjoint->memory, &used, run->nx + run->ns + run->nr + adjoint->np);
    at.work = cardan_reserve(adjoint->memory, &used, adjoint->work);
    return at;
}

/* Prepare inputs and discrete states for the step between two rows. */
static void enter(cardan_run *run, const real *row, const real *next)
{
    const real middle = 0.5 * (row[0] + next[0]);

    for (ptrdiff_t i = 0; i < run->nr; i++)
        run->r[i] = row[1 + run->n + i];
    for (ptrdiff_t i = 0; i < run->ns; i++)
        run->s[i] = row[1 + run->n + run->nr + i];
    for (ptrdiff_t i = 0; i < run->signal_count; i++) {
        cardan_signal *s = run->signals + i;
        while (s->where + 1 < s->pieces && s->breaks[s->where + 1] < middle)
            s->where++;
        while (s->where > 0 && s->breaks[s->where] > middle)
            s->where--;
    }
    /* what jumps at the ends of the step is seen from inside it */
    run->early = nextafter(row[0], next[0]);
    run->late = nextafter(next[0], row[0]);
}

/* Add gradients by inputs (nr) at t, times a factor, to those by constants and by pieces. */
static void add_inputs(const cardan_adjoint *adjoint, real t, real factor, const real *by_r)
{
    const cardan_run *run = adjoint->run;
    real *piece = adjoint->by_pieces;

    for (ptrdiff_t i = 0; i < run->nr; i++)
        adjoint->by_r[i] += factor * by_r[i];
    for (ptrdiff_t k = 0; k < run->signal_count; k++) {
        const cardan_signal *s = run->signals + k;
        const real d = t - s->breaks[s->where];
        real power = factor * by_r[s->input];
        for (int j = 0; j < 4; j++, power *= d)
            piece[4 * s->where + j] += power;
        piece += 4 * s->pieces;
    }
}

/* A product at t, x: weights in at->v; the result in at->out, of which discrete states, inputs
 * and parameters are added up, times a factor. */
static int product(const cardan_adjoint *adjoint, const scratch *at, const cardan_call *call, real t,
                   const real *x, real factor)
{
    cardan_run *run = adjoint->run;
    const real *by_s = at->out + run->nx, *by_r = by_s + run->ns, *by_p = by_r + run->nr;
    cardan_in in;
    int status;

    cardan_signals_at(run, t);
    in = cardan_at(run, &t, x);
    in.v = at->v;
    in.w = call->w;
    status = call->function(&in, at->out, at->work);
    if (status != 0)
        return CARDAN_MODEL;
    add_inputs(adjoint, t, factor, by_r);
    for (ptrdiff_t i = 0; i < run->ns; i++)
        adjoint->by_s[i] += factor * by_s[i];
    for (ptrdiff_t i = 0; i < adjoint->np; i++)
        adjoint->by_p[i] += factor * by_p[i];
    return 0;
}

/* A function of the model at t, x. */
static int value(const cardan_adjoint *adjoint, const scratch *at, const cardan_call *call, real t,
                 const real *x, real *out)
{
    cardan_in in;

    cardan_signals_at(adjoint->run, t);
    in = cardan_at(adjoint->run, &t, x);
    in.w = call->w;
    return call->function(&in, out, at->work) == 0 ? 0 : CARDAN_MODEL;
}

/* The stages of the step from a row, and its end before any projection. */
static int stages(const cardan_adjoint *adjoint, const scratch *at, const real *row, real h)
{
    const ptrdiff_t nx = adjoint->run->nx;
    const real *y = row + 1;

    for (ptrdiff_t s = 0; s < adjoint->stages; s++) {
        const real *a = adjoint->matrix + s * adjoint->stages;
        real *x = at->states + s * nx;
        int status;
        for (ptrdiff_t i = 0; i < nx; i++) {
            real sum = 0;
            for (ptrdiff_t j = 0; j < s; j++)
                sum += a[j] * at->slopes[j * nx + i];
            x[i] = y[i] + h * sum;
        }
        status = value(adjoint, at, &adjoint->run->rhs, row[0] + adjoint->nodes[s] * h, x,
                       at->slopes + s * nx);
        if (status != 0)
            return status;
    }
    for (ptrdiff_t i = 0; i < nx; i++) {
        real sum = 0;
        for (ptrdiff_t j = 0; j < adjoint->stages; j++)
            sum += adjoint->weights[j] * at->slopes[j * nx + i];
        at->end[i] = y[i] + h * sum;
    }
    return 0;
}

/* lam by the state before the projections of a step from that behind them: speeds first, at the
 * positions behind, then positions, then lengths of quaternions. */
static int pull_projection(const cardan_adjoint *adjoint, const scratch *at, const real *next)
{
    const cardan_run *run = adjoint->run;
    const ptrdiff_t nq = run->nq, nu = run->nu, nx = run->nx;
    real *lam = adjoint->lam, *x = at->place;
    int status = 0;

    if (adjoint->close_velocity.function) {
        for (ptrdiff_t i = 0; i < nx; i++)
            x[i] = i < nq ? next[1 + i] : at->end[i];
        for (ptrdiff_t i = 0; i < nu + run->rates; i++)
            at->v[i] = i < nu ? lam[nq + i] : 0;
        status = product(adjoint, at, &adjoint->close_velocity, next[0], x, 1);
        for (ptrdiff_t i = 0; i < nx && status == 0; i++)
            lam[i] = at->out[i] + (i < nq || i >= nq + nu ? lam[i] : 0);
    }
    if (adjoint->close_position.function && status == 0) {
        for (ptrdiff_t i = 0; i < nq + run->positions; i++)
            at->v[i] = i < nq ? lam[i] : 0;
        status = product(adjoint, at, &adjoint->close_position, next[0], at->end, 1);
        for (ptrdiff_t i = 0; i < nx && status == 0; i++)
            lam[i] = at->out[i] + (i < nq ? 0 : lam[i]);
    }
    for (ptrdiff_t k = 0; k < run->quaternion_count; k++) {
        const real *q = at->end + run->quaternions[k];
        real *by_q = lam + run->quaternions[k];
        const real square = cardan_dot(q, q, 4), along = cardan_dot(q, by_q, 4) / square;
        for (int j = 0; j < 4; j++)
            by_q[j] = (by_q[j] - along * q[j]) / sqrt(square);
    }
    return status;
}

/* lam by the start of a step from that by its end. */
static int pull_stages(const cardan_adjoint *adjoint, const scratch *at, real t, real h)
{
    const ptrdiff_t nx = adjoint->run->nx, count = adjoint->stages;
    real *lam = adjoint->lam;

    for (ptrdiff_t s = count - 1; s >= 0; s--) {
        const real *x = at->states + s * nx;
        const real time = t + adjoint->nodes[s] * h, share = h * adjoint->weights[s];
        real *by_x = at->pulled + s * nx, running;
        int status;
        for (ptrdiff_t i = 0; i < nx; i++) {
            real sum = adjoint->weights[s] * lam[i];
            for (ptrdiff_t j = s + 1; j < count; j++)
                sum += adjoint->matrix[j * count + s] * at->pulled[j * nx + i];
            at->v[i] = h * sum;
        }
        status = product(adjoint, at, &adjoint->rates, time, x, 1);
        for (ptrdiff_t i = 0; i < nx; i++)
            by_x[i] = at->out[i];
        if (adjoint->running.function && status == 0 && share != 0) {
            at->v[0] = 1;
            status = product(adjoint, at, &adjoint->running, time, x, share);
            for (ptrdiff_t i = 0; i < nx; i++)
                by_x[i] += share * at->out[i];
            if (status == 0)
                status = value(adjoint, at, &adjoint->running_cost, time, x, &running);
            if (status == 0)
                *adjoint->cost += share * running;
        }
        if (status != 0)
            return status;
    }
    for (ptrdiff_t s = 0; s < count; s++)
        for (ptrdiff_t i = 0; i < nx; i++)
            lam[i] += at->pulled[s * nx + i];
    return 0;
}

/* Sweep over all steps between the rows, the last one first. Returns 0 or CARDAN_MODEL. */
int cardan_adjoint_sweep(cardan_adjoint *adjoint)
{
    const ptrdiff_t width = cardan_row_width(adjoint->run);
    const scratch at = scratch_of(adjoint);

    adjoint->failed = -1;
    for (ptrdiff_t k = adjoint->count - 2; k >= 0; k--) {
        const real *row = adjoint->rows + k * width, *next = row + width, h = next[0] - row[0];
        int status;
        enter(adjoint->run, row, next);
        status = stages(adjoint, &at, row, h);
        if (status == 0)
            status = pull_projection(adjoint, &at, next);
        if (status == 0)
            status = pull_stages(adjoint, &at, row[0], h);
        if (status != 0) {
            adjoint->failed = k;
            return status;
        }
    }
    return 0;
}
