/* Runs of an exported model from several states: side by side in vectors, or one after the other.
 *
 * Part of cardan. The files of lanes are compiled once more with -DCARDAN_LANES=4 (8, 2):
 *
 *     cc ... -DCARDAN_LANES=4 -c model_lanes.c simd_steps.c lane_*.c
 *     cc ... -DCARDAN_EXAMPLE_LANES -o example *.c model_lanes.o simd_steps.o lane_*.o -lm
 *
 *     cardan_simulations runs = {.common = {.end = 1}, .count = 10, .x = x, .x_end = x_end,
 *                                .answers = answers};
 *     void *memory = malloc(cardan_simulations_size(&cardan_scene, &cardan_scene_lanes, &runs));
 *     cardan_simulate_lanes(&cardan_scene, &cardan_scene_lanes, &runs, memory);
 *
 * Every run has steps of its own and the bits that it has alone, where both builds contract alike:
 * the README says under which flags. Without lanes (NULL), where the model has events, constraints or
 * jumps at times, at a given step, with a budget, and for methods that have no lanes, runs go one after
 * the other.
 */
#ifndef CARDAN_SIMULATE_LANES_H
#define CARDAN_SIMULATE_LANES_H

#include "simd_steps.h"
#include "simulate.h"

typedef struct cardan_simulations {
    cardan_simulation common; /* of all runs: method, tolerances, parameters, span, times of rows */
    ptrdiff_t count;
    const double *x; /* (count, nx) where they start */
    const double *r; /* (count, nr) inputs; NULL: those of `common` */

    /* what came of them */
    double *x_end;      /* (count, nx) */
    double *rows;       /* (count, time_count, 1 + nx + nr + ns); NULL if none are wanted */
    ptrdiff_t *answers; /* (count) as cardan_simulate has them */
    ptrdiff_t steps;    /* of all */
    ptrdiff_t side_by_side; /* how many runs went side by side; 1: one after the other */
} cardan_simulations;

extern const cardan_lane_build cardan_scene_lanes;

/* Bytes of memory that they take; 0: there is no such method. */
size_t cardan_simulations_size(const cardan_export *model, const cardan_lane_build *build,
                               const cardan_simulations *settings);
/* Do all runs. Returns CARDAN_DONE, or CARDAN_SIZE where there is no such method. */
int cardan_simulate_lanes(const cardan_export *model, const cardan_lane_build *build,
                          cardan_simulations *settings, void *memory);

#endif
