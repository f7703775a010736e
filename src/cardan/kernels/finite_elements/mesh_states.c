/* Internal states of elements in implicit steps: slopes of their rates by the states of the same
 * element, by differences, and systems with them.
 *
 * Part of cardan. Caller owns all memory.
 */
#include "mesh_states.h"
#include "linear.h"
#include <math.h>

ptrdiff_t cardan_mesh_most_states(const cardan_mesh *mesh)
{
    ptrdiff_t most = 0;

    for (ptrdiff_t k = 0; k < mesh->group_count; k++)
        most = mesh->groups[k].z_states > most ? mesh->groups[k].z_states : most;
    return most;
}

ptrdiff_t cardan_mesh_states_block(const cardan_mesh *mesh)
{
    return cardan_states_block(cardan_mesh_most_states(mesh));
}

/* Add `share` of its change to the j-th state of every element that has so many. Returns how many. */
static ptrdiff_t shift(const cardan_mesh *mesh, ptrdiff_t j, real share, const real *change, real *z)
{
    ptrdiff_t some = 0;

    for (ptrdiff_t k = 0; k < mesh->group_count; k++) {
        const cardan_group *g = mesh->groups + k;
        for (ptrdiff_t e = 0; e < g->count && j < g->z_states; e++, some++)
            z[g->z[e * g->nz + j]] += share * change[g->z[e * g->nz + j]];
    }
    return some;
}

int cardan_mesh_slopes(const cardan_mesh *mesh, const cardan_state *at, const real *zdot,
                       const real *change, real *z, real *slopes, real *room)
{
    cardan_state trial = *at;
    int status = 0;

    trial.z = z;
    for (ptrdiff_t j = 0; status == 0 && shift(mesh, j, 1, change, z) > 0; j++) {
        status = cardan_mesh_zdot(mesh, &trial, slopes + j * mesh->nz, room);
        (void)shift(mesh, j, -1, change, z);
        for (ptrdiff_t i = 0; i < mesh->nz; i++)
            slopes[j * mesh->nz + i] -= zdot[i];
    }
    return status;
}

void cardan_states_solve(cardan_element_states of, ptrdiff_t nz, real re, real im, const real *change,
                         const real *slopes, real *x, real *y, real *block)
{
    const ptrdiff_t n = of.count;
    real *a = block, *b = a + n * n, *order = b + n * n, *u = order + n, *v = u + n;
    int singular;

    for (ptrdiff_t i = 0; i < n; i++) {
        const ptrdiff_t row = cardan_state_index(&of, i);
        u[i] = x[row];
        v[i] = y ? y[row] : 0;
        for (ptrdiff_t j = 0; j < n; j++) {
            const real slope = slopes[j * nz + row] / change[cardan_state_index(&of, j)];
            a[i * n + j] = (i == j) - re * slope;
            b[i * n + j] = -im * slope;
        }
    }
    singular = y ? cardan_factor_complex(n, a, b, order) : cardan_factor(n, a, order);
    if (!singular && y)
        cardan_substitute_complex(n, a, b, order, u, v);
    else if (!singular)
        cardan_substitute(n, a, order, u);
    for (ptrdiff_t i = 0; i < n; i++) {
        /* nothing that a caller would take for a solution */
        x[cardan_state_index(&of, i)] = singular ? (real)NAN : u[i];
        if (y)
            y[cardan_state_index(&of, i)] = singular ? (real)NAN : v[i];
    }
}

void cardan_mesh_states_solve(const cardan_mesh *mesh, real re, real im, const real *change,
                              const real *slopes, real *x, real *y, real *block)
{
    for (ptrdiff_t k = 0; k < mesh->group_count; k++)
        for (ptrdiff_t e = 0; e < mesh->groups[k].count; e++)
            cardan_states_solve(cardan_mesh_states_of(mesh->groups + k, e), mesh->nz, re, im, change,
                                slopes, x, y, block);
}
