/* The numbers of an exported model at some parameters.
 *
 * Part of cardan. Caller owns all memory.
 */
#include "export.h"

/* Numbers that elements take: they come before the w of functions that do not read elements. */
static size_t numbers_of_elements(const cardan_export *model)
{
    return model->elements ? (model->calls->size(model->elements) + sizeof(wreal) - 1) / sizeof(wreal) : 0;
}

size_t cardan_prepared_size(const cardan_export *model)
{
    size_t numbers = 1 + numbers_of_elements(model);

    for (ptrdiff_t k = 0; k < model->function_count; k++)
        numbers += (size_t)model->functions[k].w;
    return numbers * sizeof(wreal);
}

int cardan_prepare(const cardan_export *model, const wreal *p, void *prepared)
{
    wreal *w = (wreal *)prepared + numbers_of_elements(model);

    for (ptrdiff_t k = 0; k < model->function_count; k++) {
        if (model->functions[k].prepare)
            model->functions[k].prepare(p, w);
        w += model->functions[k].w;
    }
    return model->elements ? model->calls->prepare(model->elements, (const double *)p, prepared) : CARDAN_OK;
}

const wreal *cardan_prepared_w(const cardan_export *model, const void *prepared, ptrdiff_t k)
{
    const wreal *w = prepared;

    /* NULL while memory is measured: nothing lies behind it */
    if (!w || !model->functions[k].prepare)
        return w;
    w += numbers_of_elements(model);
    for (ptrdiff_t i = 0; i < k; i++)
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
