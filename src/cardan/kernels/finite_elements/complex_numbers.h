/*
 * complex_numbers.h: headers that follow compute with complex numbers, up to real_numbers.h.
 *
 * Polynomials are the same text over complex numbers. At x + i h d, with h so small that its square
 * vanishes beside 1, the imaginary part of f is h times the derivative of f along d, to rounding.
 * Source: Squire and Trapp, SIAM Review 40 (1998).
 */
#ifndef CARDAN_COMPLEX_NUMBERS_H
#define CARDAN_COMPLEX_NUMBERS_H

#include "cardan.h"

typedef double _Complex cardan_complex;

/* the blocks that elements without expressions read */
typedef struct cardan_complex_in {
    const cardan_complex *q, *u, *udot, *w, *v;
} cardan_complex_in;

#define CARDAN_COMPLEX 1
#define real cardan_complex
#define cardan_in cardan_complex_in
#undef CARDAN_REAL
#define CARDAN_REAL(x) ((cardan_complex)(x))

#endif
