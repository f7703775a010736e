/* A run of an exported model: what a program asks for, and what comes of it.
 *
 * Part of cardan. One second from where the scene starts, with the first method of the export:
 *
 *     cardan_simulation run = {.end = 1};
 *     void *memory = malloc(cardan_simulation_size(&cardan_scene, &run));
 *     int status = cardan_simulate(&cardan_scene, &run, memory);
 */
#ifndef CARDAN_SIMULATE_H
#define CARDAN_SIMULATE_H

#include "export.h"
#include "run.h"

/* What is NULL or 0 is as the scene and the method have it. */
typedef struct cardan_simulation {
    const char *method;            /* one of those that were exported, such as "dop853" */
    const double *p, *x, *s, *r;   /* parameters; x = [q, u, z] and discrete states at the start; inputs */
    double start, end;             /* [s] */
    double step;                   /* of every step [s]; 0: as the tolerances ask for */
    double rtol, atol;
    double rho_inf;                /* of "alpha": what is too fast for a step keeps this part of itself */
    const double *times;           /* (time_count) of the rows, ascending from start to end */
    ptrdiff_t time_count;
    ptrdiff_t budget;              /* most steps of the run, after which it ends with CARDAN_MORE; 0: no limit */
    double *rows;                  /* (time_count, 1 + nx + nr + ns): t, x, r, s */
    void (*on_event)(void *context, double t, const char *event); /* told of every event */
    /* writes entries of r, such as forces of your own, at every evaluation; not 0 ends the run */
    int (*inputs)(void *context, real t, const real *x, real *r);
    void *context;

    /* what came of it; x and s lie in the memory of the run */
    ptrdiff_t row_count, steps;
    double t;                      /* where it ended */
    const double *x_end, *s_end;
} cardan_simulation;

/* A run laid out in the memory of the caller, for programs that go on from where it ended. */
typedef struct cardan_laid_run {
    cardan_run run;
    void *prepared;      /* the model at the parameters: cardan_prepare fills it in */
    real *stops;         /* room for all jumps of a span, and its end */
    real *options, *memory, *jumps_work;
    size_t state_offset; /* bytes from the start of the memory to what is the state of the run */
} cardan_laid_run;

/* Lay out a run that has not begun; the state is not entered and nothing is prepared. Returns bytes of
 * memory, 0: there is no such method. NULL: that is only measured. */
size_t cardan_lay_run(const cardan_export *model, const cardan_simulation *settings, void *memory,
                      cardan_laid_run *at);

/* Bytes of memory, aligned as malloc does, that the run takes; 0: there is no such method. */
size_t cardan_simulation_size(const cardan_export *model, const cardan_simulation *settings);
/* A run that is ready to start; without memory its sizes alone. Returns a status. */
int cardan_simulation_open(const cardan_export *model, const cardan_simulation *settings,
                           cardan_run *run, void *memory);
/* Run. Returns an answer of run.h: CARDAN_DONE, CARDAN_EVENT where an event ended it, another one
 * where it broke down. */
int cardan_simulate(const cardan_export *model, cardan_simulation *settings, void *memory);

#endif
