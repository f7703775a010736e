/* The Radau IIA method over elements: data that its files share.
 *
 * Part of cardan. Caller owns all memory.
 */
#ifndef CARDAN_RADAU_ELEMENTS_H
#define CARDAN_RADAU_ELEMENTS_H

#include "mesh_extent.h"
#include "mesh_matrix.h"
#include "radau.h"

/* entries of `now` */
enum {
    RADAU_EXTENT,                                /* reference length: see mesh_extent.h */
    RADAU_FASTEST = RADAU_EXTENT + CARDAN_EXTENT, /* largest speed so far, in units of that per second */
    RADAU_WEAK,                                  /* replaced pivots of the real and the complex system */
    RADAU_WEAK_PAIR,
    RADAU_NOW
};

/* The parts of the memory; width = nu + nz + m: speeds, internal states, multipliers. */
typedef struct cardan_radau_stages {
    const cardan_mesh *mesh;
    cardan_mesh doubled; /* the mesh with the plan of pairs */
    cardan_sparse pairs;
    ptrdiff_t nu, nz, m, width;

    /* persistent between steps */
    real *now;         /* RADAU_NOW numbers */
    real *lam;         /* (m) multipliers at t */
    real *before;      /* (3, width) polynomials of the last step */
    real *powers[3];   /* matrices: see cardan_mesh_powers */
    real *change, *slopes; /* of the rates of internal states: see cardan_mesh_slopes */
    real *tables;      /* of the plan of pairs */
    cardan_mesh_system alone, pair; /* the real system and the complex one, in pairs of numbers */

    /* trial step, by stages */
    real *x, *w;       /* (3, width) increments and T^-1 of them */
    real *d;           /* (3, nu) increments along the speeds from the start of the step */
    real *shift;       /* (3, nu) part of d by which positions keep their constraints */
    real *rates;       /* (3, nu) of d - shift */
    real *states;      /* (3, nx) */
    real *maps;        /* (3, places, 9) tangents of the rotations d */
    real *turns;       /* (3, places, 9) rotations of nodes since the start of the step */
    real *residual;    /* (3, nu + mp + m) */
    real *gaps;        /* (3, mp) of positions */
    real *kinematic;   /* (3, nu) what d misses of its rates, then its change */
    real *zdot;        /* (3, nz) */
    real *udot;        /* (nu) */
    real *padded, *product; /* (2, n) vectors of the plan */
    real *error;       /* (2 nu + nz) d, u and z of the estimated error */
    real *block;       /* system of the internal states of an element */
} cardan_radau_stages;

/* radau_elements.c */
void cardan_radau_stages_at(const cardan_run *run, cardan_radau_stages *v);
cardan_state cardan_radau_state(const cardan_run *run, const real *t, const real *x, const real *lam);
/* Sum of squares of increments d, speeds u and internal states z, each in units of its tolerance. */
real cardan_radau_squares(cardan_run *run, const cardan_radau_stages *v, const real *d, const real *u,
                          const real *z, real *largest);
/* radau_elements_newton.c; transform: a (3, n) = B a with a matrix over the stages */
void cardan_radau_transform(const real B[3][3], ptrdiff_t n, real *a);
int cardan_radau_elements_iterate(cardan_run *run, real h, real *size);
int cardan_radau_place(cardan_run *run, const cardan_radau_stages *v, int stage);
/* radau_elements_turn.c: vectors (nu) into the axes of a stage, or back from there */
void cardan_radau_turns(const cardan_run *run, const cardan_radau_stages *v, int stage);
void cardan_radau_forward(const cardan_radau_stages *v, int stage, real *x);
void cardan_radau_backward(const cardan_radau_stages *v, int stage, real *x);
/* radau_elements_end.c */
int cardan_radau_elements_end(cardan_run *run, real h);
int cardan_radau_elements_error(cardan_run *run, real h, int again, real *error);
void cardan_radau_elements_remember(cardan_run *run);

#endif
