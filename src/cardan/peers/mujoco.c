/* Steps of MuJoCo in a loop over states. The steps come as addresses: no header is needed. */
#define _POSIX_C_SOURCE 199309L
#include <string.h>
#include <time.h>

enum { FORWARD, INVERSE, MASS, FUNCTIONS, STEPS = 12 };
typedef void (*step)(const void *model, void *data);

/* what is called one after the other, and where the numbers of a state and its results lie */
typedef struct {
    const void *model;
    void *data;
    step steps[FUNCTIONS][STEPS]; /* until NULL */
    step accelerate, constrain; /* constrain: NULL for trees */
    void (*rne)(const void *model, void *data, int accelerations, double *result);
    void (*full)(const void *model, const void *data, double *result);
    double *qpos, *qvel, *force, *qacc, *bias;
    const double *result;
    int nq, nv;
} peer;

static void once(const peer *p, int function, const double *q, const double *u, const double *x,
                 double *out)
{
    memcpy(p->qpos, q, sizeof(double) * (size_t)p->nq);
    memcpy(p->qvel, u, sizeof(double) * (size_t)p->nv);
    memcpy(function == FORWARD ? p->force : p->qacc, x, sizeof(double) * (size_t)p->nv);
    for (const step *s = p->steps[function]; *s; ++s) (*s)(p->model, p->data);
    if (function == INVERSE) p->rne(p->model, p->data, 1, out);
    if (function == FORWARD) {
        p->rne(p->model, p->data, 0, p->bias);
        p->accelerate(p->model, p->data);
        if (p->constrain) p->constrain(p->model, p->data);
    }
}

/* Seconds per call; results of every state in rows of `size` numbers. */
double peer_loop(void *self, int function, const double *q, const double *u, const double *x,
                 double *out, int size, int count, int repeats)
{
    const peer *p = self;
    struct timespec start, stop;
    for (int k = 0; k < count; ++k) {
        double *answer = out + k * size;
        once(p, function, q + k * p->nq, u + k * p->nv, x + k * p->nv, answer);
        if (function == FORWARD) memcpy(answer, p->result, sizeof(double) * (size_t)size);
        if (function == MASS) p->full(p->model, p->data, answer);
    }
    clock_gettime(CLOCK_MONOTONIC, &start);
    for (int r = 0; r < repeats; ++r)
        for (int k = 0; k < count; ++k)
            once(p, function, q + k * p->nq, u + k * p->nv, x + k * p->nv, out + k * size);
    clock_gettime(CLOCK_MONOTONIC, &stop);
    const double passed =
        (double)(stop.tv_sec - start.tv_sec) + 1e-9 * (double)(stop.tv_nsec - start.tv_nsec);
    return passed / repeats / count;
}
