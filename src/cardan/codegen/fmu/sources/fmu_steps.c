/* Co-simulation: a run that goes on from one communication point to the next. Part of cardan. */
#include "fmu_core.h"
#include <math.h>

/* communication points may be rounded by that */
static const double NEAR = 1e-9;

/* How inputs go on from the next communication point: derivatives of order 1 to 3. */
fmu_status fmu_set_input_derivatives(fmu_instance *m, const unsigned *references, size_t count,
                                     const int *orders, const double *values)
{
    static const double factorials[] = {1, 1, 2, 6};

    for (size_t k = 0; k < count; k++) {
        ptrdiff_t place = 0;
        if (fmu_kind_of(m->model, references[k], &place) != FMU_INPUT)
            return fmu_say(m, FMU_ERROR, "input derivatives: value reference %u is not an input.", references[k]);
        if (orders[k] < 1 || orders[k] > 3 || !fmu_finite(values[k]))
            return fmu_say(m, FMU_ERROR, "input derivatives: '%s' of order %d = %g: orders are 1 to 3, values finite.",
                           m->model->names[references[k]], orders[k], values[k]);
        m->polynomials[FMU_POLYNOMIAL * place + 2 + orders[k]] = values[k] / factorials[orders[k]];
        m->is.polynomials = m->is.stale_inputs = 1;
    }
    return FMU_OK;
}

/* Let the polynomials of the inputs begin here. */
static void begin_polynomials(fmu_instance *m, double end)
{
    cardan_run *run = &m->at.run;

    for (ptrdiff_t i = 0; i < run->nr; i++) {
        double *polynomial = m->polynomials + FMU_POLYNOMIAL * i;
        polynomial[0] = run->t, polynomial[1] = end, polynomial[2] = m->r[i];
    }
    run->signal_count = run->nr;
    m->is.stale_inputs = 1;
}

/* Let the run go on to another end. What the method remembers stays, unless an input or the model jumps
 * here. */
static int extend(fmu_instance *m, double end)
{
    cardan_run *run = &m->at.run;
    int status = 0;

    if (m->is.polynomials)
        begin_polynomials(m, end);
    if (end > m->is.horizon)
        status = fmu_find_jumps(m, run->t, end);
    for (ptrdiff_t k = 0; k < m->is.jump_count; k++)
        m->is.stale_inputs |= m->jumps[k] == run->t;
    fmu_set_stops(m, end);
    if (m->is.stale_inputs)
        cardan_restart(run);
    else
        cardan_head_for_stop(run);
    m->is.stale_inputs = 0;
    return status;
}

/* Drive the run to its end. */
static int drive(fmu_instance *m)
{
    cardan_run *run = &m->at.run;
    int status;

    do {
        status = cardan_run_drive(run);
        fmu_report_events(m);
    } while (status == CARDAN_MORE || status == CARDAN_FULL);
    if (m->is.polynomials) {
        cardan_signals_at(run, run->t);
        memcpy(m->r, run->r, (size_t)run->nr * sizeof(real));
    }
    return status;
}

fmu_status fmu_do_step(fmu_instance *m, double t, double step)
{
    cardan_run *run = &m->at.run;
    const double end = t + step;
    int status;

    if (!fmu_finite(t) || !fmu_finite(step) || !(step > 0))
        return fmu_say(m, FMU_ERROR, "DoStep from %g s over %g s: the step must be positive and finite.", t, step);
    if (fabs(t - run->t) > NEAR * fmax(1, fmax(fabs(t), step)))
        return fmu_say(m, FMU_ERROR, "DoStep from %.17g s: the FMU is at %.17g s.", t, run->t);
    if (m->is.terminated)
        return fmu_say(m, FMU_DISCARD, "DoStep at t = %.9g s: the motion has ended there.", run->t);
    if (fmu_settle(m) != FMU_OK)
        return FMU_ERROR;
    fmu_forget(m);
    /* rounding alone */
    if (end <= run->t)
        return FMU_OK;
    status = extend(m, end);
    if (status == 0)
        status = drive(m);
    if (status == CARDAN_DONE)
        return FMU_OK;
    if (status == CARDAN_EVENT) {
        m->is.terminated = 1;
        return FMU_OK;
    }
    return fmu_broke_down(m, "DoStep", status);
}
