/* Coefficients of DOP853 as a table: its 12 stages and its solution.
 *
 * Part of cardan.
 */
#include "steps.h"
#include "dop853_tables.h"

enum { STAGES = 12 };

ptrdiff_t cardan_dop853_tableau(real *nodes, real *weights, real *matrix)
{
    for (ptrdiff_t s = 0; s < STAGES; s++) {
        nodes[s] = C[s];
        weights[s] = A[STAGES][s];
        for (ptrdiff_t j = 0; j < STAGES; j++)
            matrix[s * STAGES + j] = j < s ? A[s][j] : 0;
    }
    return STAGES;
}
