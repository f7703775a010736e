/* The iteration matrix of a mesh, assembled in place of a sparse plan.
 *
 * Part of cardan. Caller owns all memory.
 *
 *     [k K T + c C + m M   Lᵀ]      T: turns increments of rotations into motions (cardan_mesh_move)
 *     [G T + lever R T      H]      rows of positions G T; lever: of the rows that bind speeds
 *
 * H: 1 on the diagonal of rows that no mode holds. L: G, and the friction that multipliers make.
 */
#include "mesh_matrix.h"
#include "mesh_lanes.h"
#include <string.h>

/* a matrix that is being filled */
typedef struct assembling {
    const cardan_assembly *parts;
    real *a;
    real *const *powers; /* NULL, or three matrices: M, G and H; C and R; K */
} assembling;

/* Speeds of the k-th place of elements that go together. */
static ptrdiff_t place_of(const cardan_mesh *mesh, const cardan_group *g,
                          const cardan_element_lanes *some, ptrdiff_t k)
{
    const ptrdiff_t *entries = mesh->u + g->place[some->element[0] * g->places + k];

    return entries[1] - entries[0];
}

/* Whether any of these is another matrix than the unit one: slides and nodes of a plane have that. */
static int turns(const real *T, ptrdiff_t lanes)
{
    int other = 0;

    for (ptrdiff_t i = 0; i < 9; i++)
        for (ptrdiff_t lane = 0; lane < lanes; lane++)
            other |= T[i * lanes + lane] != (i % 4 == 0 ? 1 : 0);
    return other;
}

/* Turn the columns of `height` rows (nu) from increments of rotations to motions. */
static void turn(const cardan_mesh *mesh, const cardan_group *g, const cardan_element_lanes *some,
                 const real *tangent_maps, ptrdiff_t height, real *rows)
{
    const real *from[CARDAN_ELEMENT_LANES];
    real T[9 * CARDAN_ELEMENT_LANES];

    for (ptrdiff_t k = 0; k < g->places && tangent_maps; k++) {
        const ptrdiff_t n = place_of(mesh, g, some, k);

        if (n == 3 || n == 6) {
            int does;
            for (ptrdiff_t lane = 0; lane < some->lanes; lane++)
                from[lane] = tangent_maps + 9 * g->place[some->element[lane] * g->places + k];
            (void)cardan_fetch(from, 9, T, some->lanes);
            does = n == 6 || turns(T, some->lanes);
            for (ptrdiff_t i = 0; i < height && does; i++)
                cardan_turn_three(T, some->lanes, rows + i * g->nu * some->lanes);
        }
        rows += n * some->lanes;
    }
}

/* Add `height` rows (nu) to those of row block k. */
static void add_rows(real *values, const cardan_mesh *mesh, const cardan_group *g,
                     const cardan_element_lanes *some, ptrdiff_t k, ptrdiff_t height, const real *rows)
{
    const ptrdiff_t blocks = g->places + (g->m > 0), size = blocks * (blocks + 1);
    const ptrdiff_t *spots[CARDAN_ELEMENT_LANES];
    real *to[CARDAN_ELEMENT_LANES];

    for (ptrdiff_t lane = 0; lane < some->filled; lane++)
        spots[lane] = g->spots + some->element[lane] * size + k * (blocks + 1);
    for (ptrdiff_t l = 0; l < g->places; l++) {
        const ptrdiff_t n = place_of(mesh, g, some, l);

        for (ptrdiff_t lane = 0; lane < some->filled; lane++)
            to[lane] = values + spots[lane][l];
        for (ptrdiff_t i = 0; i < height; i++) {
            cardan_spill(rows + i * g->nu * some->lanes, n, some->lanes, to, some->filled);
            for (ptrdiff_t lane = 0; lane < some->filled; lane++)
                to[lane] += spots[lane][blocks];
        }
        rows += n * some->lanes;
    }
}

/* Add the rows of constraints (m, nu) as columns. */
static void add_columns(real *values, const cardan_mesh *mesh, const cardan_group *g,
                        const cardan_element_lanes *some, const real *rows)
{
    const ptrdiff_t blocks = g->places + 1, size = blocks * (blocks + 1);

    for (ptrdiff_t lane = 0; lane < some->filled; lane++) {
        const real *entries = rows + lane;
        const ptrdiff_t *spots = g->spots + some->element[lane] * size;

        for (ptrdiff_t k = 0; k < g->places; k++, spots += blocks + 1)
            for (ptrdiff_t i = 0, n = place_of(mesh, g, some, k); i < n; i++, entries += some->lanes) {
                real *a = values + spots[g->places] + i * spots[blocks];
                for (ptrdiff_t r = 0; r < g->m; r++)
                    a[r] += entries[r * g->nu * some->lanes];
            }
    }
}

/* The rows of the constraints of elements, and their transposed columns. */
static void add_constraints(const assembling *to, const cardan_mesh *mesh, const cardan_group *g,
                            const cardan_element_lanes *some, real *out)
{
    const cardan_assembly *parts = to->parts;
    const ptrdiff_t *starts = g->parts, lanes = some->lanes, first = parts->stabilized ? 0 : g->mp;
    real *G = out + starts[CARDAN_G] * lanes, *R = out + starts[CARDAN_R] * lanes;

    /* with friction that follows from multipliers these do more than hold */
    add_columns(to->a, mesh, g, some, starts[CARDAN_L] >= 0 ? out + starts[CARDAN_L] * lanes : G);
    turn(mesh, g, some, parts->tangent_maps, g->mp, G);
    if (starts[CARDAN_R] >= 0 && parts->lever != 0) {
        const ptrdiff_t done = first * g->nu * lanes;
        turn(mesh, g, some, parts->tangent_maps, g->m - first, R + done);
        cardan_mix((g->m - first) * g->nu * lanes, parts->lever, R + done, 1, G + done);
    }
    add_rows(to->a, mesh, g, some, g->places, g->m, G);
}

/* Take rows that modes hold out of matrices (m, nu) of elements. */
static void release(const cardan_group *g, const cardan_element_lanes *some, real *out)
{
    const ptrdiff_t size = g->switched * g->nu * some->lanes, first = (g->m - g->switched) * g->nu * some->lanes;
    const int parts[] = {CARDAN_R, CARDAN_G, CARDAN_L};

    for (int part = 0; part < 3; part++)
        if (g->parts[parts[part]] >= 0)
            memset(out + g->parts[parts[part]] * some->lanes + first, 0, (size_t)size * sizeof(real));
}

/* Diagonal of the rows that no mode holds. */
static void add_switches(const assembling *to, const cardan_group *g,
                         const cardan_element_lanes *some, const real *out)
{
    const ptrdiff_t blocks = g->places + 1, size = blocks * (blocks + 1);
    const real *H = out + g->parts[CARDAN_RELEASED] * some->lanes;

    for (ptrdiff_t lane = 0; lane < some->filled; lane++) {
        const ptrdiff_t *spots = g->spots + some->element[lane] * size + g->places * (blocks + 1);
        for (ptrdiff_t k = g->m - g->switched; k < g->m; k++)
            to->a[spots[g->places] + k * (spots[blocks] + 1)] +=
                to->parts->released ? 1 : H[k * (g->m + 1) * some->lanes + lane];
    }
}

/* Shares of K T, C and M, in place of the first of them; NULL: there is none. */
static real *shared(const assembling *to, const cardan_mesh *mesh, const cardan_group *g,
                    const cardan_element_lanes *some, real *out)
{
    const ptrdiff_t *starts = g->parts, size = g->nu * g->nu * some->lanes;
    real *sum = NULL;

    for (int part = CARDAN_K; part <= CARDAN_M; part++) {
        const real share = to->parts->shares[part];
        real *entries = out + starts[part] * some->lanes;

        if (starts[part] < 0 || share == 0)
            continue;
        if (part == CARDAN_K)
            turn(mesh, g, some, to->parts->tangent_maps, g->nu, entries);
        if (sum)
            cardan_mix(size, share, entries, 1, sum);
        else
            cardan_mix(size, share, entries, 0, sum = entries);
    }
    return sum;
}

/* Add a matrix (nu, nu) of the speeds of elements. */
static void add_square(real *a, const cardan_mesh *mesh, const cardan_group *g,
                       const cardan_element_lanes *some, const real *square)
{
    for (ptrdiff_t k = 0; k < g->places; k++) {
        const ptrdiff_t n = place_of(mesh, g, some, k);
        add_rows(a, mesh, g, some, k, n, square);
        square += n * g->nu * some->lanes;
    }
}

static void take_matrix(const cardan_mesh *mesh, const cardan_group *g, const cardan_element_lanes *some,
                        real *out, void *into)
{
    const assembling *to = into;
    const real *sum = shared(to, mesh, g, some, out);

    if (sum)
        add_square(to->a, mesh, g, some, sum);
    if (g->parts[CARDAN_RELEASED] >= 0)
        add_switches(to, g, some, out);
    if (to->parts->released)
        release(g, some, out);
    if (g->m > 0 && !(to->parts->released && g->switched == g->m))
        add_constraints(to, mesh, g, some, out);
}

/* The parts of the matrix of elements by the power of the step that they go with. */
static void take_powers(const cardan_mesh *mesh, const cardan_group *g,
                        const cardan_element_lanes *some, real *out, void *into)
{
    const assembling *to = into;
    const ptrdiff_t *starts = g->parts, lanes = some->lanes;

    for (int part = CARDAN_K; part <= CARDAN_M; part++)
        if (starts[part] >= 0)
            add_square(to->powers[CARDAN_M - part], mesh, g, some, out + starts[part] * lanes);
    if (starts[CARDAN_RELEASED] >= 0)
        add_switches(to, g, some, out);
    if (g->m == 0)
        return;
    add_columns(to->powers[0], mesh, g, some,
                out + starts[starts[CARDAN_L] >= 0 ? CARDAN_L : CARDAN_G] * lanes);
    add_rows(to->powers[0], mesh, g, some, g->places, g->m, out + starts[CARDAN_G] * lanes);
    if (starts[CARDAN_R] >= 0)
        add_rows(to->powers[1], mesh, g, some, g->places, g->m, out + starts[CARDAN_R] * lanes);
}

int cardan_mesh_powers(const cardan_mesh *mesh, const cardan_state *at, real *const *powers,
                       real *room)
{
    static const cardan_assembly all = {{1, 1, 1}, 1, 1, NULL, 0};
    assembling to = {&all, powers[0], powers};

    for (int power = 0; power < 3; power++)
        memset(powers[power], 0, (size_t)mesh->plan->values * sizeof(real));
    return cardan_mesh_each(mesh, at, CARDAN_TANGENT, take_powers, &to, room);
}

int cardan_mesh_matrix(const cardan_mesh *mesh, const cardan_state *at,
                       const cardan_assembly *parts, const cardan_mesh_system *system)
{
    assembling to = {parts, system->a, NULL};

    memset(system->a, 0, (size_t)mesh->plan->values * sizeof(real));
    return cardan_mesh_each(mesh, at, CARDAN_TANGENT, take_matrix, &to,
                            system->work + 2 * mesh->plan->n);
}
