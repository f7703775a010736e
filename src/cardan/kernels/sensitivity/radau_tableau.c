/* Coefficients of Radau IIA as a table.
 *
 * Part of cardan.
 */
#include "steps.h"
#include "radau_tables.h"

enum { STAGES = 3 };

ptrdiff_t cardan_radau_tableau(real *nodes, real *weights, real *matrix)
{
    for (ptrdiff_t s = 0; s < STAGES; s++) {
        nodes[s] = NODES[s];
        weights[s] = A[STAGES - 1][s];
        for (ptrdiff_t j = 0; j < STAGES; j++)
            matrix[s * STAGES + j] = A[s][j];
    }
    return STAGES;
}
