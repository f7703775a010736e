/* Coefficients of the three-stage Radau IIA method; see radau.c.
 *
 * T block-diagonalizes the inverse of the Runge-Kutta matrix: one real eigenvalue, one complex
 * pair. Computed with 40 digits from the nodes.
 */
#ifndef CARDAN_RADAU_TABLES_H
#define CARDAN_RADAU_TABLES_H

#include "cardan.h"

static const real NODES[3] = {0.15505102572168219, 0.64494897427831781, 1};

static const real ALONE = 3.6378342527444957;                    /* real eigenvalue */
static const real REAL = 2.6810828736277521, IMAG = 3.0504301992474106; /* of the pair */

static const real T[3][3] = {
    {0.094438762488975241, -0.14125529502095421, -0.030029194105147424},
    {0.25021312296533331, 0.20412935229379993, 0.38294211275726194},
    {1, 1, 0},
};

static const real T_INVERSE[3][3] = {
    {4.1787185915519047, 0.32768282076106239, 0.5233764454994495},
    {-4.1787185915519047, -0.32768282076106239, 0.47662355450055045},
    {-0.50287263494578688, 2.5719269498556054, -0.59603920482822492},
};

/* the Runge-Kutta matrix itself */
static const real A[3][3] = {
    {0.19681547722366043, -0.065535425850198388, 0.023770974348220152},
    {0.39442431473908728, 0.29207341166522846, -0.04154875212599793},
    {0.37640306270046728, 0.51248582618842161, 1.0 / 9},
};

/* error estimate: f + sum ERROR[i] z_i / h, times the inverse of ALONE / h - J */
static const real ERROR[3] = {-10.048809399827416, 1.3821427331607489, -1.0 / 3};

/* Dense output of x: the polynomial through 0 and the stage increments z, as interpolant rows. */
static const real DENSE[3][3] = {
    {0, 0, 1},
    {10.048809399827416, -1.3821427331607489, -2.0 / 3},
    {-15.580782047249224, 8.9141153805825572, -10.0 / 3},
};

/* Dense output of the energies, from the powers at the stages. */
static const real ENERGY[3][3] = {
    {0.37640306270046728, 0.51248582618842161, 1.0 / 9},
    {1.1816751420244551, -1.4038973642466773, 2.0 / 9},
    {-0.80527207932398783, 1.9163831904350989, -10.0 / 9},
};

#endif
