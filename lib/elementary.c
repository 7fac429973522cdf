#include "elementary.h"
#include "need.h"
#include "wide.h"
#include <math.h>
#include <stdint.h>
#include <string.h>

/* --- bits. What the array forms use has no branches, so that compilers can do several
   numbers at once --- */

static inline uint64_t bits_of(double x)
{
    uint64_t bits;

    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static inline double from_bits(uint64_t bits)
{
    double x;

    memcpy(&x, &bits, sizeof x);
    return x;
}

/* All bits if a < b, else none: the sign of the difference. */
static inline uint64_t less(double a, double b)
{
    return 0 - (bits_of(a - b) >> 63);
}

static inline double choose(uint64_t mask, double yes, double no)
{
    return from_bits((bits_of(yes) & mask) | (bits_of(no) & ~mask));
}

/* x + SHIFT is x rounded to an integer, which stands in the last bits, if |x| < 2^51. */
static const double SHIFT = 0x1.8p52;

/* 2^n from n + SHIFT, -1023 < n < 1024 */
static inline double power_of_two(double shifted)
{
    return from_bits((bits_of(shifted) + 1023) << 52);
}

/* --- exp, expm1, tanh: with h = (x - n log 2) / 2,

     e^x = 2^n (C + h) / (C - h),  C = h coth h = 1 + h^2/3 - h^4/45 + ..,

   a function of h^2 that is almost constant. [Muller, section 6.2] --- */

static const double INVERSE_LN2 = 0x1.71547652b82fep+0;
static const double LN2_HIGH = 0x1.62e42fef00000p-1; /* 33 bits: exact times an n here */
static const double LN2_LOW = 0x1.473de6af278edp-34;

/* C - 1 from u = h^2, |h| <= 0.65: u times the polynomial that interpolates (C - 1) / u at the
   eight Chebyshev nodes of [0, 0.65^2]; it is off by less than 2^-54. Its terms come in pairs
   that need not wait for each other. */
static inline double excess(double u)
{
    double square = u * u;

    return u * ((0x1.5555555555554p-2 + u * -0x1.6c16c16c157fcp-6) +
                square * ((0x1.1566abbe1ccf1p-9 + u * -0x1.bbd776e100a4bp-13) +
                          square * ((0x1.66a84518c6e1ap-16 + u * -0x1.2264b61adedbdp-19) +
                                    square * (0x1.d1f1502f778bbp-23 +
                                              u * -0x1.4272c5a192638p-26))));
}

/* e^x = 2^n (1 + (high - low)), low much smaller than high, n the integer at the quotient
   x / log 2 or another one not far away */
typedef struct reduced {
    double shifted, n, high, low;
} reduced;

static inline reduced reduce(double x, double quotient)
{
    reduced e;
    double r, h, v;

    e.shifted = quotient + SHIFT;
    e.n = e.shifted - SHIFT;
    e.high = x - e.n * LN2_HIGH;
    r = e.high - e.n * LN2_LOW;
    h = 0.5 * r;
    v = excess(h * h);
    /* (C + h) / (C - h) = 1 + r + r (h - v) / (C - h) */
    e.low = e.n * LN2_LOW - r * (h - v) / (1 + v - h);
    return e;
}

/* e^746 is infinite, e^-746 zero */
static inline double exp_range(double x)
{
    return x > 746 ? 746 : x < -746 ? -746 : x;
}

/* |x| <= 746. 2^n in two halves, as neither 2^1024 nor 2^-1074 is a normal number. */
static inline double exp_inside(double x)
{
    reduced e = reduce(x, x * INVERSE_LN2);
    double shifted = 0.5 * e.n + SHIFT, half = shifted - SHIFT;

    return (1 + (e.high - e.low)) * power_of_two(shifted) *
           power_of_two(e.n - half + SHIFT);
}

double kw_exp(double x)
{
    return exp_inside(exp_range(x));
}

/* Two loops: one with both would have a path of its own for what is out of range. */
KW_WIDE static void exp_all(int n, const double *restrict x, double *restrict y)
{
    for (int i = 0; i < n; i++)
        y[i] = exp_range(x[i]);
    for (int i = 0; i < n; i++)
        y[i] = exp_inside(y[i]);
}

void kw_exp_many(int n, const double *x, double *y)
{
    exp_all(n, x, y);
}

double kw_expm1(double x)
{
    reduced e;
    double power;

    if (!(fabs(x) < 40)) /* the 1 is below the last place, or all there is */
        return kw_exp(x) - 1;
    e = reduce(x, fabs(x) < 0.5 ? 0 : x * INVERSE_LN2);
    if (e.n == 0)
        return e.high - e.low;
    power = power_of_two(e.shifted);
    return power * (e.high - e.low) + (power - 1);
}

/* From 20 on the tangent is 1. */
static inline double tanh_range(double x)
{
    const double size = fabs(x);

    return choose(less(20, size), 20, size);
}

/* 0 <= x <= 20. With e^2x = 2^n (C + h) / (C - h) there is one denominator for
     x = h < 0.65, n = 0:  tanh = h / C              = h - 2 h (C - 1) / (2 C)
     else:                 tanh = 1 - 2 / (e^2x + 1) = 1 - 2 (C - h) / (2^n (C + h) + C - h)
   and what is subtracted is smaller than the result. */
static inline double tanh_inside(double x)
{
    uint64_t small = less(x, 0.65);
    double shifted = choose(small, 0, x * (2 * INVERSE_LN2)) + SHIFT, n = shifted - SHIFT;
    double h = x - n * (0.5 * LN2_HIGH) - n * (0.5 * LN2_LOW), v = excess(h * h);
    double above = 1 + v + h, below = 1 + v - h, part = choose(small, h * v, below);

    return choose(small, h, 1) - 2 * part / (power_of_two(shifted) * above + below);
}

double kw_tanh(double x)
{
    return copysign(tanh_inside(tanh_range(x)), x);
}

KW_WIDE static void tanh_all(int n, const double *restrict x, double *restrict y)
{
    for (int i = 0; i < n; i++)
        y[i] = copysign(tanh_inside(tanh_range(x[i])), x[i]);
}

void kw_tanh_many(int n, const double *x, double *y)
{
    tanh_all(n, x, y);
}

/* --- log, log1p --- */

/* The logarithm of 2^n (1 + f) + c, where c is a rounding error relative to the sum. With
   s = f / (2 + f) it is log(1 + f) = 2 artanh(s) = 2 (s + s^3/3 + s^5/5 + ..), and f is the
   largest part of that; |s| < 0.172. [Muller, section 6.3] */
static double log_of(double n, double f, double c)
{
    double s = f / (2 + f), z = s * s, half = 0.5 * f * f, series = 0;

    for (int i = 21; i >= 3; i -= 2)
        series = z * (2.0 / i + series);
    return n * LN2_HIGH - (half - (s * (half + series) + (n * LN2_LOW + c)) - f);
}

/* x = 2^n m, m in [sqrt(1/2), sqrt(2)) up to rounding, x > 0 and finite */
static double mantissa(double x, int *n)
{
    double m = frexp(x, n);

    if (m < 0x1.6a09e667f3bcdp-1) {
        m *= 2;
        --*n;
    }
    return m;
}

double kw_log(double x)
{
    int n;
    double m;

    if (!(x > 0))
        return x == 0 ? -INFINITY : NAN;
    if (x == INFINITY)
        return x;
    m = mantissa(x, &n);
    return log_of(n, m - 1, 0);
}

double kw_log1p(double x)
{
    double sum = 1 + x, c;
    int n;

    if (fabs(x) < 0x1p-54)
        return x;
    if (!(sum > 0) || sum == INFINITY)
        return kw_log(sum);
    c = sum >= 2 ? 1 - (sum - x) : x - (sum - 1); /* what rounding took from the sum */
    sum = mantissa(sum, &n);
    if (n == 0)
        return log_of(0, x, 0);
    return log_of(n, sum - 1, c / ldexp(sum, n));
}

/* --- erf, erfc --- */

/* erf(x) / x - 1 from u = x^2 < 1: 2/sqrt(pi) times the sum of (-u)^k / (k! (2k+1)), from
   behind, minus 1. */
static double erf_excess(double u)
{
    double series = 0;

    for (int k = 18; k >= 1; k--)
        series = -(u / k) * (1.0 / (2 * k + 1) + series);
    return 0x1.06eba8214db69p-3 + 0x1.20dd750429b6dp+0 * series;
}

/* erfc(x) for 0.5 <= x <= 28. The trapezoidal rule of width 1/2 for the integral of
   (x/pi) e^(-x^2 - t^2) / (x^2 + t^2) over all t is off by what the pole at t = ix adds,
   2 / (e^(4 pi x) - 1), and by less than e^(-4 pi^2), which is nothing.
   [Hunter, Regan: A note on the evaluation of the complementary error function, Math. Comp.
   26 (1972)] */
static double erfc_tail(double x)
{
    enum { NODES = 14 };
    /* exp(-k^2 / 4), half of it for k = 0 */
    static const double weight[NODES] = {0.5,
                                         0x1.8ebef9eac820bp-1,
                                         0x1.78b56362cef38p-2,
                                         0x1.afb718e8457f7p-4,
                                         0x1.2c155b8213cf4p-6,
                                         0x1.fa0e9586aebc7p-10,
                                         0x1.02cf22526545ap-13,
                                         0x1.411fb0da07713p-18,
                                         0x1.e355bbaee85cbp-24,
                                         0x1.b93de1e27ca3bp-30,
                                         0x1.e8a37a45fc32ep-37,
                                         0x1.4835bd010a41bp-44,
                                         0x1.0b6c3afdde064p-52,
                                         0x1.0851945bd91fcp-61};
    const double pi = 0x1.921fb54442d18p+1;
    /* x^2 = high^2 - (high - x)(high + x), where high has so few bits that high^2 is exact */
    double high = from_bits(bits_of(x) & 0xffffffff00000000), sum = 0;
    double gauss = kw_exp(-high * high) * kw_exp((high - x) * (high + x));
    double pole = x < 6 ? 2 / kw_expm1(4 * pi * x) : 0; /* there is none beyond 2 pi */

    for (int k = NODES - 1; k >= 0; k--)
        sum += weight[k] / (0.25 * k * k + x * x);
    return gauss * (x * sum / pi) - pole;
}

double kw_erf(double x)
{
    double size = fabs(x);

    if (size < 1)
        return x + x * erf_excess(x * x);
    return size > 6 ? copysign(1, x) : copysign(1 - erfc_tail(size), x);
}

double kw_erfc(double x)
{
    if (x < 0.5)
        return 1 - kw_erf(x);
    return x > 28 ? 0 : erfc_tail(x);
}

/* --- sin, cos --- */

/* x = n pi/2 + high + low, |high| <= pi/4 up to rounding; returns n mod 4. pi/2 in parts of 33
   bits, exact times |n| < 2^20, and a last one: the error stays far below low, however
   close x is to n pi/2. [Cody, Waite, in Muller, section 11.2] */
static int quadrant(double x, double *high, double *low)
{
    const double inverse = 0x1.45f306dc9c883p-1; /* 2/pi */
    const double part[] = {0x1.921fb54400000p+0, 0x1.0b4611a600000p-34,
                           0x1.3198a2e000000p-69, 0x1.b839a252049c1p-104};
    double shifted = x * inverse + SHIFT, n = shifted - SHIFT, rest = 0;

    KW_NEED(fabs(x) <= 0x1p19, "angle %g, not in -2^19 .. 2^19", x);
    for (int i = 0; i < 4; i++) {
        double taken = n * part[i], next = x - taken;

        rest += x - next - taken; /* the rounding error of next */
        x = next;
    }
    *high = x + rest;
    *low = x - *high + rest;
    return (int)(bits_of(shifted) & 3);
}

/* The Taylor series, from behind; |x| <= pi/4. */
static double sin_near_zero(double x, double low)
{
    double z = x * x, series = 1;

    for (int k = 18; k >= 4; k -= 2) /* 1 - z/(4 5) (1 - z/(6 7) (1 - .. */
        series = 1 - z * series / (k * (k + 1));
    return x + (low * (1 - 0.5 * z) - x * z * series / 6);
}

static double cos_near_zero(double x, double low)
{
    double z = x * x, half = 0.5 * z, most = 1 - half, series = 1;

    for (int k = 17; k >= 5; k -= 2) /* 1 - z/(5 6) (1 - z/(7 8) (1 - .. */
        series = 1 - z * series / (k * (k + 1));
    return most + (1 - most - half + (z * z * series / 24 - x * low));
}

double kw_sin(double x)
{
    double high, low, value;
    int turns = quadrant(x, &high, &low);

    if (x == 0)
        return x;
    value = turns & 1 ? cos_near_zero(high, low) : sin_near_zero(high, low);
    return turns & 2 ? -value : value;
}

double kw_cos(double x)
{
    double high, low, value;
    int turns = quadrant(x, &high, &low);

    value = turns & 1 ? sin_near_zero(high, low) : cos_near_zero(high, low);
    return turns == 1 || turns == 2 ? -value : value;
}
