/* Multi-indices of a box. */
#include "box.h"
#include "test.h"

static void all_in_order(void)
{
    const int low[] = {1, -2, 5}, high[] = {3, 1, 7};
    int at[] = {1, -2, 5}, count = 0;

    do {
        const int want[] = {1 + count / 6, -2 + count / 2 % 3, 5 + count % 2};

        for (int h = 0; h < 3; h++)
            CHECK(at[h] == want[h], "step %d, direction %d: %d", count, h, at[h]);
        count++;
    } while (kw_box_next(3, low, high, at));
    CHECK(count == 12, "%d steps", count);
    for (int h = 0; h < 3; h++)
        CHECK(at[h] == low[h], "direction %d ends at %d", h, at[h]);
}

static void one_place(void)
{
    const int low[] = {4}, high[] = {5};
    int at[] = {4};

    CHECK(!kw_box_next(1, low, high, at) && at[0] == 4, "%d", at[0]);
}

int main(void)
{
    test_run("box: every multi-index once, the last direction fastest", all_in_order);
    test_run("box: a box of one", one_place);
    return test_end();
}
