/* Gradient of a cost of a motion of an exported model: see motion_gradient.h.
 *
 * Part of cardan. Caller owns all memory.
 */
#include "motion_gradient.h"
#include "adjoint.h"
#include <math.h>

enum { USUAL_STEPS = 10000, MOST_PASSES = 64, SOME_STEPS = 1000000 };
/* derivatives that grow by so much are of no use: no digit of such a motion is known */
static const real GROWTH = 1e12;

/* A run with what sweeps over it. */
typedef struct sweep {
    cardan_run run;
    cardan_steps steps;
    cardan_adjoint adjoint;
    const void *prepared;
    real *rows, *passes, *start, *before;
    ptrdiff_t capacity;
    real nodes[CARDAN_MOST_STAGES], weights[CARDAN_MOST_STAGES];
    real matrix[CARDAN_MOST_STAGES * CARDAN_MOST_STAGES];
} sweep;

static const cardan_exported_method *method_of(const cardan_export *model, const char *name)
{
    for (ptrdiff_t k = 0; k < model->method_count; k++)
        if (!name || strcmp(name, model->methods[k].name) == 0)
            return &model->methods[k];
    return NULL;
}

ptrdiff_t cardan_gradient_steps(const cardan_export *model, const cardan_gradient *of)
{
    const cardan_exported_method *method = method_of(model, of->run.method);
    const double step = of->run.step > 0 ? of->run.step : method ? method->step : 0;
    const double count = step > 0 ? fabs(of->run.end - of->run.start) / step : USUAL_STEPS;

    if (of->most_steps > 0)
        return of->most_steps;
    /* steps end where a model jumps in time too */
    return count < 1e9 ? (ptrdiff_t)count + USUAL_STEPS / 100 : (ptrdiff_t)1e9;
}

/* The function with a number, NULL where the number is -1. */
static cardan_call call_of(const cardan_export *model, const sweep *at, ptrdiff_t number)
{
    cardan_call call = {NULL, NULL};

    if (number >= 0) {
        call.function = model->functions[number].function;
        call.w = cardan_prepared_w(model, at->prepared, number);
    }
    return call;
}

/* Connect the sweep with the functions of the model. */
static void connect(const cardan_export *model, sweep *at)
{
    const cardan_exported_cost *cost = model->cost;
    cardan_adjoint *adjoint = &at->adjoint;

    adjoint->rates = call_of(model, at, cost->rates);
    adjoint->close_position = call_of(model, at, cost->close_position);
    adjoint->close_velocity = call_of(model, at, cost->close_velocity);
    adjoint->integrand = call_of(model, at, cost->integrand_product);
    adjoint->integrand_value = call_of(model, at, cost->integrand);
    adjoint->np = cost->np;
    at->steps.jacobian = at->run.rhs_jacobian;
}

/* Lay out everything behind the memory of the run; NULL: that is only measured. Returns numbers. */
static size_t lay(const cardan_export *model, const cardan_exported_method *method, ptrdiff_t steps,
                  real *block, sweep *at)
{
    const ptrdiff_t stages = at->steps.stages, nx = at->run.nx, np = model->cost->np;
    cardan_steps *s = &at->steps;
    cardan_adjoint *a = &at->adjoint;
    ptrdiff_t used = 0;

    at->capacity = steps + 1;
    at->rows = cardan_reserve(block, &used, at->capacity * cardan_row_width(&at->run));
    at->passes = cardan_reserve(block, &used, at->run.rates > 0 ? 3 * MOST_PASSES : 0);
    at->start = cardan_reserve(block, &used, nx);
    at->before = cardan_reserve(block, &used, nx);
    /* those of a step over a place where branches meet are more than the table has */
    s->states = cardan_reserve(block, &used, CARDAN_MOST_STAGES * nx);
    s->slopes = cardan_reserve(block, &used, CARDAN_MOST_STAGES * nx);
    s->open = cardan_reserve(block, &used, CARDAN_MOST_STAGES * nx);
    s->end = cardan_reserve(block, &used, nx);
    s->place = cardan_reserve(block, &used, nx);
    s->lengths = cardan_reserve(block, &used, stages * at->run.quaternion_count + 1);
    s->work = cardan_reserve(block, &used, (ptrdiff_t)cardan_work_length(model) + 1);
    a->lam = cardan_reserve(block, &used, nx);
    a->by_p = cardan_reserve(block, &used, np);
    a->by_s = cardan_reserve(block, &used, at->run.ns);
    a->by_r = cardan_reserve(block, &used, at->run.nr);
    a->by_coefficients = cardan_reserve(block, &used, 4);
    a->cost = cardan_reserve(block, &used, 1);
    a->pulled = cardan_reserve(block, &used, CARDAN_MOST_STAGES * nx);
    a->weights = cardan_reserve(block, &used, CARDAN_MOST_STAGES * nx);
    a->v = cardan_reserve(block, &used, nx + at->run.positions + at->run.rates + 1);
    a->out = cardan_reserve(block, &used, nx + at->run.ns + at->run.nr + np);
    s->system = cardan_reserve(block, &used, method->coupled ? method->coupled->length(&at->run, stages) : 0);
    return (size_t)used;
}

/* Bytes of the run; fills in its sizes. 0: there is no such method or no gradient. */
static size_t measure(const cardan_export *model, const cardan_gradient *of, sweep *at)
{
    const size_t size = cardan_simulation_size(model, &of->run);
    const cardan_exported_method *method = method_of(model, of->run.method);

    *at = (sweep){.prepared = NULL};
    if (size == 0 || !model->cost || !method || !method->tableau)
        return 0;
    at->steps.stages = method->tableau(at->nodes, at->weights, at->matrix);
    at->steps.nodes = at->nodes, at->steps.weights = at->weights, at->steps.matrix = at->matrix;
    at->steps.coupled = method->coupled;
    at->steps.kind = method->coupled ? CARDAN_COUPLED : CARDAN_EXPLICIT;
    return cardan_simulation_open(model, &of->run, &at->run, NULL) == 0 ? size : 0;
}

size_t cardan_gradient_size(const cardan_export *model, const cardan_gradient *of)
{
    sweep at;
    const size_t size = measure(model, of, &at);

    return size == 0 ? 0
                     : size + sizeof(real) * lay(model, method_of(model, of->run.method),
                                                 cardan_gradient_steps(model, of), NULL, &at);
}

/* The event that changed the run, NULL if there was none. */
static const char *event_of(const cardan_export *model, const cardan_run *run)
{
    const ptrdiff_t width = 1 + run->ne + 2 * (run->nx + run->ns);

    for (ptrdiff_t k = 0; k < run->log_count; k++)
        for (ptrdiff_t i = 0; i < run->ne; i++)
            if (run->log[k * width + 1 + i] != 0 && run->kinds[i] != CARDAN_MARK)
                return model->events[i].name;
    return NULL;
}

/* From the start to the end, with a row at the end of every step. */
static int drive(const cardan_export *model, cardan_gradient *of, sweep *at)
{
    cardan_run *run = &at->run;
    int status;

    run->times = NULL, run->time_count = 0;
    run->rows = at->rows, run->capacity = at->capacity;
    run->passes = at->passes, run->pass_capacity = run->rates > 0 ? MOST_PASSES : 0;
    run->budget = of->run.budget > 0 ? of->run.budget : SOME_STEPS;
    for (ptrdiff_t i = 0; i < run->nx; i++)
        at->start[i] = run->y[i];
    status = cardan_run_start(run);
    if (status == 0)
        status = cardan_run_drive(run);
    while (status == CARDAN_MORE && of->run.budget <= 0)
        status = cardan_run_drive(run);
    of->event = event_of(model, run);
    of->run.steps = run->steps, of->run.row_count = run->count, of->run.t = run->t;
    of->run.x_end = of->x_end = run->y, of->run.s_end = run->s;
    return status;
}

/* Begin with the cost at the end, and its gradient there. */
static int begin(const cardan_export *model, const sweep *at)
{
    const cardan_run *run = &at->run;
    const real *row = at->rows + (run->count - 1) * cardan_row_width(run);
    const real *by_s = at->adjoint.out + run->nx, *by_r = by_s + run->ns, *by_p = by_r + run->nr;
    const cardan_call value = call_of(model, at, model->cost->final);
    const cardan_call product = call_of(model, at, model->cost->final_product);
    const real one = 1;
    cardan_in in = {.t = row, .q = row + 1, .u = row + 1 + run->nq, .z = row + 1 + run->nq + run->nu,
                    .s = run->s, .r = run->r, .tau = run->zeros, .wrench = run->zeros, .v = &one};
    int status;

    if (!value.function)
        return 0;
    in.w = value.w;
    status = value.function(&in, at->adjoint.cost, at->steps.work);
    in.w = product.w;
    status = status != 0 ? status : product.function(&in, at->adjoint.out, at->steps.work);
    for (ptrdiff_t i = 0; i < run->nx; i++)
        at->adjoint.lam[i] = at->adjoint.out[i];
    for (ptrdiff_t i = 0; i < run->nr; i++)
        at->adjoint.by_r[i] = by_r[i];
    for (ptrdiff_t i = 0; i < at->adjoint.np; i++)
        at->adjoint.by_p[i] = by_p[i];
    return status == 0 ? 0 : CARDAN_MODEL;
}

/* Size of the largest of n numbers; infinite where one is not finite. */
static real largest(const real *x, ptrdiff_t n)
{
    real most = 0;

    for (ptrdiff_t i = 0; i < n; i++)
        most = x[i] - x[i] == 0 ? fmax(most, fabs(x[i])) : INFINITY;
    return most;
}

/* Sweep back over the steps, then over what moved the start onto the constraints. */
static int pull(sweep *at)
{
    cardan_steps *steps = &at->steps;
    const cardan_run *run = &at->run;
    real *lam = at->adjoint.lam;
    int status;

    for (ptrdiff_t i = 0; i < run->nx; i++)
        at->before[i] = lam[i];
    steps->rows = at->rows, steps->count = run->count;
    status = cardan_adjoint_sweep(&at->adjoint);
    if (status != 0)
        return status;
    /* as at the end of a step: positions are those behind the projection where speeds are projected */
    for (ptrdiff_t i = 0; i < run->nx; i++)
        steps->end[i] = at->start[i];
    cardan_normalize(run, steps->end);
    for (ptrdiff_t i = 0; i < run->nx; i++)
        steps->place[i] = i < run->nq ? at->rows[1 + i] : steps->end[i];
    status = cardan_pull_projection(&at->adjoint, at->rows[0], steps->end, steps->place, 1, lam);
    /* a quaternion was scaled before that */
    for (ptrdiff_t k = 0; k < run->quaternion_count; k++) {
        const real *q = at->start + run->quaternions[k];
        for (int j = 0; j < 4; j++)
            lam[run->quaternions[k] + j] /= sqrt(cardan_dot(q, q, 4));
    }
    return status;
}

/* Say why there is no gradient. */
static int refuse(cardan_gradient *of, const char *why)
{
    of->refused = why;
    return CARDAN_NO_GRADIENT;
}

int cardan_gradient_of(const cardan_export *model, cardan_gradient *of, void *memory)
{
    const cardan_exported_method *method = method_of(model, of->run.method);
    sweep at;
    const size_t size = measure(model, of, &at);
    int status = size == 0 ? CARDAN_SIZE : cardan_simulation_open(model, &of->run, &at.run, memory);

    of->refused = of->event = NULL;
    if (status != 0)
        return status;
    if (of->run.inputs)
        return refuse(of, "the derivative of a function of inputs is not known: write it into the scene");
    (void)lay(model, method, cardan_gradient_steps(model, of), (real *)((char *)memory + size), &at);
    /* what is prepared stands at the start of the memory of a run */
    at.prepared = memory;
    at.steps.run = &at.run, at.adjoint.steps = &at.steps;
    connect(model, &at);
    for (ptrdiff_t i = 0; i < at.run.nx; i++)
        at.adjoint.lam[i] = 0;
    for (ptrdiff_t i = 0; i < at.adjoint.np; i++)
        at.adjoint.by_p[i] = 0;
    for (ptrdiff_t i = 0; i < at.run.nr; i++)
        at.adjoint.by_r[i] = 0;
    for (ptrdiff_t i = 0; i < at.run.ns; i++)
        at.adjoint.by_s[i] = 0;
    *at.adjoint.cost = 0;
    status = drive(model, of, &at);
    if (of->event)
        return refuse(of, "an event changed the motion, whose gradient needs how its time moves: take "
                          "model.gradient of cardan, or end the run before it");
    if (status != CARDAN_DONE)
        return status;
    if (at.run.rates > 0 && at.run.pass_count > MOST_PASSES)
        return refuse(of, "the motion passes too many places where branches meet: take a shorter one");
    status = begin(model, &at);
    status = status == 0 ? pull(&at) : status;
    /* a cost may have no derivative at the end */
    if (status != 0 || largest(at.adjoint.lam, at.run.nx) == INFINITY
        || largest(at.adjoint.by_p, at.adjoint.np) == INFINITY
        || largest(at.adjoint.by_r, at.run.nr) == INFINITY)
        return refuse(of, "a derivative has no finite value within a step, or stages do not settle: take "
                          "tighter tolerances");
    if (!(largest(at.adjoint.lam, at.run.nx) <= GROWTH * largest(at.before, at.run.nx))
        && largest(at.before, at.run.nx) > 0)
        return refuse(of, "derivatives grow by more than 1e12: the motion is chaotic, or steps are too "
                          "long for a stiff force. Take radau, or a shorter time");
    of->cost = *at.adjoint.cost;
    of->by_x = at.adjoint.lam, of->by_p = at.adjoint.by_p, of->by_r = at.adjoint.by_r;
    return CARDAN_DONE;
}
