/*
 * sincos.h: sine and cosine together, one text for single numbers and for vectors of them.
 *
 * cardan.h includes it once for doubles and once for vectors of doubles, with
 *
 *     CARDAN_SINCOS                       name of the function
 *     CARDAN_NUMBER, CARDAN_BITS          the type, and integers of the same size
 *     CARDAN_AS_BITS, CARDAN_AS_NUMBER    the same bits as the other type
 *
 * x = n pi/2 + r + rest, |r| <= pi/4: pi/2 in three parts, the first two so short that n times
 * them is exact, so that it does not matter what the compiler contracts to fused operations. Then
 * two polynomials, and an exchange of results and signs.
 *
 * For |x| <= CARDAN_SINCOS_RANGE. Error there at most 0.83 ulp (0.79 contracted), measured over 1e7;
 * in single precision at most 0.91 ulp (0.86 contracted), measured over all numbers.
 * Source: W. J. Cody, W. Waite, Software Manual for the Elementary Functions, 1980, chapter 8;
 * polynomials: K. C. Ng, Argument reduction for huge arguments: good to the last bit, 1992; those of
 * single precision have the least largest error (E. Remez, 1934).
 */
#ifndef CARDAN_SINCOS_STEPS
#define CARDAN_SINCOS_STEPS
#ifdef CARDAN_FLOAT
#define CARDAN_SINCOS_ROUND 12582912.0 /* a sum with it has no bits behind the point */
#define CARDAN_SINCOS_FIRST 1.5707931518554688
#define CARDAN_SINCOS_SECOND 3.1749368645250797e-06
#define CARDAN_SINCOS_THIRD 2.5633440682571e-12
#define CARDAN_SINCOS_ODD(z, zz) (z * 8.33215844e-03 - 1.66666552e-01) - zz * 1.9514958e-04
#define CARDAN_SINCOS_EVEN(z, zz) (4.16666456e-02 - z * 1.3887313e-03) + zz * 2.44327857e-05
#else
#define CARDAN_SINCOS_ROUND 6755399441055744.0
#define CARDAN_SINCOS_FIRST 1.5707963267923333
#define CARDAN_SINCOS_SECOND 2.5633441515839558e-12
#define CARDAN_SINCOS_THIRD 1.0562999066987428e-23
#define CARDAN_SINCOS_ODD(z, zz)                                                                   \
    (z * 8.33333333332248946124e-03 - 1.66666666666666324348e-01) +                                \
        zz * ((z * 2.75573137070700676789e-06 - 1.98412698298579493134e-04) +                      \
              zz * (z * 1.58969099521155010221e-10 - 2.50507602534068634195e-08))
#define CARDAN_SINCOS_EVEN(z, zz)                                                                  \
    (4.16666666666666019037e-02 - z * 1.38888888888741095749e-03) +                                \
        zz * ((2.48015872894767294178e-05 - z * 2.75573143513906633035e-07) +                      \
              zz * (2.08757232129817482790e-09 - z * 1.13596475577881948265e-11))
#endif
#endif
CARDAN_INLINE void CARDAN_SINCOS(const CARDAN_NUMBER *x, CARDAN_NUMBER *sine, CARDAN_NUMBER *cosine)
{
    const CARDAN_NUMBER a = CARDAN_AS_NUMBER(CARDAN_AS_BITS(*x) & ~CARDAN_SIGN);

    /* n, the nearest integer to a / (pi/2), stands in the last bits of a sum */
    const CARDAN_NUMBER shifted = a * 0.6366197723675814 + CARDAN_SINCOS_ROUND;
    const CARDAN_NUMBER n = shifted - CARDAN_SINCOS_ROUND;
    const CARDAN_BITS quarter = CARDAN_AS_BITS(shifted);

    /* r, and what its rounding and the third part leave */
    const CARDAN_NUMBER first = a - n * CARDAN_SINCOS_FIRST;
    const CARDAN_NUMBER second = n * CARDAN_SINCOS_SECOND, r = first - second;
    const CARDAN_NUMBER remainder = ((first - r) - second) - n * CARDAN_SINCOS_THIRD;

    /* sine and cosine of r + rest */
    const CARDAN_NUMBER z = r * r, zz = z * z;
    const CARDAN_NUMBER odd = CARDAN_SINCOS_ODD(z, zz);
    const CARDAN_NUMBER even = CARDAN_SINCOS_EVEN(z, zz);
    const CARDAN_NUMBER most = 1.0 - 0.5 * z;
    const CARDAN_NUMBER s = r + (z * r * odd + remainder * most);
    const CARDAN_NUMBER c = most + (zz * even + (((1.0 - most) - 0.5 * z) - r * remainder));

    /* in odd quarters they change places; then the signs, which the last two bits of n tell */
    const CARDAN_BITS swap = -(quarter & 1) & (CARDAN_AS_BITS(s) ^ CARDAN_AS_BITS(c));
    const CARDAN_BITS half = quarter << (8 * sizeof(cardan_word) - 2);
    const CARDAN_BITS s_sign = (half ^ CARDAN_AS_BITS(*x)) & CARDAN_SIGN;
    const CARDAN_BITS c_sign = (half ^ half << 1) & CARDAN_SIGN;
    *sine = CARDAN_AS_NUMBER(CARDAN_AS_BITS(s) ^ swap ^ s_sign);
    *cosine = CARDAN_AS_NUMBER(CARDAN_AS_BITS(c) ^ swap ^ c_sign);
}
#undef CARDAN_SINCOS
#undef CARDAN_NUMBER
#undef CARDAN_BITS
#undef CARDAN_AS_BITS
#undef CARDAN_AS_NUMBER
