/* Model exchange: the importer integrates, the events of the model happen here.
 *
 * Part of cardan. What happens, and what it changes, is that of a run: the transitions of
 * event_transition.c. The importer finds the times of state events by the signs of indicators.
 */
#include "events.h"
#include "fmu_core.h"
#include "jumps.h"
#include <math.h>

/* times of events that the importer reaches up to rounding */
static const double NEAR = 1e-9;

/* What happens at the present time, until nothing does. Returns an answer of run.h. */
int fmu_happen(fmu_instance *m)
{
    cardan_run *run = &m->at.run;
    int status = 0;

    while (status == 0) {
        if (cardan_events_full(run))
            fmu_report_events(m);
        if (!run->event_pending && !(cardan_events_due(run) && cardan_events_tick(run)))
            break;
        status = cardan_events_apply(run);
        fmu_forget(m);
    }
    fmu_report_events(m);
    return status;
}

/* Tell of the events in the log, and empty it. */
void fmu_report_events(fmu_instance *m)
{
    cardan_run *run = &m->at.run;
    const ptrdiff_t width = 1 + run->ne + 2 * (run->nx + run->ns);

    for (ptrdiff_t k = 0; k < run->log_count && m->logger.events; k++)
        for (ptrdiff_t i = 0; i < run->ne; i++) {
            const cardan_exported_event *event = fmu_scene(m)->events + i;
            const real *row = run->log + k * width, *s = row + 1 + run->ne + run->nx;
            const int first = event->mode >= 0 && s[event->mode] == event->first;
            if (row[1 + i] != 0 && !first)
                (void)fmu_say(m, FMU_OK, "'%s' happens at t = %.17g s.", event->name, row[0]);
        }
    run->log_count = 0;
}

/* Let samples that are due be due at this very time; what the importer went past is not made up for. */
static void clock(fmu_instance *m)
{
    cardan_run *run = &m->at.run;

    for (ptrdiff_t i = 0; i < run->tick_count; i++) {
        cardan_tick *tick = run->ticks + i;
        if (tick->next > run->t + NEAR * tick->period)
            continue;
        while (tick->next + tick->period <= run->t + NEAR * tick->period) {
            (void)fmu_say(m, FMU_WARNING, "'%s' was due at t = %.9g s; the importer went past it.",
                          fmu_scene(m)->events[tick->event].name, tick->next);
            tick->count++;
            tick->next = tick->phase + (real)tick->count * tick->period;
        }
        tick->next = run->t;
    }
}

/* Times at which the model jumps lie behind, and more are looked for where the horizon is near. */
static int advance(fmu_instance *m)
{
    cardan_run *run = &m->at.run;
    const double near = NEAR * fmax(1, fabs(run->t));
    double t = run->t;
    int status = 0;

    /* the jump that was reached counts as behind */
    for (ptrdiff_t k = 0; k < m->is.jump_count; k++)
        if (fabs(m->jumps[k] - run->t) <= near && m->jumps[k] > t)
            t = m->jumps[k];
    if (run->t >= m->is.horizon - near)
        status = fmu_find_jumps(m, t, t);
    run->t = t;
    fmu_set_stops(m, m->is.horizon);
    cardan_restart(run);
    return status;
}

/* Which events happen: those that have fallen, and those that are negative where none may be. */
static int find_events(fmu_instance *m)
{
    cardan_run *run = &m->at.run;
    const cardan_board at = cardan_board_of(run);
    int status;

    if (at.m == 0)
        return 0;
    status = cardan_event_values(run, run->t, run->y, at.g);
    for (ptrdiff_t i = 0; i < at.m && status == 0; i++) {
        const int fallen = at.armed[i] != 0 && run->t >= m->armed_at[i] && at.g[i] <= 0;
        const int beyond = cardan_is_binding(run, i) && at.g[i] < -cardan_event_threshold(&at, i);
        m->armed_at[i] = -INFINITY;
        run->e[i] = run->kinds[i] != CARDAN_TICK && run->kinds[i] != CARDAN_MARK && (fallen || beyond);
        if (run->e[i] != 0)
            run->event_pending = 1;
    }
    return status;
}

/* The next time at which something happens whatever the state does. */
static void next_event(const fmu_instance *m, fmu_update *update)
{
    const cardan_run *run = &m->at.run;

    update->next = INFINITY;
    /* where there are no jumps ahead others are looked for at the horizon */
    if (cardan_jumps_capacity(fmu_scene(m)) > 0
        && (run->stop_count > 1 || !m->is.stop_defined || m->is.horizon < m->is.stop))
        update->next = m->at.stops[0];
    for (ptrdiff_t i = 0; i < run->tick_count; i++)
        update->next = fmin(update->next, run->ticks[i].next);
    update->next_defined = update->next < INFINITY;
}

/* Everything that happens at the present time and state. */
fmu_status fmu_update_discrete(fmu_instance *m, fmu_update *update)
{
    cardan_run *run = &m->at.run;
    const double t = run->t;
    int status;

    *update = (fmu_update){0};
    if (fmu_settle(m) != FMU_OK)
        return FMU_ERROR;
    memcpy(m->before, run->y, (size_t)run->nx * sizeof(real));
    fmu_forget(m);
    run->fresh = run->event_pending = run->at_once = 0;
    m->is.stale_inputs = 0;
    status = advance(m);
    cardan_normalize(run, run->y);
    if (status == 0)
        status = cardan_close(run, run->t, run->y, 1);
    clock(m);
    if (status == 0)
        status = find_events(m);
    if (status == 0)
        status = fmu_happen(m);
    if (status == CARDAN_EVENT)
        update->terminate = m->is.terminated = 1;
    else if (status != 0)
        return fmu_broke_down(m, "the events", status);
    run->t = t;
    for (ptrdiff_t i = 0; i < run->nx; i++)
        update->values_changed |= run->y[i] != m->before[i];
    next_event(m, update);
    return FMU_OK;
}

fmu_status fmu_set_time(fmu_instance *m, double t)
{
    if (!fmu_finite(t))
        return fmu_say(m, FMU_ERROR, "SetTime: %g is not a time.", t);
    if (m->at.run.t != t)
        fmu_forget(m);
    m->at.run.t = t;
    return FMU_OK;
}

static fmu_status check_count(fmu_instance *m, const char *call, size_t given, ptrdiff_t expected)
{
    if (given == (size_t)expected)
        return FMU_OK;
    return fmu_say(m, FMU_ERROR, "%s: there are %lld numbers, not %llu.", call, (long long)expected,
                   (unsigned long long)given);
}

fmu_status fmu_set_states(fmu_instance *m, const double *x, size_t count)
{
    if (check_count(m, "SetContinuousStates", count, fmu_nx(m)) != FMU_OK)
        return FMU_ERROR;
    fmu_forget(m);
    memcpy(m->at.run.y, x, count * sizeof(double));
    return FMU_OK;
}

fmu_status fmu_get_states(fmu_instance *m, double *x, size_t count)
{
    if (check_count(m, "GetContinuousStates", count, fmu_nx(m)) != FMU_OK || fmu_settle(m) != FMU_OK)
        return FMU_ERROR;
    memcpy(x, m->at.run.y, count * sizeof(double));
    return FMU_OK;
}

/* All rates or all indicators. */
fmu_status fmu_get_block(fmu_instance *m, int kind, double *values, size_t count)
{
    fmu_status status;

    if (check_count(m, "Get", count, fmu_count(m, kind)) != FMU_OK || fmu_settle(m) != FMU_OK)
        return FMU_ERROR;
    status = fmu_compute(m, kind);
    if (status == FMU_OK)
        memcpy(values, m->values[kind], count * sizeof(double));
    return status;
}

/* How far the state has drifted from unit quaternions and closed loops, in units of the tolerance. */
static int drifted(fmu_instance *m)
{
    cardan_run *run = &m->at.run;
    int status;

    memcpy(m->moved, run->y, (size_t)run->nx * sizeof(real));
    cardan_normalize(run, m->moved);
    for (ptrdiff_t i = 0; i < run->quaternion_count; i++)
        for (ptrdiff_t j = run->quaternions[i]; j < run->quaternions[i] + 4; j++)
            if (fabs(m->moved[j] - run->y[j]) > m->is.tolerance)
                return 1;
    if (run->positions + run->rates == 0)
        return 0;
    status = cardan_close(run, run->t, m->moved, 0);
    return status != 0 || run->correction > 1;
}

/* An accepted step of the importer: events that are clear of zero can happen from here on. */
fmu_status fmu_completed_step(fmu_instance *m, int *enter_event_mode)
{
    cardan_run *run = &m->at.run;
    const cardan_board at = cardan_board_of(run);
    int status = 0;

    *enter_event_mode = drifted(m);
    if (at.m > 0)
        status = cardan_event_values(run, run->t, fmu_unit_view(m), at.g);
    for (ptrdiff_t i = 0; i < at.m && status == 0; i++) {
        if (run->kinds[i] == CARDAN_TICK)
            continue;
        cardan_arm(&at, i, at.g[i]);
        m->armed_at[i] = -INFINITY;
        if (cardan_is_binding(run, i) && at.g[i] < -cardan_event_threshold(&at, i))
            *enter_event_mode = 1;
    }
    m->computed[FMU_INDICATOR] = 0;
    return status == 0 ? FMU_OK : fmu_broke_down(m, "CompletedIntegratorStep", status);
}
