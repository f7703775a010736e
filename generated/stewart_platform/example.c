/* Try it:  cc -std=c99 -O2 -fno-math-errno -ffp-contract=on -DCARDAN_EXAMPLE -o example *.c -lm && ./example */
#include "functions.h"
#include <stdio.h>
#include <stdlib.h>

/* so that *.c of this folder links with a main of yours */
#ifdef CARDAN_EXAMPLE

/* what may be chosen when this is compiled: -DSTEP=1e-3, -DRHO_INF=0.9 */
#ifndef STEP
#define STEP 0.0 /* [s]; 0: steps as the tolerances ask for */
#endif
#ifndef RHO_INF
#define RHO_INF 0.8 /* of "alpha": what is too fast for a step keeps this part of itself; at most 0.95 */
#endif

static void show(const char *name, const double *x, ptrdiff_t count)
{
    for (ptrdiff_t k = 0; k < count; k++)
        printf("%s[%d] = %.17Lg\n", name, (int)k, (long double)x[k]);
}

/* The first function of the model, where the scene starts. */
static int show_function(const cardan_export *model)
{
    const cardan_exported_function *f = model->functions;
    const ptrdiff_t nx = model->nq + model->nu + model->nz;
    void *prepared = malloc(cardan_prepared_size(model));
    double *zeros = calloc((size_t)(model->zeros + nx + f->out) + cardan_work_length(model), sizeof *zeros);
    double *x = zeros + model->zeros, *u = x + model->nq, *out = x + nx, *work = out + f->out;
    const cardan_in in = {.t = zeros, .q = x, .u = u, .z = u + model->nu, .s = model->s, .r = model->r,
                          .w = prepared, .udot = zeros, .zdot = zeros, .lam = zeros, .tau = zeros,
                          .wrench = zeros, .du = zeros, .q0 = x, .e = zeros, .v = zeros};
    int status = prepared && zeros ? cardan_prepare(model, model->p, prepared) : 1;

    if (status == 0)
        status = cardan_start_state(model, prepared, 0, model->r, x, work);
    if (status == 0)
        status = f->function(&in, out, work);
    if (status == 0)
        show(f->name, out, f->out);
    free(zeros);
    free(prepared);
    return status;
}

#ifdef CARDAN_SIMULATE_H
static void report_event(void *context, double t, const char *event)
{
    (void)context;
    printf("event at %.17Lg: %s\n", (long double)t, event);
}

/* One second of motion from where the scene starts, printed at its end. */
static int simulate(const cardan_export *model)
{
    cardan_simulation run = {.end = 1, .step = STEP, .rho_inf = RHO_INF, .on_event = report_event};
    void *memory = malloc(cardan_simulation_size(model, &run));
    const int status = memory ? cardan_simulate(model, &run, memory) : 1;

    if (memory) {
        show("x", run.x_end, model->nq + model->nu + model->nz);
        show("s", run.s_end, model->ns);
    }
    free(memory);
    return status == CARDAN_EVENT ? 0 : status;
}
#endif

#ifdef CARDAN_MOTION_GRADIENT_H
/* The cost of that second, and its gradient by the start, the parameters and the inputs. */
static int show_gradient(const cardan_export *model)
{
    cardan_gradient of = {.run = {.end = 1, .step = STEP}};
    void *memory = malloc(cardan_gradient_size(model, &of));
    const int status = memory ? cardan_gradient_of(model, &of, memory) : 1;

    if (status == 0) {
        show("cost", &of.cost, 1);
        show("by_x", of.by_x, model->nq + model->nu + model->nz);
        show("by_p", of.by_p, model->cost->np);
        show("by_r", of.by_r, model->nr);
    } else if (status == CARDAN_NO_GRADIENT)
        printf("no gradient: %s%s%s\n", of.event ? of.event : "", of.event ? ": " : "", of.refused);
    free(memory);
    return status == CARDAN_NO_GRADIENT ? 0 : status;
}
#endif

int main(void)
{
    int status = show_function(&cardan_scene);

#ifdef CARDAN_SIMULATE_H
    if (status == 0)
        status = simulate(&cardan_scene);
#endif
#ifdef CARDAN_MOTION_GRADIENT_H
    if (status == 0)
        status = show_gradient(&cardan_scene);
#endif
    if (status != 0)
        fprintf(stderr, "status %d; run.h says what that is\n", status);
    return status;
}

#endif
