/* Equation (22) -- what it says, and what the prose on Figure 16 says instead.

   What to see: nothing to look at. (22) multiplies the first number of the input with the
   last one of the filter, and so on: it turns the filter by half a turn. The element-wise
   products of the prose do not; the two agree where half a turn leaves the filter as it is.

   Book: section 1.2, (22) and the text around Figure 16.
   Claims: cnn.eq22.*
   Chosen here: random matrices of up to 5 x 5 integers, so that every sum is exact. */

#include "claim.h" /* what we found, for the ledger */
#include "conv.h"  /* both operators */
#include "out.h"   /* reports are files */
#include "rng.h"   /* random matrices */

enum { CASES = 200, SIDE = 5, MOST = SIDE * SIDE, WIDE = 2 * SIDE - 1 };

/* Input and filter of the same size m x n. */
typedef struct pair {
    int m, n;
    double A[MOST], W[MOST];
} pair;

static pair random_pair(uint64_t i)
{
    kw_rng r = kw_rng_at(22, 0, i, 0);
    pair p = {.m = 1 + kw_rng_below(&r, SIDE), .n = 1 + kw_rng_below(&r, SIDE)};

    for (int j = 0; j < p.m * p.n; j++) {
        p.A[j] = kw_rng_below(&r, 19) - 9;
        p.W[j] = kw_rng_below(&r, 19) - 9;
    }
    return p;
}

/* a times W and b times W turned by half a turn. */
static pair with_filter(pair p, int a, int b)
{
    const pair old = p;

    for (int i = 0; i < p.m * p.n; i++)
        p.W[i] = a * old.W[i] + b * old.W[p.m * p.n - 1 - i];
    return p;
}

/* --- the number that each of the two makes of them --- */

/* (22) as printed, with indices from 1. */
static double equation(const pair *p)
{
    double sum = 0;

    for (int i = 0; i <= p->m - 1; i++)
        for (int j = 0; j <= p->n - 1; j++)
            sum += p->A[(p->m - i - 1) * p->n + p->n - j - 1] * p->W[i * p->n + j];
    return sum;
}

/* The sum of the element-wise products. */
static double prose(const pair *p)
{
    double sum = 0;

    for (int i = 0; i < p->m * p->n; i++)
        sum += p->A[i] * p->W[i];
    return sum;
}

/* --- what holds for every pair --- */

static int has_its_indices_inside(const pair *p)
{
    for (int i = 0; i <= p->m - 1; i++)
        for (int j = 0; j <= p->n - 1; j++)
            if (p->m - i < 1 || p->n - j < 1 || 1 + i > p->m || 1 + j > p->n)
                return 0;
    return 1;
}

/* Both are what the library makes of them. */
static int is_in_the_library(const pair *p)
{
    const kw_conv l = kw_conv_layer((kw_conv){.in_channels = 1,
                                              .rows = p->m,
                                              .columns = p->n,
                                              .out_channels = 1,
                                              .filter_rows = p->m,
                                              .filter_columns = p->n,
                                              .stride = 1});
    double convolved, correlated;

    kw_conv_convolve(&l, p->W, p->A, &convolved);
    kw_conv_correlate(&l, p->W, p->A, &correlated);
    return l.out == 1 && convolved == equation(p) && correlated == prose(p);
}

/* In the product of the polynomials in s and t with the coefficients A and W, which has the
   entries of their full convolution for coefficients, (22) is the one in the middle. */
static int is_the_middle_of_a_product(const pair *p)
{
    double product[WIDE * WIDE] = {0};

    for (int i = 0; i < p->m * p->n; i++)
        for (int j = 0; j < p->m * p->n; j++)
            product[(i / p->n + j / p->n) * WIDE + i % p->n + j % p->n] +=
                p->A[i] * p->W[j];
    return equation(p) == product[(p->m - 1) * WIDE + p->n - 1];
}

static int is_symmetric(const pair *p)
{
    pair other = {.m = p->m, .n = p->n};

    for (int i = 0; i < p->m * p->n; i++) {
        other.A[i] = p->W[i];
        other.W[i] = p->A[i];
    }
    return equation(p) == equation(&other);
}

static int is_the_prose_with_the_filter_turned(const pair *p)
{
    const pair turned = with_filter(*p, 0, 1);

    return equation(p) == prose(&turned);
}

static int is_the_prose(const pair *p)
{
    return equation(p) == prose(p);
}

static int is_the_prose_for_a_filter_that_is_its_half_turn(const pair *p)
{
    const pair symmetric = with_filter(*p, 1, 1);

    return is_the_prose(&symmetric);
}

/* If the filter is not its half turn, some input tells: their difference. */
static int some_input_tells(const pair *p)
{
    const pair difference = with_filter(*p, 1, -1);
    pair told = *p;
    int same = 1;

    for (int i = 0; i < p->m * p->n; i++) {
        told.A[i] = difference.W[i];
        same &= difference.W[i] == 0;
    }
    return is_the_prose(&told) == same;
}

/* Random cases in which a property does not hold. */
static int exceptions(int holds(const pair *))
{
    int count = 0;

    for (uint64_t i = 0; i < CASES; i++) {
        const pair p = random_pair(i);

        count += !holds(&p);
    }
    return count;
}

int main(void)
{
    kw_out *report = kw_claim_new("ex_equation22");
    const pair square = {.m = 2, .n = 2, .A = {1, 2, 3, 4}, .W = {1, 0, 0, 0}};
    const pair line = {.m = 1, .n = 2, .A = {1, 2}, .W = {1, 0}};

    kw_claim_count(report, "cnn.eq22.indices", exceptions(has_its_indices_inside));
    kw_claim_count(report, "cnn.eq22.functions", exceptions(is_in_the_library));
    kw_claim_count(report, "cnn.eq22.middle", exceptions(is_the_middle_of_a_product));
    kw_claim_count(report, "cnn.eq22.symmetric", exceptions(is_symmetric));
    kw_claim_count(report, "cnn.eq22.turned",
                   exceptions(is_the_prose_with_the_filter_turned));
    kw_claim_count(report, "cnn.eq22.prose", exceptions(is_the_prose));
    kw_claim_count(report, "cnn.eq22.prose.symmetric",
                   exceptions(is_the_prose_for_a_filter_that_is_its_half_turn));
    kw_claim_count(report, "cnn.eq22.prose.told", exceptions(some_input_tells));
    kw_claim_real(report, "cnn.eq22.line", equation(&line));
    kw_claim_real(report, "cnn.eq22.line.prose", prose(&line));
    kw_claim_real(report, "cnn.eq22.square", equation(&square));
    kw_claim_real(report, "cnn.eq22.square.prose", prose(&square));
    return kw_out_close(report);
}
