/* Steps of MuJoCo in a loop over states. The steps come as addresses: no header is needed. */
#define _POSIX_C_SOURCE 199309L
#include <string.h>
#include <time.h>

enum { FORWARD, INVERSE, MASS, DERIVATIVES, FUNCTIONS, STEPS = 12 };
/* difference of its slopes: their error is about 1e-6 of the largest */
static const double difference = 1e-6;
typedef void (*step)(const void *model, void *data);

/* what is called one after the other, and where the numbers of a state and its results lie */
typedef struct {
    const void *model;
    void *data;
    step steps[FUNCTIONS][STEPS]; /* until NULL */
    step accelerate, constrain; /* constrain: NULL for trees */
    void (*rne)(const void *model, void *data, int accelerations, double *result);
    void (*full)(const void *model, const void *data, double *result);
    void (*slopes)(const void *model, void *data, double step, unsigned char actuation,
                   double *by_q, double *by_v, double *by_a, double *sensors_by_q,
                   double *sensors_by_v, double *sensors_by_a, double *mass_by_q);
    void (*solve)(const void *model, void *data, double *x, const double *y, int count);
    double *qpos, *qvel, *force, *qacc, *bias;
    const double *result;
    double *slope; /* 4 nv^2 */
    int nq, nv;
} peer;

/* Accelerations by q and u in rows of them: differences of inverse dynamics at the accelerations
   of these forces, which count as applied in both, times -1 / M. */
static void differentiate(const peer *p, double *out)
{
    const int n = p->nv, block = n * n;
    double *by_q = p->slope, *by_v = by_q + block, *solved = by_v + block;
    p->rne(p->model, p->data, 0, p->bias);
    p->accelerate(p->model, p->data);
    memcpy(p->qacc, p->result, sizeof(double) * (size_t)n);
    p->slopes(p->model, p->data, difference, 0, by_q, by_v, NULL, NULL, NULL, NULL, NULL);
    /* the factor is that of the last difference */
    for (const step *s = p->steps[DERIVATIVES]; *s; ++s) (*s)(p->model, p->data);
    p->solve(p->model, p->data, solved, by_q, 2 * n);
    /* theirs have a row for each variable */
    for (int part = 0; part < 2; ++part)
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j)
                out[part * block + i * n + j] = -solved[part * block + j * n + i];
}

static void once(const peer *p, int function, const double *q, const double *u, const double *x,
                 double *out)
{
    memcpy(p->qpos, q, sizeof(double) * (size_t)p->nq);
    memcpy(p->qvel, u, sizeof(double) * (size_t)p->nv);
    const int forces = function == FORWARD || function == DERIVATIVES;
    memcpy(forces ? p->force : p->qacc, x, sizeof(double) * (size_t)p->nv);
    for (const step *s = p->steps[function]; *s; ++s) (*s)(p->model, p->data);
    if (function == DERIVATIVES) differentiate(p, out);
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
