/* Gradient of a cost of a motion of an exported model: a run, and a sweep back over its steps.
 *
 * Part of cardan. The cost is that of the export. Two seconds from where the scene starts:
 *
 *     cardan_gradient of = {.run = {.end = 2}};
 *     void *memory = malloc(cardan_gradient_size(&cardan_scene, &of));
 *     int status = cardan_gradient_of(&cardan_scene, &of, memory);
 *
 * then of.cost, of.by_x[q_elbow], of.by_p[p_mass]. It is the gradient of the numbers that were computed,
 * with the sizes of the steps as they were, exact to rounding: see adjoint.h.
 */
#ifndef CARDAN_MOTION_GRADIENT_H
#define CARDAN_MOTION_GRADIENT_H

#include "simulate.h"

/* no gradient: `refused` says why and what to do */
enum { CARDAN_NO_GRADIENT = -20 };

typedef struct cardan_gradient {
    cardan_simulation run; /* as cardan_simulate takes it; `times` and `rows` stay NULL */
    ptrdiff_t most_steps;  /* room for them, cardan_gradient_steps without; more end with CARDAN_FULL */

    /* what came of it; the arrays lie in the memory */
    double cost;
    const double *by_x;  /* (nx) by the start, entry by entry as x has them; a unit quaternion counts by
                            its direction, and changes that open loops are brought onto them first */
    const double *by_p;  /* (np) by the parameters */
    const double *by_r;  /* (nr) by the inputs, which are constant */
    const double *x_end; /* (nx) where the motion ended, at run.t after run.steps steps */
    const char *refused; /* why there is no gradient, NULL if there is one */
    const char *event;   /* the event that is to blame, NULL if none is */
} cardan_gradient;

/* Steps for which there is room where nobody says it: those of a given size, else 10000. */
ptrdiff_t cardan_gradient_steps(const cardan_export *model, const cardan_gradient *of);
/* Bytes of memory, aligned as malloc does; 0: there is no such method, or no gradient with it. */
size_t cardan_gradient_size(const cardan_export *model, const cardan_gradient *of);
/* Run and sweep. Returns CARDAN_DONE, CARDAN_NO_GRADIENT, or what ended the run, as cardan_simulate. */
int cardan_gradient_of(const cardan_export *model, cardan_gradient *of, void *memory);

#endif
