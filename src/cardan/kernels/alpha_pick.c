/* The rows of constraints that bind in the generalized-alpha method: those that follow from no others.
 *
 * Part of cardan. Caller owns all memory.
 *
 * How many there are is told where a segment of a run starts, where positions are closed. Which they
 * are may change: rows that were at large angles to each other turn, and may vanish.
 * Source: as of dependent.h.
 */
#include "alpha.h"
#include <math.h>

/* square of the sine of the angle to others at which a row still is one of its own: dependent.h */
static const real DEPENDENT = 1e-9;
/* what is left of a row that counts beside others, of the most that is: dependent.h; what is left of
 * the least of other rows to be picked in place of those that are */
static const real LEAST = 1e-3, BETTER = 30;

/* How many of the first rows are picked. */
ptrdiff_t cardan_alpha_picked(const cardan_alpha *v, ptrdiff_t rows)
{
    ptrdiff_t count = 0;

    for (ptrdiff_t k = 0; k < rows; k++)
        count += v->picked[k] != 0;
    return count;
}

/* Take from all rows (m, nu) what the best of them has, and return how much that is, squared. */
static real take(const cardan_alpha *v, real *rows, ptrdiff_t best)
{
    const ptrdiff_t nu = v->nu;
    const real *own = rows + best * nu;
    real size = 0;

    for (ptrdiff_t i = 0; i < nu; i++)
        size += own[i] * own[i];
    for (ptrdiff_t k = 0; k < v->m && size > 0; k++) {
        real share = 0;
        for (ptrdiff_t i = 0; i < nu; i++)
            share += rows[k * nu + i] * own[i] / size;
        for (ptrdiff_t i = 0; i < nu && k != best; i++)
            rows[k * nu + i] -= share * own[i];
    }
    return size;
}

/* Rows of G (m, nu) in units of the weights. */
static real *weighted(const cardan_alpha *v)
{
    const real *G = v->tangent + 3 * v->nu * v->nu + v->m * v->nu;

    for (ptrdiff_t k = 0; k < v->m; k++)
        for (ptrdiff_t i = 0; i < v->nu; i++)
            v->room[k * v->nu + i] = G[k * v->nu + i] * v->weight[i];
    return v->room;
}

/* The row from first to last that is to be picked next, -1 for none: of those of which a part is
 * left the largest, as in dependent.h. */
static ptrdiff_t next_of(const cardan_alpha *v, const real *rows, const real *picked,
                         ptrdiff_t first, ptrdiff_t last)
{
    real share = DEPENDENT, largest = 0;
    ptrdiff_t best = -1;

    for (int look = 0; look < 2; look++)
        for (ptrdiff_t k = first; k < last; k++) {
            real left = 0, part;
            for (ptrdiff_t i = 0; i < v->nu; i++)
                left += rows[k * v->nu + i] * rows[k * v->nu + i];
            part = left * v->unit[k] * v->unit[k];
            if (picked[k] != 0)
                continue;
            if (look == 0)
                share = fmax(share, LEAST * part);
            else if (part > share && left > largest) {
                largest = left;
                best = k;
            }
        }
    return best;
}

/* Choose rows of G that follow from no others into picked (m), those of positions first: as many of
 * these and of all as `most` says. Returns how much is left of the row that depends most, squared. */
static real choose(const cardan_alpha *v, const ptrdiff_t *most, real *picked)
{
    real *rows = weighted(v), least = INFINITY;
    ptrdiff_t count = 0, best;

    for (ptrdiff_t k = 0; k < v->m; k++)
        picked[k] = 0;
    for (int level = 0; level < 2; level++)
        while (count < most[level]) {
            best = level == 0 ? next_of(v, rows, picked, 0, v->mp)
                              : next_of(v, rows, picked, v->mp, v->m);
            if (best < 0)
                break;
            picked[best] = 1;
            least = fmin(least, take(v, rows, best));
            count++;
        }
    return count == most[1] ? least : 0;
}

/* Choose rows of G that follow from no others, where positions are closed. */
void cardan_alpha_pick(const cardan_alpha *v)
{
    const ptrdiff_t all[2] = {v->m, v->m};

    (void)choose(v, all, v->picked);
}

/* Choose other rows, as many, where those picked have come to depend on each other, or vanish, while
 * others do not. Multipliers of rows that are picked no more become 0. */
void cardan_alpha_pick_again(const cardan_alpha *v)
{
    const ptrdiff_t all = cardan_alpha_picked(v, v->m), most[2] = {cardan_alpha_picked(v, v->mp), all};
    real *rows, least = INFINITY, *other = v->right;

    if (all == v->m)
        return;
    rows = weighted(v);
    for (ptrdiff_t k = 0; k < v->m; k++)
        if (v->picked[k] != 0)
            least = fmin(least, take(v, rows, k));
    if (!(choose(v, most, other) > BETTER * least))
        return;
    for (ptrdiff_t k = 0; k < v->m; k++) {
        v->picked[k] = other[k];
        v->lam_new[k] = other[k] != 0 ? v->lam_new[k] : 0;
    }
}
