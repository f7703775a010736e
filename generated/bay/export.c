/* The numbers of an exported model at some parameters.
 *
 * Part of cardan. Caller owns all memory.
 */
#include "export.h"

size_t cardan_prepared_size(const cardan_export *model)
{
    ptrdiff_t numbers = 1;

    if (model->elements)
        return model->calls->size(model->elements);
    for (ptrdiff_t k = 0; k < model->function_count; k++)
        numbers += model->functions[k].w;
    return (size_t)numbers * sizeof(wreal);
}

int cardan_prepare(const cardan_export *model, const wreal *p, void *prepared)
{
    wreal *w = prepared;

    if (model->elements)
        return model->calls->prepare(model->elements, (const double *)p, prepared);
    for (ptrdiff_t k = 0; k < model->function_count; k++) {
        model->functions[k].prepare(p, w);
        w += model->functions[k].w;
    }
    return CARDAN_OK;
}

const wreal *cardan_prepared_w(const cardan_export *model, const void *prepared, ptrdiff_t k)
{
    const wreal *w = prepared;

    /* NULL while memory is measured: nothing lies behind it */
    for (ptrdiff_t i = 0; i < k && w && !model->elements; i++)
        w += model->functions[i].w;
    return w;
}

size_t cardan_work_length(const cardan_export *model)
{
    size_t most = model->elements ? model->calls->work(model->elements) : 1;

    for (ptrdiff_t k = 0; k < model->function_count; k++)
        if (most < (size_t)model->functions[k].work)
            most = (size_t)model->functions[k].work;
    return most;
}

int cardan_start_state(const cardan_export *model, const void *prepared, real t, const real *r,
                       real *x, real *work)
{
    for (ptrdiff_t i = 0; i < model->nq; i++)
        *x++ = CARDAN_REAL(model->q[i]);
    for (ptrdiff_t i = 0; i < model->nu; i++)
        *x++ = CARDAN_REAL(model->u[i]);
    for (ptrdiff_t i = 0; i < model->nz; i++)
        *x++ = CARDAN_REAL(model->z[i]);
    x -= model->nq + model->nu + model->nz;
    return model->elements ? model->calls->start(model, prepared, t, r, x, work) : CARDAN_OK;
}
