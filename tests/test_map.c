/* The table from 64-bit keys to small numbers, against a plain array of all keys that were put. */
#include "map.h"
#include "test.h"

enum { MANY = 20000, VALUES = 1 << 30 };

/* Families of keys that make life hard for a table whose size is a power of two. */
static uint64_t key_of(int family, int i)
{
    uint64_t n = (uint64_t)i;

    switch (family) {
    case 0:
        return n;
    case 1:
        return n << 20;
    case 2:
        return n << 48;
    case 3:
        return UINT64_MAX - n;
    case 4:
        return UINT64_MAX - (n << 32);
    case 5: /* what one diagonal of a fine grid looks like */
        return n * ((UINT64_C(1) << 31) + 1);
    case 6: /* multiples of the inverse of the golden hash's factor, modulo 2^64 */
        return n * UINT64_C(0xf1de83e19937733d);
    default: {
        kw_rng r = kw_rng_at(33, 0, n, 0);

        return kw_rng_word(&r);
    }
    }
}

enum { FAMILIES = 8 };

static void an_empty_map_has_no_key(void)
{
    kw_map *m = kw_map_new();

    CHECK(m->count == 0, "%zu", m->count);
    CHECK(kw_map_find(m, 0) == KW_MAP_NONE, "%d", kw_map_find(m, 0));
    CHECK(kw_map_find(m, UINT64_MAX) == KW_MAP_NONE, "%d", kw_map_find(m, UINT64_MAX));
    kw_map_free(m);
}

/* Every key is found while the table grows, and no other one; it stays at most half full. */
static void keys_are_found(void)
{
    for (int family = 0; family < FAMILIES; family++) {
        kw_map *m = kw_map_new();

        for (int i = 0; i < MANY; i++) {
            uint64_t key = key_of(family, i);

            CHECK(kw_map_find(m, key) == KW_MAP_NONE, "family %d, key %d", family, i);
            kw_map_put(m, key, i);
            CHECK(kw_map_find(m, key) == i, "family %d, key %d", family, i);
            CHECK(m->count == (size_t)i + 1, "family %d: %zu keys", family, m->count);
            CHECK(2 * m->count <= m->room, "%zu keys in %zu", m->count, m->room);
        }
        for (int i = 0; i < MANY; i++)
            CHECK(kw_map_find(m, key_of(family, i)) == i, "family %d, key %d", family, i);
        for (int i = MANY; i < 2 * MANY; i++)
            CHECK(kw_map_find(m, key_of(family, i)) == KW_MAP_NONE, "family %d, key %d",
                  family, i);
        kw_map_free(m);
    }
}

/* Room follows the keys: less than eight entries a key, and a power of two. */
static void room_is_linear(void)
{
    kw_map *m = kw_map_new();

    for (int i = 0; i < MANY; i++) {
        kw_map_put(m, (uint64_t)i << 32, i);
        CHECK((m->room & (m->room - 1)) == 0, "%zu", m->room);
    }
    CHECK(m->room <= 8 * (size_t)MANY, "%zu entries for %d keys", m->room, MANY);
    kw_map_free(m);
}

/* The most entries in use that follow one another. */
static size_t longest_run(const kw_map *m)
{
    size_t longest = 0, run = 0;

    for (size_t i = 0; i < 2 * m->room; i++) { /* twice round: a run may pass the end */
        run = m->value[i % m->room] == KW_MAP_NONE ? 0 : run + 1;
        longest = run > longest ? run : longest;
    }
    return longest;
}

/* What a find costs is bounded by the runs. If places were drawn at random, a run of `r` entries
   in a table that is half full would have to begin somewhere where r/2 entries are expected
   and r fall; by Chernoff that has a probability of at most (e/4)^(r/2) at each of the room
   places: 2^16 (e/4)^(r/2) is below 10^-12 for r = 202. */
static void keys_are_spread(void)
{
    enum { RUN = 202 };

    for (int power = 0; power < 4; power++)
        for (int shift = 0; shift <= 48; shift++) {
            kw_map *m = kw_map_new();

            for (int i = 0; i < 500 << power; i++)
                kw_map_put(m, (uint64_t)i << shift, i);
            CHECK(longest_run(m) < RUN, "%zu keys, multiples of 2^%d: a run of %zu",
                  m->count, shift, longest_run(m));
            kw_map_free(m);
        }
}

static void the_last_value_counts(void)
{
    for (int family = 0; family < FAMILIES; family++) {
        kw_map *m = kw_map_new();

        for (int round = 0; round < 3; round++)
            for (int i = 0; i < 1000; i++)
                kw_map_put(m, key_of(family, i), round * i);
        CHECK(m->count == 1000, "%zu keys", m->count);
        for (int i = 0; i < 1000; i++)
            CHECK(kw_map_find(m, key_of(family, i)) == 2 * i, "family %d, key %d: %d",
                  family, i, kw_map_find(m, key_of(family, i)));
        kw_map_free(m);
    }
}

static void ends_of_the_keys(void)
{
    kw_map *m = kw_map_new();

    kw_map_put(m, UINT64_MAX, 0);
    CHECK(kw_map_find(m, 0) == KW_MAP_NONE, "%d", kw_map_find(m, 0));
    kw_map_put(m, 0, INT32_MAX);
    kw_map_put(m, UINT64_C(1) << 63, 7);
    CHECK(kw_map_find(m, UINT64_MAX) == 0, "%d", kw_map_find(m, UINT64_MAX));
    CHECK(kw_map_find(m, 0) == INT32_MAX, "%d", kw_map_find(m, 0));
    CHECK(kw_map_find(m, UINT64_C(1) << 63) == 7, "%d",
          kw_map_find(m, UINT64_C(1) << 63));
    CHECK(m->count == 3, "%zu", m->count);
    kw_map_free(m);
}

/* Random puts on few keys, which overwrite one another often. */
static void it_is_an_array(void)
{
    enum { KEYS = 500 };
    int want[KEYS];
    kw_map *m = kw_map_new();
    kw_rng r = kw_rng_at(33, 1, 0, 0);

    for (int i = 0; i < KEYS; i++)
        want[i] = KW_MAP_NONE;
    for (int i = 0; i < MANY; i++) {
        int k = kw_rng_below(&r, KEYS), other = kw_rng_below(&r, KEYS);

        if (kw_rng_below(&r, 8) == 0) {
            want[k] = kw_rng_below(&r, VALUES);
            kw_map_put(m, key_of(FAMILIES - 1, k), want[k]);
        }
        CHECK(kw_map_find(m, key_of(FAMILIES - 1, other)) == want[other], "key %d",
              other);
    }
    kw_map_free(m);
}

/* Sums of many keys, among values that were put. */
static void sums_are_kept(void)
{
    enum { KEYS = 3000 };
    kw_map *m = kw_map_new();

    for (int i = 0; i < KEYS; i += 3)
        kw_map_put(m, (uint64_t)i << 20, 5);
    for (int amount = 0; amount < 4; amount++)
        for (int i = 0; i < KEYS; i++)
            kw_map_add(m, (uint64_t)i << 20, amount * i);
    CHECK(m->count == KEYS, "%zu", m->count);
    for (int i = 0; i < KEYS; i++) {
        int want = 6 * i + (i % 3 == 0 ? 5 : 0), got = kw_map_find(m, (uint64_t)i << 20);

        CHECK(got == want, "%d, not %d", got, want);
    }
    kw_map_free(m);
}

static void add_negative(void)
{
    kw_map_add(kw_map_new(), 12, -1);
}

static void add_too_much(void)
{
    kw_map *m = kw_map_new();

    kw_map_put(m, 12, INT32_MAX);
    kw_map_add(m, 12, 1);
}

static void put_negative(void)
{
    kw_map_put(kw_map_new(), 12, -1);
}

static void negative_values_abort(void)
{
    test_aborts("-1", put_negative);
    test_aborts("0 + -1", add_negative);
    test_aborts("2147483647 + 1", add_too_much);
}

static void nothing_may_be_freed(void)
{
    kw_map_free(NULL);
}

int main(void)
{
    test_run("map: an empty map has no key", an_empty_map_has_no_key);
    test_run("map: every key that was put is found, and no other", keys_are_found);
    test_run("map: room is linear in the number of keys", room_is_linear);
    test_run("map: multiples of a power of two do not pile up", keys_are_spread);
    test_run("map: the last value of a key counts, and the key once",
             the_last_value_counts);
    test_run("map: 0, 2^63 and 2^64 - 1 are keys like others", ends_of_the_keys);
    test_run("map: random puts and finds are those of an array", it_is_an_array);
    test_run("map: what is added is summed up, from 0", sums_are_kept);
    test_run("map: a negative value and a sum that no int holds abort",
             negative_values_abort);
    test_run("map: NULL may be freed", nothing_may_be_freed);
    return test_end();
}
