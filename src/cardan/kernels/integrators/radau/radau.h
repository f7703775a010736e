/* The Radau IIA method: what its files share.
 *
 * Part of cardan. Caller owns all memory.
 */
#ifndef CARDAN_RADAU_H
#define CARDAN_RADAU_H

#include "run.h"

/* State that persists between steps, at the start of the memory of the method. */
typedef struct cardan_radau {
    real factored; /* step size of the stored factors, 0: none */
    real current;  /* 1: the Jacobian was evaluated at the present state */
    real reusable; /* 1: the Jacobian may be kept for the next step */
    real rate;     /* theta / (1 - theta) of the last Newton solve, theta its convergence rate */
    real h, error; /* size and error of the last accepted step; h = 0: none in this segment */
} cardan_radau;
enum { CARDAN_RADAU_NUMBERS = (int)(sizeof(cardan_radau) / sizeof(real)) };

/* Where the memory of a form begins: behind those numbers, a state (n) and a derivative (n). */
static inline real *cardan_radau_memory(const cardan_run *run)
{
    return run->method_memory ? run->method_memory + CARDAN_RADAU_NUMBERS + 2 * run->n : NULL;
}

/* What the polynomial of the last step on [0, 1], as rows (3, n) of a dense output, adds to entry i
 * up to 1 + theta; the second and third row vanish at its end. */
static inline real cardan_radau_beyond(const real *rows, ptrdiff_t n, ptrdiff_t i, real theta)
{
    return theta * rows[i] - (1 + theta) * theta * (rows[n + i] + (1 + theta) * rows[2 * n + i]);
}

/* How the equations of the stages are written and solved; `length`: of its memory.
 * Statuses are those of a run; CARDAN_TOO_SMALL: no convergence. */
typedef struct cardan_radau_form {
    ptrdiff_t (*length)(const cardan_run *run);
    int (*sound)(const cardan_run *run); /* whether indices stored there are valid */
    int (*begin)(cardan_run *run);       /* at the start of a segment */
    int (*jacobian)(cardan_run *run, real h); /* at the present state */
    int (*factor)(cardan_run *run, real h);
    /* starting values of the stages; ratio: h by the size of the last step, 0: there is none */
    int (*predict)(cardan_run *run, real h, real ratio);
    real (*rounding)(cardan_run *run, real h); /* size of an update that is only rounding */
    /* one simplified Newton iteration; `size`: norm of the update in units of the tolerance */
    int (*iterate)(cardan_run *run, real h, real *size);
    /* stage increments (3, n) of x in `k`, and x at the end in `trial` */
    int (*end)(cardan_run *run, real h);
    /* filtered error norm in units of the tolerance; again: with f(t, y + error) in place of f(t, y) */
    int (*error)(cardan_run *run, real h, int again, real *error);
    void (*remember)(cardan_run *run); /* what the next step extrapolates */
    real fast; /* convergence rates up to this keep the Jacobian */
    int refilters; /* 1: an error above 1 is filtered again in every step */
} cardan_radau_form;

/* radau_rates.c: x' = f(t, x), dense matrices */
extern const cardan_radau_form cardan_radau_rates;
/* radau_elements.c: elements with constraints, sparse matrices */
extern const cardan_radau_form cardan_radau_elements;

#endif
