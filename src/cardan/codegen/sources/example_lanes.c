#include "functions.h"
#include <stdio.h>
#include <stdlib.h>

/* so that *.c of this folder links with a main of yours */
#ifdef CARDAN_EXAMPLE_LANES

enum { COUNT = 10 };

/* One second of motion from ten states near where the scene starts, side by side and one by one. */
int main(void)
{
    const cardan_export *model = &cardan_scene;
    const ptrdiff_t nx = model->nq + model->nu + model->nz;
    double *x = calloc((size_t)(3 * COUNT * nx), sizeof *x), *ends[] = {x + COUNT * nx, x + 2 * COUNT * nx};
    ptrdiff_t answers[COUNT], equal = 0;

    for (ptrdiff_t k = 0; x && k < COUNT * nx; k++) {
        const ptrdiff_t i = k % nx;
        x[k] = i < model->nq ? model->q[i] : i < model->nq + model->nu ? model->u[i - model->nq]
                                                                     : model->z[i - model->nq - model->nu];
        x[k] += 0.01 * (double)(k / nx);
    }
    for (int alone = 0; x && alone < 2; alone++) {
        const cardan_lane_build *build = alone ? NULL : &cardan_scene_lanes;
        cardan_simulations runs = {.common = {.end = 1}, .count = COUNT, .x = x, .x_end = ends[alone],
                                   .answers = answers};
        void *memory = malloc(cardan_simulations_size(model, build, &runs));
        const int status = memory ? cardan_simulate_lanes(model, build, &runs, memory) : 1;

        free(memory);
        for (ptrdiff_t i = 0; i < COUNT; i++)
            if (status != 0 || answers[i] != 0)
                fprintf(stderr, "run %d: status %d; run.h says what that is\n", (int)i, (int)answers[i]);
        printf("%d runs, %d side by side: %d steps\n", COUNT, (int)runs.side_by_side, (int)runs.steps);
    }
    for (ptrdiff_t k = 0; x && k < COUNT * nx; k++) {
        equal += ends[0][k] == ends[1][k];
        if (k < nx || k >= (COUNT - 1) * nx)
            printf("x[%d][%d] = %.17Lg\n", (int)(k / nx), (int)(k % nx), (long double)ends[0][k]);
    }
    printf("%d of %d numbers are the same bits\n", (int)equal, (int)(COUNT * nx));
    free(x);
    return 0;
}

#endif
