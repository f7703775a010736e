/* A function written by cardan in a loop over states, and what the processor can do at most. */
#define _POSIX_C_SOURCE 199309L
#include "cardan.h"
#include <time.h>

typedef int (*function)(const cardan_in *in, real *out, real *work);

/* the function, what does not change from state to state, and whose lengths change */
typedef struct {
    function f;
    cardan_in in;
    real *work;
    int nq, nu;
} peer;

static double since(const struct timespec *start)
{
    struct timespec stop;
    clock_gettime(CLOCK_MONOTONIC, &stop);
    return (double)(stop.tv_sec - start->tv_sec) + 1e-9 * (double)(stop.tv_nsec - start->tv_nsec);
}

/* Seconds per call; results of every state in rows of `size` numbers. */
double peer_loop(void *self, int which, const double *q, const double *u, const double *x,
                 double *out, int size, int count, int repeats)
{
    peer *p = self;
    struct timespec start = {0, 0};
    /* the first round fills `out` and is not timed */
    for (int r = -1; r < repeats; ++r) {
        if (r == 0) clock_gettime(CLOCK_MONOTONIC, &start);
        for (int k = 0; k < count; ++k) {
            p->in.q = q + k * p->nq;
            p->in.u = u + k * p->nu;
            if (which == 1)
                p->in.udot = x + k * p->nu;
            else
                p->in.tau = x + k * p->nu;
            p->f(&p->in, out + k * size, p->work);
        }
    }
    return since(&start) / repeats / count;
}

#if defined(__AVX512F__)
enum { LANES = 8 };
#elif defined(__AVX__)
enum { LANES = 4 };
#else
enum { LANES = 2 };
#endif
typedef double vector __attribute__((vector_size(8 * LANES)));

/* Chains of multiply-adds enough to keep every unit busy; 1e9 operations per second. */
#define PEAK(name, type, zero, width)                                                              \
    double name(int rounds)                                                                        \
    {                                                                                              \
        type a[12], m = zero + 0.999999, c = zero + 1e-7;                                          \
        for (int i = 0; i < 12; ++i) a[i] = zero + 0.1 * i;                                        \
        struct timespec start;                                                                     \
        clock_gettime(CLOCK_MONOTONIC, &start);                                                    \
        for (int r = 0; r < rounds; ++r) {                                                         \
            a[0] = a[0] * m + c, a[1] = a[1] * m + c, a[2] = a[2] * m + c, a[3] = a[3] * m + c;    \
            a[4] = a[4] * m + c, a[5] = a[5] * m + c, a[6] = a[6] * m + c, a[7] = a[7] * m + c;    \
            a[8] = a[8] * m + c, a[9] = a[9] * m + c, a[10] = a[10] * m + c;                       \
            a[11] = a[11] * m + c;                                                                 \
        }                                                                                          \
        const double passed = since(&start);                                                       \
        type sum = a[0];                                                                           \
        for (int i = 1; i < 12; ++i) sum += a[i];                                                  \
        volatile type sink = sum;                                                                  \
        (void)sink;                                                                                \
        return 2e-9 * 12.0 * width * rounds / passed;                                              \
    }

PEAK(peak_scalar, double, 0.0, 1)
PEAK(peak_vector, vector, (vector){0}, LANES)
int peak_lanes(void) { return LANES; }
