/* Runs over one and the same time, from state after state.
 *
 * Part of cardan. Caller owns all memory.
 */
#ifndef CARDAN_SHORT_RUNS_H
#define CARDAN_SHORT_RUNS_H

#include "run.h"

/* Of the numbers that are read nothing changes from run to run but the state. */
typedef struct cardan_short_runs {
    cardan_run *run;         /* works; its memory is one block, which begins at y */
    const cardan_run *begun; /* the same as every run begins; no events, no signals */
    ptrdiff_t length;        /* numbers of its memory */
    const real *r;           /* (nr) inputs */
    const real *s;           /* (ns) modes */
    real t;                  /* start */
    real far;                /* a time ahead, by which the first step is chosen */
    const real *stops;       /* (stop_count) of every run, the last one is the end */
    ptrdiff_t stop_count;
    const real *x;   /* (count, nx) states at the start */
    real *ends;      /* (count, nx) states at the end */
    ptrdiff_t count;
    ptrdiff_t done;  /* states until one broke down, which stays in `run` */
    ptrdiff_t going; /* 1: the run of state `done` is under way; 0 before the first call */
} cardan_short_runs;

int cardan_short_runs_go(cardan_short_runs *runs);

#endif
