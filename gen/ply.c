#include "ply.h"
#include "out.h"

int gen_ply_cloud(const char *path, int rows, int columns, const double *row,
                  const int *place)
{
    static const char *const name[] = {"x", "y", "z", "u", "v"};
    kw_out *f = kw_out_new(path);

    kw_out_text(f, "ply\nformat ascii 1.0\nelement vertex %d\n", rows);
    for (int k = 0; k < 5; k++)
        kw_out_text(f, "property double %s\n", name[k]);
    kw_out_text(f, "end_header\n");
    for (int i = 0; i < rows; i++, row += columns)
        for (int k = 0; k < 5; k++)
            kw_out_text(f, "%.17g%c", row[place[k]], k < 4 ? ' ' : '\n');
    return kw_out_close(f);
}
