#include "optimizer.h"
#include "need.h"
#include <math.h>
#include <stdlib.h>

kw_optimizer *kw_optimizer_new(kw_method method, int parameters, double rate)
{
    kw_optimizer *o;

    KW_NEED(KW_DESCENT <= method && method <= KW_ADAM, "method %d", (int)method);
    KW_NEED(parameters >= 1, "%d parameters", parameters);
    KW_NEED(rate > 0 && isfinite(rate), "rate %g", rate);
    o = kw_need_memory(1, sizeof *o);
    o->method = method;
    o->rate = rate;
    o->momentum = 0.9;
    o->memory = 0.999;
    o->floor = 1e-8;
    o->parameters = parameters;
    o->power = o->power2 = 1;
    o->v = kw_need_memory((size_t)parameters, sizeof *o->v);
    o->s = kw_need_memory((size_t)parameters, sizeof *o->s);
    return o;
}

void kw_optimizer_free(kw_optimizer *o)
{
    if (!o)
        return;
    free(o->v);
    free(o->s);
    free(o);
}

static void descent(const kw_optimizer *o, const double *restrict dw, double *restrict w)
{
    const double rate = o->rate;

    for (int i = 0; i < o->parameters; i++)
        w[i] -= rate * dw[i];
}

static void momentum(const kw_optimizer *o, const double *restrict dw, double *restrict w)
{
    const double rate = o->rate, keep = o->momentum;
    double *restrict v = o->v;

    for (int i = 0; i < o->parameters; i++) {
        v[i] = keep * v[i] + dw[i];
        w[i] -= rate * v[i];
    }
}

/* The means v and s begin at zero, which is no gradient that was seen. The weights of
   those that were add up to 1 - power, and dividing by that leaves the zero out. */
static void adam(const kw_optimizer *o, const double *restrict dw, double *restrict w)
{
    const double rate = o->rate, keep = o->momentum, keep2 = o->memory;
    const double seen = 1 - o->power, seen2 = 1 - o->power2, least = o->floor;
    double *restrict v = o->v, *restrict s = o->s;

    for (int i = 0; i < o->parameters; i++) {
        double size;

        v[i] = keep * v[i] + (1 - keep) * dw[i];
        s[i] = keep2 * s[i] + (1 - keep2) * dw[i] * dw[i];
        size = sqrt(s[i] / seen2) + least;
        w[i] -= size != 0 ? rate * (v[i] / seen) / size : 0;
    }
}

void kw_optimizer_step(kw_optimizer *o, const double *restrict dw, double *restrict w)
{
    KW_NEED(o->rate > 0 && isfinite(o->rate), "rate %g", o->rate);
    KW_NEED(0 <= o->momentum && o->momentum < 1, "momentum %g", o->momentum);
    KW_NEED(0 <= o->memory && o->memory < 1, "memory %g", o->memory);
    KW_NEED(o->floor >= 0 && isfinite(o->floor), "floor %g", o->floor);
    o->steps++;
    o->power *= o->momentum;
    o->power2 *= o->memory;
    if (o->method == KW_DESCENT)
        descent(o, dw, w);
    else if (o->method == KW_MOMENTUM)
        momentum(o, dw, w);
    else
        adam(o, dw, w);
}
