/* Events: found inside the last step, located on its dense output, and what they change.
 *
 * Part of cardan. Caller owns all memory.
 *
 * An event happens where its value falls through zero. It is armed once its value has been larger
 * than its slack, and disarmed when it happens. Events of which the equations depend (CARDAN_MODE,
 * CARDAN_IMPACT, CARDAN_END) happen too where they are not armed but below minus their slack:
 * at a start that violates them, or where a transition has not lifted them off.
 *
 * The slack is what rounding may do to a value: some epsilons of the largest one seen, and twice
 * what was left at the time where the event was found last, as times are rounded as well. What
 * falls again and again without getting clear of its slack chatters.
 *
 * Marks interrupt nothing: they are noted, and the run is the same without them.
 */
#include "events.h"
#include <float.h>
#include <math.h>

enum { MOST_AT_ONCE = 50, MOST_CLOSE = 20, MOST_IN_A_BURST = 1000 };
static const real ROUNDING = 256 * DBL_EPSILON;
static const real TIMED = CARDAN_ROUNDING(1e-9, 1e-4); /* of a period */
static const real CLOSE = 1e3 * DBL_EPSILON, BURST = 1e-6; /* of the time, of the span */

ptrdiff_t cardan_board_length(const cardan_run *run)
{
    ptrdiff_t m = run->ne + run->watched;

    if (m == 0)
        return 0;
    return (10 + cardan_most_samples) * m + cardan_most_samples + run->n + run->nx + run->ns;
}

cardan_board cardan_board_of(const cardan_run *run)
{
    cardan_board at;
    ptrdiff_t m = run->ne + run->watched;
    real *next = run->board;

    at.m = m;
    at.g = next, next += m;
    at.armed = next, next += m;
    at.rounding = next, next += m;
    at.reach = next, next += m;
    at.last = next, next += m;
    at.close = next, next += m;
    at.since = next, next += m;
    at.burst = next, next += m;
    at.root = next, next += m;
    at.probe = next, next += m;
    at.values = next, next += cardan_most_samples * m;
    at.theta = next, next += cardan_most_samples;
    at.y = next, next += run->n;
    at.out = next;
    return at;
}

/* Values g of all events at t, y. */
int cardan_event_values(cardan_run *run, real t, const real *y, real *g)
{
    cardan_in in;
    int status = cardan_inputs_at(run, t, y);

    in = cardan_at(run, &t, y);
    if (status == 0 && run->events.function)
        status = cardan_call_model(run, &run->events, &in, g);
    if (status == 0 && run->watch && run->watch(t, y, g + run->ne) != 0)
        status = CARDAN_INPUT;
    if (status == 0) {
        ptrdiff_t bad = cardan_not_finite(g, run->ne + run->watched);
        if (bad >= 0) {
            run->culprit = run->n + bad;
            status = CARDAN_NOT_FINITE;
        }
    }
    return status;
}

/* What of a value may be rounding. */
real cardan_event_threshold(const cardan_board *at, ptrdiff_t i)
{
    return fmax(at->rounding[i], ROUNDING * at->reach[i]);
}

/* Whether an event happens where it is negative without having fallen. */
int cardan_is_binding(const cardan_run *run, ptrdiff_t i)
{
    return run->kinds[i] == CARDAN_MODE || run->kinds[i] == CARDAN_IMPACT
           || run->kinds[i] == CARDAN_END;
}

/* Arm an event whose value is clear of zero. */
void cardan_arm(const cardan_board *at, ptrdiff_t i, real value)
{
    at->reach[i] = fmax(at->reach[i], fabs(value));
    if (value > cardan_event_threshold(at, i)) {
        at->armed[i] = 1;
        at->rounding[i] = 0;
    }
}

/* Events that are negative at t though nothing has fallen: they happen at once. */
static void enter(cardan_run *run, const cardan_board *at)
{
    run->event_pending = 0;
    for (ptrdiff_t i = 0; i < at->m; i++) {
        /* what the new mode has not seen positive yet does not fall */
        if (cardan_is_binding(run, i))
            at->armed[i] = 0;
        /* how far below zero it was counts only if it still is */
        if (at->rounding[i] < 0)
            at->rounding[i] = at->g[i] < 0 ? -at->rounding[i] : 0;
        cardan_arm(at, i, at->g[i]);
        run->e[i] = cardan_is_binding(run, i) && at->g[i] < -cardan_event_threshold(at, i);
        if (run->e[i] != 0)
            run->event_pending = 1;
    }
}

/* The first ticks of a run that starts at t. */
void cardan_events_clock(cardan_run *run)
{
    for (ptrdiff_t i = 0; i < run->tick_count; i++) {
        cardan_tick *tick = run->ticks + i;
        real k = ceil((run->t - tick->phase) / tick->period - TIMED);
        tick->count = (ptrdiff_t)k;
        tick->next = tick->phase + k * tick->period;
        /* a tick that rounding puts beside the start is at the start */
        if (fabs(tick->next - run->t) <= TIMED * tick->period)
            tick->next = run->t;
    }
}

/* Values at the start, and what happens there already. */
int cardan_events_start(cardan_run *run)
{
    const cardan_board at = cardan_board_of(run);
    int status;

    run->event_pending = run->at_once = 0;
    if (at.m == 0)
        return 0;
    for (ptrdiff_t i = 0; i < at.m; i++) {
        at.last[i] = at.since[i] = -INFINITY;
        at.armed[i] = at.rounding[i] = at.reach[i] = at.close[i] = at.burst[i] = 0;
    }
    status = cardan_event_values(run, run->t, run->y, at.g);
    if (status == 0)
        enter(run, &at);
    return status;
}

/* Whether a tick is due at t. */
int cardan_events_due(const cardan_run *run)
{
    for (ptrdiff_t i = 0; i < run->tick_count; i++)
        if (run->ticks[i].next == run->t)
            return 1;
    return 0;
}

/* Let the ticks of this time happen. Returns whether there are any. */
int cardan_events_tick(cardan_run *run)
{
    for (ptrdiff_t i = 0; i < run->tick_count; i++) {
        cardan_tick *tick = run->ticks + i;
        if (tick->next != run->t)
            continue;
        run->e[tick->event] = 1;
        run->event_pending = 1;
        tick->count++;
        tick->next = tick->phase + (real)tick->count * tick->period;
    }
    return run->event_pending != 0;
}

/* Whether the log may be too short for what the next step brings. */
int cardan_events_full(const cardan_run *run)
{
    ptrdiff_t m = run->ne + run->watched;

    return m > 0 && run->log_capacity - run->log_count < MOST_AT_ONCE + 2 + cardan_most_samples * m;
}

/* A row of the log for the events in `e`. Returns its end, which is yet as before them. */
real *cardan_note(cardan_run *run, real t, const real *y)
{
    const ptrdiff_t m = run->ne + run->watched, half = run->nx + run->ns;
    real *row = run->log + run->log_count * (1 + m + 2 * half);

    row[0] = t;
    for (ptrdiff_t i = 0; i < m; i++)
        row[1 + i] = run->e[i];
    row += 1 + m;
    for (ptrdiff_t side = 0; side < 2; side++, row += half) {
        for (ptrdiff_t i = 0; i < run->nx; i++)
            row[i] = y[i];
        for (ptrdiff_t i = 0; i < run->ns; i++)
            row[run->nx + i] = run->s[i];
    }
    run->log_count++;
    return row - half;
}

/* Whether an event happens ever again within no time to speak of, or by no more than rounding. */
static int chatters(const cardan_run *run, const cardan_board *at, ptrdiff_t i)
{
    real span = fabs(run->stops[run->stop_count - 1] - run->t_start);
    int soon = fabs(run->t - at->last[i]) <= CLOSE * fmax(fabs(run->t), span);

    at->close[i] = soon || at->armed[i] == 0 ? at->close[i] + 1 : 0;
    at->last[i] = run->t;
    if (!(fabs(run->t - at->since[i]) <= BURST * span)) {
        at->since[i] = run->t;
        at->burst[i] = 0;
    }
    at->burst[i]++;
    return at->close[i] > (real)MOST_CLOSE || at->burst[i] > (real)MOST_IN_A_BURST;
}

/* New u, z and s by the transition of the model, on the constraints. */
static int change(cardan_run *run, const cardan_board *at)
{
    cardan_in in;
    int status = cardan_inputs_at(run, run->t, run->y);

    if (status != 0)
        return status;
    in = cardan_at(run, &run->t, run->y);
    in.e = run->e;
    status = cardan_call_model(run, &run->transition, &in, at->out);
    if (status != 0)
        return status;
    run->culprit = cardan_not_finite(at->out, run->nu + run->nz);
    if (run->culprit >= 0) {
        run->culprit += run->nq;
        return CARDAN_NOT_FINITE;
    }
    for (ptrdiff_t i = 0; i < run->nu + run->nz; i++)
        run->y[run->nq + i] = at->out[i];
    for (ptrdiff_t i = 0; i < run->ns; i++)
        run->s[i] = at->out[run->nu + run->nz + i];
    status = cardan_close(run, run->t, run->y, 1);
    cardan_restart(run);
    /* other modes hold other velocities */
    if (status == 0 && run->constraint_jacobian.function)
        cardan_first_rank(run);
    run->row_open = 2;
    return status;
}

/* End the run because of event i. */
static int give_up(cardan_run *run, ptrdiff_t i, int status)
{
    run->culprit = run->n + i;
    for (ptrdiff_t k = 0; k < run->ne + run->watched; k++)
        run->e[k] = 0;
    return status;
}

/* The events in `e` happen: note them, change what they change, see what happens then. */
int cardan_events_apply(cardan_run *run)
{
    const cardan_board at = cardan_board_of(run);
    ptrdiff_t last = -1; /* of those that end the run */
    int changes = 0, status = 0;
    real *after;

    run->event_pending = 0;
    run->at_once++;
    after = cardan_note(run, run->t, run->y);
    for (ptrdiff_t i = 0; i < at.m; i++) {
        if (run->e[i] == 0)
            continue;
        run->occurred++;
        changes |= run->kinds[i] <= CARDAN_TICK;
        if (run->kinds[i] == CARDAN_END || run->kinds[i] == CARDAN_HALT)
            last = run->n + i;
        if (run->at_once > MOST_AT_ONCE)
            return give_up(run, i, CARDAN_EVENT_LIMIT);
        if (run->kinds[i] != CARDAN_TICK && run->at_once == 1 && chatters(run, &at, i))
            return give_up(run, i, CARDAN_CHATTER);
        /* marked by its sign where nothing has fallen */
        at.rounding[i] = at.armed[i] != 0 ? 2 * fabs(at.g[i])
                                       : -(fabs(at.g[i]) + ROUNDING * at.reach[i]);
        at.armed[i] = 0;
    }
    if (changes)
        status = change(run, &at);
    for (ptrdiff_t i = 0; i < run->nx && status == 0; i++)
        after[i] = run->y[i];
    for (ptrdiff_t i = 0; i < run->ns && status == 0; i++)
        after[run->nx + i] = run->s[i];
    for (ptrdiff_t i = 0; i < at.m; i++)
        run->e[i] = 0;
    if (status == 0 && last >= 0) {
        run->culprit = last;
        return CARDAN_EVENT;
    }
    if (status != 0)
        return status;
    status = cardan_event_values(run, run->t, run->y, at.g);
    if (status == 0)
        enter(run, &at);
    return status;
}
