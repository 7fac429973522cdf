#include "map.h"
#include "need.h"
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

/* The place of the key: where it stands, or the empty place where it would. */
static size_t place(const kw_map *m, uint64_t key)
{
    /* neighbouring keys are spread by the golden ratio; the high bits are the best ones */
    uint64_t mixed = key * 0x9e3779b97f4a7c15u;
    size_t i = (size_t)(mixed ^ (mixed >> 32)) & (m->room - 1);

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

void kw_map_put(kw_map *m, uint64_t key, int value)
{
    size_t i = place(m, key);

    KW_NEED(value >= 0, "value %d", value);
    if (m->value[i] == KW_MAP_NONE) {
        if (2 * (m->count + 1) > m->room) {
            grow(m);
            i = place(m, key);
        }
        m->count++;
    }
    m->key[i] = key;
    m->value[i] = value;
}
