/* Shared parts of the explicit Runge-Kutta methods: stages, trial loop, quaternions in charts.
 *
 * Part of cardan. Caller owns all memory.
 *
 * A method integrates y (n) directly. If the run is `charted`, it works in a chart around the state
 * at the start of the step: the four entries of a quaternion then contain (0, theta), where theta
 * is the rotation vector in body axes since the start of the step. Other entries do not change.
 */
#ifndef CARDAN_EXPLICIT_H
#define CARDAN_EXPLICIT_H

#include "run.h"

/* stage s: derivative at t + C[s] h and y + h sum, where sum combines the earlier stages */
#define STAGE(s, sum)                                                                              \
    do {                                                                                           \
        for (ptrdiff_t i = 0; i < n; i++)                                                          \
            trial[i] = y[i] + h * (sum);                                                           \
        status = cardan_slope(run, t + C[s] * h, trial, k + (s) * n);                              \
        if (status != 0)                                                                           \
            return status;                                                                         \
    } while (0);
#define K(j) k[(j) * n + i]

/* An adaptive explicit method. */
typedef struct cardan_explicit {
    int order; /* the error estimate behaves like h^order */
    int ends;  /* index of the stage at the end of the step (FSAL), -1 if there is none */
    int (*stages)(cardan_run *run, real h);                     /* fill k and `trial` */
    real (*error)(cardan_run *run, real h, const real *against); /* in units of the tolerance */
    real (*part)(const cardan_run *run, const real *against, ptrdiff_t i); /* share of entry i */
    int other; /* index of a stage at the end time but at another state, for the stiffness test */
    real bound; /* stability limit of h |lambda| on the negative real axis */
    real (*state)(const cardan_run *run, real h, ptrdiff_t i); /* entry i of the state of `other` */
} cardan_explicit;

int cardan_fixed_init(cardan_run *run);
real cardan_grid(const cardan_run *run);
int cardan_explicit_step(cardan_run *run, const cardan_explicit *method);
void cardan_hermite(cardan_run *run, const real *first, real *last);
int cardan_dense_later(cardan_run *run, ptrdiff_t count, const real *t, const real *y,
                       const real *sources, real *spreads);

/* chart.c */
const real *cardan_enter(cardan_run *run, const real *y, const real *f, real *first);
int cardan_slope(cardan_run *run, real t, const real *y, real *f);
void cardan_leave(cardan_run *run, real *y);
void cardan_rise(const cardan_run *run, const real *y, real *rise);
const real *cardan_against(cardan_run *run, const real *y);
void cardan_arrive(cardan_run *run, real *rise, real *last);

#endif
