/* A system in finite-element coordinates: elements that couple a few places, looped over tables.
 *
 * Part of cardan. Caller owns all memory; nothing here is written to but what functions are given.
 *
 * A place holds coordinates of its own: a node (the pose of a body or of a section of a beam,
 * q = [w x y z, px py pz], u = [omega in its axes, v in those of the ground]) or those of a joint.
 * Elements of one kind share their functions, which know local numbers only: those of their places
 * one behind the other, their own rows of constraints, their own data. A group is a table of
 * elements of one kind.
 *
 * Rows of constraints are numbered with those of positions first (mp of m), then those that bind
 * speeds alone. Source: M. Géradin, A. Cardona, Flexible Multibody Dynamics (2001), chapters 2, 6.
 */
#ifndef CARDAN_MESH_H
#define CARDAN_MESH_H

#include "run.h"
#include "sparse.h"

/* what the functions of an element give */
enum {
    CARDAN_BALANCE,  /* M udot + h - f - Gᵀ lam (nu), g (mp), G u + g_t (m) */
    CARDAN_TANGENT,  /* its derivatives: K C M (nu, nu) each, R G (m, nu) each, H (m, m) of rows
                        that no mode holds, L (m, nu) of the balance by -lam where that is not G; see
                        `parts` */
    CARDAN_GAMMA,    /* (m) G udot = gamma */
    CARDAN_ENERGY,   /* kinetic, potential */
    CARDAN_MOMENTUM, /* (6) about the origin of the ground, angular part first */
    CARDAN_POWER,    /* given to the motion by what is not conservative */
    CARDAN_REACTION, /* (6) of the parent on the child */
    CARDAN_OUTPUTS,  /* of the user */
    CARDAN_STRESS,   /* resultants and strains along an element */
    CARDAN_MIXED,    /* balance (nu) and K (nu, nu) with unknowns of its own that are not settled */
    CARDAN_MIXED_STEP, /* these after the increment du */
    CARDAN_ELEMENT_FORCES, /* along a line or a joint, or the wrench on a frame */
    CARDAN_ZDOT,     /* of its internal states */
    CARDAN_SIGNS,    /* (ne) values of its events, then 1 where they read udot or lam now */
    CARDAN_JUMPS,    /* impulses at events (jumps, 4), gradients of velocities (jumps, nu) */
    CARDAN_CHANGE,   /* its own z and s behind events */
    CARDAN_BODIES,    /* motion of the bodies of a rigid tree */
    CARDAN_REACTIONS, /* shares of the wrenches of joints of rigid trees */
    CARDAN_REACTION_FRICTION, /* of every friction that follows from the reaction of a joint: force per
                        force across its line (k), action of a unit (k, nu), that force by multipliers
                        (k, 3, m) */
    CARDAN_GENERALIZED_MOMENTA, /* of inertia that couples places, all along body axes: dT/du (nu), then
                        u'.(dM/dx) u / 2 along every speed (nu), for the speeds u and u' in udot */
    CARDAN_FORMS
};

/* the matrices of a tangent */
enum { CARDAN_K, CARDAN_C, CARDAN_M, CARDAN_R, CARDAN_G, CARDAN_RELEASED, CARDAN_L, CARDAN_PARTS };

/* A function of a kind with what was prepared of the data of every element. */
typedef struct cardan_form {
    cardan_function call; /* NULL: the kind has none, all zeros */
    ptrdiff_t lanes;      /* elements that it takes side by side */
    const real *w;        /* (ceil(count / lanes), nw, lanes) */
    ptrdiff_t nw, size;   /* size: numbers of a result */
} cardan_form;

typedef struct cardan_group {
    ptrdiff_t count;           /* elements */
    ptrdiff_t places;          /* that each couples */
    ptrdiff_t nq, nu, nz, ns, mp, m; /* local numbers */
    ptrdiff_t switched;        /* of m, the last ones: rows that modes hold */
    ptrdiff_t z_states, s_states;  /* the first of nz and ns: those that it keeps itself */
    ptrdiff_t ne, jumps, responses; /* events; impulses and responses that it asks for; the latter */
    ptrdiff_t frictions;       /* that follow from its reaction */
    ptrdiff_t inner, inner_start; /* unknowns of an element's own while one searches; where they
                                     begin among those of all */
    const ptrdiff_t *place;    /* (count, places) */
    const ptrdiff_t *rows;     /* (count, 2): first row of positions, first of the others */
    const ptrdiff_t *z, *s;    /* (count, nz), (count, ns): which of the scene's they are */
    const ptrdiff_t *events;   /* (count, ne): which of the scene's they are */
    const ptrdiff_t *parts;    /* (CARDAN_PARTS): where each begins in a tangent, -1: it is zero */
    const ptrdiff_t *spots;    /* (count, blocks, blocks + 1) of the plan: where every block of its
                                  places, then of its rows, begins, and the stride of its rows */
    const ptrdiff_t *powers;   /* (count, size of its power): which of the scene's sources they are */
    const ptrdiff_t *outputs;  /* (count, size of its outputs): which of the scene's they add to */
    cardan_form forms[CARDAN_FORMS];
} cardan_group;

/* Places of one kind that move by functions of their own; NULL functions: coordinates are speeds. */
typedef struct cardan_movers {
    ptrdiff_t count, nq, nu;
    const ptrdiff_t *place;  /* (count) */
    cardan_function move;    /* q (nq), T (nu, nu) */
    cardan_function rates;   /* qdot (nq) */
    const real *w_move, *w_rates;
} cardan_movers;

typedef struct cardan_mesh {
    ptrdiff_t nq, nu, nz, ns, nr, mp, m;
    ptrdiff_t places, nodes, flats;
    const ptrdiff_t *q, *u;    /* (places + 1): where the numbers of a place begin */
    const ptrdiff_t *node;     /* (nodes): places that are poses */
    const ptrdiff_t *flat;     /* (flats): nodes of a plane, which hold x, y, angle */
    ptrdiff_t group_count, mover_count;
    const cardan_group *groups;
    const cardan_movers *movers;
    const cardan_sparse *plan; /* of its matrices: blocks are the places, then the rows of every
                                  element that has some, group by group */
    const ptrdiff_t *unknown;  /* (m): the unknown of the plan that a multiplier is */
    const ptrdiff_t *diagonal; /* (nu): where the diagonal of the matrix stands */
    ptrdiff_t lanes;           /* elements side by side at most */
    ptrdiff_t work;            /* numbers that the largest work of an element takes, per lane */
    ptrdiff_t local;           /* numbers that the largest element reads and gives, per lane */
    ptrdiff_t powers, driven;  /* sources of power; 1: some of them are multipliers' */
    ptrdiff_t ne, jumps, responses, frictions; /* of all elements */
    ptrdiff_t outputs, solved; /* of the scene; 1: some of them read udot or multipliers */
} cardan_mesh;

/* What the elements are asked at. */
typedef struct cardan_state {
    real t;
    const real *q, *u, *udot, *lam, *z, *s, *r;
    const real *du, *inner; /* of a search: increments (nu), unknowns of elements; NULL else */
    /* of events: speeds behind them (nu), which happen (ne), responses of all elements; NULL else */
    const real *behind, *e, *responses;
    const real *certainty; /* of friction that follows from reactions (frictions); NULL: not known */
    /* of derivatives: gives their weights or directions, behind the states; NULL else */
    const struct cardan_gift *gift;
} cardan_state;

/* Weights of the results of elements, or directions of what they read. */
typedef struct cardan_gift {
    /* writes those of elements side by side to `to`; returns where these end */
    real *(*give)(const struct cardan_mesh *mesh, const cardan_group *group, const ptrdiff_t *element,
                  ptrdiff_t lanes, const struct cardan_gift *gift, real *to);
    int form;         /* whose results */
    const real *v;    /* of the whole mesh, see mesh_pull.h */
    const void *more; /* what else `give` needs */
} cardan_gift;

/* Numbers of elements side by side, 0 where `from` is NULL: those of their places, those that they pick
 * from a block, and the first `count` of their rows. Return where what follows begins. */
real *cardan_mesh_fetch_places(const cardan_group *g, const ptrdiff_t *element, ptrdiff_t lanes,
                               const ptrdiff_t *starts, const real *from, real *to);
real *cardan_mesh_pick(const real *from, const ptrdiff_t *which, ptrdiff_t n,
                       const ptrdiff_t *element, ptrdiff_t lanes, real *to);
real *cardan_mesh_pick_rows(const cardan_group *g, ptrdiff_t count, const ptrdiff_t *element,
                            ptrdiff_t lanes, const real *from, real *to);

/* Elements side by side. */
typedef struct cardan_element_lanes {
    ptrdiff_t lanes, filled;  /* how many go together, and how many of these are elements */
    ptrdiff_t element[8];     /* (lanes) which; behind the filled ones the last again */
} cardan_element_lanes;

/* Takes the results of elements: entry i of the k-th stands at out[i * lanes + k]; may change
 * them. */
typedef void cardan_taker(const cardan_mesh *mesh, const cardan_group *group,
                          const cardan_element_lanes *some, real *out, void *to);

/* Add entries of elements to those that they pick, to those of their places, and to the first `count` of
 * their rows. Return what follows. */
const real *cardan_mesh_add_picked(const cardan_element_lanes *some, const ptrdiff_t *which,
                                   ptrdiff_t n, const real *out, real *to);
const real *cardan_mesh_add_places(const cardan_group *g, const cardan_element_lanes *some,
                                   const ptrdiff_t *starts, const real *out, real *to);
const real *cardan_mesh_add_rows(const cardan_group *g, ptrdiff_t count,
                                 const cardan_element_lanes *some, const real *out, real *to);

/* numbers of memory that a loop over elements needs */
ptrdiff_t cardan_mesh_room(const cardan_mesh *mesh);
int cardan_mesh_each(const cardan_mesh *mesh, const cardan_state *at, int form,
                     cardan_taker *take, void *to, real *room);
/* the same of one group, by a function that may be none of its forms */
int cardan_mesh_group(const cardan_mesh *mesh, const cardan_group *g, const cardan_form *form,
                      const cardan_state *at, cardan_taker *take, void *to, real *room);

/* What is missing in the balance of all elements: b (nu), g (mp), rates (m). */
int cardan_mesh_balance(const cardan_mesh *mesh, const cardan_state *at, real *out, real *room);
/* The same of the elements that have rows alone; what stands in b means nothing. */
int cardan_mesh_gaps(const cardan_mesh *mesh, const cardan_state *at, real *out, real *room);
int cardan_mesh_gamma(const cardan_mesh *mesh, const cardan_state *at, real *gamma, real *room);
/* rates of all internal states (nz) */
int cardan_mesh_zdot(const cardan_mesh *mesh, const cardan_state *at, real *zdot, real *room);
/* sums over the elements: CARDAN_ENERGY, CARDAN_MOMENTUM, CARDAN_POWER */
int cardan_mesh_sum(const cardan_mesh *mesh, const cardan_state *at, int form, ptrdiff_t size,
                    real *out, real *room);
/* the result of every element, group by group */
int cardan_mesh_results(const cardan_mesh *mesh, const cardan_state *at, int form, real *out,
                        real *room);
/* qdot (nq); q moved by du, with T (places, 9) of those that are poses, NULL where not wanted */
int cardan_mesh_rates(const cardan_mesh *mesh, const real *q, const real *u, real *qdot,
                      real *room);
int cardan_mesh_move(const cardan_mesh *mesh, const real *q, const real *du, real *moved,
                     real *tangent_maps, real *room);

#endif
