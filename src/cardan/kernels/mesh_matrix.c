/* The iteration matrix of a mesh, assembled in place of a sparse plan.
 *
 * Part of cardan. Caller owns all memory.
 *
 *     [k K T + c C + m M   Gᵀ]      T: turns increments of rotations into motions (cardan_mesh_move)
 *     [G T + lever R T      0]      rows of positions G T; lever: of the rows that bind speeds
 */
#include "mesh_matrix.h"

/* a matrix that is being filled */
typedef struct assembling {
    const cardan_assembly *parts;
    real *a, *row;
} assembling;

/* Row `i` of a part of a tangent (height, nu) with what turns its columns, into `row` (nu). */
static void turned_row(const cardan_mesh *mesh, const cardan_group *g, ptrdiff_t element,
                       const real *from, ptrdiff_t stride, const real *turned, real share,
                       real *row)
{
    const ptrdiff_t *place = g->place + element * g->places;

    for (ptrdiff_t k = 0; k < g->places; k++) {
        const ptrdiff_t n = mesh->u[place[k] + 1] - mesh->u[place[k]];
        const real *T = turned && n == 6 ? turned + 9 * place[k] : NULL;
        ptrdiff_t j = 0;

        for (; T && j < 3; j++)
            row[j] += share * (from[0] * T[j] + from[stride] * T[3 + j] + from[2 * stride] * T[6 + j]);
        for (; j < n; j++)
            row[j] += share * from[j * stride];
        from += n * stride;
        row += n;
    }
}

/* Add a row of an element to the blocks of row block `k` of its places. */
static void add_row(real *values, const cardan_mesh *mesh, const cardan_group *g,
                    ptrdiff_t element, ptrdiff_t k, ptrdiff_t i, const real *row)
{
    const ptrdiff_t blocks = g->places + (g->m > 0);
    const ptrdiff_t *spots = g->spots + element * blocks * (blocks + 1) + k * (blocks + 1);
    const ptrdiff_t *place = g->place + element * g->places, stride = spots[blocks];

    for (ptrdiff_t l = 0; l < g->places; l++) {
        const ptrdiff_t n = mesh->u[place[l] + 1] - mesh->u[place[l]];
        real *a = values + spots[l] + i * stride;
        for (ptrdiff_t j = 0; j < n; j++)
            a[j] += row[j];
        row += n;
    }
}

/* The rows of the constraints of an element, and their transposed columns. */
static void add_constraints(const assembling *to, const cardan_mesh *mesh,
                            const cardan_group *g, ptrdiff_t element, const real *out,
                            ptrdiff_t stride)
{
    const ptrdiff_t blocks = g->places + 1, *starts = g->parts;
    const cardan_assembly *parts = to->parts;
    const ptrdiff_t *spots = g->spots + element * blocks * (blocks + 1);
    const ptrdiff_t *place = g->place + element * g->places;

    for (ptrdiff_t r = 0; r < g->m; r++) {
        const int position = r < g->mp;
        const real *G = out + (starts[CARDAN_G] + r * g->nu) * stride, *column = G;

        for (ptrdiff_t j = 0; j < g->nu; j++)
            to->row[j] = 0;
        turned_row(mesh, g, element, G, stride, position ? parts->turned : NULL, 1, to->row);
        if (starts[CARDAN_R] >= 0 && parts->lever != 0 && (!position || parts->stabilized))
            turned_row(mesh, g, element, out + (starts[CARDAN_R] + r * g->nu) * stride, stride,
                       parts->turned, parts->lever, to->row);
        add_row(to->a, mesh, g, element, g->places, r, to->row);
        for (ptrdiff_t k = 0; k < g->places; k++) {
            const ptrdiff_t n = mesh->u[place[k] + 1] - mesh->u[place[k]];
            real *a = to->a + spots[k * (blocks + 1) + g->places] + r;
            for (ptrdiff_t i = 0; i < n; i++, column += stride)
                a[i * spots[k * (blocks + 1) + blocks]] += *column;
        }
    }
}

static void take_matrix(const cardan_mesh *mesh, const cardan_group *g, ptrdiff_t element,
                        const real *out, ptrdiff_t stride, void *into)
{
    const assembling *to = into;
    const cardan_assembly *parts = to->parts;
    const ptrdiff_t *place = g->place + element * g->places, *starts = g->parts;
    ptrdiff_t i = 0;

    for (ptrdiff_t k = 0; k < g->places; k++)
        for (ptrdiff_t n = mesh->u[place[k] + 1] - mesh->u[place[k]], own = 0; own < n; own++, i++) {
            for (ptrdiff_t j = 0; j < g->nu; j++)
                to->row[j] = 0;
            for (int part = CARDAN_K; part <= CARDAN_M; part++)
                if (starts[part] >= 0 && parts->shares[part] != 0)
                    turned_row(mesh, g, element, out + (starts[part] + i * g->nu) * stride, stride,
                               part == CARDAN_K ? parts->turned : NULL, parts->shares[part],
                               to->row);
            add_row(to->a, mesh, g, element, k, own, to->row);
        }
    if (g->m > 0)
        add_constraints(to, mesh, g, element, out, stride);
}

int cardan_mesh_matrix(const cardan_mesh *mesh, const cardan_state *at,
                       const cardan_assembly *parts, const cardan_mesh_system *system)
{
    real *row = system->work + 2 * mesh->plan->n;
    assembling to = {parts, system->a, row};

    for (ptrdiff_t i = 0; i < mesh->plan->values; i++)
        system->a[i] = 0;
    return cardan_mesh_each(mesh, at, CARDAN_TANGENT, take_matrix, &to, row + mesh->widest);
}
