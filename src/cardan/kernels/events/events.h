/* What the files about events share, event_transition.c, search.c, event_bracketing.c, and what a run
 * calls of them. Part of cardan. */
#ifndef CARDAN_EVENTS_H
#define CARDAN_EVENTS_H

#include "run.h"

enum {
    cardan_samples = 5,      /* of every step, at even distances */
    cardan_most_samples = 24 /* with those where a value may dip below zero between them */
};

/* What is known of the events; every pointer but the last four has m entries. */
typedef struct cardan_board {
    ptrdiff_t m;   /* events */
    real *g;       /* values at t */
    real *armed;   /* 1: positive since it happened last */
    real *rounding;   /* what of a value may be rounding of times */
    real *reach;   /* largest value seen */
    real *last;    /* when it happened last */
    real *close;   /* how often in a row within no time */
    real *since;   /* start of the present burst */
    real *burst;   /* how often since then */
    real *root;   /* when it happens in the present interval, NaN: not */
    real *probe;   /* values at a time that is looked at */
    real *values;  /* (samples, m) */
    real *theta;   /* (samples) where in the step, 0 ... 1 */
    real *y;       /* (n) state at a time that is looked at */
    real *out;     /* (nx + ns) result of a transition */
} cardan_board;

/* event_transition.c and search.c, for the run */
ptrdiff_t cardan_board_length(const cardan_run *run);
ptrdiff_t cardan_rank_length(const cardan_run *run);
ptrdiff_t cardan_crossing_length(const cardan_run *run);
void cardan_events_clock(cardan_run *run);
int cardan_events_start(cardan_run *run);
int cardan_events_seek(cardan_run *run);
int cardan_events_apply(cardan_run *run);
int cardan_events_full(const cardan_run *run);
int cardan_events_due(const cardan_run *run);
int cardan_events_tick(cardan_run *run);

/* event_transition.c */
cardan_board cardan_board_of(const cardan_run *run);
int cardan_event_values(cardan_run *run, real t, const real *y, real *g);
real cardan_event_threshold(const cardan_board *at, ptrdiff_t i);
int cardan_is_binding(const cardan_run *run, ptrdiff_t i);
void cardan_arm(const cardan_board *at, ptrdiff_t i, real value);
real *cardan_note(cardan_run *run, real t, const real *y);

/* event_bracketing.c */
int cardan_samples_of(cardan_run *run, const cardan_board *at, ptrdiff_t *count);

#endif
