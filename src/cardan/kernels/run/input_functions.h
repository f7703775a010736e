/* Inputs that functions compute: C of the user, which may read outputs of the model.
 *
 * Part of cardan.
 */
#ifndef CARDAN_INPUT_FUNCTIONS_H
#define CARDAN_INPUT_FUNCTIONS_H

#include "run.h"

/* C of the user: from time, state x = [q, u, z] and the outputs it reads to the inputs it gives. */
typedef struct cardan_input_function {
    int (*function)(double t, const double *x, const double *reads, double *gives);
    const ptrdiff_t *reads; /* (read_count) places among the outputs */
    const ptrdiff_t *gives; /* (give_count) places in r */
    ptrdiff_t read_count, give_count;
} cardan_input_function;

typedef struct cardan_input_functions {
    cardan_run *run;
    cardan_call outputs; /* of the model, NULL if none is read */
    int (*python)(void *context, real t, const real *x, real *r); /* for those in Python, NULL without */
    const cardan_input_function *functions; /* (count) */
    ptrdiff_t count;
    real *values, *work; /* the outputs, and what their function needs */
    double *reads, *gives; /* room for those of the function that takes most */
    ptrdiff_t failed; /* function that returned another status than 0, -1 if none did */
    ptrdiff_t status; /* what it returned */
} cardan_input_functions;

/* What a run asks for its inputs; `context` is a cardan_input_functions. */
int cardan_input_functions_at(void *context, real t, const real *x, real *r);

#endif
