/* All tasks -- why learning is with respect to a class of tasks.

   What to see: inputs are three signs, so there are eight, and 256 ways to label them. Over all
   these tasks every program is wrong on exactly half of what it has not seen, whatever it has
   seen. The Perceptron is better than that on tasks that a plane can solve; what it wins there it
   loses on all the others.

   Book: section 1.2, Definition 6 and the sentence on generalizing behind it.
   Claims: learn.all.*
   Chosen here: three signs, four programs. Every set of inputs is tried as experience, so all
   numbers are exact. */

#include "bits.h"       /* the inputs */
#include "claim.h"      /* what we found, for the ledger */
#include "out.h"        /* columns for gnuplot */
#include "perceptron.h" /* the Perceptron */

enum {
    BITS = 3,
    INPUTS = 1 << BITS,
    SETS = 1 << INPUTS, /* of inputs; also labellings, as a set of those labelled +1 */
    PROGRAMS = 4,
    /* The Perceptron makes at most 28 mistakes on a task that a plane solves, (R / margin)^2: R is
       2, and at worst the plane is one like (1, 1, 1, -2) or (2, 1, 1, -1), bias last, with the
       margin 1 / sqrt(7). So the 29th pass at the latest has none. */
    PASSES = 29
};

/* --- programs: the answer to an input after the inputs of the set `seen` --- */

typedef struct experience {
    int m, input[INPUTS];
    double signs[INPUTS * BITS], label[INPUTS];
    double w[BITS + 1]; /* what the Perceptron has learned */
} experience;

typedef double program(const experience *e, const double *signs);

static double constant(const experience *e, const double *signs)
{
    (void)e;
    (void)signs;
    return 1;
}

static double opposite(const experience *e, const double *signs)
{
    double sum = 0;

    (void)signs;
    for (int i = 0; i < e->m; i++)
        sum += e->label[i];
    return sum > 0 ? -1 : 1;
}

/* The label of the nearest input seen, the first of them. */
static double nearest(const experience *e, const double *signs)
{
    double label = 1, most = -BITS - 1;

    for (int i = 0; i < e->m; i++) {
        double alike = 0;

        for (int j = 0; j < BITS; j++)
            alike += signs[j] * e->signs[i * BITS + j];
        if (alike > most) {
            most = alike;
            label = e->label[i];
        }
    }
    return label;
}

static double perceptron(const experience *e, const double *signs)
{
    return kw_perceptron_decide(BITS, e->w, signs);
}

static program *const PROGRAM[PROGRAMS] = {constant, opposite, nearest, perceptron};

/* --- all experiences --- */

/* The label of an input: is it in the set? */
static double label_of(int labelling, int input)
{
    return labelling >> input & 1 ? 1 : -1;
}

/* Returns whether the Perceptron ends without a mistake. */
static int gather(int labelling, int seen, const double *all, experience *e)
{
    int clean = 1;

    *e = (experience){.m = 0};
    for (int i = 0; i < INPUTS; i++) {
        if (!(seen >> i & 1))
            continue;
        for (int j = 0; j < BITS; j++)
            e->signs[e->m * BITS + j] = all[i * BITS + j];
        e->label[e->m++] = label_of(labelling, i);
    }
    if (e->m > 0)
        kw_perceptron_train(BITS, e->m, e->signs, e->label, 1, PASSES, e->w, &clean);
    return clean != 0;
}

/* A count for each program and number of inputs seen. */
typedef struct tally {
    int tasks, unseen[INPUTS], wrong[PROGRAMS][INPUTS];
} tally;

/* Over all sets of inputs, at least one of them unseen. */
static void try_task(int labelling, const double *all, tally *t)
{
    experience e;

    t->tasks++;
    for (int seen = 0; seen < SETS - 1; seen++) {
        gather(labelling, seen, all, &e);
        for (int i = 0; i < INPUTS; i++) {
            if (seen >> i & 1)
                continue;
            t->unseen[e.m]++;
            for (int p = 0; p < PROGRAMS; p++)
                t->wrong[p][e.m] +=
                    PROGRAM[p](&e, all + i * BITS) != label_of(labelling, i);
        }
    }
}

/* Numbers of inputs seen for which some program is not wrong on exactly half of the others. */
static int not_half(const tally *t)
{
    int count = 0;

    for (int p = 0; p < PROGRAMS; p++)
        for (int m = 0; m < INPUTS; m++)
            count += 2 * t->wrong[p][m] != t->unseen[m];
    return count;
}

int main(void)
{
    enum { NEAREST = 2, PERCEPTRON = 3 };
    kw_out *f = kw_out_data("ex_all_tasks"), *report = kw_claim_new("ex_all_tasks");
    static tally planes, others, both;
    double all[INPUTS * BITS];

    fill_inputs(BITS, all);
    for (int labelling = 0; labelling < SETS; labelling++) {
        experience e;
        int a_plane_solves_it = gather(labelling, SETS - 1, all, &e);

        try_task(labelling, all, &both);
        try_task(labelling, all, a_plane_solves_it ? &planes : &others);
    }
    kw_out_section(f, "tasks", "planes all others");
    kw_out_number(f, planes.tasks);
    kw_out_number(f, both.tasks);
    kw_out_number(f, others.tasks);
    kw_out_row(f);
    kw_out_section(f, "perceptron", "seen planes all others");
    for (int m = 0; m < INPUTS; m++) {
        kw_out_number(f, m);
        kw_out_number(f, (double)planes.wrong[PERCEPTRON][m] / planes.unseen[m]);
        kw_out_number(f, (double)both.wrong[PERCEPTRON][m] / both.unseen[m]);
        kw_out_number(f, (double)others.wrong[PERCEPTRON][m] / others.unseen[m]);
        kw_out_row(f);
    }

    kw_claim_count(report, "learn.all.tasks", both.tasks);
    kw_claim_count(report, "learn.all.not-half", not_half(&both));
    kw_claim_count(report, "learn.all.planes", planes.tasks);
    kw_claim_count(report, "learn.all.planes.unseen", planes.unseen[INPUTS - 1]);
    kw_claim_count(report, "learn.all.planes.perceptron",
                   planes.wrong[PERCEPTRON][INPUTS - 1]);
    kw_claim_count(report, "learn.all.planes.nearest", planes.wrong[NEAREST][INPUTS - 1]);
    kw_claim_count(report, "learn.all.others.unseen", others.unseen[INPUTS - 1]);
    kw_claim_count(report, "learn.all.others.perceptron",
                   others.wrong[PERCEPTRON][INPUTS - 1]);
    return kw_out_close(f) | kw_out_close(report);
}
