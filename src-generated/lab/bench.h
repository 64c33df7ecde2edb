/* Weft: lab/bench.h, tangled from chapters/engine/04-design.nw. Chapters that add to it:
 * friction.lab, sequential.lab, soft.lab, joints.lab, drawing-pixels.lab, accuracy.lab. Do not edit
 * this file: edit the chapter and type make. MIT licence. */
#ifndef WEFT_LAB_BENCH_H
#define WEFT_LAB_BENCH_H
/* What measurements share, and how a chapter adds its own. Source. */
#include <stdio.h>
#include "lab/lab.h"
#include "weft/contact.h"
#include "weft/resolve.h"
#include "weft/joint.h"

/* lab/NAME.c ends with   const wfMeasureSet NAME_measurements = WF_ROWS(rows);   */
#define CHAPTER(name) extern const wfMeasureSet name##_measurements;
#include "lab/list.h"
#undef CHAPTER

/* By how much the larger of two positive numbers exceeds the other, as a share of it. */
double labRelative(double got, double want);

enum { BENCH_BODIES = 404, BENCH_CONTACTS = 2048 };
typedef struct labBench {
    wfShape      shape[BENCH_BODIES];
    wfBodyState  state[BENCH_BODIES];
    wfBodyForces force[BENCH_BODIES];
    wfReal restitution[BENCH_BODIES], friction[BENCH_BODIES],
        rollingResistance[BENCH_BODIES];
    wfReal       sticking[BENCH_BODIES];
    wfContact    contact[BENCH_CONTACTS], before[BENCH_CONTACTS];
    int          count, contacts, solver, passes, substeps, columns;
    wfResidual  *fine;
    wfVec2       gravity;
    wfReal       h, restitutionThreshold, contactPushSpeed, slop, share;
    wfReal       period, damping;    /* of soft contacts; 0: what is usual */
    _Alignas(16) uint8_t memory[1 << 20];
} labBench;

void labStartBench(labBench *b, const char *solver, double hertz);
int labAddBox(labBench *b, double x, double y, double w, double h, double mass,
              double mu);
int labAddDisc(labBench *b, double x, double y, double r, double mass, double mu);
void labStepBench(labBench *b);
void labRunBench(labBench *b, int steps);
double labCreepOnSlope(const char *solver, double steep);
int labByValue(const void *a, const void *b);           /* orders doubles, for qsort */
void labStackBoxes(labBench *b, const char *solver, int boxes);
double labSlideError(const char *solver, int passes);
double labRollError(const char *solver, int passes);
/* how far a box creeps between the fifth and the tenth second, m */
double labLateCreep(const char *solver, int passes, double steep);

enum { JOINTS_MOST = 24 };
typedef struct labChain {
    wfBodyState state[JOINTS_MOST];
    wfBodyForces forces[JOINTS_MOST];
    wfJoint joint[JOINTS_MOST];
    wfJointStep step;
    wfPool pool;
    _Alignas(WF_POOL_ALIGN) unsigned char memory[1 << 18];
} labChain;

/* Boxes of 1 m and 1 kg in a row below body 0, the last one of `load' kg. */
void labMakeChain(labChain *c, int links, double load, int substeps, int passes);
double labMean(double a, double b)       /* Gauss's arithmetic-geometric mean */;
double labSwingEnergy(const wfBodyState *s);
double labSeconds(void);
int labNeedsDoubles(const char *name);
#endif
