/* What closes loops, by the speeds of joints: rows of constraints without the speeds of nodes.
 *
 * Part of cardan. Caller owns all memory.
 *
 * The rows of a joint of the tree determine the speeds of the node that it carries. From the last
 * node inward these rows are used up: of [A B] by that node and by all else, and another row [c d],
 * what is left is d - c A^-1 B. The rows of loops that are left have the rank that all rows have
 * beyond those used up, and are as few as in joint coordinates.
 */
#include "mesh_calls.h"
#include "solve.h"
#include <math.h>
#include <string.h>

/* of a row, what is left of it where it follows from the tree */
static const real ROUNDING = 1e-12;
enum { WIDEST = 6 };

static ptrdiff_t size_of(const cardan_sparse *plan, ptrdiff_t block)
{
    return plan->first[block + 1] - plan->first[block];
}

/* The numbers of a block of rows at the columns of a place. */
static const real *entries_of(const cardan_sparse *plan, const real *a, ptrdiff_t block,
                              ptrdiff_t place)
{
    const real *entries = a + plan->at[block];

    for (ptrdiff_t pair = plan->row[block]; plan->column[pair] != place; pair++)
        entries += size_of(plan, plan->column[pair]);
    return entries;
}

/* How many blocks of rows of the tree meet every node; -1 for other places. `loop` (n): not 0 for
 * unknowns of loops. */
static void count_rows(const cardan_mesh *mesh, const real *loop, real *meets)
{
    const cardan_sparse *plan = mesh->plan;

    for (ptrdiff_t place = 0; place < mesh->places; place++)
        meets[place] = -1;
    for (ptrdiff_t k = 0; k < mesh->nodes; k++)
        meets[mesh->node[k]] = 0;
    for (ptrdiff_t k = 0; k < mesh->flats; k++)
        meets[mesh->flat[k]] = 0;
    for (ptrdiff_t block = mesh->places; block < plan->blocks; block++)
        for (ptrdiff_t pair = plan->row[block]; pair < plan->row[block + 1]; pair++)
            if (plan->column[pair] < mesh->places && meets[plan->column[pair]] >= 0
                && size_of(plan, block) > 0 && loop[plan->first[block]] == 0)
                meets[plan->column[pair]]++;
}

/* The node that no other block of rows meets and that these determine; -1: none. */
static ptrdiff_t last_node(const cardan_mesh *mesh, ptrdiff_t block, const real *meets)
{
    const cardan_sparse *plan = mesh->plan;

    for (ptrdiff_t pair = plan->row[block]; pair < plan->row[block + 1]; pair++) {
        const ptrdiff_t place = plan->column[pair];
        if (place < mesh->places && meets[place] == 1 && size_of(plan, place) <= WIDEST
            && size_of(plan, place) == size_of(plan, block))
            return place;
    }
    return -1;
}

/* Set rows of a block that are used up to zero where they are not yet. */
static void clear(const cardan_sparse *plan, ptrdiff_t block, ptrdiff_t nu, real *row)
{
    for (ptrdiff_t pair = plan->row[block]; pair < plan->row[block + 1]; pair++) {
        const ptrdiff_t from = plan->first[plan->column[pair]];
        if (from < nu)
            memset(row + from, 0, (size_t)size_of(plan, plan->column[pair]) * sizeof(real));
    }
}

/* Take a node out of all rows (m, nu) but those used up, by the block of rows that determines it.
 * `used` (n): the block of rows of unknowns that are used up, 0 for others. Returns CARDAN_OK where these do. */
static int take_out(const cardan_mesh *mesh, const real *a, ptrdiff_t block, ptrdiff_t place,
                    const real *used, real *rows)
{
    const cardan_sparse *plan = mesh->plan;
    const ptrdiff_t n = size_of(plan, block), stride = plan->stride[block], nu = mesh->nu;
    const real *A = entries_of(plan, a, block, place);
    real transposed[WIDEST * WIDEST], inverse[WIDEST * WIDEST], scratch[2 * WIDEST], share[WIDEST];

    for (ptrdiff_t i = 0; i < n; i++)
        for (ptrdiff_t j = 0; j < n; j++) {
            transposed[i * n + j] = A[j * stride + i];
            inverse[i * n + j] = i == j;
        }
    /* A^-1, transposed */
    if (cardan_solve_rank_revealing((int)n, (int)n, transposed, inverse, scratch) != CARDAN_OK)
        return CARDAN_SINGULAR;
    /* d - c A^-1 B of every row that meets the node */
    for (ptrdiff_t k = 0; k < mesh->m; k++) {
        real *row = rows + k * nu, *at_node = row + plan->first[place];
        if (used[mesh->unknown[k]] != 0 || cardan_dot(at_node, at_node, n) == 0)
            continue;
        for (ptrdiff_t i = 0; i < n; i++)
            share[i] = cardan_dot(inverse + i * n, at_node, n);
        for (ptrdiff_t pair = plan->row[block]; pair < plan->row[block + 1]; pair++) {
            const ptrdiff_t from = plan->first[plan->column[pair]], size = size_of(plan, plan->column[pair]);
            const real *entries = entries_of(plan, a, block, plan->column[pair]);
            for (ptrdiff_t i = 0; i < n && from < nu; i++)
                for (ptrdiff_t j = 0; j < size; j++)
                    row[from + j] -= share[i] * entries[i * stride + j];
        }
        memset(at_node, 0, (size_t)n * sizeof(real));
    }
    return CARDAN_OK;
}

/* Leave of rows (m, nu) of a matrix what the tree does not determine: rows that are used up, or follow
 * from them, become zero. Returns another status than CARDAN_OK where rows of the tree determine no node,
 * with rows spoiled. */
int cardan_mesh_loops(const cardan_mesh *mesh, const cardan_mesh_system *system, real *rows)
{
    const cardan_sparse *plan = mesh->plan;
    const ptrdiff_t n = plan->n, nu = mesh->nu;
    real *used = system->solution, *loop = system->rows, *meets = system->units, *size = system->right;
    int progress = plan->blocks <= n, status = CARDAN_OK;

    /* which rows close loops, and how long rows are */
    for (ptrdiff_t k = 0; k < n; k++) {
        used[k] = 0;
        loop[plan->order[k]] = plan->multiplier[k] == 2;
    }
    for (ptrdiff_t k = 0; k < mesh->m; k++)
        size[k] = loop[mesh->unknown[k]] != 0 ? sqrt(cardan_dot(rows + k * nu, rows + k * nu, nu)) : 0;
    if (progress)
        count_rows(mesh, loop, meets);
    /* from the last nodes inward, as long as there are any */
    while (progress && status == CARDAN_OK) {
        progress = 0;
        for (ptrdiff_t block = plan->blocks - 1; block >= mesh->places && status == CARDAN_OK; block--) {
            const ptrdiff_t first = plan->first[block], count = size_of(plan, block);
            ptrdiff_t place;
            if (count == 0 || loop[first] != 0 || used[first] != 0)
                continue;
            place = last_node(mesh, block, meets);
            if (place < 0)
                continue;
            for (ptrdiff_t i = first; i < first + count; i++)
                used[i] = (real)block;
            for (ptrdiff_t pair = plan->row[block]; pair < plan->row[block + 1]; pair++)
                if (plan->column[pair] < mesh->places)
                    meets[plan->column[pair]]--;
            status = take_out(mesh, system->a, block, place, used, rows);
            progress = 1;
        }
    }
    /* what is left of rows that follow from the tree is rounding */
    for (ptrdiff_t k = 0; k < mesh->m; k++) {
        real *row = rows + k * nu;
        if (used[mesh->unknown[k]] != 0)
            clear(plan, (ptrdiff_t)used[mesh->unknown[k]], nu, row);
        else if (sqrt(cardan_dot(row, row, nu)) <= ROUNDING * size[k])
            memset(row, 0, (size_t)nu * sizeof(real));
    }
    return status;
}
