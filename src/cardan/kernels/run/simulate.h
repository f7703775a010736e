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
    void *context;

    /* what came of it; x and s lie in the memory of the run */
    ptrdiff_t row_count, steps;
    double t;                      /* where it ended */
    const double *x_end, *s_end;
} cardan_simulation;

/* Bytes of memory, aligned as malloc does, that the run takes; 0: there is no such method. */
size_t cardan_simulation_size(const cardan_export *model, const cardan_simulation *settings);
/* Run. Returns an answer of run.h: CARDAN_DONE, CARDAN_EVENT where an event ended it, another one
 * where it broke down. */
int cardan_simulate(const cardan_export *model, cardan_simulation *settings, void *memory);

#endif
