/* Products with derivatives of the matrices of a mesh: see mesh_pull.h.
 *
 * Part of cardan. Caller owns all memory.
 *
 * Elements have derivatives of M udot and G udot. These are linear in udot and nothing else of the
 * balance is in them, so that those at unit accelerations are derivatives of columns, without rounding
 * of the stiffnesses beside them.
 */
#include "mesh_pull.h"
#include <string.h>

/* Without accelerations, of which one at a time becomes 1. */
static void clear_probe(cardan_place *here)
{
    memset(here->probe, 0, (size_t)here->mesh->nu * sizeof(real));
    here->at.udot = here->probe;
}

/* Where the products with udot begin that make up the matrix, and how many they are. */
static ptrdiff_t rows_of(const cardan_place *here, ptrdiff_t *start)
{
    const cardan_mesh *mesh = here->mesh;
    const int mass = here->product->function == CARDAN_OF_MASS_MATRIX;

    *start = mass ? 0 : mesh->nu;
    return mass ? mesh->nu : mesh->m;
}

int cardan_mesh_pull_matrix(cardan_place *here, const real *v, int along)
{
    const cardan_mesh *mesh = here->mesh;
    const ptrdiff_t nu = mesh->nu;
    ptrdiff_t start, rows = rows_of(here, &start);
    real *weights = here->weights + start;
    int status = 0;

    clear_probe(here);
    memset(here->weights, 0, (size_t)(nu + mesh->m) * sizeof(real));
    for (ptrdiff_t j = 0; j < nu && status == 0; j++) {
        int empty = 1;
        for (ptrdiff_t i = 0; i < rows; i++) {
            weights[i] = v[i * nu + j];
            empty = empty && weights[i] == 0;
        }
        /* columns without weights count for nothing */
        here->probe[j] = 1;
        if (!empty)
            status = cardan_mesh_pull_elements(here, here->product->direct, CARDAN_TANGENT,
                                               here->weights, along);
        here->probe[j] = 0;
    }
    return status;
}

int cardan_mesh_push_matrix(cardan_place *here, real *out)
{
    const cardan_mesh *mesh = here->mesh;
    const ptrdiff_t nu = mesh->nu;
    ptrdiff_t start, rows = rows_of(here, &start);
    int status = 0;

    clear_probe(here);
    for (ptrdiff_t j = 0; j < nu && status == 0; j++) {
        here->probe[j] = 1;
        status = cardan_mesh_push_elements(here, here->product->direct, CARDAN_TANGENT, nu + mesh->m,
                                           here->weights);
        for (ptrdiff_t i = 0; i < rows; i++)
            out[i * nu + j] = here->weights[start + i];
        here->probe[j] = 0;
    }
    return status;
}
