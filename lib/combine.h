/* combine.h -- combinations of neighbouring control points, the innermost loop of geometries.
   [source text, (9)] */
#ifndef KW_COMBINE_H
#define KW_COMBINE_H

/* point = sum over j < k of scale weight[j] c_j, in this order, where c_j is c[j*N .. j*N+N-1];
   with `more` the sum begins with what point is already. */
static inline void kw_combine_sized(int more, double scale, int k, int N,
                                    const double *restrict weight,
                                    const double *restrict c, double *restrict point)
{
    for (int a = 0; a < N; a++) {
        double sum = more ? point[a] : 0;

        for (int j = 0; j < k; j++)
            sum += scale * weight[j] * c[j * N + a];
        point[a] = sum;
    }
}

/* point = sum of weight[j] c_j: the same, where compilers see the usual sizes and unroll. */
static inline void kw_combine(int k, int N, const double *restrict weight,
                              const double *restrict c, double *restrict point)
{
    if (k == 4 && N == 3)
        kw_combine_sized(0, 1, 4, 3, weight, c, point);
    else if (k == 4 && N == 2)
        kw_combine_sized(0, 1, 4, 2, weight, c, point);
    else if (k == 4)
        kw_combine_sized(0, 1, 4, N, weight, c, point);
    else if (k == 3 && N == 3)
        kw_combine_sized(0, 1, 3, 3, weight, c, point);
    else if (k == 3)
        kw_combine_sized(0, 1, 3, N, weight, c, point);
    else if (N == 3)
        kw_combine_sized(0, 1, k, 3, weight, c, point);
    else
        kw_combine_sized(0, 1, k, N, weight, c, point);
}

#endif
