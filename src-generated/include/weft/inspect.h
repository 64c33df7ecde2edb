/* Weft: include/weft/inspect.h, tangled from chapters/engine/23-looking.nw. Chapters that add to
 * it: world, step, modules, joints-in-a-world, continuous-collision, sleep-in-a-world. Do not edit
 * this file: edit the chapter and type make. MIT licence. */
#ifndef WEFT_INSPECT_H
#define WEFT_INSPECT_H
/* A world from the inside: for tests, tools and overlays. Views are arrays of the world's
 * own, to read and not to keep: valid until the next call that changes the world. */
#include "weft/world.h"
WF_BEGIN_C

/* One array of the block. */
typedef struct wfRegion {
    const char *name;
    int32_t chunk;             /* 0: permanent, 1: transient */
    size_t  count, each;       /* elements, and bytes of one */
    size_t  offset;            /* bytes from the start of the chunk */
} wfRegion;
/* Where everything lies in a world made from `def`: the function that places it, asked.
 * out has room for wfRegionCount of them. */
wfResult wfWorldRegions(const wfWorldDef *def, wfRegion *out);
extern const int wfRegionCount;
struct wfStep;
typedef wfResult wfStageFn(struct wfStep *step);
/* One stage of a step: what it is called and what it does. */
typedef struct wfStageRow {
    const char *name, *text;
    wfStageFn *run;
    uint32_t all, any;         /* needs: run if all of `all` are met, and one of `any` if
                                * there are any */
} wfStageRow;
extern const wfStageRow wfStageTable[];
extern const int wfStageCount;
/* How the solver of the last step fared: "exact" tells how many problems it has solved and
 * how many not; other solvers leave zeros. WF_ERROR_NULL. */
wfResult wfGetSolveReport(const wfWorld *world, wfSolveReport *out);
/* Pairs of shapes of the broad phase and contacts of the narrow phase of the last step, as
 * far as they are still true; first those of bodies that sleep, then those of
 * all others, each part sorted by the indices of the shapes. */
const wfPair *wfWorldPairs(const wfWorld *world, int32_t *count);
const wfContact *wfWorldContacts(const wfWorld *world, int32_t *count);
/* Boxes around the shapes as they stand: what a broad phase reads, to build and draw its
 * tree with. Arrays of the world's own. */
wfResult wfWorldProxies(const wfWorld *world, wfProxies *out);
/* Shows the boxes (m) of the index by which the broad phase finds these, as
 * they stand; none, if the method keeps no index. Gives scratch back. WF_ERROR_NULL;
 * WF_ERROR_MEMORY: scratch has no room for a copy of the index and its update. */
wfResult wfWorldIndexBoxes(const wfWorld *world, wfPool *scratch, wfBoxVisitFn *visit,
                           void *context);
/* The contact of two shapes in the last step, either one first. WF_ERROR_STALE_ID;
 * WF_ERROR_UNKNOWN: they have none. */
wfResult wfGetContact(const wfWorld *world, wfShapeId a, wfShapeId b, wfContact *out);
/* A point (m) or a direction from the frame of a body's origin to the world, and back; how
 * fast the point of the body is that is now there (m/s). A stale id: as a body at rest in
 * the world's origin. */
wfVec2 wfBodyWorldPoint(const wfWorld *world, wfBodyId id, wfVec2 local);
wfVec2 wfBodyLocalPoint(const wfWorld *world, wfBodyId id, wfVec2 point);
wfVec2 wfBodyWorldVector(const wfWorld *world, wfBodyId id, wfVec2 local);
wfVec2 wfBodyLocalVector(const wfWorld *world, wfBodyId id, wfVec2 vector);
wfVec2 wfBodyVelocityAt(const wfWorld *world, wfBodyId id, wfVec2 point);
/* The next contact of the last step in which a body is, after that one (NULL: the first);
 * NULL: no more. As wfWorldContacts, to read and not to keep. */
const wfContact *wfNextContact(const wfWorld *world, wfBodyId id, const wfContact *after);
/* Kinetic energy of the dynamic bodies, and potential energy in gravity and in the
 * registered forces that have one, J. Either pointer may be NULL. */
wfResult wfWorldEnergy(const wfWorld *world, double *kinetic, double *potential);
/* Momentum of the dynamic bodies, kg m/s, and angular momentum about the origin, kg
 * m^2/s. */
wfResult wfWorldMomentum(const wfWorld *world, double linear[2], double *angular);
/* A number for the state of all live bodies: equal states, equal numbers, on any
 * machine. */
uint64_t wfHashWorld(const wfWorld *world);
/* What is known of a shape besides its geometry. */
typedef struct wfShapeProps {
    wfReal  density, restitution, friction, staticFriction, rollingResistance, tangentSpeed;
    wfReal   reach;            /* m: wfShapeMaxExtent, from its middle to its rim */
    wfReal   arm;              /* m: the same of its core, without the coat */
    wfReal   inner;           /* m: wfShapeMinExtent, from its middle to the nearest edge */
    wfReal   spare;            /* 0: without it there would be a hole in the bytes */
    int32_t  sensor, material;
    uint64_t userData;
} wfShapeProps;
/* The world's own arrays of shapes, to read and not to keep. bodyOfShape[k] is the index of
 * shape k's body, or -1: an empty place. For an empty handle the count is 0. */
typedef struct wfShapeView {
    int32_t             count;
    const wfShape      *shapes;      /* relative to the centre of mass */
    const int32_t      *bodyOfShape;
    const int32_t      *next;        /* the next shape of the same body, or -1 */
    const wfFilter     *filters;
    const wfShapeProps *props;
} wfShapeView;
wfShapeView wfWorldShapes(const wfWorld *world);

/* A clock for the stages of a step. */
typedef struct wfStepClock {
    double (*now)(void *context);    /* s, since whenever */
    void   *context;
    double *seconds;                 /* wfStageCount numbers; each stage adds its time */
} wfStepClock;
/* One stage of a world's pipeline. */
typedef struct wfStageReport {
    const char *name;
    bool        runs;
    uint32_t    because;       /* runs: the needs that it serves, 0: every world. Does not
                                * run: the needs that are absent */
    size_t      bytes;         /* of the arrays that it fills */
} wfStageReport;
/* wfStepWorld with a clock (NULL: none), which must not change the world: _BUSY. */
wfResult wfStepWorldTimed(wfWorld *world, const wfStepClock *clock);
/* Row `stage` of wfStageTable in this world. WF_ERROR_NULL, _UNKNOWN. */
wfResult wfExplainStage(const wfWorld *world, int stage, wfStageReport *out);

typedef void wfPrintFn(void *context, const char *line);
/* Tells what this world was made for, what a step of it does, what it leaves out and why,
 * and how many bytes and how much time each stage takes: a line at a time, without the
 * end of the line. seconds: as a wfStepClock has added them up over so many steps; NULL:
 * no times. WF_ERROR_NULL. */
wfResult wfExplainWorld(const wfWorld *world, const double *seconds, int64_t steps,
                        wfPrintFn *print, void *context);
/* Joints that the last step solved together, and whether these were all. */
int32_t wfDirectJointCount(const wfWorld *world);
bool wfAllJointsDirect(const wfWorld *world);
/* Substeps of the last step in which the joints that are solved together could not be: a
 * load that snapped a chain tight, say. They were taken inelastically. */
int32_t wfUnsolvedSubsteps(const wfWorld *world);
/* Where a joint is on its way, m or rad: the length, the slide along the axis, the turn of
 * b against a; of a gear, rack, linkage or pulley their sum of both; and how fast that
 * changes. Either may be NULL. WF_ERROR_STALE_ID, _UNKNOWN: this kind has no way. */
wfResult wfGetJointMotion(const wfWorld *world, wfJointId id, wfReal *coordinate,
                          wfReal *speed);
/* The next joint of a body, after that one (index 0: the first); index 0: no more. */
wfJointId wfNextJoint(const wfWorld *world, wfBodyId id, wfJointId after);
/* What became of fast bodies in the last step. */
typedef struct wfContinuousReport {
    int32_t bodies;            /* that were followed, since they were fast */
    int32_t impacts;           /* collisions that were solved at their moment */
    int32_t held;              /* bodies that lost the rest of the step: too many impacts */
} wfContinuousReport;
wfResult wfGetContinuousReport(const wfWorld *world, wfContinuousReport *out);
/* How much of a world rests: bodies awake (dynamic and kinematic) and asleep; islands that
 * are awake; pairs and contacts that the last step looked at, and those that it kept. */
typedef struct wfSleepCounts {
    int32_t awake, asleep, islands;
    int32_t pairs, contacts;
    int32_t pairsKept, contactsKept;
} wfSleepCounts;
wfSleepCounts wfGetSleepCounts(const wfWorld *world);
WF_END_C
#endif
