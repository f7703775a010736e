/* Quaternions by their increments in a step: the Lie group methods of Munthe-Kaas.
 *
 * Part of cardan. Caller owns all memory. Where a run is not `charted` these functions hand on what
 * they get.
 *
 * In a step from the quaternion p the rotation is p exp(theta / 2), and theta, the rotation vector
 * in body axes, obeys theta' = dexpinv(theta) omega with the angular velocity omega = 2 conj(q) q'.
 * A method of some order for theta has that order for the rotation, and the length of quaternions
 * is that of a product of unit ones.
 * Source: H. Munthe-Kaas, High order Runge-Kutta methods on manifolds, Appl. Numer. Math. 29
 * (1999) 115-127; A. Iserles et al., Lie-group methods, Acta Numerica 9 (2000), sections 4 and 5.
 */
#include "explicit.h"
#include <math.h>

/* rotations in a step beyond this are refused: dexpinv is singular at a whole turn */
static const real LARGEST = 4.5;

/* Numbers of memory: a state, the origin of the chart, its coordinates. */
ptrdiff_t cardan_chart_length(const cardan_run *run)
{
    return run->charted ? 3 * run->n : 0;
}

/* The state (n) that serves the model; where the chart has its origin (n); the origin in it (n). */
static real *full(const cardan_run *run)
{
    return run->chart;
}

static real *origin(const cardan_run *run)
{
    return run->chart + run->n;
}

static real *base(const cardan_run *run)
{
    return run->chart + 2 * run->n;
}

/* r = p q, or conj(p) q for sign -1; r may be neither of them. */
static void multiply(const real *p, const real *q, real sign, real *r)
{
    real x = sign * p[1], y = sign * p[2], z = sign * p[3];

    r[0] = p[0] * q[0] - x * q[1] - y * q[2] - z * q[3];
    r[1] = p[0] * q[1] + x * q[0] + y * q[3] - z * q[2];
    r[2] = p[0] * q[2] - x * q[3] + y * q[0] + z * q[1];
    r[3] = p[0] * q[3] + x * q[2] - y * q[1] + z * q[0];
}

/* q = p exp(theta / 2) for the increment (0, theta). */
static void advance(const real *p, const real *increment, real *q)
{
    const real *v = increment + 1;
    real half = 0.5 * sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    /* sin(x) / 2x; below 1e-4 the next term is less than a rounding */
    real share = half < 1e-4 ? 0.5 - half * half / 12 : 0.5 * sin(half) / half;
    real turn[4] = {cos(half), share * v[0], share * v[1], share * v[2]};

    multiply(p, turn, 1, q);
}

/* The increment (0, theta) from p to q. */
static void increment_of(const real *p, const real *q, real *increment)
{
    real turn[4], length, share;

    multiply(p, q, -1, turn);
    length = sqrt(turn[1] * turn[1] + turn[2] * turn[2] + turn[3] * turn[3]);
    /* the same rotation by less than half a turn, unless the step is longer: see LARGEST */
    share = length < 1e-8 ? 2 / turn[0] : 2 * atan2(length, turn[0]) / length;
    increment[0] = 0;
    for (int j = 1; j < 4; j++)
        increment[j] = share * turn[j];
}

/* f = (0, dexpinv(theta) omega) for q and its derivative f. */
static void pull(const real *q, const real *increment, real *f)
{
    const real *v = increment + 1;
    real square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2], half = 0.5 * sqrt(square), c;
    real omega[4], a[3], b[3];

    multiply(q, f, -1, omega);
    for (int j = 0; j < 4; j++)
        omega[j] *= 2;
    /* (1 - x cot x) / 4 x^2 */
    c = half < 0.02 ? 1.0 / 12 + square / 720 + square * square / 30240
                    : (1 - half * cos(half) / sin(half)) / square;
    for (int j = 0; j < 3; j++)
        a[j] = v[(j + 1) % 3] * omega[1 + (j + 2) % 3] - v[(j + 2) % 3] * omega[1 + (j + 1) % 3];
    for (int j = 0; j < 3; j++)
        b[j] = v[(j + 1) % 3] * a[(j + 2) % 3] - v[(j + 2) % 3] * a[(j + 1) % 3];
    f[0] = 0;
    for (int j = 0; j < 3; j++)
        f[1 + j] = omega[1 + j] + 0.5 * a[j] + c * b[j];
}

/* Begin a step at y with derivative f: its coordinates in the chart, its derivative in `first`. */
const real *cardan_enter(cardan_run *run, const real *y, const real *f, real *first)
{
    static const real none[4] = {0, 0, 0, 0};

    for (ptrdiff_t i = 0; i < run->n; i++)
        first[i] = f[i];
    if (!run->charted)
        return y;
    for (ptrdiff_t i = 0; i < run->n; i++)
        origin(run)[i] = base(run)[i] = full(run)[i] = y[i];
    for (ptrdiff_t i = 0; i < run->quaternion_count; i++) {
        const ptrdiff_t at = run->quaternions[i];
        for (int j = 0; j < 4; j++)
            base(run)[at + j] = 0;
        pull(y + at, none, first + at);
    }
    return base(run);
}

/* The state of coordinates y in the chart. Returns whether no rotation is too large. */
static int state_of(cardan_run *run, const real *y)
{
    int good = 1;

    for (ptrdiff_t i = 0; i < run->n; i++)
        full(run)[i] = y[i];
    for (ptrdiff_t i = 0; i < run->quaternion_count; i++) {
        const real *v = y + run->quaternions[i];
        good &= v[1] * v[1] + v[2] * v[2] + v[3] * v[3] < LARGEST * LARGEST;
        advance(origin(run) + run->quaternions[i], v, full(run) + run->quaternions[i]);
    }
    return good;
}

/* Derivative f of the coordinates y. Returns 0, what the model does, or CARDAN_ROTATION_TOO_LARGE. */
int cardan_slope(cardan_run *run, real t, const real *y, real *f)
{
    int status;

    if (!run->charted)
        return cardan_derivative(run, t, y, f);
    if (!state_of(run, y))
        return CARDAN_ROTATION_TOO_LARGE;
    status = cardan_derivative(run, t, full(run), f);
    for (ptrdiff_t i = 0; i < run->quaternion_count && status == 0; i++) {
        const ptrdiff_t at = run->quaternions[i];
        pull(full(run) + at, y + at, f + at);
    }
    return status;
}

/* Make coordinates at the end of a step the state there. */
void cardan_leave(cardan_run *run, real *y)
{
    if (!run->charted)
        return;
    (void)state_of(run, y);
    for (ptrdiff_t i = 0; i < run->n; i++)
        y[i] = full(run)[i];
}

/* Numbers against which errors of y count: increments against a unit quaternion. */
const real *cardan_against(cardan_run *run, const real *y)
{
    if (!run->charted)
        return y;
    for (ptrdiff_t i = 0; i < run->n; i++)
        full(run)[i] = y[i];
    for (ptrdiff_t i = 0; i < run->quaternion_count; i++)
        for (int j = 0; j < 4; j++)
            full(run)[run->quaternions[i] + j] = 1;
    return full(run);
}

/* rise (n): coordinates of a state y (n) less those of the start of the last step. */
void cardan_rise(const cardan_run *run, const real *y, real *rise)
{
    for (ptrdiff_t i = 0; i < run->n; i++)
        rise[i] = y[i] - run->y_old[i];
    for (ptrdiff_t i = 0; i < (run->charted ? run->quaternion_count : 0); i++) {
        const ptrdiff_t at = run->quaternions[i];
        increment_of(run->y_old + at, y + at, rise + at);
    }
}

/* Coordinates of the present state less those of the start, and the derivative there. */
void cardan_arrive(cardan_run *run, real *rise, real *last)
{
    cardan_rise(run, run->y, rise);
    for (ptrdiff_t i = 0; i < run->n; i++)
        last[i] = run->f[i];
    for (ptrdiff_t i = 0; i < (run->charted ? run->quaternion_count : 0); i++) {
        const ptrdiff_t at = run->quaternions[i];
        pull(run->y + at, rise + at, last + at);
    }
}

/* Make the increments inside the last step, y (n) of its dense output at theta, rotations. */
void cardan_leave_inside(const cardan_run *run, real theta, real *y)
{
    for (ptrdiff_t i = 0; i < (run->charted ? run->quaternion_count : 0); i++) {
        const ptrdiff_t at = run->quaternions[i];
        real turn[4] = {0};
        for (int entry = 1; entry < 4; entry++)
            for (ptrdiff_t j = run->dense_rows - 1; j >= 0; j--)
                turn[entry] = (turn[entry] + run->interpolant[j * run->n + at + entry])
                              * (j % 2 == 0 ? theta : 1 - theta);
        advance(run->y_old + at, turn, y + at);
    }
}
