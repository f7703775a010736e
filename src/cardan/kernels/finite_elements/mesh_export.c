/* Elements of an exported model at some parameters.
 *
 * Part of cardan. Caller owns all memory.
 */
#include "mesh_export.h"

/* The data (count, each + more) of the elements of a group. */
static int find(const cardan_element_data *d, ptrdiff_t count, const double *p, real *scratch,
                real *to)
{
    real *out = scratch, *w = out + d->size;
    const cardan_in in = {.w = w};
    int status = 0;

    if (d->function) {
        d->prepare(p, w);
        status = d->function(&in, out, w + d->nw);
    }
    for (ptrdiff_t e = 0; e < count; e++) {
        for (ptrdiff_t i = 0; i < d->each; i++)
            *to++ = out[(d->alike ? 0 : e * d->each) + i];
        for (ptrdiff_t i = 0; i < d->more; i++)
            *to++ = d->attributes[e * d->more + i];
    }
    return status;
}

int cardan_elements_prepare(const cardan_elements *elements, const double *p, cardan_mesh *mesh,
                            cardan_group *groups, real *numbers)
{
    const cardan_element_function *f = elements->functions, *const end = f + elements->function_count;
    real *w = numbers + elements->data_room;
    int status = 0;

    *mesh = *elements->mesh;
    mesh->groups = groups;
    for (ptrdiff_t k = 0; k < mesh->group_count && status == 0; k++) {
        const cardan_element_data *data = &elements->data[k];
        const ptrdiff_t size = data->each + data->more, count = elements->mesh->groups[k].count;

        groups[k] = elements->mesh->groups[k];
        status = find(data, count, p, numbers + count * size, numbers);
        for (; f < end && f->group == k; f++) {
            cardan_form *form = &groups[k].forms[f->form];

            form->call = f->function, form->lanes = 1, form->w = w;
            form->nw = f->nw, form->size = f->size;
            for (ptrdiff_t e = 0; e < count; e++, w += f->nw)
                f->prepare(numbers + e * size, w);
        }
    }
    return status;
}

void cardan_mesh_pattern(const cardan_mesh *mesh, int32_t *columns, int32_t *starts,
                         ptrdiff_t *unknowns)
{
    const cardan_sparse *plan = mesh->plan;
    int32_t count = 0;

    for (ptrdiff_t block = 0; block < plan->blocks; block++)
        for (int32_t row = plan->first[block]; row < plan->first[block + 1]; row++) {
            starts[row] = count;
            for (int32_t k = plan->row[block]; k < plan->row[block + 1]; k++) {
                const int32_t *first = plan->first + plan->column[k];

                for (int32_t i = first[0]; i < first[1]; i++)
                    columns[count++] = i;
            }
        }
    starts[plan->n] = count;
    for (ptrdiff_t k = 0; k < mesh->m; k++)
        unknowns[k] = mesh->unknown[k];
}

/* Bytes of the mesh, its groups and their numbers, one behind the other. */
static size_t size_of(const cardan_elements *elements)
{
    return sizeof(cardan_mesh) + (size_t)elements->mesh->group_count * sizeof(cardan_group)
           + (size_t)(elements->data_room + elements->nw) * sizeof(real);
}

static int prepare(const cardan_elements *elements, const double *p, void *prepared)
{
    cardan_mesh *mesh = prepared;
    cardan_group *groups = (cardan_group *)(void *)(mesh + 1);
    void *numbers = groups + elements->mesh->group_count;

    return cardan_elements_prepare(elements, p, mesh, groups, numbers);
}

static size_t work_of(const cardan_elements *elements)
{
    return (size_t)cardan_mesh_start_work(elements->mesh);
}

static int start(const cardan_export *model, const void *prepared, real t, const real *r, real *x,
                 real *work)
{
    return cardan_mesh_start(prepared, t, r, model->quaternions, model->quaternion_count,
                             model->elements->locked, x, work);
}

const cardan_element_calls cardan_calls_of_elements = {size_of, prepare, work_of, start};
