#include "vtu.h"
#include "hierset.h"
#include "out.h"
#include <stdlib.h>

/* Corner k of a cell in the order of VTK: around the lower face, then around the upper
   one. Is it at the high end of direction h? */
static int is_high(int k, int h)
{
    return h == 0 ? (k & 3) == 1 || (k & 3) == 2 : h == 1 ? (k & 2) != 0 : (k & 4) != 0;
}

typedef struct writer {
    const kw_mesh *m;
    kw_out *file;
    void (*place)(void *with, const double *x, double *point);
    void *with;
    int cells;
} writer;

static void put_corners(writer *w, int level, const int *cell)
{
    double low[KW_TENSOR_D], high[KW_TENSOR_D];

    hierset_corners(w->m, level, cell, low, high);
    for (int k = 0; k < 1 << w->m->D; k++) {
        double x[KW_TENSOR_D], point[3] = {0};

        for (int h = 0; h < w->m->D; h++) {
            x[h] = is_high(k, h) ? high[h] : low[h];
            point[h] = x[h];
        }
        if (w->place)
            w->place(w->with, x, point);
        kw_out_text(w->file, "%.17g %.17g %.17g\n", point[0], point[1], point[2]);
    }
}

static void put_level(writer *w, int level, const int *cell)
{
    (void)cell;
    kw_out_text(w->file, "%d\n", level);
}

static void count_cell(writer *w, int level, const int *cell)
{
    (void)level;
    (void)cell;
    w->cells++;
}

/* Active cells, level by level. */
static void each_cell(writer *w, void (*visit)(writer *, int level, const int *cell))
{
    for (int l = 0; l < w->m->levels; l++) {
        long long count;
        uint64_t *flat = kw_mesh_cells(w->m, l, &count);

        for (long long i = 0; i < count; i++) {
            int cell[KW_TENSOR_D];

            kw_mesh_multi(w->m, l, flat[i], cell);
            if (!kw_mesh_refined(w->m, l, cell))
                visit(w, l, cell);
        }
        free(flat);
    }
}

static void begin_array(kw_out *f, const char *type, const char *name, const char *more)
{
    kw_out_text(f, "<DataArray type=\"%s\" Name=\"%s\"%s format=\"ascii\">\n", type, name,
                more);
}

static void put_topology(writer *w)
{
    static const int type[] = {3, 9, 12}; /* line, quadrilateral, hexahedron */
    const int corners = 1 << w->m->D;
    kw_out *f = w->file;

    kw_out_text(f, "<Cells>\n");
    begin_array(f, "Int64", "connectivity", "");
    for (int i = 0; i < w->cells * corners; i++)
        kw_out_text(f, "%d%c", i, i % corners == corners - 1 ? '\n' : ' ');
    kw_out_text(f, "</DataArray>\n");
    begin_array(f, "Int64", "offsets", "");
    for (int i = 1; i <= w->cells; i++)
        kw_out_text(f, "%d\n", i * corners);
    kw_out_text(f, "</DataArray>\n");
    begin_array(f, "UInt8", "types", "");
    for (int i = 0; i < w->cells; i++)
        kw_out_text(f, "%d\n", type[w->m->D - 1]);
    kw_out_text(f, "</DataArray>\n</Cells>\n");
}

int gen_vtu_mesh(const char *path, const kw_mesh *m,
                 void (*place)(void *with, const double *x, double *point), void *with)
{
    writer w = {m, kw_out_new(path), place, with, 0};
    kw_out *f = w.file;

    each_cell(&w, count_cell);
    kw_out_text(
        f, "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
           "byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n");
    kw_out_text(f, "<Piece NumberOfPoints=\"%d\" NumberOfCells=\"%d\">\n<Points>\n",
                w.cells << m->D, w.cells);
    begin_array(f, "Float64", "Points", " NumberOfComponents=\"3\"");
    each_cell(&w, put_corners);
    kw_out_text(f, "</DataArray>\n</Points>\n");
    put_topology(&w);
    kw_out_text(f, "<CellData Scalars=\"level\">\n");
    begin_array(f, "Int32", "level", "");
    each_cell(&w, put_level);
    kw_out_text(f,
                "</DataArray>\n</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
    return kw_out_close(f);
}
