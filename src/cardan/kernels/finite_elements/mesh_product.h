/* Products of weights with derivatives of the functions of a mesh, and all columns of these.
 *
 * Part of cardan. Caller owns all memory.
 *
 * Of a sum of results with weights v every kind of element has a gradient by what it reads, one sweep
 * in reverse. Accelerations and multipliers y are never differentiated through their solution: they
 * fulfil R(x, y) = 0, balance and constraints, so that the gradient of phi(x, y) is that of phi - mu R
 * at mu R_y = phi_y, one solve with the factors at hand. Projections onto constraints are differentiated
 * where gaps are closed: what is proportional to them is left out.
 * Source: A. Griewank, A. Walther, Evaluating Derivatives (2008), sections 3.2 and 15.3.
 */
#ifndef CARDAN_MESH_PRODUCT_H
#define CARDAN_MESH_PRODUCT_H

#include "mesh_calls.h"

/* functions of a mesh that have derivatives */
enum {
    CARDAN_OF_INVERSE_DYNAMICS,
    CARDAN_OF_CONSTRAINTS,
    CARDAN_OF_CONSTRAINT_RATES,
    CARDAN_OF_ENERGY,
    CARDAN_OF_MOMENTUM,
    CARDAN_OF_POWER,
    CARDAN_OF_OUTPUTS,
    CARDAN_OF_QDOT,
    CARDAN_OF_RHS,
    CARDAN_OF_FORWARD_DYNAMICS,
    CARDAN_OF_MULTIPLIERS,
    CARDAN_OF_CLOSE_POSITION,
    CARDAN_OF_CLOSE_VELOCITY,
    CARDAN_OF_EXPRESSION,
    CARDAN_OF_EVENTS,
    CARDAN_OF_TRANSITION,
    CARDAN_OF_REACTION,
    CARDAN_OF_ELEMENT_FORCES,
    CARDAN_OF_MASS_MATRIX,
    CARDAN_OF_CONSTRAINT_JACOBIAN,
    CARDAN_OF_POSE,
    CARDAN_OF_VELOCITY,
    CARDAN_OF_ACCELERATION,
    CARDAN_OF_FRAME_JACOBIAN
};

/* numbers of the motion of a body, ground axes: R (9), p (3), velocity (6), acceleration (6) */
enum { CARDAN_MOTION = 24 };

/* Slopes of the data of the elements of a group by the parameters, row by row: those of one element,
 * if `shared`, or of all of them. */
typedef struct cardan_data_slopes {
    ptrdiff_t count;            /* data of an element that parameters change, the first ones */
    ptrdiff_t shared;           /* 1: all elements have the same */
    const ptrdiff_t *start;     /* (rows + 1) */
    const ptrdiff_t *parameter; /* of every slope */
    const real *slope;
    /* of Hessians: where rows begin among those of all groups, and second derivatives by two
     * parameters, in both orders where these differ */
    ptrdiff_t first_row, rows;
    const ptrdiff_t *second_start;      /* (rows + 1) */
    const ptrdiff_t *second_parameters; /* of every second derivative, 2 each */
    const real *second;
} cardan_data_slopes;

/* Sums that the results of the elements of a group add to. */
typedef struct cardan_summands {
    ptrdiff_t size;            /* numbers of a result */
    const ptrdiff_t *which;    /* (count, size): which sum; the one behind all sums: none */
} cardan_summands;

/* A frame: on a node, on the ground, or on a body whose motion an element tells as sums. */
typedef struct cardan_frame {
    ptrdiff_t q, u;            /* first coordinate and speed of its node; -1: it has none */
    const real *home, *to_space; /* of nodes of a plane: unit quaternion at angle 0 (4); speeds in space
                                  from the rates of x, y and angle (6, 3); NULL: it is in space */
    const real *local;         /* its axes on node or body (9), then its origin there (3) */
    const cardan_data_slopes *data; /* of these by the parameters; NULL: not by parameters */
    ptrdiff_t speeds;          /* that move it */
    const ptrdiff_t *speed;    /* (speeds) */
} cardan_frame;

/* What a product is made of; it is the `w` of its functions. */
typedef struct cardan_mesh_product {
    const cardan_mesh *mesh;       /* with room for gradients */
    ptrdiff_t function;            /* CARDAN_OF_... */
    ptrdiff_t results;             /* numbers of that function */
    ptrdiff_t solved;              /* 1: it follows from accelerations or multipliers */
    const cardan_form *dynamics;   /* (groups) gradients of balances, of constraints and of zdot */
    const cardan_form *direct;     /* (groups) of what is summed up, of values of events, or of states behind
                                      these; NULL */
    const cardan_summands *summands; /* (groups); NULL: nothing is summed up */
    ptrdiff_t sums;                /* how many sums there are */
    const cardan_frame *frame;     /* of which the function is; NULL: of none */
    const cardan_form *impulse;    /* (groups) of M udot - G^T lam (nu) and G udot - H lam (m); NULL */
    const cardan_form *jumps;      /* (groups) of impulses at events; NULL */
    const cardan_form *friction;   /* (groups) of friction that follows from reactions; NULL */
    const cardan_form *rates;      /* (movers) of qdot by q and u; NULL calls: speeds are rates */
    const cardan_form *formula;    /* value of an expression by states and outputs (in v), and its slopes
                                      by t q u z r p and outputs */
    const cardan_data_slopes *data; /* (groups); NULL: not by parameters */
    ptrdiff_t np;
    const ptrdiff_t *quaternion;   /* (quaternions) first entries in q */
    ptrdiff_t quaternions;
    ptrdiff_t columns;             /* of all parts */
    const ptrdiff_t *column;       /* (columns) which derivative, see mesh_product.c */
    ptrdiff_t parts;               /* blocks and names that it is by */
    const ptrdiff_t *part;         /* (parts + 1) where each begins among the columns */
    /* of Hessians, whose forms are gradients: the same with changes, and with changes of gradients; NULL
     * else */
    const struct cardan_mesh_product *change, *curvature;
    ptrdiff_t data_rows;           /* of all groups */
} cardan_mesh_product;

/* numbers of work memory that these need */
ptrdiff_t cardan_mesh_product_work(const cardan_mesh_product *product);
/* numbers of a room for many products at one state, and what keeps factors there */
ptrdiff_t cardan_mesh_room_length(const cardan_mesh_product *product);
extern const cardan_repeated cardan_mesh_repeated;
/* where derivatives by t q coordinates u z s r p udot tau begin (10) */
void cardan_mesh_product_starts(const cardan_mesh_product *product, ptrdiff_t *starts);
/* (1): value of an expression */
int cardan_mesh_call_expression(const cardan_in *in, real *out, real *work);
/* (columns): weights v times the derivative */
int cardan_mesh_call_vjp(const cardan_in *in, real *out, real *work);
/* (results): change along a direction v (columns); forms of the product are changes, not gradients */
int cardan_mesh_call_jvp(const cardan_in *in, real *out, real *work);
/* (results, columns of the part), part after part: row by row, or column by column, by changes */
int cardan_mesh_call_derivative(const cardan_in *in, real *out, real *work);
int cardan_mesh_call_columns(const cardan_in *in, real *out, real *work);
/* mesh_hessian.c: (columns, columns): second derivatives of the sum with weights v */
int cardan_mesh_call_hessian(const cardan_in *in, real *out, real *work);
ptrdiff_t cardan_mesh_hessian_work(const cardan_mesh_product *product);

#endif
