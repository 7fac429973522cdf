#include "perceptron.h"
#include "need.h"
#include <math.h>
#include <stddef.h>

static void need_data(int m, int count, const double *P, const double *x)
{
    KW_NEED(m >= 1, "m = %d", m);
    KW_NEED(count >= 1, "%d samples", count);
    for (int i = 0; i < count; i++) {
        KW_NEED(x[i] == 1 || x[i] == -1, "label %d is %g", i, x[i]);
        for (int j = 0; j < m; j++)
            KW_NEED(isfinite(P[(ptrdiff_t)i * m + j]), "feature %d of sample %d is %g", j,
                    i, P[(ptrdiff_t)i * m + j]);
    }
}

double kw_perceptron_sum(int m, const double *w, const double *p)
{
    double sum = 0;

    KW_NEED(m >= 1, "m = %d", m);
    for (int j = 0; j < m; j++)
        sum += w[j] * p[j];
    sum += w[m];
    KW_NEED(isfinite(sum), "the sum is %g", sum);
    return sum;
}

int kw_perceptron_decide(int m, const double *w, const double *p)
{
    return kw_perceptron_sum(m, w, p) >= 0 ? 1 : -1;
}

int kw_perceptron_update(int m, double rate, const double *p, double x, double *w)
{
    int error;
    double step;

    KW_NEED(rate > 0 && isfinite(rate), "rate %g", rate);
    KW_NEED(x == 1 || x == -1, "label %g", x);
    error = (int)x - kw_perceptron_decide(m, w, p);
    step = rate * error;
    for (int j = 0; j < m; j++)
        w[j] += step * p[j];
    w[m] += step;
    return error;
}

long long kw_perceptron_train(int m, int count, const double *P, const double *x,
                              double rate, int passes, double *w, int *clean)
{
    long long mistakes = 0, before = -1;
    int pass = 0;

    need_data(m, count, P, x);
    KW_NEED(passes >= 1, "%d passes", passes);
    while (pass < passes && mistakes != before) {
        before = mistakes;
        pass++;
        for (int i = 0; i < count; i++)
            mistakes += kw_perceptron_update(m, rate, P + (ptrdiff_t)i * m, x[i], w) != 0;
    }
    *clean = mistakes == before ? pass : 0;
    return mistakes;
}

static double norm(int count, const double *a, double last)
{
    double sum = last * last;

    for (int i = 0; i < count; i++)
        sum += a[i] * a[i];
    return sqrt(sum);
}

double kw_perceptron_margin(int m, int count, const double *P, const double *x,
                            const double *w)
{
    double least = INFINITY, length;

    need_data(m, count, P, x);
    length = norm(m, w, w[m]);
    KW_NEED(length > 0, "the norm of w is %g", length);
    for (int i = 0; i < count; i++) {
        const double *p = P + (ptrdiff_t)i * m;

        least = fmin(least, x[i] * kw_perceptron_sum(m, w, p) / length);
    }
    return least;
}

double kw_perceptron_bound(int m, int count, const double *P, const double *x,
                           const double *u)
{
    double margin = kw_perceptron_margin(m, count, P, x, u), most = 0;

    KW_NEED(margin > 0, "the margin of u is %g", margin);
    for (int i = 0; i < count; i++)
        most = fmax(most, norm(m, P + (ptrdiff_t)i * m, 1));
    return most / margin * (most / margin);
}
