#include "size.h"
#include "estimate.h"
#include "gen.h"

/* The steps of kw_active_new, and the numbers that kw_hier_new moves. */
static const double most_bytes = 0x1p32, most_steps = 0x1p30, most_numbers = 0x1p35;

/* Is there not too much of `what`? */
static int check(double needed, double most, const char *what, const char *path)
{
    if (needed > most)
        return gen_say(
            GEN_BAD_INPUT,
            "%s: its basis needs about %.3g %s, more than %.3g; fewer cells or a "
            "lower degree will do",
            path, needed, what, most);
    return GEN_GOOD;
}

int size_check_active(const kw_mesh *m, const char *path)
{
    int status = check(kw_estimate_pairs(m), most_steps, "steps", path);

    return status == GEN_GOOD ? check(kw_estimate_active(m), most_bytes, "bytes", path)
                              : status;
}

int size_check_basis(const kw_mesh *m, const char *path)
{
    int status = size_check_active(m, path);
    kw_active *a;

    if (status == GEN_GOOD)
        status = check(kw_estimate_numbers(m), most_numbers, "numbers", path);
    if (status != GEN_GOOD)
        return status;
    a = kw_active_new(m);
    status = check(kw_estimate_hier(a), most_bytes, "bytes", path);
    kw_active_free(a);
    return status;
}
