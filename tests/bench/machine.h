/* machine.h -- what the machine itself can do, measured beside the works: its memory and its
   arithmetic. */
#ifndef MACHINE_H
#define MACHINE_H

typedef struct machine {
    double *a; /* three long arrays, one behind the other */
    double sum;
} machine;

machine *machine_new(void);
void machine_free(machine *m);

/* a = b + 3 c with arrays that no cache holds. [McCalpin: STREAM, the triad] */
void machine_triad(void *with);
extern const double MACHINE_BYTES; /* that it reads and writes */

/* Multiplications, each followed by an addition, in as many sums side by side as keep the
   processor busy: first as two operations, as all of Knotwork has them, then fused to
   one, which rounds once and so gives other bits. */
void machine_multiply_add(void *with);
void machine_fused(void *with);
extern const double MACHINE_MULTIPLY_ADDS; /* of a call of either */

#endif
