/*
 * sparse.h: linear systems of many small blocks, such as those of finite-element coordinates.
 *
 * The unknowns come in blocks: speeds of a node or a joint, multipliers of an element. The coupling of
 * blocks, the order of elimination (minimum degree) and the place of every number are planned once,
 * in tables (runtime/sparse/plan.py). Nothing is searched and no memory is allocated here.
 * LU factorization by supernodes: consecutive unknowns with the same later neighbors, eliminated
 * together as dense blocks.
 *
 *   a      the assembled matrix in compressed rows: the rows of a block follow each other, and each
 *          holds the columns of all blocks coupled with it, ascending
 *   panel  a supernode in the factors: D, U and Lt, row by row, one behind the other. D (n x n) couples its
 *          own unknowns, U (n x later) its rows with later unknowns, Lt (n x later, transposed) the rows
 *          of later unknowns with its columns. Of long chains solutions take the time in which these
 *          come from memory: D and Lt on the way forward, D and U on the way back. Pivots are chosen
 *          among the rows of the supernode only
 *
 * Zero pivots that remain are replaced by small ones and recorded; where they are of multipliers, all
 * rows that close loops give way by as much. If the matrix is regular, or its constraints are redundant
 * but consistent, refinement still gives the solution.
 * Denormal numbers are flushed to zero inside; the processor mode is restored.
 * Source: I. S. Duff, A. M. Erisman, J. K. Reid, Direct Methods for Sparse Matrices, chapters 10-12;
 * X. S. Li, J. W. Demmel, SuperLU_DIST, ACM TOMS 29 (2003), on static pivots with refinement.
 */
#ifndef CARDAN_SPARSE_H
#define CARDAN_SPARSE_H

#include "cardan.h"
#include <stddef.h>

/* A block of the matrix and its place in a panel. */
typedef struct cardan_sparse_load {
    int32_t from;   /* its first value in a */
    int32_t stride; /* numbers from one of its rows to the next */
    int32_t to;     /* where it begins in the factors */
    int32_t rows, columns;
    int32_t row, column; /* first unknown of its rows and of its columns, as in a */
    int32_t transposed;  /* 1: it goes to Lt */
} cardan_sparse_load;

/* Consecutive unknowns of one later supernode that are coupled with a supernode. */
typedef struct cardan_sparse_run {
    int32_t at;    /* where they begin in U and Lt */
    int32_t size;  /* how many */
    int32_t place; /* the first of them, in order of elimination */
    int32_t owner; /* the later supernode */
} cardan_sparse_run;

/* The plan; all tables are constant. */
typedef struct cardan_sparse {
    ptrdiff_t n;          /* unknowns */
    ptrdiff_t blocks;     /* their blocks */
    ptrdiff_t values;     /* numbers of a */
    ptrdiff_t supernodes;
    ptrdiff_t factors;    /* numbers of the factors */
    ptrdiff_t widest;     /* unknowns of the largest supernode */
    /* the matrix */
    const int32_t *first;  /* blocks + 1: the first unknown of a block */
    const int32_t *row;    /* blocks + 1: where its list begins in `column` */
    const int32_t *column; /* the blocks that a row block meets, ascending */
    const int32_t *at;     /* blocks: its first value in a */
    const int32_t *stride; /* blocks: numbers from one of its rows to the next */
    /* the elimination */
    const int32_t *order;      /* n: the unknown that is eliminated as the k-th */
    const int32_t *multiplier; /* n: 1 if that one is a multiplier, 2 of a loop, 0 for speeds */
    const int32_t *start;      /* supernodes + 1: its first unknown in that order */
    const int32_t *panel;      /* supernodes: where its panel begins */
    const int32_t *later;      /* supernodes: unknowns in U */
    const int32_t *open_start; /* supernodes + 1: where its list begins in `open` */
    const int32_t *open;       /* supernodes: the panels to be filled when its turn comes */
    const int32_t *load_start; /* supernodes + 1: where its list begins in `load` */
    const cardan_sparse_load *load;
    const int32_t *run_start; /* supernodes + 1: where its list begins in `run` */
    const cardan_sparse_run *run;
    const int32_t *target_start; /* supernodes: where its list begins in `target` */
    const int32_t *target;       /* for run i, for run j: where their product goes */
} cardan_sparse;

/* A supernode and its numbers among the factors. */
typedef struct cardan_panel {
    ptrdiff_t first, n, later; /* its first unknown, in order of elimination; how many; unknowns of U */
    double *d, *u, *lt;        /* (n, n), (n, later), (n, later) */
} cardan_panel;

static inline cardan_panel cardan_panel_of(const cardan_sparse *plan, ptrdiff_t s, double *values)
{
    cardan_panel panel = {plan->start[s], plan->start[s + 1] - plan->start[s], plan->later[s],
                          values + plan->panel[s], NULL, NULL};

    panel.u = panel.d + panel.n * panel.n;
    panel.lt = panel.u + panel.n * panel.later;
    return panel;
}

/* The numbers of a factorization. The caller provides the arrays and may read the results. */
typedef struct cardan_sparse_factors {
    double *values;        /* plan->factors */
    double *scale;         /* n: original size of each pivot, before anything was subtracted */
    double *work;          /* cardan_sparse_work(plan); solutions use it too */
    double *shift;         /* n: what was added to the diagonal, the first `weak` of them */
    int32_t *pivot;        /* n: with which row of its supernode each was exchanged */
    int32_t *exchanged;    /* n: with which column of it */
    int32_t *replaced;     /* n: the k-th unknowns, in order of elimination, they belong to: what lost
                              its pivot, and all rows that close loops if one of them did */
    const double *rows;    /* n: what equations are multiplied with, NULL for 1 */
    const double *columns; /* n: the units of unknowns, NULL for 1 */
    double *certainty;     /* CARDAN_SPARSE_CERTAINTY numbers, see cardan_sparse_solve_certain; NULL: not
                              wanted */
    double hidden;         /* loop constraints count as redundant if the squared sine of their
                              angle to the other rows is below this */
    double compliance;     /* what rows that close loops give way where multipliers lose their pivots,
                              of their size; 0: 1e-8, more where `hidden` asks for it */
    int32_t count;         /* 1: count the signs of the eigenvalues of a symmetric matrix */
    int32_t weak;          /* how many numbers were added; if not 0, solutions are to be refined */
    int32_t singular;      /* the unknown without any equation, or -1 */
    int32_t positive;      /* eigenvalues by their signs; the others are zero to rounding */
    int32_t negative;
} cardan_sparse_factors;

/* What is known of all solutions by the factors: what rounding leaves of a right-hand side at most, of
 * the largest unknown; the smallest diagonal entry of speeds, which the caller fills in; both scaled. */
enum { CARDAN_SPARSE_LEFT, CARDAN_SPARSE_DIAGONAL, CARDAN_SPARSE_CERTAINTY };

/* How many numbers of work memory a factorization needs. */
ptrdiff_t cardan_sparse_work(const cardan_sparse *plan);

/* Factor the matrix a. Returns CARDAN_SINGULAR where an unknown or an equation is empty, or where
 * numbers are not finite: `singular` then says which unknown, and there are no factors. */
int cardan_sparse_factor(const cardan_sparse *plan, const double *a, cardan_sparse_factors *f);

/* x = a^-1 b for `count` right-hand sides of n numbers, one behind the other; x may be b. */
void cardan_sparse_solve(const cardan_sparse *plan, const cardan_sparse_factors *f, ptrdiff_t count,
                         const double *b, double *x);

/* One of them by factors with `certainty` and no replaced pivots. Returns a bound of the backward error that
 * cardan_sparse_residual would find: of a solution below it nothing needs to be multiplied out. */
double cardan_sparse_solve_certain(const cardan_sparse *plan, const cardan_sparse_factors *f,
                                   const double *b, double *x);

/* Fill a panel with the numbers of the matrix, before any supernode is subtracted from it. */
void cardan_sparse_fill(const cardan_sparse *plan, ptrdiff_t s, const double *a,
                        cardan_sparse_factors *f);

/* What a supernode adds to CARDAN_SPARSE_LEFT; sums (supernodes, 2) are zeros before the first. */
void cardan_sparse_bound(const cardan_sparse *plan, ptrdiff_t s, const cardan_panel *panel, double *sums,
                         double *left);

/* The same with the transposed matrix. */
void cardan_sparse_solve_transposed(const cardan_sparse *plan, const cardan_sparse_factors *f,
                                ptrdiff_t count, const double *b, double *x);

/* y = a x. */
void cardan_sparse_multiply(const cardan_sparse *plan, const double *a, const double *x, double *y);

/* y = a^T x. */
void cardan_sparse_multiply_transposed(const cardan_sparse *plan, const double *a, const double *x,
                                       double *y);

/* Sizes below which numbers have too few digits left for relative errors: they count as exact. */
#define CARDAN_LEAST 1e-280

/* r = b - a x. Returns the backward error: the largest entry of r over the largest sum of magnitudes
 * |b| + |a| |x|, both scaled by units; infinity if a number is not finite. */
double cardan_sparse_residual(const cardan_sparse *plan, const cardan_sparse_factors *f,
                              const double *a, const double *b, const double *x, double *r);

/* Iterative refinement of a solution x of a x = b, at most `steps` times, until its backward error is
 * at most `enough` or no longer falls. room: 2 n numbers. Returns the backward error. */
double cardan_sparse_refine(const cardan_sparse *plan, const cardan_sparse_factors *f,
                            const double *a, const double *b, double enough, ptrdiff_t steps,
                            double *x, double *room);

/* Fraction of the right-hand side b that the changes of replaced pivots balance in the solution x:
 * nearly 0 if the matrix is regular, or singular and consistent; about 1 if there is no solution. The
 * unknown with the largest fraction is left in `unknown`, -1 if there is none. */
double cardan_sparse_perturbation(const cardan_sparse *plan, const cardan_sparse_factors *f,
                             const double *b, const double *x, int32_t *unknown);

/* A null vector x (n) of the matrix in which speeds move. Returns the speed that moves most, in its
 * unit; -1 if there is none: then only multipliers had lost their pivots, or later unknowns made up
 * for the loss. */
int32_t cardan_sparse_free_column(const cardan_sparse *plan, const cardan_sparse_factors *f, double *x);

/* Replace y, the right-hand side in order of elimination and in units, by the solution. */
void cardan_sparse_substitute(const cardan_sparse *plan, const cardan_sparse_factors *f, int transposed,
                              double *y);

/* Count the signs of the eigenvalues of a symmetric D (n x n) of a panel in f. work: n thresholds up
 * to which diagonal entries count as zero, then n n numbers of scratch. */
void cardan_sparse_signs(ptrdiff_t n, const double *d, double *work, cardan_sparse_factors *f);

/* Whether the rows and columns that factors name exist, as they may come from a file; `weak` is how many
 * pivots were replaced, as a number. Memory that is zero is sound. */
int cardan_sparse_sound(const cardan_sparse *plan, const cardan_sparse_factors *f, double weak);

/* The logarithm of |det a|, and its sign, 1 or -1. Replaced pivots enter with their new values. */
double cardan_sparse_determinant(const cardan_sparse *plan, const cardan_sparse_factors *f,
                                 double *sign);

/* Estimate of the smallest singular value of the scaled matrix by inverse iteration, and its right
 * singular vector x (n), scaled, of length 1. x is a nonzero guess on entry. */
double cardan_sparse_smallest(const cardan_sparse *plan, const cardan_sparse_factors *f,
                              ptrdiff_t steps, double *x);

/* sparse_pair.c: the plan of a complex matrix as a real one of pairs, whose tables lie in memory of
 * so many numbers; `fill` writes them. */
ptrdiff_t cardan_sparse_pair_length(const cardan_sparse *plan);
void cardan_sparse_pair(const cardan_sparse *plan, double *memory, cardan_sparse *pair);
void cardan_sparse_pair_fill(const cardan_sparse *plan, double *memory);
/* a = powers[0] + c powers[1] + c^2 powers[2] with c = re + i im, as the plan of pairs has it. */
void cardan_sparse_pair_combine(const cardan_sparse *plan, const double *const *powers,
                                double re, double im, double *a);

#endif
