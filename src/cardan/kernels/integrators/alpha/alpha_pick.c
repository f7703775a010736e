/* Selection of linearly independent constraint rows for the generalized-alpha method.
 *
 * Part of cardan. Caller owns all memory.
 *
 * Their number (the rank) is found at the start of a segment, where position constraints hold.
 * Which rows are selected may change later: rows turn during the motion, may become dependent, or
 * vanish.
 * Source: as in dependent.h (Gram-Schmidt with pivoting).
 */
#include "alpha.h"
#include <math.h>

/* squared sine of the angle to the other rows above which a row is independent: see dependent.h */
static const real DEPENDENT = 1e-9;
/* LEAST: remaining part of a row relative to the largest one, to be a candidate (dependent.h).
 * BETTER: factor by which another selection must be less dependent to replace the present one */
static const real LEAST = 1e-3, BETTER = 30;

/* Number of selected rows among the first `rows`. */
ptrdiff_t cardan_alpha_picked(const cardan_alpha *v, ptrdiff_t rows)
{
    ptrdiff_t count = 0;

    for (ptrdiff_t k = 0; k < rows; k++)
        count += v->picked[k] != 0;
    return count;
}

/* Orthogonalize all other rows (m, nu) against row `best`; returns its squared length. */
static real take(const cardan_alpha *v, real *rows, ptrdiff_t best)
{
    const ptrdiff_t nu = v->nu;
    const real *chosen = rows + best * nu;
    real size = 0;

    for (ptrdiff_t i = 0; i < nu; i++)
        size += chosen[i] * chosen[i];
    for (ptrdiff_t k = 0; k < v->m && size > 0; k++) {
        real share = 0;
        for (ptrdiff_t i = 0; i < nu; i++)
            share += rows[k * nu + i] * chosen[i] / size;
        for (ptrdiff_t i = 0; i < nu && k != best; i++)
            rows[k * nu + i] -= share * chosen[i];
    }
    return size;
}

/* Rows of G (m, nu), scaled by the weights of the speeds. */
static real *weighted(const cardan_alpha *v)
{
    const real *G = v->tangent + 3 * v->nu * v->nu + v->m * v->nu;

    for (ptrdiff_t k = 0; k < v->m; k++)
        for (ptrdiff_t i = 0; i < v->nu; i++)
            v->room[k * v->nu + i] = G[k * v->nu + i] * v->weight[i];
    return v->room;
}

/* Next row to select from [first, last), -1 if all others are dependent: the longest remaining row
 * among those of which a significant part is left, as in dependent.h. */
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

/* Select independent rows of G into picked (m), position rows first: at most most[0] of them and
 * most[1] in total. Returns the smallest squared pivot, or 0 if fewer than most[1] were found. */
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

/* Select independent rows of G at the start of a segment, where position constraints hold. */
void cardan_alpha_pick(const cardan_alpha *v)
{
    const ptrdiff_t all[2] = {v->m, v->m};

    (void)choose(v, all, v->picked);
}

/* Select the same number of other rows if the present ones have become nearly dependent or vanish
 * and others are better. Multipliers of rows that are no longer selected become 0. */
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
