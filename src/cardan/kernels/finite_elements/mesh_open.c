/* What open positions hide of the rank of constraints.
 *
 * Part of cardan. Caller owns all memory.
 *
 * Rows that follow from others do so where positions are closed. Beside that, as at the stages of
 * explicit steps and at predictions of implicit ones, an angle to the others is left of them, in
 * proportion to the gaps, and they ask for something else: multipliers of gaps over that angle would
 * hold the motion. So as much of an angle as gaps explain counts as none.
 */
#include "mesh_matrix.h"
#include <math.h>

/* what resists a speed, of what resists most: below that it is rounding */
static const real ROUNDING = 1e-14;
/* the angle that is left of a row, of that by which bodies would have to turn to close it */
static const real LEFT = 10;
/* The largest unit of the turns of places that a block of rows meets: how far the bodies there turn
 * with a displacement of 1. What nothing resists has no unit of its own. */
static real rotation_angle(const cardan_mesh *mesh, const cardan_mesh_system *system, ptrdiff_t block,
                    real least)
{
    const cardan_sparse *plan = mesh->plan;
    real most = 0;

    for (ptrdiff_t pair = plan->row[block]; pair < plan->row[block + 1]; pair++) {
        const ptrdiff_t first = plan->first[plan->column[pair]];
        const ptrdiff_t size = plan->first[plan->column[pair] + 1] - first;
        /* of the speeds of a pose the first three */
        for (ptrdiff_t j = first; j < first + (size == 6 ? 3 : size) && j < mesh->nu; j++)
            if (fabs(system->a[mesh->diagonal[j]]) > least)
                most = fmax(most, system->units[j]);
    }
    return most;
}

/* The sine of the angle that rows may have to others because of gaps open (mp). */
real cardan_mesh_sine(const cardan_mesh *mesh, const cardan_mesh_system *system, const real *open)
{
    const cardan_sparse *plan = mesh->plan;
    real *gap = system->solution, largest = 0, angle = 0;
    ptrdiff_t closing = 0;

    /* in trees no row follows from others */
    while (closing < plan->n && plan->multiplier[closing] != 2)
        closing++;
    if (closing == plan->n)
        return 0;
    for (ptrdiff_t i = 0; i < mesh->nu; i++)
        largest = fmax(largest, fabs(system->a[mesh->diagonal[i]]));
    for (ptrdiff_t k = 0; k < mesh->m; k++)
        gap[mesh->unknown[k]] = k < mesh->mp ? open[k] : 0;
    for (ptrdiff_t block = mesh->places; block < plan->blocks; block++) {
        real wide = 0;
        for (ptrdiff_t k = plan->first[block]; k < plan->first[block + 1]; k++)
            wide = fmax(wide, fabs(system->rows[k] * gap[k]));
        angle = fmax(angle, wide * rotation_angle(mesh, system, block, ROUNDING * largest));
    }
    return LEFT * angle;
}
