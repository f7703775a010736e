/*
 * elements.c: the model as a whole; see functions.h.
 */
#include "functions.h"

int prepare_model(const double *p, cardan_model *model)
{
    return cardan_elements_prepare(cardan_scene.elements, p, &model->mesh, model->groups, model->numbers);
}

const wreal *model_w(const cardan_model *model)
{
    return (const wreal *)(const void *)&model->mesh;
}

size_t model_work_size(const cardan_model *model)
{
    return (size_t)cardan_mesh_start_work(&model->mesh);
}

int start_model(const cardan_model *model, real t, const real *r, real *x, real *work)
{
    return cardan_start_state(&cardan_scene, &model->mesh, t, r, x, work);
}

void model_pattern(int32_t *columns, int32_t *starts, ptrdiff_t *unknowns)
{
    cardan_mesh_pattern(cardan_scene.mesh, columns, starts, unknowns);
}

#define DEFINE(name, kernel)                                                                       \
    int name(const cardan_in *in, real *out, real *work)                                           \
    {                                                                                              \
        return kernel(in, out, work);                                                              \
    }
CARDAN_ELEMENT_CALLS(DEFINE)
