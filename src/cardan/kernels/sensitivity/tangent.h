/* Sensitivities of a motion: a sweep forward over the steps that a run has taken.
 *
 * Part of cardan. Caller owns all memory.
 *
 * Every column is the change of the state along one direction of starts, parameters and inputs. Steps
 * are differentiated as they were taken, see adjoint.h: this is the same derivative the other way
 * round.
 */
#ifndef CARDAN_TANGENT_H
#define CARDAN_TANGENT_H

#include "steps.h"

/* Derivatives below are along coordinates, u, z, s and r, as far as there are any of them, a matrix
 * for each with a row for every result, then along `named` parameters, a vector for each.
 * Tables of all columns have a row for every number, `wide` of them: so they go side by side. */
typedef struct cardan_tangent {
    struct cardan_steps *steps;
    ptrdiff_t pushed;           /* 1: the functions are changes along a direction, called for each */
    cardan_call rates;          /* derivative of rhs (nx) */
    cardan_call close_position; /* of close_position (nq + positions), NULL without constraints */
    cardan_call close_velocity; /* of close_velocity (nu + rates) */
    ptrdiff_t columns, named;
    ptrdiff_t wide;        /* columns, and empty ones to a multiple of CARDAN_SIDE_BY_SIDE */
    const ptrdiff_t *named_ends; /* (named): how many of the next two belong to it and those before */
    const ptrdiff_t *named_columns; /* in which a parameter changes */
    const real *named_changes;   /* and by how much */
    const real *by_input;  /* (columns, nr) of inputs that are constant */
    const real *by_coefficients; /* (columns, pieces, 4) of the coefficients of all signals */
    const real *by_s;      /* (columns, ns) of the discrete states at all steps */
    ptrdiff_t segments;
    real *changes;  /* (count, columns, nx) of the state at every row; the first one is given */
    real *before;   /* (nx, wide) of the state at the start of a step */
    real *moved;    /* (nx + ns + nr, wide) of what a function reads */
    real *changed;  /* (nx, wide) of what it gives */
    real *along;    /* (nx + ns + nr + named) one column of what it reads */
    real *rising;   /* (CARDAN_MOST_STAGES, nx, wide) of the slopes of stages */
    real *coupled;  /* (stages, nx) of one column, of coupled stages; (columns, nx) of a pass */
    real *out;      /* longest result */
} cardan_tangent;

int cardan_tangent_sweep(cardan_tangent *tangent);

#endif
