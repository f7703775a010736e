/* Positions of a mechanism that meet conditions, next to a start. Part of cardan.
 *
 * The caller owns the record and every array it points to. Lengths count in sizes of the mechanism
 * and angles in radians: rows and columns of Jacobians can be compared, and a rank says something.
 */
#ifndef CARDAN_POSITION_H
#define CARDAN_POSITION_H

#include "run.h"

/* What a position is to reach: coordinates, (q[entries] - value) / scale, or what functions say. */
typedef struct cardan_target {
    ptrdiff_t rows;
    real weight;              /* root of what its square counts; negative: it must hold */
    const ptrdiff_t *entries; /* (rows) of q, where there are no functions */
    const real *value;        /* (rows) */
    const real *scale;        /* (rows) */
    cardan_call residual;     /* (rows) */
    cardan_call jacobian;     /* (rows, nu) per step */
} cardan_target;

typedef struct cardan_position {
    /* the mechanism */
    ptrdiff_t nq;
    ptrdiff_t nu;                    /* steps */
    ptrdiff_t positions;             /* constraints of positions */
    ptrdiff_t kept_count;            /* those of them that must hold */
    const ptrdiff_t *kept;           /* (kept_count), all if NULL */
    const real *rows;                /* (positions) what they count in, 1 if NULL */
    const real *columns;             /* (nu) what steps count in, 1 if NULL */
    const ptrdiff_t *quaternions;    /* where they start in q */
    ptrdiff_t quaternion_count;
    cardan_call constraints;         /* (positions) */
    cardan_call constraint_jacobian; /* (positions or more, nu) */
    cardan_call integrate;           /* q moved by du (nq) */
    cardan_call qdot;                /* (nq) by u */
    cardan_call kinematics;          /* instead of it: coordinates per step (nq, nu) */
    cardan_call facing;              /* (facings): positive where axes are as they were built */
    ptrdiff_t facings;
    real t;
    const real *z, *s, *r;
    const cardan_target *targets;
    ptrdiff_t target_count;
    /* how it is sought */
    real rank;  /* singular values below this part of the largest, or of 1, hold nothing */
    real slack; /* residuals that count as none, beside those of rounding */
    ptrdiff_t hard, soft; /* rows that must vanish, rows that should be small */
    ptrdiff_t iteration;
    real damping;
    real *q;         /* (nq) the position */
    real *residuals; /* (hard + soft) there, the latter by their weights */
    real *jacobian;  /* (hard + soft, nu) where it was asked for last */
    real *memory;    /* cardan_position_length */
    real *work;      /* of the functions */
    /* where it ended */
    real open; /* the largest residual of what must vanish; infinite where one is not a number */
    real cost; /* sum of squares of what should be small */
    ptrdiff_t freedoms; /* steps that keep what must hold, to first order */
    ptrdiff_t turned;   /* first of the facings that is not positive, -1 if none */
} cardan_position;

ptrdiff_t cardan_position_length(const cardan_position *p);
int cardan_position_residuals(cardan_position *p);
int cardan_position_jacobian(cardan_position *p);
int cardan_position_begin(cardan_position *p);
int cardan_position_solve(cardan_position *p, ptrdiff_t budget);

/* least.c: rows that must vanish, rows that should be small */
typedef struct cardan_least {
    ptrdiff_t hard, soft, nu;
    const real *jacobian;  /* (hard + soft, nu) */
    const real *residuals; /* (hard + soft) */
    real rank, damping;
    real *memory;          /* cardan_least_length */
    ptrdiff_t freedoms;    /* nu less the rank of the hard rows */
    real price;            /* what leaving them costs: 1 + the largest multiplier */
} cardan_least;

ptrdiff_t cardan_least_length(ptrdiff_t hard, ptrdiff_t soft, ptrdiff_t nu);
void cardan_least_step(cardan_least *least, real *step);

#endif
