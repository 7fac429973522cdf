/* box.h -- going through the multi-indices of a box. */
#ifndef KW_BOX_H
#define KW_BOX_H

/* Steps at[0..D-1] to the next multi-index with low[h] <= at[h] < high[h], the last direction
   fastest; begin with at = low. Returns 0 behind the last one, and then at = low again. */
int kw_box_next(int D, const int *low, const int *high, int *at);

#endif
