/* Values of the variables of an FMU. Part of cardan. */
#include "fmu_core.h"
#include "events.h"
#include <float.h>
#include <math.h>

/* The kind of a variable and its place there; -1: there is no such variable. */
int fmu_kind_of(const fmu_model *model, unsigned reference, ptrdiff_t *place)
{
    for (int kind = 0; kind < FMU_KINDS; kind++)
        if (reference >= model->blocks[kind].first
            && reference - model->blocks[kind].first < model->blocks[kind].count) {
            *place = (ptrdiff_t)(reference - model->blocks[kind].first);
            return kind;
        }
    return -1;
}

/* The state with quaternions of unit length: importers let them drift. */
const double *fmu_unit_view(fmu_instance *m)
{
    const cardan_run *run = &m->at.run;

    memcpy(m->view, run->y, (size_t)run->nx * sizeof(real));
    cardan_normalize(run, m->view);
    return m->view;
}

/* Call a function of the model by its name at t, y (nx). Returns an answer of run.h. */
int fmu_call(fmu_instance *m, const char *function, const double *y, double *out)
{
    const cardan_export *scene = fmu_scene(m);
    cardan_run *run = &m->at.run;
    cardan_in in = cardan_at(run, &run->t, y);

    for (ptrdiff_t k = 0; k < scene->function_count; k++)
        if (strcmp(scene->functions[k].name, function) == 0) {
            const cardan_call call = {scene->functions[k].function, cardan_prepared_w(scene, m->at.prepared, k)};
            return cardan_call_model(run, &call, &in, out);
        }
    return CARDAN_MODEL;
}

/* dx/dt. A quaternion that has drifted turns as the one of unit length does, and stays as long as it is. */
static int rates(fmu_instance *m, double *out)
{
    cardan_run *run = &m->at.run;
    const double *y = fmu_unit_view(m);
    const int status = cardan_evaluate(run, run->t, y, out, NULL);

    for (ptrdiff_t i = 0; i < run->quaternion_count && status == 0; i++) {
        const ptrdiff_t at = run->quaternions[i];
        for (ptrdiff_t j = at; j < at + 4; j++)
            out[j] *= fmu_length(run->y + at);
    }
    return status;
}

/* Numbers whose signs change where events happen. An event that has just happened counts from where
 * its value is clear of rounding, as the events of a run do; importers look at earlier times again. */
static int indicators(fmu_instance *m, double *out)
{
    cardan_run *run = &m->at.run;
    const cardan_board at = cardan_board_of(run);
    const int status = cardan_event_values(run, run->t, fmu_unit_view(m), at.probe);

    for (ptrdiff_t k = 0; k < fmu_count(m, FMU_INDICATOR) && status == 0; k++) {
        const ptrdiff_t i = m->model->indicators[k];
        const double least = fmax(2 * cardan_event_threshold(&at, i), DBL_MIN);
        if (run->t < m->armed_at[i])
            at.armed[i] = 0;
        if (at.armed[i] == 0 && at.probe[i] > least && (m->is.phase & FMU_CONTINUOUS)) {
            cardan_arm(&at, i, at.probe[i]);
            m->armed_at[i] = run->t;
        }
        out[k] = at.probe[i] + (at.armed[i] != 0 ? 0 : least);
    }
    return status;
}

/* Compute all variables of a kind at the present state, unless they are there. */
fmu_status fmu_compute(fmu_instance *m, int kind)
{
    const ptrdiff_t count = fmu_count(m, kind);
    double *out = m->values[kind];
    int status;

    if (m->computed[kind] || count == 0)
        return FMU_OK;
    if (kind == FMU_RATE)
        status = rates(m, out);
    else if (kind == FMU_INDICATOR)
        status = indicators(m, out);
    else
        status = fmu_call(m, m->model->slopes[kind].function, fmu_unit_view(m), out);
    if (status == 0) {
        const ptrdiff_t bad = cardan_not_finite(out, count);
        if (bad >= 0)
            return fmu_say(m, FMU_DISCARD, "'%s' is not finite at t = %.9g s.",
                           m->model->names[m->model->blocks[kind].first + (unsigned)bad], m->at.run.t);
    }
    if (status != 0)
        return fmu_broke_down(m, m->model->names[m->model->blocks[kind].first], status);
    m->computed[kind] = 1;
    return FMU_OK;
}

/* Whether a kind of variable follows from the state. */
static int follows(int kind)
{
    return kind == FMU_RATE || kind == FMU_OUTPUT || kind == FMU_ENERGY || kind == FMU_INDICATOR;
}

static double value_of(const fmu_instance *m, int kind, ptrdiff_t place)
{
    switch (kind) {
    case FMU_TIME: return m->at.run.t;
    case FMU_STATE: return m->at.run.y[place];
    case FMU_PARAMETER: return m->p[place];
    case FMU_INPUT: return m->r[place];
    case FMU_MODE: return m->at.run.s[place];
    default: return m->values[kind][place];
    }
}

fmu_status fmu_get(fmu_instance *m, const unsigned *references, size_t count, double *values)
{
    for (size_t k = 0; k < count; k++) {
        ptrdiff_t place = 0;
        const int kind = fmu_kind_of(m->model, references[k], &place);
        fmu_status status = FMU_OK;

        if (kind < 0)
            return fmu_say(m, FMU_ERROR, "get: there is no variable with the value reference %u.", references[k]);
        /* what the importer sets is there at once, what follows from it from the initialization on */
        if (kind != FMU_TIME && kind != FMU_PARAMETER && kind != FMU_INPUT)
            status = fmu_settle(m);
        if (status == FMU_OK && follows(kind))
            status = fmu_compute(m, kind);
        if (status != FMU_OK)
            return status;
        values[k] = value_of(m, kind, place);
    }
    return FMU_OK;
}

/* Whether a parameter may have a value: what elements say about their numbers. */
static fmu_status check_parameter(fmu_instance *m, ptrdiff_t place, double value)
{
    for (ptrdiff_t k = 0; k < m->model->limit_count; k++) {
        const fmu_limit *limit = m->model->limits + k;
        const double x = limit->scale * value;

        if (limit->parameter != place)
            continue;
        if (x < limit->least || x > limit->most || (limit->open && x == limit->least)
            || (limit->below && x == limit->most) || (limit->nonzero && x == 0))
            return fmu_say(m, FMU_ERROR, "set: the parameter '%s' = %g is out of its range.",
                           m->model->names[m->model->blocks[FMU_PARAMETER].first + (unsigned)place], value);
    }
    return FMU_OK;
}

/* Set one variable. */
static fmu_status set_one(fmu_instance *m, int kind, ptrdiff_t place, const char *name, double value)
{
    const int early = FMU_INSTANTIATED | FMU_INITIALIZING;
    const cardan_export *scene = fmu_scene(m);

    switch (kind) {
    case FMU_PARAMETER:
        if (!(m->is.phase & (early | FMU_EVENT_MODE | FMU_STEPPING)))
            return fmu_say(m, FMU_ERROR, "set: the parameter '%s' is tunable: set it in Event Mode.", name);
        if (check_parameter(m, place, value) != FMU_OK)
            return FMU_ERROR;
        m->is.stale_parameters |= m->p[place] != value;
        m->p[place] = value;
        break;
    case FMU_INPUT:
        m->is.stale_inputs |= m->r[place] != value;
        m->r[place] = value;
        m->at.run.r[place] = value;
        break;
    case FMU_STATE:
        if (!(m->is.phase & early))
            return fmu_say(m, FMU_ERROR, "set: '%s' is a state: it is set before the end of the initialization, "
                           "in model exchange then by SetContinuousStates.", name);
        /* the others stay where the model starts */
        if (!m->is.start_is_set)
            (void)cardan_start_state(&(const cardan_export){.q = scene->q, .u = scene->u, .z = scene->z,
                                     .nq = scene->nq, .nu = scene->nu, .nz = scene->nz},
                                     NULL, 0, NULL, m->start, NULL);
        m->is.start_is_set = 1;
        m->start[place] = value;
        break;
    default:
        return fmu_say(m, FMU_ERROR, "set: '%s' is computed and cannot be set.", name);
    }
    m->is.begun = m->is.begun && !(m->is.phase & early);
    return FMU_OK;
}

fmu_status fmu_set(fmu_instance *m, const unsigned *references, size_t count, const double *values)
{
    fmu_forget(m);
    for (size_t k = 0; k < count; k++) {
        ptrdiff_t place = 0;
        const int kind = fmu_kind_of(m->model, references[k], &place);
        fmu_status status;

        if (kind < 0)
            return fmu_say(m, FMU_ERROR, "set: there is no variable with the value reference %u.", references[k]);
        if (!fmu_finite(values[k]))
            return fmu_say(m, FMU_ERROR, "set: '%s' = %g: it must be a finite number.",
                           m->model->names[references[k]], values[k]);
        status = set_one(m, kind, place, m->model->names[references[k]], values[k]);
        if (status != FMU_OK)
            return status;
    }
    return FMU_OK;
}
