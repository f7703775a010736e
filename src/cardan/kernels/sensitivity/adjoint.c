/* Gradient of a cost along a motion: see adjoint.h.
 *
 * Part of cardan. Caller owns all memory.
 */
#include "adjoint.h"
#include <math.h>

enum { MOST_SWEEPS = 100 };

/* Add gradients by inputs (nr) at t, times a factor, to those by constants and by pieces. */
static void add_inputs(const cardan_adjoint *adjoint, real t, real factor, const real *by_r)
{
    const cardan_run *run = adjoint->steps->run;
    real *block = adjoint->by_coefficients;

    for (ptrdiff_t i = 0; i < run->nr; i++)
        adjoint->by_r[i] += factor * by_r[i];
    for (ptrdiff_t k = 0; k < run->signal_count; k++) {
        const cardan_signal *s = run->signals + k;
        const real d = t - s->breaks[s->where];
        real power = factor * by_r[s->input];
        for (int j = 0; j < 4; j++, power *= d)
            block[4 * s->where + j] += power;
        block += s->pieces * 4;
    }
}

/* Add up discrete states, inputs and parameters of the product in `out`, times a factor. */
static void add_up(const cardan_adjoint *adjoint, real t, real factor)
{
    const cardan_run *run = adjoint->steps->run;
    const real *by_s = adjoint->out + run->nx, *by_r = by_s + run->ns, *by_p = by_r + run->nr;

    add_inputs(adjoint, t, factor, by_r);
    for (ptrdiff_t i = 0; i < run->ns; i++)
        adjoint->by_s[i] += factor * by_s[i];
    for (ptrdiff_t i = 0; i < adjoint->np; i++)
        adjoint->by_p[i] += factor * by_p[i];
}

/* A product at t, x: weights in `v`; the result in `out`, which is added up. */
static int product(const cardan_adjoint *adjoint, const cardan_call *call, real t, const real *x,
                   real factor)
{
    cardan_in in = cardan_step_in(adjoint->steps, &t, x);

    in.v = adjoint->v;
    in.w = call->w;
    if (call->function(&in, adjoint->out, adjoint->steps->work) != 0)
        return CARDAN_MODEL;
    add_up(adjoint, t, factor);
    return 0;
}

/* The same with the rates at a stage. */
static int stage_product(const cardan_adjoint *adjoint, ptrdiff_t s, real t, real factor)
{
    const cardan_steps *steps = adjoint->steps;
    real *room = steps->factored + s * steps->factored_length;

    if (!steps->repeated || steps->kind != CARDAN_COUPLED)
        return product(adjoint, &adjoint->rates, t, steps->states + s * steps->run->nx, factor);
    if (steps->repeated->pull(room, adjoint->v, adjoint->out) != 0)
        return CARDAN_MODEL;
    /* where inputs are at that time */
    cardan_signals_at(steps->run, t);
    add_up(adjoint, t, factor);
    return 0;
}

/* Factor what products with the rates at the stages need, which come many times. */
static int enter_stages(const cardan_adjoint *adjoint, real t, real h)
{
    const cardan_steps *steps = adjoint->steps;

    for (ptrdiff_t s = 0; s < steps->stages && steps->repeated; s++) {
        const real time = t + steps->nodes[s] * h;
        cardan_in in = cardan_step_in(steps, &time, steps->states + s * steps->run->nx);
        in.w = adjoint->rates.w;
        if (steps->repeated->enter(&in, steps->factored + s * steps->factored_length) != 0)
            return CARDAN_MODEL;
    }
    return 0;
}

/* The running cost at t, x counts with a share, and so does its gradient by x, added to by_x. */
static int add_cost(const cardan_adjoint *adjoint, real t, const real *x, real share, real *by_x)
{
    cardan_in in = cardan_step_in(adjoint->steps, &t, x);
    real cost;

    in.w = adjoint->integrand_value.w;
    if (adjoint->integrand_value.function(&in, &cost, adjoint->steps->work) != 0)
        return CARDAN_MODEL;
    *adjoint->cost += share * cost;
    adjoint->v[0] = 1;
    if (product(adjoint, &adjoint->integrand, t, x, share) != 0)
        return CARDAN_MODEL;
    for (ptrdiff_t i = 0; i < adjoint->steps->run->nx; i++)
        by_x[i] += share * adjoint->out[i];
    return 0;
}

/* lam by the state `end` before the projections from that behind them: speeds first, at `place`
 * with the positions behind, then positions, then lengths of quaternions. */
int cardan_pull_projection(const cardan_adjoint *adjoint, real t, const real *end, const real *place,
                           real factor, real *lam)
{
    const cardan_run *run = adjoint->steps->run;
    const ptrdiff_t nq = run->nq, nu = run->nu, nx = run->nx;
    const real *out = adjoint->out;
    real *v = adjoint->v;

    if (adjoint->close_velocity.function) {
        for (ptrdiff_t i = 0; i < nu + run->rates; i++)
            v[i] = i < nu ? lam[nq + i] : 0;
        if (product(adjoint, &adjoint->close_velocity, t, place, factor) != 0)
            return CARDAN_MODEL;
        for (ptrdiff_t i = 0; i < nx; i++)
            lam[i] = out[i] + (i < nq || i >= nq + nu ? lam[i] : 0);
    }
    if (adjoint->close_position.function) {
        for (ptrdiff_t i = 0; i < nq + run->positions; i++)
            v[i] = i < nq ? lam[i] : 0;
        if (product(adjoint, &adjoint->close_position, t, end, factor) != 0)
            return CARDAN_MODEL;
        for (ptrdiff_t i = 0; i < nx; i++)
            lam[i] = out[i] + (i < nq ? 0 : lam[i]);
    }
    for (ptrdiff_t k = 0; k < run->quaternion_count; k++) {
        const real *q = end + run->quaternions[k];
        cardan_unit_change(q, sqrt(cardan_dot(q, q, 4)), lam + run->quaternions[k]);
    }
    return 0;
}

/* Gradients by the states of the stages: at first those of the running cost alone. */
static int begin(const cardan_adjoint *adjoint, real t, real h)
{
    const cardan_steps *steps = adjoint->steps;
    const ptrdiff_t nx = steps->run->nx;

    for (ptrdiff_t s = 0; s < steps->stages; s++) {
        const real share = h * steps->weights[s];
        real *by_x = adjoint->pulled + s * nx;
        for (ptrdiff_t i = 0; i < nx; i++)
            by_x[i] = 0;
        if (adjoint->integrand.function && share != 0
            && add_cost(adjoint, t + steps->nodes[s] * h, steps->states + s * nx, share, by_x) != 0)
            return CARDAN_MODEL;
        cardan_stage_lengths(steps, s, by_x);
    }
    return 0;
}

/* Gradient (nx) by the slope of a stage from those by the end and by the states of stages. */
static void by_slope(const cardan_adjoint *adjoint, ptrdiff_t s, real h, real *weights)
{
    const cardan_steps *steps = adjoint->steps;
    const ptrdiff_t nx = steps->run->nx, count = steps->stages;

    for (ptrdiff_t i = 0; i < nx; i++) {
        real sum = steps->weights[s] * adjoint->lam[i];
        for (ptrdiff_t j = steps->kind == CARDAN_EXPLICIT ? s + 1 : 0; j < count; j++)
            sum += steps->matrix[j * count + s] * adjoint->pulled[j * nx + i];
        weights[i] = h * sum;
    }
}

/* Of which step the Jacobians of stages are multiplied with. */
typedef struct stage_times {
    const cardan_adjoint *adjoint;
    real t, h;
} stage_times;

/* Weights (stages, nx) times the Jacobians of the rates at the stages. */
static int times_stages(const void *context, const real *weights, real *out)
{
    const stage_times *of = context;
    const cardan_adjoint *adjoint = of->adjoint;
    const cardan_steps *steps = adjoint->steps;
    const ptrdiff_t nx = steps->run->nx;

    for (ptrdiff_t s = 0; s < steps->stages; s++) {
        real *by_x = out + s * nx;
        for (ptrdiff_t i = 0; i < nx; i++)
            adjoint->v[i] = weights[s * nx + i];
        if (stage_product(adjoint, s, of->t + steps->nodes[s] * of->h, 0) != 0)
            return CARDAN_MODEL;
        for (ptrdiff_t i = 0; i < nx; i++)
            by_x[i] = adjoint->out[i];
        cardan_stage_lengths(steps, s, by_x);
    }
    return 0;
}

/* lam by the start of a step from that by its end. */
static int pull_stages(const cardan_adjoint *adjoint, real t, real h)
{
    const cardan_steps *steps = adjoint->steps;
    const ptrdiff_t nx = steps->run->nx, count = steps->stages;
    const int coupled = steps->kind == CARDAN_COUPLED;
    const stage_times stages = {adjoint, t, h};
    real *lam = adjoint->lam;
    int status;

    if (begin(adjoint, t, h) != 0)
        return CARDAN_MODEL;
    /* slopes of an implicit method depend on each other: all of them at once */
    for (ptrdiff_t s = 0; s < count && coupled; s++)
        by_slope(adjoint, s, h, adjoint->weights + s * nx);
    status = coupled ? enter_stages(adjoint, t, h) : 0;
    if (status == 0 && coupled)
        status = steps->coupled->backward(steps, adjoint->weights, times_stages, &stages);
    if (status != 0)
        return status;
    for (ptrdiff_t s = count - 1; s >= 0; s--) {
        if (!coupled)
            by_slope(adjoint, s, h, adjoint->v);
        for (ptrdiff_t i = 0; i < nx && coupled; i++)
            adjoint->v[i] = adjoint->weights[s * nx + i];
        if (stage_product(adjoint, s, t + steps->nodes[s] * h, 1) != 0)
            return CARDAN_MODEL;
        /* the state was scaled before the rates were asked at it */
        cardan_stage_lengths(steps, s, adjoint->out);
        for (ptrdiff_t i = 0; i < nx; i++)
            adjoint->pulled[s * nx + i] += adjoint->out[i];
    }
    for (ptrdiff_t s = 0; s < count; s++)
        for (ptrdiff_t i = 0; i < nx; i++)
            lam[i] += adjoint->pulled[s * nx + i];
    return 0;
}

/* One sweep over the stages of a pass, from h lam by its end. `factor`: what derivatives by parameters,
 * inputs and discrete states are added with; `change` and `size`: of the gradients by stages. */
static int pass_sweep(const cardan_adjoint *adjoint, real t, real h, real factor, real *change,
                      real *size)
{
    const cardan_steps *steps = adjoint->steps;
    const ptrdiff_t nx = steps->run->nx, nq = steps->run->nq;
    real *by_x = steps->end, *place = steps->place;

    *change = *size = 0;
    for (ptrdiff_t s = steps->stages - 1; s >= 0; s--) {
        const real *x = steps->states + s * nx, *open = steps->open + s * nx;
        const real time = t + steps->nodes[s] * h;
        by_slope(adjoint, s, h, adjoint->v);
        if (product(adjoint, &adjoint->rates, time, x, factor) != 0)
            return CARDAN_MODEL;
        for (ptrdiff_t i = 0; i < nx; i++) {
            by_x[i] = adjoint->out[i] + adjoint->weights[s * nx + i];
            place[i] = i < nq ? x[i] : open[i];
        }
        if (cardan_pull_projection(adjoint, time, open, place, factor, by_x) != 0)
            return CARDAN_MODEL;
        for (ptrdiff_t i = 0; i < nx; i++) {
            real *by = adjoint->pulled + s * nx + i;
            *change = cardan_worst(*change, fabs(by_x[i] - *by));
            *size = fmax(*size, fmax(fabs(by_x[i]), fabs(adjoint->lam[i])));
            *by = by_x[i];
        }
    }
    return 0;
}

/* lam by the start of a pass from that by its end: stages are swept until nothing changes. */
static int pull_pass(const cardan_adjoint *adjoint, real t, real h)
{
    const cardan_steps *steps = adjoint->steps;
    const ptrdiff_t nx = steps->run->nx, size = steps->stages * nx;
    real change, largest, last = INFINITY;

    /* what the running cost adds, at the projected states */
    if (begin(adjoint, t, h) != 0)
        return CARDAN_MODEL;
    for (ptrdiff_t i = 0; i < size; i++) {
        adjoint->weights[i] = adjoint->pulled[i];
        adjoint->pulled[i] = 0;
    }
    for (int n = 0; n < MOST_SWEEPS; n++) {
        if (pass_sweep(adjoint, t, h, 0, &change, &largest) != 0)
            return CARDAN_MODEL;
        if (cardan_swept_enough(change, largest, &last)) {
            if (pass_sweep(adjoint, t, h, 1, &change, &largest) != 0)
                return CARDAN_MODEL;
            for (ptrdiff_t i = 0; i < size; i++)
                adjoint->lam[i % nx] += adjoint->pulled[i];
            return 0;
        }
    }
    return CARDAN_CONSTRAINT_OPEN;
}

/* lam by the start of the step from row *k, or of the pass that ends behind it; then *k is its first. */
static int pull_step(const cardan_adjoint *adjoint, ptrdiff_t *k)
{
    cardan_steps *steps = adjoint->steps;
    const ptrdiff_t width = cardan_row_width(steps->run), pass = cardan_pass_of(steps, *k);
    const real end = steps->rows[(*k + 1) * width];
    cardan_adjoint over = *adjoint;
    cardan_pass again;
    real t;
    int status;

    if (pass < 0)
        status = cardan_step_again(steps, *k);
    else {
        status = cardan_pass_again(steps, pass, *k, &again);
        over.steps = &again.steps;
        /* a sweep begins where rows do: behind a pass, not within it */
        if (status == 0 && again.to != *k + 1)
            status = CARDAN_CONSTRAINT_OPEN;
        if (status == 0)
            *k = again.from;
    }
    if (status == 0)
        status = cardan_pull_projection(&over, end, steps->end, steps->place, 1, adjoint->lam);
    if (status != 0)
        return status;
    t = steps->rows[*k * width];
    return pass < 0 ? pull_stages(&over, t, end - t) : pull_pass(&over, t, end - t);
}

/* Sweep over all steps between the rows, the last one first. Returns 0 or a status. */
int cardan_adjoint_sweep(cardan_adjoint *adjoint)
{
    cardan_steps *steps = adjoint->steps;

    steps->failed = -1;
    for (ptrdiff_t k = steps->count - 2; k >= 0; k--) {
        const int status = pull_step(adjoint, &k);
        if (status != 0) {
            steps->failed = k > 0 ? k : 0;
            return status;
        }
    }
    return 0;
}
