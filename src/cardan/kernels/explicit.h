/* What explicit Runge-Kutta methods share: stages, the loop of trials, quaternions in charts.
 *
 * Part of cardan. Caller owns all memory.
 *
 * A method works on y (n) as it is, or, where the run is `charted`, in the chart of the state its
 * step starts from: the entries of a quaternion then hold (0, theta), theta the rotation vector in
 * body axes since the start of the step. Everything else stays what it is.
 */
#ifndef CARDAN_EXPLICIT_H
#define CARDAN_EXPLICIT_H

#include "run.h"

/* derivative s of `run` at the state that the derivatives before it lead to */
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
    int order; /* of the error estimate in the step */
    int ends;  /* derivative at the end of the step, -1 if the stages have none */
    int (*stages)(cardan_run *run, real h);                     /* k, and the end in `trial` */
    real (*error)(cardan_run *run, real h, const real *against); /* in units of the tolerance */
    real (*part)(const cardan_run *run, const real *against, ptrdiff_t i); /* what entry i adds */
    int other; /* a derivative at the time of the end, at another state */
    real bound; /* of h times the rate of the fastest decay, beyond which errors grow */
    real (*state)(const cardan_run *run, real h, ptrdiff_t i); /* entry i of that state */
} cardan_explicit;

int cardan_fixed_init(cardan_run *run);
real cardan_grid(const cardan_run *run);
int cardan_explicit_step(cardan_run *run, const cardan_explicit *method);
void cardan_hermite(cardan_run *run, const real *first, real *last);

/* chart.c */
const real *cardan_enter(cardan_run *run, const real *y, const real *f, real *first);
int cardan_slope(cardan_run *run, real t, const real *y, real *f);
void cardan_leave(cardan_run *run, real *y);
void cardan_rise(const cardan_run *run, const real *y, real *rise);
const real *cardan_against(cardan_run *run, const real *y);
void cardan_arrive(cardan_run *run, real *rise, real *last);

#endif
