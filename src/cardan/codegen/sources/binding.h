/* Calls of exported functions from programs that hand over arrays of their own.
 *
 * Part of cardan. Caller owns all memory; no state is kept. A unit quaternion counts by its
 * direction: it is brought to length 1 first, and columns of derivatives along it are those of the
 * function of what was handed over.
 */
#ifndef CARDAN_BINDING_H
#define CARDAN_BINDING_H

#include "export.h"

/* An input block: where its pointer stands in cardan_in, how many numbers it has, of which argument
 * of the caller it is a part, and from where on. */
typedef struct cardan_bound_block {
    size_t field;
    ptrdiff_t count, argument, start;
} cardan_bound_block;

/* A function with the blocks that it takes. */
typedef struct cardan_bound {
    const char *name;
    cardan_function function;
    void (*prepare)(const wreal *p, wreal *w);
    ptrdiff_t out, work, w; /* lengths */
    const cardan_bound_block *blocks;
    ptrdiff_t block_count, argument_count; /* parameters are the argument behind them */
    ptrdiff_t longest; /* of the blocks and the parameters */
    /* columns of a derivative along the coordinates: where they begin in out, how many rows they
     * have, how far it is from row to row; 0 rows: there are none */
    ptrdiff_t columns, rows, stride;
    int is_hessian; /* its rows are differentiated by the coordinates as its columns are */
} cardan_bound;

/* How many numbers of memory a call takes. */
static inline size_t cardan_bound_memory(const cardan_export *model, const cardan_bound *f)
{
    return (size_t)(f->longest + model->nq + f->w + f->work + 1);
}

/* Prepare parameters p; NULL stands for zeros. */
static inline void cardan_bound_prepare(const cardan_export *model, const cardan_bound *f,
                                        const double *p, double *memory)
{
    memset(memory, 0, (size_t)f->longest * sizeof *memory);
    f->prepare(p ? p : memory, memory + f->longest + model->nq);
}

static inline double cardan_bound_length(const double *x)
{
    return sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + x[3] * x[3]);
}

/* Call what is prepared: `arguments` point to what the caller has, NULL stands for zeros. */
static inline int cardan_bound_call(const cardan_export *model, const cardan_bound *f,
                                    const double *const *arguments, double *out, double *memory)
{
    double *unit = memory + f->longest, *w = unit + model->nq;
    const double *q = NULL;
    cardan_in in = {0};
    int status;

    in.w = w;
    for (ptrdiff_t k = 0; k < f->block_count; k++) {
        const cardan_bound_block *block = f->blocks + k;
        const double *value = arguments[block->argument];
        value = value ? value + block->start : memory;
        if (block->field == offsetof(cardan_in, q) && model->quaternion_count) {
            q = value;
            memcpy(unit, q, (size_t)model->nq * sizeof *unit);
            for (ptrdiff_t i = 0; i < model->quaternion_count; i++)
                for (ptrdiff_t n = model->quaternions[i], j = 0; j < 4; j++)
                    unit[n + j] = q[n + j] / cardan_bound_length(q + n);
            value = unit;
        }
        memcpy((char *)&in + block->field, &value, sizeof value);
    }
    status = f->function(&in, out, w + f->w);
    for (ptrdiff_t i = 0; q && i < model->quaternion_count; i++) {
        const ptrdiff_t n = model->quaternions[i];
        const double length = cardan_bound_length(q + n);
        for (ptrdiff_t row = 0; row < f->rows; row++)
            for (ptrdiff_t j = 0; j < 4; j++)
                out[f->columns + row * f->stride + n + j] /= length;
        for (ptrdiff_t j = 0; f->is_hessian && j < 4; j++)
            for (ptrdiff_t column = 0; column < f->rows; column++)
                out[(f->columns + n + j) * f->stride + column] /= length;
    }
    return status;
}

#endif
