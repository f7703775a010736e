/* Times of sparse.h: the least of several factorizations and solutions [s]. */
#define _POSIX_C_SOURCE 200809L
#include "sparse.h"
#include <time.h>

int sparse_times(const cardan_sparse *plan, const double *a, cardan_sparse_factors *f,
                 const double *b, double *x, int rounds, double *times);

static double now(void)
{
    struct timespec t;

    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

int sparse_times(const cardan_sparse *plan, const double *a, cardan_sparse_factors *f,
                 const double *b, double *x, int rounds, double *times)
{
    int status = 0;

    times[0] = times[1] = INFINITY;
    for (int round = 0; round < rounds; round++) {
        const double start = now();
        double factored, solved;

        status |= cardan_sparse_factor(plan, a, f);
        factored = now();
        cardan_sparse_solve(plan, f, 1, b, x);
        solved = now();
        times[0] = fmin(times[0], factored - start);
        times[1] = fmin(times[1], solved - factored);
    }
    return status;
}
