/* Figure 17 -- A convolutional network with all its connections.

   What to see: in the convolutional layers every unit has three connections to the layer
   before, at the ends two; in the fully connected layers one to each unit. Dark: all paths
   to the middle unit of the last convolutional layer; it depends on every input.

   Book: section 1.2, Definition 11 and the text around Figure 17.
   Claims: cnn.fig17.*
   Chosen here: how many units the layers have, one channel, a filter of 3 with zeros around
   the input, ReLU between the layers. */

#include "claim.h" /* what we found, for the ledger */
#include "need.h"  /* the layers are those that we draw */
#include "net.h"   /* the network */
#include "out.h"   /* columns for gnuplot */

enum { UNITS = 9, FILTER = 3, CONVOLUTIONAL = 4, FULL = 8, OUTPUT = 4, STAGES = 7 };

static kw_net *new_network(void)
{
    const kw_conv l = kw_conv_layer((kw_conv){.in_channels = 1,
                                              .rows = 1,
                                              .columns = UNITS,
                                              .out_channels = 1,
                                              .filter_rows = 1,
                                              .filter_columns = FILTER,
                                              .stride = 1,
                                              .padding = KW_CONV_SAME});
    kw_net *n = kw_net_new(UNITS);

    for (int i = 0; i < CONVOLUTIONAL; i++) {
        kw_net_add_conv(n, &l);
        kw_net_add_activation(n, KW_RELU);
    }
    for (int i = 0; i < 2; i++) {
        kw_net_add_affine(n, FULL);
        kw_net_add_activation(n, KW_RELU);
    }
    kw_net_add_affine(n, OUTPUT);
    return n;
}

/* A layer with parameters, and which of its outputs and inputs it joins. */
typedef enum stage_kind { INPUT, CONV, AFFINE, LAST } stage_kind;

typedef struct stage {
    stage_kind kind;
    int in, out, parameters, connections;
    int joined[UNITS][UNITS]; /* output, input */
    int dark[UNITS][UNITS];   /* those on a path to the middle unit */
} stage;

/* All parameters are one. Then a unit input gives every output its bias, one, and something
   more to those that it is joined with. */
static stage read_stage(const kw_layer *l)
{
    stage s = {.kind = l->kind == KW_LAYER_CONV ? CONV : AFFINE,
               .in = l->in,
               .out = l->out,
               .parameters = l->parameters};
    double ones[UNITS * (UNITS + 1)];

    KW_NEED(l->in <= UNITS && l->out <= UNITS, "%d and %d units", l->in, l->out);
    for (int i = 0; i < l->parameters; i++)
        ones[i] = 1;
    for (int i = 0; i < l->in; i++) {
        double x[UNITS] = {0}, y[UNITS] = {0};

        x[i] = 1;
        if (l->kind == KW_LAYER_CONV)
            kw_conv_forward(&l->is.conv, ones, 1, x, y);
        else
            kw_affine_forward(&l->is.affine, ones, 1, x, y);
        for (int o = 0; o < l->out; o++) {
            s.joined[o][i] = y[o] != 1;
            s.connections += s.joined[o][i];
        }
    }
    return s;
}

static void read_network(const kw_net *n, stage *s)
{
    int count = 0;

    for (int l = 0; l < n->layers; l++)
        if (n->layer[l].parameters > 0) {
            KW_NEED(count < STAGES, "more than %d layers with parameters", STAGES);
            s[count++] = read_stage(&n->layer[l]);
        }
    KW_NEED(count == STAGES, "%d layers with parameters", count);
    s[STAGES - 1].kind = LAST;
}

/* Marks the paths from the middle unit of the last convolutional layer back to the input;
   how many inputs they reach. */
static int mark_paths(stage *s)
{
    int reached[UNITS] = {0}, count = 0;

    reached[UNITS / 2] = 1;
    for (int l = CONVOLUTIONAL - 1; l >= 0; l--) {
        int before[UNITS] = {0};

        for (int o = 0; o < s[l].out; o++)
            for (int i = 0; i < s[l].in; i++)
                if (reached[o] && s[l].joined[o][i])
                    s[l].dark[o][i] = before[i] = 1;
        for (int i = 0; i < UNITS; i++)
            reached[i] = before[i];
    }
    for (int i = 0; i < UNITS; i++)
        count += reached[i];
    return count;
}

/* --- the picture --- */

static double height(int units, int i)
{
    return (units - 1) / 2.0 - i;
}

static void write_units(kw_out *f, int layer, int units, stage_kind kind)
{
    for (int i = 0; i < units; i++) {
        kw_out_number(f, layer);
        kw_out_number(f, height(units, i));
        kw_out_number(f, kind);
        kw_out_row(f);
    }
}

static void write_connections(kw_out *f, int layer, const stage *s)
{
    for (int o = 0; o < s->out; o++)
        for (int i = 0; i < s->in; i++)
            if (s->joined[o][i]) {
                kw_out_number(f, layer - 1);
                kw_out_number(f, height(s->in, i));
                kw_out_number(f, layer);
                kw_out_number(f, height(s->out, o));
                kw_out_number(f, s->kind);
                kw_out_number(f, s->dark[o][i]);
                kw_out_row(f);
            }
}

static void write_picture(kw_out *f, const stage *s)
{
    kw_out_section(f, "units", "layer y kind");
    write_units(f, 0, s[0].in, INPUT);
    for (int l = 0; l < STAGES; l++)
        write_units(f, l + 1, s[l].out, s[l].kind);
    kw_out_section(f, "connections", "from y to y kind dark");
    for (int l = 0; l < STAGES; l++)
        write_connections(f, l + 1, &s[l]);
    kw_out_section(f, "counts", "layer connections");
    for (int l = 0; l < STAGES; l++) {
        kw_out_number(f, l + 1);
        kw_out_number(f, s[l].connections);
        kw_out_row(f);
    }
}

/* --- what is counted --- */

typedef struct totals {
    int layers, parameters, least, most; /* least and most connections of a layer */
} totals;

/* Of the stages of the kinds from `first` to `last`. */
static totals add_up(const stage *s, stage_kind first, stage_kind last)
{
    totals t = {.least = UNITS * UNITS};

    for (int l = 0; l < STAGES; l++) {
        if (s[l].kind < first || s[l].kind > last)
            continue;
        t.layers++;
        t.parameters += s[l].parameters;
        t.least = s[l].connections < t.least ? s[l].connections : t.least;
        t.most = s[l].connections > t.most ? s[l].connections : t.most;
    }
    return t;
}

int main(void)
{
    kw_out *f = kw_out_data("fig17"), *report = kw_claim_new("fig17");
    kw_net *n = new_network();
    stage s[STAGES];
    totals conv, hidden, full;
    int reached;

    read_network(n, s);
    reached = mark_paths(s);
    write_picture(f, s);

    conv = add_up(s, CONV, CONV);
    hidden = add_up(s, AFFINE, AFFINE);
    full = add_up(s, AFFINE, LAST);
    kw_claim_count(report, "cnn.fig17.hidden", conv.layers + hidden.layers);
    kw_claim_count(report, "cnn.fig17.convolutional", conv.layers);
    kw_claim_count(report, "cnn.fig17.full", hidden.layers);
    kw_claim_count(report, "cnn.fig17.connections.convolutional", conv.most);
    kw_claim_count(report, "cnn.fig17.connections.full", full.least);
    kw_claim_true(report, "cnn.fig17.fewer", conv.most < full.least);
    kw_claim_count(report, "cnn.fig17.parameters.convolutional", conv.parameters);
    kw_claim_count(report, "cnn.fig17.parameters.full", full.parameters);
    kw_claim_count(report, "cnn.fig17.seen", reached);

    kw_net_free(n);
    return kw_out_close(f) | kw_out_close(report);
}
