/* optimizer.h -- steps downhill: gradient descent, momentum, Adam.

   An optimizer turns the gradient at the parameters w into the next w. It owns what it
   remembers of earlier gradients, and one optimizer belongs to one array of parameters. It
   is made of + - * / and sqrt alone, so every machine takes the same steps. With g the
   gradient, rate > 0 and all memory zero at the start, entry by entry:

     descent    w -= rate g
     momentum   v = 0.9 v + g;  w -= rate v                                     [Polyak 1964]
     Adam       v = 0.9 v + 0.1 g;  s = 0.999 s + 0.001 g^2;  after step number t
                w -= rate (v / (1 - 0.9^t)) / (sqrt(s / (1 - 0.999^t)) + 1e-8)
                                                                         [Kingma, Ba 2015] */
#ifndef KW_OPTIMIZER_H
#define KW_OPTIMIZER_H

typedef enum kw_method { KW_DESCENT, KW_MOMENTUM, KW_ADAM } kw_method;

typedef struct kw_optimizer {
    kw_method method;
    double rate;          /* of the next step; the caller may change it between steps */
    double momentum;      /* what v keeps of itself, 0.9; in [0,1) */
    double memory;        /* what s keeps of itself, 0.999; in [0,1) */
    double floor;         /* 1e-8: keeps Adam from dividing by zero; >= 0 */
    int parameters;       /* how many */
    long long steps;      /* taken so far */
    double power, power2; /* momentum^steps, memory^steps */
    double *v, *s;        /* v and s above, an entry a parameter */
} kw_optimizer;

/* An optimizer with the constants above. parameters >= 1, rate > 0. */
kw_optimizer *kw_optimizer_new(kw_method method, int parameters, double rate);
void kw_optimizer_free(kw_optimizer *o);

/* One step: w and the gradient dw have o->parameters entries. With floor 0, Adam leaves an entry
   where it is whose s is zero. */
void kw_optimizer_step(kw_optimizer *o, const double *restrict dw, double *restrict w);

#endif
