/* Solver for positions of a mechanism that meet constraints and targets. Part of cardan.
 *
 * The caller owns the record and every array it points to. Lengths are measured in sizes of the
 * mechanism and angles in radians. Rows and columns of Jacobians are then comparable, and a
 * numerical rank is meaningful.
 */
#ifndef CARDAN_POSITION_H
#define CARDAN_POSITION_H

#include "run.h"

/* A target: coordinates, (q[entries] - value) / scale, or residuals of a model function. */
typedef struct cardan_target {
    ptrdiff_t rows;
    real weight;              /* of a soft target: factor of its residuals; any negative number: hard target */
    const ptrdiff_t *entries; /* (rows) of q, if there are no functions */
    const real *value;        /* (rows) */
    const real *scale;        /* (rows) */
    cardan_call residual;     /* (rows) */
    cardan_call jacobian;     /* (rows, nu) per step */
} cardan_target;

typedef struct cardan_position {
    /* the mechanism */
    ptrdiff_t nq;
    ptrdiff_t nu;                    /* entries of a step */
    ptrdiff_t positions;             /* position constraints */
    ptrdiff_t hard_count;            /* number of enforced position constraints */
    const ptrdiff_t *hard_rows;      /* (hard_count) ascending, all if NULL */
    const real *rows;                /* (positions) units of the constraints, 1 if NULL */
    const real *columns;             /* (nu) units of the step, 1 if NULL */
    const ptrdiff_t *quaternions;    /* first entry of each in q */
    ptrdiff_t quaternion_count;
    cardan_call constraints;         /* (positions) */
    cardan_call constraint_jacobian; /* (positions, nu), other rows may follow */
    cardan_call integrate;           /* q moved by du (nq) */
    cardan_call qdot;                /* (nq) by u */
    cardan_call kinematics;          /* optional replacement of qdot: dq per step (nq, nu) */
    cardan_call assembly_signs;      /* (assembly_sign_count): positive if axes point as assembled */
    ptrdiff_t assembly_sign_count;
    real t;
    const real *z, *s, *r;
    const cardan_target *targets;
    ptrdiff_t target_count;
    /* solver state */
    real rank;  /* singular values below this times max(1, largest) count as zero */
    real residual_noise; /* residuals that count as zero, in addition to rounding */
    ptrdiff_t hard, soft; /* rows that must vanish, rows to be minimized */
    ptrdiff_t iteration;
    real damping;
    real *q;         /* (nq) present position */
    real *residuals; /* (hard + soft) at q, soft ones weighted */
    real *jacobian;  /* (hard + soft, nu) as last evaluated */
    real *memory;    /* workspace of cardan_position_length numbers */
    real *work;      /* scratch of the model functions */
    /* result */
    real open; /* largest absolute hard residual; infinite if one is not finite */
    real cost; /* sum of squares of the soft residuals */
    ptrdiff_t freedoms; /* dimension of the motions that keep the hard residuals, to first order */
    ptrdiff_t wrong_sign;   /* first assembly sign that is not positive, -1 if none */
} cardan_position;

ptrdiff_t cardan_position_length(const cardan_position *p);
int cardan_position_residuals(cardan_position *p);
int cardan_position_jacobian(cardan_position *p);
int cardan_position_begin(cardan_position *p);
int cardan_position_solve(cardan_position *p, ptrdiff_t budget);

/* least.c: hard rows must vanish, soft rows are minimized */
typedef struct cardan_least {
    ptrdiff_t hard, soft, nu;
    const real *jacobian;  /* (hard + soft, nu) */
    const real *residuals; /* (hard + soft) */
    real rank, damping;
    real *memory;          /* cardan_least_length */
    ptrdiff_t freedoms;    /* nu minus the rank of the hard rows */
    real price;            /* penalty weight of hard residuals: 1 + the largest multiplier */
} cardan_least;

ptrdiff_t cardan_least_length(ptrdiff_t hard, ptrdiff_t soft, ptrdiff_t nu);
void cardan_least_step(cardan_least *least, real *step);

#endif
