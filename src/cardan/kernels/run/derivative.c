/* Derivative of y = [x, e] along a run, and the inputs that it needs.
 *
 * Part of cardan. Caller owns all memory.
 */
#include "run.h"
#include <float.h>
#include <math.h>

/* of speeds on the constraints, times the square of the hold */
static const real ROUNDING = CARDAN_ROUNDING(1e-14, 5e-6);
static const real BENT = 0.3; /* radians by which a given step may differ from the mean of its rates */

/* Fill in the part of r that is given by pieces. */
void cardan_signals_at(cardan_run *run, real t)
{
    for (ptrdiff_t i = 0; i < run->signal_count; i++) {
        const cardan_signal *s = run->signals + i;
        const real *c = s->coefficients + 4 * s->where;
        real d = t - s->breaks[s->where];
        run->r[s->input] = ((c[3] * d + c[2]) * d + c[1]) * d + c[0];
    }
}

/* Fill r at t: signals by pieces, then functions of the user. Constants stay as they are. */
static int inputs_at(cardan_run *run, real t, const real *x, int asked)
{
    cardan_signals_at(run, t);
    if (run->inputs && asked && run->inputs(run->input_context, t, x, run->r) != 0)
        return CARDAN_INPUT;
    return 0;
}

/* r at t; a sampled function keeps its value. Returns 0 or CARDAN_INPUT. */
int cardan_inputs_at(cardan_run *run, real t, const real *x)
{
    return inputs_at(run, t, x, !run->sampled);
}

/* dx/dt (nx) and the powers of the sources at t, y; either may be NULL.
 *
 * Returns 0, CARDAN_MODEL or CARDAN_INPUT.
 */
int cardan_evaluate(cardan_run *run, real t, const real *y, real *xdot, real *power)
{
    cardan_in in;
    int status = inputs_at(run, t, y, !run->sampled);

    if (status != 0)
        return status;
    in = cardan_at(run, &t, y);
    if (xdot) {
        run->evaluations++;
        status = cardan_call_model(run, &run->rhs, &in, xdot);
    }
    if (status == 0 && power && run->power.function)
        status = cardan_call_model(run, &run->power, &in, power);
    return status;
}

/* f = dy/dt (n) at t, y. Returns as cardan_evaluate. */
int cardan_derivative(cardan_run *run, real t, const real *y, real *f)
{
    return cardan_evaluate(run, t, y, f, f + run->nx);
}

/* Make f the derivative at t, y unless it is. */
int cardan_refresh(cardan_run *run)
{
    int status = 0;

    if (!run->fresh) {
        status = cardan_derivative(run, run->t, run->y, run->f);
        run->fresh = status == 0;
    }
    return status;
}

/* The time next to the start of a span, inside: by one rounding of the longer of time and span. */
static real inside(real start, real end)
{
    const real next = start + DBL_EPSILON * (end - start);

    return next != start ? next : nextafter(start, end);
}

/* Let steps go to the next stop or tick; what the method remembers stays. */
void cardan_head_for_stop(cardan_run *run)
{
    run->until = run->stops[run->next_stop];
    for (ptrdiff_t i = 0; i < run->tick_count; i++)
        if (run->ticks[i].next < run->until)
            run->until = run->ticks[i].next;
    run->early = inside(run->segment, run->until);
    run->late = inside(run->until, run->segment);
}

/* Start over at t, where something has changed: steps go to the next stop or tick. */
void cardan_restart(cardan_run *run)
{
    run->segment = run->t;
    run->in_segment = run->begun = 0;
    run->error_before = 1;
    run->fresh = run->pass_parts = 0;
    cardan_head_for_stop(run);
}

/* Start the segment that lies ahead of t: choose the pieces of its inputs.
 *
 * All stages of its steps lie between two stops, so that one piece serves them all and a corner
 * or jump of an input is never inside a step.
 */
int cardan_segment(cardan_run *run)
{
    real middle = 0.5 * (run->t + run->stops[run->next_stop]);

    cardan_restart(run);
    for (ptrdiff_t i = 0; i < run->signal_count; i++) {
        cardan_signal *s = run->signals + i;
        while (s->where + 1 < s->pieces && s->breaks[s->where + 1] < middle)
            s->where++;
        while (s->where > 0 && s->breaks[s->where] > middle)
            s->where--;
    }
    return inputs_at(run, run->t, run->y, 1);
}

/* Scale every quaternion in q to unit length; one of length 0 becomes NaN. */
void cardan_normalize(const cardan_run *run, real *y)
{
    for (ptrdiff_t i = 0; i < run->quaternion_count; i++) {
        real *q = y + run->quaternions[i];
        real norm = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
        for (int j = 0; j < 4; j++)
            q[j] /= norm;
    }
}

/* Index of the first entry that is NaN or infinite, -1 if all are finite. */
ptrdiff_t cardan_not_finite(const real *y, ptrdiff_t n)
{
    for (ptrdiff_t i = 0; i < n; i++)
        if (!(y[i] - y[i] == 0))
            return i;
    return -1;
}

/* Make `trial` with the derivative in `y_old` the present state. */
void cardan_record_row(cardan_run *run, real t)
{
    for (ptrdiff_t i = 0; i < run->n; i++) {
        run->f[i] = run->y_old[i];
        run->y_old[i] = run->y[i];
        run->y[i] = run->trial[i];
    }
    run->t_old = run->t;
    run->t = t;
    run->fresh = 1;
    run->is_dense = 0;
    run->steps++;
    run->in_segment++;
}

/* How much a projection may change, in tolerances: 1, or what rounding makes of it in speeds. */
static real allowed_correction(const cardan_run *run)
{
    const real magnified = ROUNDING / (run->rank_margin * run->rank_margin);

    return run->rank_margin > 0 ? fmax(1, magnified / cardan_finest(run)) : 1;
}

/* Whether a given step to t, next (n) follows the coordinates of rotations; slope (n): there.
 *
 * No error of such a step is known. But beside a place where they are singular, these turn by some
 * radians within a step however short it is, until it is shorter than the distance from there.
 */
int cardan_follows(cardan_run *run, real t, const real *next, const real *slope)
{
    const real h = t - run->t;

    for (ptrdiff_t k = 0; k < (run->on_grid ? run->bounded_count : 0); k++) {
        const ptrdiff_t i = run->bounded[k];
        const real bent = next[i] - run->y[i] - 0.5 * h * (run->f[i] + slope[i]);
        if (!(fabs(bent) <= BENT)) {
            run->culprit = i;
            return 0;
        }
    }
    return 1;
}

/* The step to t, y succeeded: make it the present state and evaluate its derivative.
 *
 * y may be `trial`; it is normalized and projected onto the constraints here, which must change it
 * by less than the tolerance: more is a jump to another branch of the motion. The present state has
 * not changed when the status is not 0.
 */
int cardan_commit(cardan_run *run, real t, const real *y)
{
    return cardan_commit_derivative(run, t, y, -1);
}

/* The derivative at t, next (n): that of stage `stage` where nothing changed the state since. */
static int next_derivative(cardan_run *run, real t, const real *next, int stage, real *f)
{
    if (stage < 0 || run->quaternion_count + run->positions + run->rates > 0)
        return cardan_derivative(run, t, next, f);
    for (ptrdiff_t i = 0; i < run->n; i++)
        f[i] = run->k[stage * run->n + i];
    return 0;
}

/* The same, of a method whose stage `stage` is at the end of the step; -1 where none is. */
int cardan_commit_derivative(cardan_run *run, real t, const real *y, int stage)
{
    real *next = run->trial;
    int status;

    if (next != y)
        for (ptrdiff_t i = 0; i < run->n; i++)
            next[i] = y[i];
    cardan_normalize(run, next);
    run->culprit = cardan_not_finite(next, run->n);
    if (run->culprit >= 0)
        return CARDAN_NOT_FINITE;
    status = cardan_close(run, t, next, 1);
    if (status == 0 && run->correction > allowed_correction(run))
        status = CARDAN_CONSTRAINT_OPEN;
    if (status != 0)
        return status;
    /* y_old serves as room for the new derivative until nothing can fail any more */
    status = next_derivative(run, t, next, stage, run->y_old);
    if (status == 0) {
        run->culprit = cardan_not_finite(run->y_old, run->n);
        status = run->culprit >= 0 ? CARDAN_NOT_FINITE : 0;
    }
    if (status == 0 && !cardan_follows(run, t, next, run->y_old))
        status = CARDAN_ROTATION_UNRESOLVED;
    if (status != 0)
        return status;
    cardan_record_row(run, t);
    return 0;
}
