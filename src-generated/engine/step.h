/* Weft: engine/step.h, tangled from chapters/engine/22-step.nw. Chapters that add to it: looking,
 * joints-in-a-world, continuous-collision, sleep-in-a-world, seams, tolerance. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#ifndef WEFT_ENGINE_STEP_H
#define WEFT_ENGINE_STEP_H
/* A step in the making. For the engine's own files; not installed. */
#include "core/parts.h"
#include "engine/block.h"

enum { WF_STEP_PART = 128 };   /* bodies or shapes in a part, at least */

/* A step in the making: everything new is in transient memory until the last stage. */
struct wfStep {
    wfBlock          b;
    wfPool           scratch;
    wfWorkers        workers;     /* who shares the work, sec:memory-parts */
    /* what a step works with at all */
    const wfStepClock *clock;     /* that times the stages, or NULL */
    int32_t          count;       /* places for bodies in use */
    uint8_t         *present;     /* 1: a body that takes part in the step */
    bool             all;         /* all bodies are present */
    int32_t          again;       /* 1: begin this step anew */
    int32_t          restarts;    /* how often it was begun anew */
    wfBodyState     *state;       /* the new states */
    wfForce         *forces;      /* the forces that act in this step */
    wfReal          *ages;        /* s: for so long each of them has been there */
    int32_t          forceCount;
    /* arrays of the second half */
    int32_t          shapeCount;  /* places for shapes in use */
    int32_t          movers;      /* how many bodies can move, or do */
    wfSleepingLists  kept;        /* of the last step, and not to be looked at again */
    wfBodyForces    *sums;        /* of the forces, for a solver that steps */
    wfTransform     *places;      /* of the bodies, from the new states */
    wfPace          *paces;       /* of the shapes, for a solver that steps */
    wfRect          *bounds;      /* of the shapes, and their flags */
    uint8_t         *flags;
    void            *index;       /* of the broad phase, or NULL */
    wfPairList       pairs;
    int32_t          foundPairs;  /* so many the broad phase has found, with those kept */
    wfContact       *contacts;
    int32_t          contactCount;
    const wfConstraints *laws;    /* constraints besides contacts, or NULL */
    wfManifoldCache *caches;      /* one for each pair */
    wfTouchingPair  *touches;
    int32_t          touchCount;
    wfTold          *told;        /* of each contact; NULL: nobody asks */
    wfContactHit    *hits;
    int32_t          hitCount;
    wfReal           hitSpeed;    /* m/s: faster approaches are hits */
    wfContactEvent  *events;
    int32_t          eventTotal, eventCount[WF_EVENT_KINDS];
    const wfCallbacks *hooks;     /* the user's functions, or NULL */
    wfCallbackView   view;        /* what they get to see */
    wfResidual *fine;          /* the new one, or NULL */
    wfSolveReport report;         /* of the solver, if it makes one */
    int32_t          joinedCount; /* pairs of joined bodies, sorted, in their region */
    wfJointSet       jointSet;    /* copies of the joints, and what solving them takes */
    wfConstraints    jointLaws;
    int32_t         *jointPlaces; /* from which place each of them was copied */
    uint64_t         machines;    /* a fingerprint of who is joined to whom */
    wfSweptBody     *flights;
    int32_t         *flightOf;    /* of each body, or -1; valid when there are flights */
    int32_t          flightCount, fastCount, impactCount, heldCount;
    wfReal           slack;       /* m: no other body moves farther */
    wfKeyed         *inOrder;     /* flights by where their boxes begin, in x or y; or NULL */
    int32_t          alongY;
    wfReal           longest;     /* m: the longest side of their boxes, along the same axis */
    wfImpactEvent   *strikes;     /* in the order of their pairs */
    int32_t          strikeCount;
    wfPair          *spared;      /* pairs that pass each other in this step, lower first; or
                                   * until the one comes over the other's link, higher first */
    int32_t          sparedCount;
    bool             followed;    /* somebody was not looked ahead for, since it is followed */
    bool             driven;      /* somebody is followed whom nothing can change */
    uint8_t         *linked;      /* 1: a joint holds the body, and its margins stay; or NULL */
    uint8_t         *woken;       /* 1: slept before, and takes part; 2: fell asleep */
    int32_t          roused;      /* 1: some of what was kept is kept no longer */
    int32_t          tired;       /* how many fall asleep at the end */
    wfReal          *clocks;      /* new clocks of rest */
    wfIslands        islands;
    int32_t         *firstTile;   /* of each shape: its first pair with a tile, -1; or NULL */
    int32_t         *nextTile;    /* of each pair: the next pair of the same shape, or -1 */
};

/* by chunk; a bit is an array */
typedef struct wfArrays { uint64_t kept, fresh; } wfArrays;
enum { WF_SOLVER_MOVES = 1, WF_STAGES_MOVE = 2, WF_EITHER = 3 };
/* What a stage reads and writes. All rows of its name count: a part that has arrays of its
 * own adds a row. seldom: when it writes so, if no scene ever shows it; or NULL. */
typedef struct wfFlowRow {
    const char *stage;
    int32_t pages;
    wfArrays reads, writes;
    const char *seldom;
} wfFlowRow;
extern const wfFlowRow wfFlowTable[];
extern const int wfFlowCount;

/* Does the world's solver move the bodies itself? How far may a shape come, m? */
bool wfSolverIntegrates(const struct wfStep *s);
int32_t wfPassesOf(const wfHeader *head);     /* of the contact solver */
/* notes its pace */
wfReal wfSpeculativeMargin(struct wfStep *s, int32_t k, bool *followed);
/* Is it a sensor, and could a contact change its body's velocity? */
static inline bool wfIsSensor(const wfBlock *b, int32_t k)
{
    return b->materials[k].sensor != 0;
}
bool wfHasMass(const struct wfStep *s, int32_t k);
wfReal wfSpeculativeMarginOfPair(const struct wfStep *s, wfPair p);
/* Does anything move it, or could it? Its flags and its box, where the body is placed. */
bool wfCanMove(const wfBodyState *s);
uint8_t wfFlagShape(const wfBlock *b, const wfBodyState *state, int32_t k);
wfRect wfBoundOne(const wfBlock *b, int32_t k, wfTransform placed);
size_t wfIndexBytes(const wfHeader *head);      /* of the broad phase's index */
/* Stages. */
wfResult wfBoundShapes(struct wfStep *s);
wfResult wfFindNewPairs(struct wfStep *s);
wfResult wfFindContacts(struct wfStep *s);
wfResult wfPrepareIndex(struct wfStep *s);
wfResult wfKeepTouches(struct wfStep *s);       /* two stages */
wfResult wfTellEvents(struct wfStep *s);
void wfNoteStep(const struct wfStep *s, wfResult result);
#define WF_NEAR_WAY WF_R(0.5)       /* reaches in a step: no body is followed below */
#define WF_LINKED_WAY 8     /* reaches in a step: bodies with joints are followed above */
/* Does a shape with such a way (m) in a step go farther than its inner radius, and is it
 * therefore followed? eq:impact-fast */
static WF_ONE_COPY bool wfIsFollowed(const struct wfStep *s, int32_t k, wfReal way)
{
    const wfShapeProps *m = &s->b.materials[k];
    wfReal least = (wfSolverIntegrates(s) ? WF_NEAR_WAY : s->b.head->slop) * m->reach;
    bool linked = s->linked != NULL && s->linked[s->b.bodyOfShape[k]];
    if (linked && way <= WF_LINKED_WAY * m->reach) return false;
    return s->b.head->maxImpacts > 0 && way > wfMaxR(m->inner, least);
}
void wfFindLinked(struct wfStep *s);    /* which bodies have a joint that holds */
/* Tiles. */
void wfFindTiles(struct wfStep *s);
void wfMendTile(const struct wfStep *s, wfPair p, wfReal margin, wfManifold *m);
void wfMendStruck(const struct wfStep *s, wfPair p, const wfTransform at[2], wfReal margin,
                  wfManifold *m);
/* Do some bodies make fewer substeps than others? The step of such a world. */
bool wfStepsApart(const struct wfStep *s);
wfResult wfStepApart(struct wfStep *s, const wfSolve *solve);
#endif
