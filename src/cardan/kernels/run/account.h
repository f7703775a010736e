/* What a run has done with its energy, as far as its rows tell.
 *
 * Part of cardan. Caller owns all memory.
 */
#ifndef CARDAN_ACCOUNT_H
#define CARDAN_ACCOUNT_H

#include "run.h"

typedef struct cardan_account {
    /* what is looked at */
    const real *u;        /* (count, stride) of which the first nu are speeds */
    ptrdiff_t count, nu, stride;
    ptrdiff_t every_step; /* 1: the rows are those of all steps */
    real least;           /* of the largest range: speeds that vary by less show no period */
    const real *energy;   /* (looked, 3) kinetic, potential, total */
    const real *supplied; /* (looked, sources) energy that sources have given */
    ptrdiff_t looked, sources;
    /* what comes out */
    real fastest;   /* largest speed */
    real turns;     /* how often the speed that turns back most does so */
    real kinetic;   /* largest */
    real potential; /* largest by its size */
    real exchanged; /* by how much the potential and what sources have given went up and down */
    real missed;    /* largest that is unaccounted for */
} cardan_account;

void cardan_account_of(cardan_account *account);

#endif
