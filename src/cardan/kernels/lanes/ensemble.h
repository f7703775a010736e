/* Many runs of one model by one thread: its queue, its lanes, its answers.
 *
 * Part of cardan. Caller owns all memory. Every run starts from copies of a record and its memory
 * as they were before the first one, so that nothing of a run is left for the next.
 */
#ifndef CARDAN_ENSEMBLE_H
#define CARDAN_ENSEMBLE_H

#include "simd_steps.h"
#include "run.h"

/* Numbers of a run that a pointer in its record shall point to, such as prepared parameters. */
typedef struct cardan_run_pointer {
    ptrdiff_t offset;   /* of the pointer in cardan_run [bytes] */
    const double *base; /* (count, stride) */
    ptrdiff_t stride;
} cardan_run_pointer;

/* One after the other in one lane: the record at work, and how each run begins. */
typedef struct cardan_lane {
    cardan_run *run;
    double *memory; /* what of its memory a run may leave behind: all that follows the stages */
    const cardan_run *fresh;
    const double *fresh_memory; /* (memory_length) */
    ptrdiff_t number;           /* of the run under way, -1 if there is none */
    ptrdiff_t parked;           /* whether an idle lane does what another one does */
} cardan_lane;

typedef struct cardan_ensemble {
    cardan_lane *lanes;
    cardan_simd *simd; /* NULL: one lane, one run after the other */
    ptrdiff_t (*attempt)(cardan_simd *a); /* cardan_simd_try of its lanes */
    ptrdiff_t (*move)(cardan_simd *a);    /* cardan_simd_move */
    ptrdiff_t lane_count, memory_length;

    /* the runs */
    const double *x0;      /* (count, nx) where they start */
    const double *r;       /* (count, nr) constant inputs */
    const cardan_run_pointer *pointers; /* (own_count) */
    const double *w;       /* (count, w_size) of rhs, for lanes with parameters of their own */
    ptrdiff_t count, pointer_count, w_size;
    ptrdiff_t timed; /* 1: inputs depend on time */

    /* answers */
    double *rows;     /* (count, capacity, cardan_row_width(run)), NULL if none are wanted */
    double *x;        /* (count, nx) where they end */
    double *numbers;  /* (count, 4): t, steps, rejections, evaluations */
    cardan_run *ends; /* (count) records, of those that did not reach their end */
    ptrdiff_t *answers; /* (count) */

    ptrdiff_t next, finished;
    ptrdiff_t vacant; /* 1: a lane is idle, and it is not known what it shall do */
    volatile ptrdiff_t stop; /* set by anybody at any time */
} cardan_ensemble;

/* Do all runs, or those that are done when `stop` is set: the answers of others are STOPPED where
 * a run was under way, and stay what they were where it has not begun. */
void cardan_ensemble_drive(cardan_ensemble *e);

#endif
