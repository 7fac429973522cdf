#include "box.h"

int kw_box_next(int D, const int *low, const int *high, int *at)
{
    for (int h = D - 1; h >= 0; h--) {
        if (++at[h] < high[h])
            return 1;
        at[h] = low[h];
    }
    return 0;
}
