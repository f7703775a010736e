/* The level of instruction sets that this processor and its system have.
 *
 * Part of cardan. Built for any processor of its kind: it chooses among builds for more demanding
 * ones. Source: System V Application Binary Interface, AMD64 Supplement, table 3.1;
 * Intel 64 and IA-32 Architectures Software Developer's Manual, volume 1, 13.3 and 14.3.
 */
#if defined(__x86_64__) || defined(_M_X64)
#include <cpuid.h>

enum { V2 = 2, V3, V4 };

/* bits that must be set, all of them */
static int has(unsigned word, unsigned bits)
{
    return (word & bits) == bits;
}

/* which registers the system saves when it changes threads */
static unsigned saved(void)
{
    unsigned low, high;
    __asm__ volatile("xgetbv" : "=a"(low), "=d"(high) : "c"(0));
    return low;
}

int cardan_level(void)
{
    unsigned a, b, c, d, wide_b = 0, extended_c = 0;
    if (!__get_cpuid(1, &a, &b, &c, &d)) return 1;
    const unsigned first_c = c;
    if (__get_cpuid_count(7, 0, &a, &b, &c, &d)) wide_b = b;
    if (__get_cpuid(0x80000001u, &a, &b, &c, &d)) extended_c = c;

    /* SSE3, SSSE3, CMPXCHG16B, SSE4.1, SSE4.2, POPCNT; LAHF */
    const unsigned v2 = 1u | 1u << 9 | 1u << 13 | 1u << 19 | 1u << 20 | 1u << 23;
    if (!has(first_c, v2) || !has(extended_c, 1u)) return 1;
    /* FMA, MOVBE, XSAVE in use, AVX, F16C; BMI1, AVX2, BMI2; LZCNT; the system saves ymm */
    const unsigned v3 = 1u << 12 | 1u << 22 | 1u << 27 | 1u << 28 | 1u << 29;
    if (!has(first_c, v3) || !has(wide_b, 1u << 3 | 1u << 5 | 1u << 8)) return V2;
    if (!has(extended_c, 1u << 5) || !has(saved(), 0x6u)) return V2;
    /* AVX512 F, DQ, CD, BW, VL; the system saves zmm and masks */
    if (!has(wide_b, 1u << 16 | 1u << 17 | 1u << 28 | 1u << 30 | 1u << 31)) return V3;
    return has(saved(), 0xe6u) ? V4 : V3;
}
#elif defined(__aarch64__) || defined(_M_ARM64)
int cardan_level(void)
{
    return 8;
}
#else
int cardan_level(void)
{
    return 0;
}
#endif
