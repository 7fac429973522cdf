/* map.h -- a table from 64-bit keys to small numbers, for grids of which little is used.

   Open addressing with linear probing, at most half full. [Knuth, The Art of Computer
   Programming 3, section 6.4] */
#ifndef KW_MAP_H
#define KW_MAP_H

#include <stddef.h>
#include <stdint.h>

typedef struct kw_map {
    uint64_t *key; /* room entries; owned */
    int *value;    /* room entries, KW_MAP_NONE where there is no key; owned */
    size_t room;   /* a power of two */
    size_t count;  /* keys in the table */
} kw_map;

enum { KW_MAP_NONE = -1 };

/* An empty table; the caller frees. Never NULL. */
kw_map *kw_map_new(void);
void kw_map_free(kw_map *m);

/* The value of `key`, or KW_MAP_NONE. */
int kw_map_find(const kw_map *m, uint64_t key);

/* Gives `key` the value, which is >= 0, whether or not it had one. */
void kw_map_put(kw_map *m, uint64_t key, int value);

/* Adds to the value of `key`, which counts as 0 if it had none; amount >= 0. */
void kw_map_add(kw_map *m, uint64_t key, int amount);

#endif
