/* Weft: include/weft/save.h, tangled from chapters/methods/29-save-and-replay.nw. Chapters that add
 * to it: compound, world, looking, sensors-and-callbacks, mouse-joint, world-origin,
 * joints-in-a-world, sleep-in-a-world, rewind, replay, save-files, in-a-game, tolerance. Do not
 * edit this file: edit the chapter and type make. MIT licence. */
/* save.h: a world as bytes: copied, compared, taken back, saved, checked.
   Every call that can fail returns a wfResult and then has changed nothing. */
#ifndef WEFT_SAVE_H
#define WEFT_SAVE_H
#include "weft/chain.h"
#include "weft/world.h"
#include "weft/inspect.h"
#include "weft/modules.h"
#include "weft/settings.h"
#include "weft/material.h"
#include "weft/callbacks.h"
#include "weft/mouse.h"
#include "weft/origin.h"
#include "weft/spring.h"
#include "weft/disable.h"
#include "weft/frames.h"
#include "weft/world_draw.h"
#include "weft/mover.h"
WF_BEGIN_C

/* Bytes of a snapshot of the world as it is now; 0: not a world. */
size_t wfSnapshotSize(const wfWorld *world);
/* Writes a snapshot, and to *size how many bytes it has. Between two steps; the bytes may
 * lie anywhere. WF_ERROR_NULL, _BUSY, _MEMORY: capacity is too small. */
wfResult wfSnapshotWorld(const wfWorld *world, void *bytes, size_t capacity, size_t *size);
/* Makes a world what a snapshot shows: of itself, or of another one of this program.
 * WF_ERROR_NULL, _BUSY, _TRUNCATED, _NOT_A_WORLD, _INVALID: not a snapshot's bytes; _FULL,
 * _BUILT_IN: the world has not the room, or not the parts. Trusts the rest: what comes from
 * outside is for wfLoadFromBytes. */
wfResult wfRestoreWorld(wfWorld *world, const void *bytes, size_t size);
/* A second world like the first, in memory of its own, or in `memory` unless that is NULL
 * (sizes: wfWorldSize of wfGetWorldDef; not the first one's own). Given memory is written
 * only where the world has something: who clones again into the same memory pays for no
 * page twice. WF_ERROR_NULL, _BUSY, _MEMORY. */
wfResult wfCloneWorld(const wfWorld *world, const wfMemory *memory, wfWorld *out);

/* Where two worlds differ first. */
typedef struct wfDifference {
    const char *region;        /* its name, as in wfWorldRegions; NULL: nowhere */
    int32_t     element;       /* of the region: the index of a body, a shape, a pair ... */
    const char *field;         /* its name, or "byte" */
    size_t      byte;          /* of the element */
    double      one, two;      /* what stands there, if the field has a name */
} wfDifference;

/* Are two worlds of one precision the same, bit for bit, in all that the next step reads?
 * Capacities may differ. WF_ERROR_DIFFERENT, and where; `out` may be NULL. */
wfResult wfCompareWorlds(const wfWorld *a, const wfWorld *b, wfDifference *out);
/* Moves a world into a block with the room that `room` names (read it by wfGetWorldDef and
 * raise what is built in; its memory: handed over, or zero for the world's own). With more
 * bodies or shapes, capacities that followed from these (wfWorldDef) and are not raised by
 * themselves follow again. Ids, state and future stay; the old block is freed if the world
 * owned it. Errors of wfCreateWorld; WF_ERROR_FULL: there is more in the world than that;
 * _BUILT_IN; _BUSY. */
wfResult wfGrowWorld(wfWorld *world, const wfWorldDef *room);

/* A ring of snapshots in memory that the user gives: the newest push out the oldest. */
typedef struct wfRewind {
    uint8_t *bytes;
    size_t   size;
    size_t   oldest, newest;   /* where those snapshots are kept */
    int32_t  count;            /* how many are kept */
} wfRewind;

/* Starts an empty ring. WF_ERROR_NULL; WF_ERROR_MEMORY: not aligned to WF_POOL_ALIGN. */
wfResult wfRewindInit(wfRewind *ring, void *bytes, size_t size);
/* Keeps the world as it is. WF_ERROR_MEMORY: it would not fit even into an empty ring; the
 * ring is unchanged. Errors of wfSnapshotWorld. */
wfResult wfRewindKeep(wfRewind *ring, const wfWorld *world);
/* Takes the world back to the newest snapshot that was kept at `step` (wfWorldSteps) or
 * before, and forgets those behind it. WF_ERROR_UNKNOWN: nothing so old is kept. Errors of
 * wfRestoreWorld. */
wfResult wfRewindTo(wfRewind *ring, wfWorld *world, uint64_t step);
/* The steps of the oldest and the newest snapshot. WF_ERROR_UNKNOWN: the ring is empty. */
wfResult wfRewindReach(const wfRewind *ring, uint64_t *oldest, uint64_t *newest);

/* A call as a value. `index` and `generation` are the id of what is changed: a body, a
 * shape, a force or a joint. */
typedef struct wfInput {
    int32_t  kind;             /* WF_INPUT_... */
    uint32_t index, generation;
    union {
        struct { wfVec2 at, by; wfReal x, y; int32_t number; } with;
        wfBodyDef body;
        uint64_t userData;
        wfShapeDef shape;
        wfForce force;
        wfJoint joint;
        wfPairMaterial pair;
        wfGlobalPoint global;
    };
} wfInput;
typedef struct wfInputId { uint32_t index, generation; } wfInputId;

enum {
    WF_INPUT_ADD_BODY,             /* body */
    WF_INPUT_REMOVE_BODY,
    WF_INPUT_TRANSFORM,            /* at: m; x: angle, rad */
    WF_INPUT_VELOCITY,             /* by: m/s; x: rad/s */
    WF_INPUT_MASS,                 /* x: kg */
    WF_INPUT_TYPE,                 /* number: WF_STATIC, ... */
    WF_INPUT_DAMPING,              /* x, y: linear, angular, 1/s */
    WF_INPUT_PUSH,                 /* by: N, at: m, for one step */
    WF_INPUT_TWIST,                /* x: N m, for one step */
    WF_INPUT_IMPULSE,              /* by: N s, at: m */
    WF_INPUT_SPIN,                 /* x: N m s */
    WF_INPUT_GRAVITY,              /* by: m/s^2 */
    WF_INPUT_DT,                   /* x: s */
    WF_INPUT_GRAVITY_SCALE,        /* x */
    WF_INPUT_FIXED_ROTATION,       /* number: 0 or 1 */
    WF_INPUT_MASS_DATA,            /* at: centre, m; x: kg; y: inertia, kg m^2 */
    WF_INPUT_TARGET,               /* at: m; x: angle, rad; y: seconds */
    WF_INPUT_BODY_DATA, WF_INPUT_SHAPE_DATA, WF_INPUT_JOINT_DATA,   /* userData */
    WF_INPUT_ADD_SHAPE,            /* shape; the id is the body's */
    WF_INPUT_REMOVE_SHAPE,
    WF_INPUT_SET_SHAPE,            /* shape */
    WF_INPUT_MATERIAL,             /* x: restitution, y: friction; of a body */
    WF_INPUT_ADD_FORCE,            /* force */
    WF_INPUT_REMOVE_FORCE,
    WF_INPUT_SET_FORCE,            /* force */
    WF_INPUT_GRAB,                 /* at: m; the id is the body's */
    WF_INPUT_DRAG,                 /* at: m; the id is the hand's */
    WF_INPUT_ADD_JOINT,            /* joint */
    WF_INPUT_REMOVE_JOINT,
    WF_INPUT_SET_JOINT,            /* joint */
    WF_INPUT_WAKE, WF_INPUT_SLEEP,
    WF_INPUT_NEVER_SLEEPS,         /* number: 0 or 1 */
    WF_INPUT_ENABLE,               /* number: 0 or 1 */
    WF_INPUT_PAIR,                 /* pair; index, generation: the two materials */
    WF_INPUT_FORGET_PAIR,          /* index, generation: the two materials */
    WF_INPUT_SETTING,              /* index: row of wfSettingTable; generation: its part; x */
    WF_INPUT_MOVE_ORIGIN,          /* by: m */
    WF_INPUT_SET_ORIGIN,           /* far: m */
    WF_INPUT_SUBSTEPS,             /* number: wfSetBodySubsteps */
    WF_INPUT_KINDS
};

/* What was done to a world, in memory that the user gives. */
typedef struct wfJournal {
    uint8_t *bytes;
    size_t   size, used;
    size_t   run;              /* where the entry of the last run of steps is, or `used` */
    int32_t  trail;            /* 1: the hash of the world is noted after every step */
    uint64_t begins;           /* hash of the world before the first entry; 0: none yet */
} wfJournal;

/* Starts an empty journal. WF_ERROR_NULL; _RANGE: trail is 0 or 1. */
wfResult wfJournalInit(wfJournal *journal, void *bytes, size_t size, int32_t trail);
/* Carries out an input and notes it, unless it fails: then nothing has changed, and there
 * is nothing to note. journal, made may be NULL; *made: the id of what was added. Errors of
 * the call; WF_ERROR_UNKNOWN: no such kind; _FULL: the journal is, nothing was done. */
wfResult wfGiveInput(wfWorld *world, wfJournal *journal, const wfInput *input,
                     wfInputId *made);
/* wfStepWorldWithCallbacks, noted. WF_ERROR_FULL: the journal is, the world did not step.
 * */
wfResult wfStepNoted(wfWorld *world, wfJournal *journal, const wfCallbacks *hooks);

/* A finger on a journal. All zero but for the journal: at its beginning. */
typedef struct wfReplay {
    const wfJournal *journal;
    size_t   at;               /* the next entry */
    uint64_t left;             /* steps that are left of the run before it */
} wfReplay;

/* Carries out what the journal says, up to and with the next step; *stepped: 0 when there
 * is none left. hooks as at recording. Errors of the inputs and of the step;
 * WF_ERROR_DIVERGED: the hash after the step is not the noted one; _INVALID: no journal of
 * this program. */
wfResult wfReplayStep(wfReplay *replay, wfWorld *world, const wfCallbacks *hooks,
                      int32_t *stepped);

/* Where two runs part. */
typedef struct wfDivergence {
    uint64_t     step;         /* wfWorldSteps of the first worlds that differ */
    wfBodyId     body;         /* whose state differs; index 0: it is not a body's */
    wfDifference what;         /* region NULL: they never part */
} wfDivergence;

/* Replays two journals side by side, each in its world, until the worlds differ or both
 * end. WF_ERROR_DIVERGED, and where; errors of the replays other than that. */
wfResult wfFindDivergence(wfReplay *one, wfWorld *a, wfReplay *two, wfWorld *b,
                          const wfCallbacks *hooks, wfDivergence *out);
#define WF_SAVE_VERSION 1
/* What the header of a file says. */
typedef struct wfSaveInfo {
    uint32_t version;
    int32_t  highestFirst;     /* 1: the machine had the highest byte first */
    int32_t  realBytes;        /* 4: float, 8: double */
    int32_t  holds;            /* 1: a world, 2: a journal */
    uint64_t layout;           /* what the writing program's structures look like */
    uint64_t size, steps, hash;
} wfSaveInfo;

/* Reads a header, and sees whether the file is whole; knows nothing of versions. WF_ERROR_
 * NULL, _NOT_A_SAVE, _TRUNCATED (or too long), _CHECKSUM. */
wfResult wfReadSaveInfo(const void *bytes, size_t size, wfSaveInfo *out);
/* Bytes that a save takes now; 0: not a world. And the save itself: WF_ERROR_NULL, _BUSY,
 * _MEMORY: capacity is too small. */
size_t wfSaveSize(const wfWorld *world);
wfResult wfSaveToBytes(const wfWorld *world, void *bytes, size_t capacity, size_t *size);

/* A new world from a save, in its own memory or in `memory` unless that is NULL. Believes
 * nothing: whatever the bytes are, what comes back has passed wfCheckWorld. Errors of
 * wfReadSaveInfo; WF_ERROR_VERSION, _BYTE_ORDER, _PRECISION, _LAYOUT; _INVALID: whole, and
 * yet no world; of wfCreateWorld. */
wfResult wfLoadFromBytes(const void *bytes, size_t size, const wfMemory *memory,
                         wfWorld *out);
/* What a save or a scene from outside may claim. */
typedef struct wfLoadLimits {
    size_t memory;             /* bytes; 0: WF_LOAD_MEMORY */
} wfLoadLimits;
#define WF_LOAD_MEMORY ((size_t)1 << 30)
/* What they allow; limits NULL: the usual ones. */
size_t wfMostMemory(const wfLoadLimits *limits);
/* The same; limits NULL: the usual ones. A world in memory handed over claims none.
 * WF_ERROR_LIMIT: it would take more, and has taken nothing. */
wfResult wfLoadFromBytesWithin(const void *bytes, size_t size, const wfLoadLimits *limits,
                               const wfMemory *memory, wfWorld *out);
/* A number for what a block looks like in this program: other layout, other number. */
uint64_t wfLayoutHash(void);
/* Differs for any two inputs that differ within 64 neighbouring bits: eq:save-sum. */
uint64_t wfChecksum(const void *bytes, size_t n);
#if defined WF_FREESTANDING && !defined WF_NO_FILES
#define WF_NO_FILES
#endif
#ifndef WF_NO_FILES
/* Makes these bytes the contents of a file. They go to a new file beside it, .weft-save-
 * and 16 digits, are brought to the disk and renamed to path: at every moment path is the
 * old file or the new one, whole, whoever else saves to it. The file keeps its permissions;
 * a link at path is replaced, not followed. A process that is killed may leave the new file
 * behind. WF_ERROR_NULL; _FILE: the system refuses, or path is a directory, a pipe or a
 * device, or has 4000 bytes or more; then nothing has changed and errno says why. */
wfResult wfReplaceFile(const char *path, const void *bytes, size_t size);
/* Saves to a file by wfReplaceFile. Needs memory of wfSaveSize for a moment. Errors of
 * wfSaveToBytes and of wfReplaceFile; _MEMORY. */
wfResult wfSaveToFile(const wfWorld *world, const char *path);
/* Errors of wfLoadFromBytes; WF_ERROR_FILE: it cannot be read, or is not a regular file;
 * _MEMORY. The file's bytes and the world each keep to the limits (NULL: the usual). */
wfResult wfLoadFromFile(const char *path, wfWorld *out);
wfResult wfLoadFromFileWithin(const char *path, const wfLoadLimits *limits, wfWorld *out);
#endif
/* A journal with the header and the checksum of a save file: no damage goes unnoticed. In
 * its header: its steps, and the hash of the world with which it begins. wfJournalSaveSize
 * is 0 for no journal. WF_ERROR_NULL; _INVALID: no journal of this program; _MEMORY. */
size_t wfJournalSaveSize(const wfJournal *journal);
wfResult wfSaveJournalToBytes(const wfJournal *journal, void *bytes, size_t capacity,
                              size_t *size);
/* The entries go to `room`, of at least size - 64 bytes, which the journal keeps (more: it
 * can go on). Believes nothing. out->begins is wfHashWorld of the world to replay it in.
 * Errors of wfReadSaveInfo; WF_ERROR_VERSION, _BYTE_ORDER, _PRECISION, _LAYOUT;
 * _NOT_A_SAVE: it holds no journal; _INVALID: whole, and yet none; _MEMORY: room is too
 * small. */
wfResult wfLoadJournalFromBytes(const void *bytes, size_t size, void *room,
                                size_t capacity, wfJournal *out);
#ifndef WF_NO_FILES
/* The same as wfSaveToFile and wfLoadFromFile do. */
wfResult wfSaveJournalToFile(const wfJournal *journal, const char *path);
wfResult wfLoadJournalFromFile(const char *path, void *room, size_t capacity,
                               wfJournal *out);
#endif

/* What is wrong with a block, and where. */
typedef struct wfFault {
    const char *region;        /* its name, as in wfWorldRegions */
    int32_t     element;       /* which of the region */
    const char *rule;          /* the rule that it breaks: a sentence */
} wfFault;

/* Does the block keep all rules that a step relies on? Asked of any bytes, of which only
 * the header's magic must be right. `fault` may be NULL. Writes to the transient chunk.
 * WF_ERROR_INVALID: it does not; WF_ERROR_BUSY (from a hook); those of a bad handle. */
wfResult wfCheckWorld(const wfWorld *world, wfFault *fault);
WF_END_C
#endif
