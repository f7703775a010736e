/* Instances of an FMU: memory, modes, start. Part of cardan. */
#include "fmu_core.h"
#include "jumps.h"
#include <math.h>
#include <stdlib.h>

/* absolute tolerances as simulate() of cardan has them */
static const double RATIO = 1e-3, LARGEST_ATOL = 1e-9, TIGHTEST = 2.5e-14;
/* windows in which jumps are looked for, in the duration of an experiment */
static const double WINDOWS = 10;
/* how far behind a stop a start may lie */
static const double LIMIT_TOLERANCE = 1e-9;

static cardan_simulation settings_of(const fmu_instance *m)
{
    const double rtol = fmax(m->is.tolerance, TIGHTEST);

    return (cardan_simulation){.rtol = rtol, .atol = fmin(RATIO * m->is.tolerance, LARGEST_ATOL),
                               .start = m->is.start};
}

/* Numbers that an instance takes beside its run; NULL: they are only measured. */
static size_t lay_arrays(fmu_instance *m, real *block)
{
    const cardan_export *scene = fmu_scene(m);
    const ptrdiff_t nx = scene->nq + scene->nu + scene->nz, np = fmu_count(m, FMU_PARAMETER);
    const ptrdiff_t columns = 2 * scene->nu + scene->nz + 1 + scene->nr;
    ptrdiff_t used = 0;

    m->p = cardan_reserve(block, &used, np);
    m->r = cardan_reserve(block, &used, scene->nr);
    m->start = cardan_reserve(block, &used, nx);
    m->armed_at = cardan_reserve(block, &used, scene->event_count);
    m->polynomials = cardan_reserve(block, &used, FMU_POLYNOMIAL * scene->nr);
    m->jumps = cardan_reserve(block, &used, (ptrdiff_t)cardan_jumps_capacity(scene));
    m->view = cardan_reserve(block, &used, nx);
    m->moved = cardan_reserve(block, &used, nx);
    m->before = cardan_reserve(block, &used, nx);
    for (int kind = 0; kind < FMU_KINDS; kind++) {
        const ptrdiff_t rows = kind == FMU_INDICATOR ? scene->event_count : fmu_count(m, kind);
        m->values[kind] = cardan_reserve(block, &used, rows);
        m->slopes[kind] = cardan_reserve(block, &used, m->model->slopes[kind].by_state ? rows * columns : 0);
        m->by_parameters[kind] = cardan_reserve(block, &used, m->model->slopes[kind].by_parameters ? rows * np : 0);
    }
    m->kinematics = cardan_reserve(block, &used, scene->nq * scene->nu);
    m->normal = cardan_reserve(block, &used, scene->nu * scene->nu);
    m->direction = cardan_reserve(block, &used, columns + np);
    m->increment = cardan_reserve(block, &used, nx + np);
    return (size_t)used * sizeof(real);
}

void fmu_free(fmu_instance *m)
{
    if (m) {
        free(m->memory);
        free(m->signals);
        free(m->name);
        free(m);
    }
}

/* Make an instance; NULL where that is refused, as a message says. */
fmu_instance *fmu_create(const fmu_model *model, int exchange, const char *name, const char *token,
                         fmu_logger logger)
{
    fmu_instance *m = calloc(1, sizeof *m);
    cardan_simulation settings = {0};
    size_t arrays, length = name ? strlen(name) : 0;

    if (!m)
        return NULL;
    m->model = model, m->logger = logger, m->exchange = exchange;
    m->name = malloc(length + 1);
    arrays = lay_arrays(m, NULL);
    m->memory = malloc(arrays + cardan_lay_run(model->scene, &settings, NULL, &m->at) + sizeof(real));
    m->signals = calloc((size_t)model->scene->nr + 1, sizeof *m->signals);
    if (!m->name || !m->memory || !m->signals) {
        (void)fmu_say(m, FMU_ERROR, "instantiate: there is no memory for another instance.");
        fmu_free(m);
        return NULL;
    }
    memcpy(m->name, name ? name : "", length);
    m->name[length] = 0;
    if (!token || strcmp(token, model->token) != 0)
        (void)fmu_say(m, FMU_ERROR, "instantiate: the token '%.80s' is not that of this FMU, '%s': the "
                      "modelDescription.xml belongs to another binary.", token ? token : "", model->token);
    else if (!(exchange ? model->exchange : model->simulates))
        (void)fmu_say(m, FMU_ERROR, "instantiate: this FMU was exported without %s.",
                      exchange ? "model exchange" : "co-simulation");
    else {
        (void)lay_arrays(m, m->memory);
        if (fmu_reset(m) == FMU_OK)
            return m;
    }
    fmu_free(m);
    return NULL;
}

/* Where the run lies: behind the arrays. */
void fmu_lay_run(fmu_instance *m)
{
    const cardan_simulation settings = settings_of(m);

    (void)cardan_lay_run(fmu_scene(m), &settings, (char *)m->memory + lay_arrays(m, m->memory), &m->at);
    for (ptrdiff_t i = 0; i < m->at.run.nr; i++) {
        const double *polynomial = m->polynomials + FMU_POLYNOMIAL * i;
        m->signals[i] = (cardan_signal){i, 1, 0, polynomial, polynomial + 2};
    }
    m->at.run.signals = m->signals;
}

/* What was computed is no longer that of the present state. */
void fmu_forget(fmu_instance *m)
{
    for (int kind = 0; kind < FMU_KINDS; kind++)
        m->computed[kind] = m->differentiated[kind] = m->by_parameters_now[kind] = 0;
    m->factored = 0;
}

/* As it was when it was made. */
fmu_status fmu_reset(fmu_instance *m)
{
    const cardan_export *scene = fmu_scene(m);

    m->is = (struct fmu_record){.phase = FMU_INSTANTIATED, .tolerance = m->model->tolerance,
                                .stale_parameters = 1};
    fmu_lay_run(m);
    for (ptrdiff_t i = 0; i < fmu_count(m, FMU_PARAMETER); i++)
        m->p[i] = scene->p[i];
    for (ptrdiff_t i = 0; i < scene->nr; i++)
        m->r[i] = scene->r[i];
    memset(m->polynomials, 0, (size_t)(FMU_POLYNOMIAL * scene->nr) * sizeof(double));
    fmu_forget(m);
    return FMU_OK;
}

/* Refuse a call in a state of the instance that does not allow it. */
fmu_status fmu_allow(fmu_instance *m, const char *call, int phases)
{
    static const char *const names[] = {"Instantiated", "Initialization Mode", "Event Mode",
                                        "Continuous-Time Mode", "Step Mode", "Terminated"};
    int k = 0;

    if (!m)
        return FMU_ERROR;
    if (m->is.phase & phases)
        return FMU_OK;
    while (k < 5 && !(m->is.phase >> k & 1))
        k++;
    return fmu_say(m, FMU_ERROR, "%s is not allowed in the state %s.", call, names[k]);
}

fmu_status fmu_setup(fmu_instance *m, int tolerance_defined, double tolerance, double start,
                     int stop_defined, double stop)
{
    if (!fmu_finite(start) || (stop_defined && !(fmu_finite(stop) && stop >= start)))
        return fmu_say(m, FMU_ERROR, "the experiment from %g s to %g s: give finite times, the end behind the start.",
                       start, stop);
    if (tolerance_defined && !(tolerance > 0 && fmu_finite(tolerance)))
        return fmu_say(m, FMU_ERROR, "the tolerance %g: give a positive number.", tolerance);
    m->is.tolerance_defined = tolerance_defined;
    m->is.tolerance = tolerance_defined ? tolerance : m->model->tolerance;
    m->is.start = start, m->is.stop = stop, m->is.stop_defined = stop_defined;
    m->is.begun = 0;
    return FMU_OK;
}

/* Find the times at which the model jumps, up to a horizon not before `to`. Returns a status of the model. */
int fmu_find_jumps(fmu_instance *m, double from, double to)
{
    double far = from + m->model->duration / WINDOWS;

    /* jumps are looked for at so many times of a window: a short one shows short pulses */
    if (m->is.stop_defined && m->is.stop > from)
        far = fmin(far, m->is.stop);
    m->is.horizon = fmax(to, far);
    return cardan_time_jumps(fmu_scene(m), m->at.prepared, from, m->is.horizon, m->jumps, &m->is.jump_count,
                             m->at.jumps_work);
}

/* Steps of the run end at the jumps ahead, and at `end`. */
void fmu_set_stops(fmu_instance *m, double end)
{
    cardan_run *run = &m->at.run;

    run->stop_count = run->next_stop = 0;
    for (ptrdiff_t k = 0; k < m->is.jump_count; k++)
        if (m->jumps[k] > run->t && m->jumps[k] < end)
            m->at.stops[run->stop_count++] = m->jumps[k];
    run->jumps = m->is.jump_count > 0;
    m->at.stops[run->stop_count++] = end;
}

/* Refuse a start behind a stop. */
static fmu_status check_start(fmu_instance *m)
{
    const cardan_run *run = &m->at.run;

    for (ptrdiff_t i = 0; i < run->ne && m->model->beyond; i++)
        if (m->model->beyond[i] && run->board[i] < -LIMIT_TOLERANCE)
            return fmu_say(m, FMU_ERROR, "the start: %s, by %.6g: start within its range.",
                           m->model->beyond[i], -run->board[i]);
    return FMU_OK;
}

/* Prepare the model at the parameters. */
static fmu_status prepare(fmu_instance *m)
{
    const int status = cardan_prepare(fmu_scene(m), m->p, m->at.prepared);

    if (status != 0)
        return fmu_say(m, FMU_ERROR, "the parameters: the model has no numbers at these values.");
    m->is.stale_parameters = 0;
    return FMU_OK;
}

/* The first consistent state: loops closed, quaternions of unit length, the first step chosen. */
static fmu_status begin(fmu_instance *m)
{
    const cardan_export *scene = fmu_scene(m);
    cardan_run *run = &m->at.run;
    int status = 0;

    if (m->is.stale_parameters && prepare(m) != FMU_OK)
        return FMU_ERROR;
    /* nothing of an earlier start is left */
    fmu_lay_run(m);
    memcpy(run->r, m->r, (size_t)run->nr * sizeof(real));
    memcpy(run->s, scene->s, (size_t)run->ns * sizeof(real));
    if (!m->is.start_is_set)
        status = cardan_start_state(scene, m->at.prepared, run->t, run->r, m->start, run->work);
    if (status != 0)
        return fmu_say(m, FMU_ERROR, "the start: elements cannot follow these parameters, inputs or this time; "
                       "export the model with them as its own values.");
    memcpy(run->y, m->start, (size_t)run->nx * sizeof(real));
    status = fmu_find_jumps(m, run->t, run->t);
    if (status != 0)
        return fmu_broke_down(m, "the start", CARDAN_MODEL);
    fmu_set_stops(m, m->is.horizon);
    status = cardan_run_start(run);
    if (status != 0) {
        (void)fmu_broke_down(m, "the start", status);
        return FMU_ERROR;
    }
    for (ptrdiff_t i = 0; i < run->ne; i++)
        m->armed_at[i] = -INFINITY;
    m->is.begun = 1, m->is.stale_inputs = 0;
    fmu_forget(m);
    return check_start(m);
}

/* New parameters in a run: the model is prepared anew, loops close again. */
static fmu_status adapt(fmu_instance *m)
{
    cardan_run *run = &m->at.run;
    fmu_status status = prepare(m);
    int closed;

    if (status != FMU_OK)
        return status;
    closed = fmu_find_jumps(m, run->t, run->t);
    if (closed == 0) {
        fmu_set_stops(m, m->is.horizon);
        cardan_restart(run);
        closed = cardan_close(run, run->t, run->y, 1);
    }
    fmu_forget(m);
    return closed == 0 ? FMU_OK : fmu_broke_down(m, "the parameters", closed);
}

/* Take what was set into account. */
fmu_status fmu_settle(fmu_instance *m)
{
    if (m->is.phase == FMU_INSTANTIATED)
        return fmu_say(m, FMU_ERROR, "values that are computed are there from Initialization Mode on.");
    if (!m->is.begun)
        return begin(m);
    return m->is.stale_parameters ? adapt(m) : FMU_OK;
}

fmu_status fmu_enter_initialization(fmu_instance *m)
{
    m->is.phase = FMU_INITIALIZING;
    m->at.run.t = m->is.start;
    m->is.begun = 0;
    return FMU_OK;
}

fmu_status fmu_exit_initialization(fmu_instance *m)
{
    fmu_status status = fmu_settle(m);
    int broken;

    if (status != FMU_OK)
        return status;
    m->is.phase = m->exchange ? FMU_EVENT_MODE : FMU_STEPPING;
    if (m->exchange)
        return FMU_OK;
    broken = fmu_happen(m);
    if (broken == CARDAN_EVENT)
        m->is.terminated = 1;
    else if (broken != 0)
        return fmu_broke_down(m, "the start", broken);
    return FMU_OK;
}
