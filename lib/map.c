#include "map.h"
#include "need.h"
#include <limits.h>
#include <stdlib.h>

enum { FIRST_ROOM = 16 };

static void make_room(kw_map *m, size_t room)
{
    m->room = room;
    m->key = kw_need_memory(room, sizeof *m->key);
    m->value = kw_need_memory(room, sizeof *m->value);
    for (size_t i = 0; i < room; i++)
        m->value[i] = KW_MAP_NONE;
}

kw_map *kw_map_new(void)
{
    kw_map *m = kw_need_memory(1, sizeof *m);

    make_room(m, FIRST_ROOM);
    return m;
}

void kw_map_free(kw_map *m)
{
    if (!m)
        return;
    free(m->key);
    free(m->value);
    free(m);
}

/* Each bit of the key moves each bit of the result. [Stafford: Better bit mixing, variant 13,
   known from SplitMix64] */
static uint64_t mixed(uint64_t key)
{
    key = (key ^ key >> 30) * 0xbf58476d1ce4e5b9u;
    key = (key ^ key >> 27) * 0x94d049bb133111ebu;
    return key ^ key >> 31;
}

/* The place of the key: where it stands, or the empty place where it would. */
static size_t place(const kw_map *m, uint64_t key)
{
    /* eight keys in a row stay together, in one line of the processor's cache */
    size_t i = (size_t)(mixed(key >> 3) << 3 | (key & 7)) & (m->room - 1);

    while (m->value[i] != KW_MAP_NONE && m->key[i] != key)
        i = (i + 1) & (m->room - 1);
    return i;
}

int kw_map_find(const kw_map *m, uint64_t key)
{
    return m->value[place(m, key)];
}

static void grow(kw_map *m)
{
    kw_map old = *m;

    make_room(m, 2 * old.room);
    for (size_t i = 0; i < old.room; i++)
        if (old.value[i] != KW_MAP_NONE) {
            size_t to = place(m, old.key[i]);

            m->key[to] = old.key[i];
            m->value[to] = old.value[i];
        }
    free(old.key);
    free(old.value);
}

/* The place of the key, which is in the table from now on, with the value 0 if it is new. */
static size_t own_place(kw_map *m, uint64_t key)
{
    size_t i = place(m, key);

    if (m->value[i] != KW_MAP_NONE)
        return i;
    if (2 * (m->count + 1) > m->room) {
        grow(m);
        i = place(m, key);
    }
    m->count++;
    m->key[i] = key;
    m->value[i] = 0;
    return i;
}

void kw_map_put(kw_map *m, uint64_t key, int value)
{
    size_t i = own_place(m, key); /* may move m->value */

    KW_NEED(value >= 0, "value %d", value);
    m->value[i] = value;
}

void kw_map_add(kw_map *m, uint64_t key, int amount)
{
    size_t i = own_place(m, key);

    KW_NEED(0 <= amount && amount <= INT_MAX - m->value[i], "%d + %d", m->value[i],
            amount);
    m->value[i] += amount;
}
