/* normal.h -- normal deviates, the same bits everywhere.

   The ziggurat: 128 layers of equal area cover the density e^(-x^2/2), x >= 0. A uniform point of
   a random layer lies below the density almost always, and mostly that is seen from its x alone;
   else kw_exp decides, and kw_log makes the tail. So one word gives one deviate, 97 times of 100.
   [Marsaglia, Tsang: The ziggurat method for generating random variables, J. Stat. Softw. 5
   (2000); Doornik: An improved ziggurat method to generate normal random samples, 2005: layer,
   sign and place come from different bits] */
#ifndef KW_NORMAL_H
#define KW_NORMAL_H

#include "rng.h"

enum { KW_NORMAL_LAYERS = 128 };

/* Layer i reaches from 0 to kw_normal_edge[i] and, i > 0, from the density kw_normal_height[i] up
   to that of layer i+1. Layer 0 has the tail behind kw_normal_edge[1] and as much area; its
   edge is where it would end as a rectangle. Both KW_NORMAL_LAYERS + 1 numbers. */
extern const double kw_normal_edge[], kw_normal_height[];

/* x[0..n-1] with mean 0 and variance 1, n >= 0. */
void kw_normal_many(kw_rng *r, int n, double *x);

#endif
