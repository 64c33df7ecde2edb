/* Weft: engine/block.h, tangled from chapters/engine/20-world.nw. Chapters that add to it:
 * bodies-in-a-world, step, looking, sensors-and-callbacks, mouse-joint, world-origin, modules,
 * joints-in-a-world, continuous-collision, sleep-in-a-world, save-files, in-a-game. Do not edit
 * this file: edit the chapter and type make. MIT licence. */
#ifndef WEFT_ENGINE_BLOCK_H
#define WEFT_ENGINE_BLOCK_H
/* What lies in a world's two chunks. For the engine's own files; not installed. */
#include "engine/regions.h"
#include "weft/world.h"
#include "weft/inspect.h"
#include "weft/modules.h"
#include "weft/settings.h"
#include "weft/material.h"
#include "weft/callbacks.h"
#include "weft/mouse.h"
#include "weft/origin.h"
#include "weft/disable.h"
#include "weft/frames.h"
#include "weft/world_draw.h"
#include "weft/chain.h"
#include "weft/spring.h"
#include "weft/joint_kinds.h"
#include "weft/mover.h"

/* How much of the lists of a step is handed on, untouched, from one step to the next: so
 * many of the first entries, which are sorted by themselves. */
typedef struct wfSleepingLists { int32_t pairs, contacts, touches; } wfSleepingLists;
/* Of a shape in a step: its body's velocity to be and how fast its rim turns, m/s; how far
 * it may come, m. */
typedef struct wfPace { wfVec2 toBe; wfReal rim, way; } wfPace;
#define WF_SOLVER_LARGE "exact"     /* takes many times the room of others */
typedef struct wfKnownPair { int32_t a, b; wfPairMaterial m; } wfKnownPair;
typedef struct wfHeader {
    uint64_t   magic;          /* says: a world, of this layout and precision */
    uint64_t   bytes;          /* of the permanent chunk in use */
    uint64_t   scratchBytes;   /* of the transient chunk in use */
    uint64_t   steps;
    double     time;           /* s */
    uint64_t   offset[WF_REGION_COUNT];
#define WF_SETTING(type, name, ...) type name;
#define WF_ADVANCED WF_SETTING
#include "weft/setting_rows.h"
    wfSlots    bodySlots;
    int32_t    disabledCount;  /* live bodies that take no part in steps */
    /* what else a world keeps */
    wfSlots forceSlots;
    wfSlots shapeSlots;
    int32_t pairCount, contactCount;   /* of the last step */
    wfSleepingLists kept;      /* how much of the lists the next step will not look at */
    int32_t sensorCount;       /* shapes that are sensors */
    int32_t indexStale;        /* 1: the bounds have changed since the index was made */
    int32_t touchCount, hitCount, eventCount[WF_EVENT_KINDS];
    int32_t knownPairs, mostMaterials;   /* now, and ever */
    wfSolveReport report;         /* of the last step */
    int32_t large;                /* 1: created with room for the solver WF_SOLVER_LARGE */
    wfGlobalPoint origin;      /* m: where (0, 0) is; no stage reads it */
    uint32_t used;                       /* needs that somebody had use for */
    int32_t mostPairs, mostContacts;     /* that a step has ever had */
    wfSlots jointSlots;
    int32_t brokenCount;       /* joints that broke in the last step */
    int32_t directJointCount;  /* joints that the last step solved together */
    int32_t unsolved;          /* substeps of the last step not solved so */
    uint64_t machines;         /* of which joints the regions "alone" tell, or 0 */
    int32_t fastCount, impactCount, heldCount;  /* of the last step */
    int32_t crowd;             /* 1: those followed were too many, and struck too often */
    int32_t sleepingCount;     /* how many bodies sleep */
    int32_t roused;            /* 1: since the last step somebody may have woken */
    int32_t islandCount;       /* of the last step: islands that were awake, at its end */
    int32_t    busy;           /* 1: a step runs that calls the user's functions */
} wfHeader;

/* The block's arrays as pointers: made from the offsets when a call begins, never
 * stored. */
typedef struct wfBlock {
#define WF_KEPT(NAME, pointer, name, per, type, modules, stage, rule) type *pointer;
#define WF_FRESH(NAME, name, per, type, modules, stage)
#include "engine/array_rows.h"
    uint8_t *transient;
    /* where a block notes a fault */
    wfCallFault *fault;        /* the handle's; NULL: nobody */
} wfBlock;
/* needs of a block */
uint32_t wfModulesOf(const wfWorldDef *def);
/* Those of these needs that a world with `have` lacks. */
uint32_t wfLacking(uint32_t have, uint32_t modules);
/* What a scene with all of these needs: first the things, then what shows in them. */
uint32_t wfModulesOfAll(uint32_t modules);
/* The first need in this set: its error; WF_OK for none. */
wfResult wfModuleError(uint32_t modules);
/* Does a stage run in worlds of these needs? */
bool wfStageRuns(const wfStageRow *row, uint32_t modules);

/* What an array holds in any world: `each` bytes for each of what `per` says. */
typedef struct wfRegionRow {
    const char *name;
    int32_t chunk, per;
    size_t each;
} wfRegionRow;
extern const wfRegionRow wfRegionTable[WF_REGION_COUNT];
enum {
    /* things that arrays hold one of each */
    WF_PER_WORLD, WF_PER_BODY, WF_PER_ACTIVE_FORCE, WF_BYTES_OF_SCRATCH,
    WF_PER_FORCE,
    WF_PER_SHAPE, WF_PER_PAIR, WF_PER_CONTACT, WF_BYTES_OF_INDEX,
    WF_PER_TOUCH, WF_PER_EVENT,
    WF_PER_PAIR_MATERIAL,
    WF_PER_FINE_BODY,
    WF_PER_JOINT, WF_BYTES_OF_JOINT_ROWS,
    WF_BYTES_OF_MATRIX,
    WF_BYTES_OF_ISLANDS,
    WF_PER_COUNT
};
/* The arrays of the permanent chunk are the first so many. */
#define WF_REGION_KEPT WF_REGION_NEW_STATE

/* What the library of scenes as text calls, too, is marked. */
#if defined __GNUC__ && !defined _WIN32
#define WF_FOR_SCENES __attribute__((visibility("default")))
#else
#define WF_FOR_SCENES
#endif

/* Chunks of these sizes: what is given, as it is, or cleared ones if nothing is. */
wfResult wfTakeMemory(const wfMemory *given, const size_t size[2], wfMemory *out);
/* Checks a handle and finds the arrays. WF_ERROR_NULL, _MEMORY, _NOT_A_WORLD. */
WF_FOR_SCENES wfResult wfOpenBlock(const wfWorld *world, wfBlock *out);
/* An array of the transient chunk. */
void *wfTransient(const wfBlock *b, int region);
/* That chunk from this array on, as a pool. */
wfPool wfScratchFrom(const wfBlock *b, int region);
/* The settings of a header, as a definition; and from a definition that was checked. */
wfWorldDef wfSettings(const wfHeader *head);
void wfKeepSettings(const wfWorldDef *def, wfHeader *head);
/* All bodies as a view of the given states. */
wfBodyView wfViewOf(const wfBlock *b, const wfBodyState *state);
/* A definition whose open capacities are chosen, without what its modules don't need. */
wfWorldDef wfCompleteDef(const wfWorldDef *def);
/* Is the value one of this setting's? The settings that are vectors have two parts. */
wfResult wfCheckSetting(const wfSetting *s, double value);
int wfSettingParts(const wfSetting *s);
/* The body that an id names, as wfOpenBlock and wfChangeBlock; WF_ERROR_STALE_ID. */
wfResult wfOpenBody(const wfWorld *world, wfBodyId id, wfBlock *b, int32_t *index);
/* The slot that an id names, or -1. */
int32_t wfFindSlot(const wfSlots *s, const wfSlot *slots, uint32_t index,
                   uint32_t generation);
/* The id of the living body at place i. */
wfBodyId wfIdOfBody(const wfBlock *b, int32_t i);
/* Something was done to body i from outside (-1: to all); to both ends of a force, a joint
 * or a contact, as far as they are dynamic. */
void wfBodyChanged(wfBlock *b, int32_t i);
void wfEndsChanged(wfBlock *b, int32_t first, int32_t second);
/* Clears thing i in all arrays of one each (of: WF_PER_BODY ...), but not its slot. */
void wfClearPlace(wfBlock *b, int32_t of, const void *slots, int32_t i);
/* alive[i] of a body that takes no part in steps; of one that does, awake or asleep: 1. */
enum { WF_DISABLED = 2 };
static inline bool wfIsEnabled(const wfBlock *b, int32_t i)
{
    (void)b, (void)i;
    /* see whether body i was taken out */
    if (b->alive[i] == WF_DISABLED) return false;
    return true;
}
/* who can let a world grow */
bool wfGrowFor(wfWorld *world, const char *name, int32_t need);
/* Has the world grown, so that there is room for `need` of what this capacity counts (0: of
 * pairs and contacts, for a step), and the call should be made again? b is then no more. */
static inline bool wfGrew(wfWorld *world, const wfBlock *b, const char *name, int32_t need)
{
    (void)world, (void)b, (void)name, (void)need;
    /* see whether the world can grow */
    if (b->head->growth) return wfGrowFor(world, name, need);
    return false;
}
/* True when no number is NaN or infinite. */
bool wfAllFinite(const wfReal *number, size_t count);
wfResult wfOpenShape(const wfWorld *world, wfShapeId id, wfBlock *b, int32_t *index);
wfShapeView wfShapesOf(const wfBlock *b);
wfShapeId wfIdOfShape(const wfBlock *b, int32_t k);
/* How many more shapes there is room for; hang one on a body (-1: no room), or drop it. */
int32_t wfFreeShapes(const wfBlock *b);
wfResult wfRefuseShapes(const wfBlock *b, int32_t more);    /* WF_ERROR_FULL */
int32_t wfHangShape(wfBlock *b, int32_t body, const wfShapeDef *def);
void wfDropShape(wfBlock *b, int32_t k);
/* Bounds a shape, or all shapes of a body, anew: after every change from outside. */
WF_FOR_SCENES void wfBoundShape(wfBlock *b, int32_t k);
WF_FOR_SCENES void wfBoundBody(wfBlock *b, int32_t i);
/* The proxies of all shapes with these bounds. */
wfProxies wfProxiesOf(const wfBlock *b, const wfRect *bounds, const uint8_t *flags);
/* Forgets the contacts and pairs of a body (-1: none) and of a shape (-1: none). */
void wfForgetContacts(wfBlock *b, int32_t body, int32_t shape);
/* What body i would be if it had this type; and making it so. */
wfResult wfWeighBody(const wfBlock *b, int32_t i, int type, wfBodyState *state,
                     wfBodyProps *props);
WF_FOR_SCENES void wfCarryOut(wfBlock *b, int32_t i, const wfBodyState *state,
                              const wfBodyProps *props);
/* Is it a shape, as it is stored, or at least when moved by the centre of mass? */
wfResult wfCheckMovedShape(const wfShape *stored, wfVec2 centre);
/* What two shapes' materials make together: known, or mixed by the world's rules. */
wfPairMaterial wfMixMaterials(const wfBlock *b, const wfShapeProps *one,
                              const wfShapeProps *two);
/* name the call that runs */
#define WF_CALL __func__
#ifndef WF_CALL
#define WF_CALL NULL            /* nobody wants to know it */
#endif
/* As wfOpenBlock; WF_ERROR_BUSY. The second: for a call of that name, which changes the
 * world. */
wfResult wfOpenAtRest(const wfWorld *world, wfBlock *out);
wfResult wfChangeBlockAs(const char *call, wfWorld *world, wfBlock *out);
#define wfChangeBlock(world, out) wfChangeBlockAs(WF_CALL, world, out)
wfResult wfChangeBodyAs(const char *call, wfWorld *world, wfBodyId id, wfBlock *b,
                        int32_t *index);
#define wfChangeBody(world, id, b, index) wfChangeBodyAs(WF_CALL, world, id, b, index)
/* Notes that a number of a structure is refused (number NULL: a field of that name, which
 * is no number; wfNoRange: `mend` tells what it may be). A "[]" stands for the element. */
void wfNoteFault(const wfBlock *b, wfResult result, const char *of, int32_t element,
                 const char *field, const wfNumber *number, double value,
                 const char *mend);
void wfNoteWorld(wfWorld *world, const wfWorldDef *def, wfResult result);
/* The first of a call; result may be WF_OK. */
void wfNoteField(const wfBlock *b, wfResult result, const char *field, int32_t element,
                 const char *mend);
void wfNoteValue(const wfBlock *b, wfResult result, const char *field, double value,
                 const char *mend);
void wfNoteId(const wfBlock *b, const char *field, uint32_t index, uint32_t generation);
void wfRenameFault(wfCallFault *f, wfResult result, const char *call);
extern const wfNumber wfNoRange;
/* Returns the result. If it is an error, and no other was noted for this call: notes that
 * it is a field's, and what mends it (NULL: what the result says). A "[]" of the field
 * stands for an element's index. */
static inline wfResult wfRefuseOne(const wfBlock *b, wfResult result, const char *field,
                                   int32_t element, const char *mend)
{
    (void)b, (void)field, (void)element, (void)mend;
    /* note what is refused */
    wfNoteField(b, result, field, element, mend);
    return result;
}
static inline wfResult wfRefuse(const wfBlock *b, wfResult result, const char *field,
                                const char *mend)
{
    return wfRefuseOne(b, result, field, 0, mend);
}
/* The same of a number, and of an id that names nothing. */
static inline wfResult wfRefuseValue(const wfBlock *b, wfResult result, const char *field,
                                     double value, const char *mend)
{
    (void)b, (void)field, (void)value, (void)mend;
    /* note the value that is refused */
    wfNoteValue(b, result, field, value, mend);
    return result;
}
static inline wfResult wfRefuseId(const wfBlock *b, const char *field, uint32_t index,
                                  uint32_t generation)
{
    (void)b, (void)field, (void)index, (void)generation;
    /* note the id that is refused */
    wfNoteId(b, field, index, generation);
    return WF_ERROR_STALE_ID;
}
/* The same for a call that has no block of its own. */
static inline wfResult wfRefuseCallAs(const char *call, wfWorld *world, wfResult result,
                                      const char *field, const char *mend)
{
    (void)call, (void)world, (void)field, (void)mend;
    /* note what a call without a block refuses */
    wfBlock b = { .fault = world != NULL ? &world->fault : NULL };
    if (b.fault != NULL && result != WF_OK && result != WF_ERROR_BUSY) {
        *b.fault = (wfCallFault){ .call = call };
        wfNoteField(&b, result, field, 0, mend);
    }
    return result;
}
#define wfRefuseCall(world, result, field, mend) \
    wfRefuseCallAs(WF_CALL, world, result, field, mend)
/* The result of another call that this one made: it is told in this one's name. */
static inline wfResult wfTellAs(const char *call, wfWorld *world, wfResult result)
{
    (void)call, (void)world;
    /* tell another call's refusal in this one's name */
    if (world != NULL && result != WF_ERROR_BUSY) wfRenameFault(&world->fault, result, call);
    return result;
}
#define wfTellOwn(world, result) wfTellAs(WF_CALL, world, result)
/* Are the numbers of a structure what they may be? Their names begin with `of`. */
wfResult wfCheckFields(const wfBlock *b, const char *of, int32_t element,
                       const void *structure, const wfNumber *numbers, int count);
/* Likewise a number, and the parts of a vector. */
wfResult wfCheckReal(const wfBlock *b, const char *name, wfReal x, wfReal least,
                     wfReal most);
wfResult wfCheckVector(const wfBlock *b, const char *name, wfVec2 v);
/* Returns the result: a setting of a definition is wrong (NULL: none by itself). */
wfResult wfRefuseSetting(const wfBlock *b, wfResult result, const wfSetting *s,
                         const wfWorldDef *def);
/* WF_ERROR_FULL: a capacity, of which more is needed. */
wfResult wfRefuseFull(const wfBlock *b, const char *name, int32_t capacity, int32_t need);
wfResult wfChangeShapeAs(const char *call, wfWorld *world, wfShapeId id, wfBlock *b,
                         int32_t *index);
#define wfChangeShape(world, id, b, index) wfChangeShapeAs(WF_CALL, world, id, b, index)

/* Was the world made for one of these needs? */
static inline bool wfHas(const wfHeader *h, uint32_t modules)
{
    (void)h, (void)modules;
    /* look whether a need is met */
    if ((h->modules & modules) == 0) return false;
    return true;
}
/* WF_OK if the world has all these needs; else the error of the first that it lacks. */
static inline wfResult wfRequireModules(const wfBlock *b, uint32_t modules)
{
    (void)b, (void)modules;
    /* demand the needs */
    uint32_t missing = wfLacking(b->head->modules, modules);
    if (missing != 0) return wfRefuse(b, wfModuleError(missing), "modules", NULL);
    return WF_OK;
}
/* Somebody has had use for these needs. */
static inline void wfUse(wfBlock *b, uint32_t modules)
{
    (void)b, (void)modules;
    /* note the needs */
    b->head->used |= modules;
}
/* Weighs body i with these properties and makes it so; errors of wfWeighBody. */
wfResult wfReweighBody(wfBlock *b, int32_t i, const wfBodyProps *changed);

/* What the states round away; NULL: nobody keeps it. */
static inline wfResidual *wfResidualOf(const wfBlock *b)
{
    return b->head->compensatedSums ? b->fine : NULL;
}
/* Is a rest what rounding to this state can lose? eq:world-digits */
WF_FOR_SCENES bool wfAreDigits(const wfBodyState *s, const wfResidual *rest);
/* What a rest has more than that goes to the state. */
void wfSettleDigits(wfBodyState *s, wfResidual *rest);
/* Removes the joints of a body. */
void wfDropJoints(wfBlock *b, int32_t body);
/* Stages of joints. */
struct wfStep;
wfResult wfLeaveOutJoined(struct wfStep *s);
wfResult wfTakeJoints(struct wfStep *s);
wfResult wfBreakJoints(struct wfStep *s);
wfResult wfKeepJoints(struct wfStep *s);
/* Tells the joints that every place is called by less `by`. */
void wfMoveJoints(wfBlock *b, wfVec2 by);
/* Would all of them still be joints? */
bool wfJointsCanMove(const wfBlock *b, wfVec2 by);

enum { WF_CROWD = 256, WF_STEP_ROOM = 4096 };
/* Are fast bodies followed to unmovable things alone? */
static inline bool wfIsCrowd(const wfBlock *b) { return b->head->crowd != 0; }
/* A body that is followed through a step. Times are shares of the step. */
typedef struct wfSweptBody {
    int32_t body, impacts;     /* whose it is; how many it has had */
    int32_t own, other;        /* the shapes that meet next; other -1: nobody */
    wfReal  since, next;       /* when the leg begins; when they meet, above 1: never */
    wfSweep leg;               /* the motion from `since` to the end of the step */
    wfVec2  gain;              /* m/s and rad/s: what the step has added to the velocity */
    wfReal  spin;
    wfReal  reach;             /* m: no point of the body is farther from its centre */
    wfRect  box;               /* round the leg */
    wfVec2  point, normal;     /* where they meet: halfway, and from `own` to `other` */
    bool    fast, held, lost;  /* looks for others; waits; does not know what comes */
    bool    fresh;             /* its leg has just been changed */
} wfSweptBody;
/* A collision that was dealt with at its own moment. */
typedef struct wfImpactEvent {
    wfPair pair;
    wfVec2 point, normal;      /* world, m; unit, from pair.a to pair.b */
    wfReal speed, impulse;     /* m/s before it; N s */
    wfReal bounced;            /* 1: it bounced; a real, so that no byte is a hole */
} wfImpactEvent;
/* Stages of fast bodies, and what they need from others. */
wfResult wfContinuousBefore(struct wfStep *s);
wfResult wfContinuousAfter(struct wfStep *s);
wfResult wfFindPairsAgain(struct wfStep *s);
wfContact wfStartContact(const struct wfStep *s, wfPair p);
wfResult wfTellImpactEvents(struct wfStep *s);
int32_t wfFindFlown(struct wfStep *s, wfPair *out, int32_t most);
wfResult wfAskAboutContact(struct wfStep *s, wfContact *c, bool *enabled);
/* Is there a joint that keeps the bodies a and b from colliding? */
bool wfIsJoined(const struct wfStep *s, int32_t a, int32_t b);
/* Wakes whom a joint holds to a body that is not dynamic. */
void wfWakeJoined(wfBlock *b, int32_t body);
/* Sleep. A new or a cleared place; who is disturbed, and by what. */
void wfBeginRest(wfBlock *b, int32_t i, int32_t never);
void wfWakeIsland(wfBlock *b, int32_t i);
void wfWakeNear(wfBlock *b, int32_t k);
bool wfBodySleeps(const wfBlock *b, int32_t i);
void wfLeaveOutSleeping(struct wfStep *s);
void wfWakeInStep(struct wfStep *s, int32_t i);
bool wfMovesNow(const struct wfStep *s, int32_t i);
void wfKeepRest(struct wfStep *s);
wfResult wfPlaceSleeping(struct wfStep *s);
wfResult wfFindIslands(struct wfStep *s);
int32_t wfOldTouches(const struct wfStep *s, wfTouchingPair *out);
void wfAddSensed(const struct wfStep *s, wfTouchingList *stay);
void wfLeaveOutDisabled(struct wfStep *s);
/* Leaves those capacities open in `to` that were not chosen in `now`, nor are there. */
void wfLetFollow(const wfWorldDef *now, wfWorldDef *to);
#endif
