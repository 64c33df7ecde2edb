/* abuse.h: what a session of abuse is. A session is one world and a list of calls, each an operation and a seed; everything
   that a call does follows from its seed and from what the session has done. So any part of the list can be run again. */
#ifndef WEFT_ABUSE_H
#define WEFT_ABUSE_H
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "weft/weft.h"

typedef struct Call { uint32_t op; uint64_t seed; } Call;

/* what came of an operation: filled in by all sessions, in memory that parent and children share */
typedef struct Tally {
    uint64_t calls[256][WF_RESULT_COUNT + 1];   /* by operation and result; the last: it returns none */
    uint64_t steps, sessions, done;
    Call     now;                               /* the call under way */
    uint64_t session;                           /* of which session, and which of its calls */
    int      at;
    char     broken[400];                       /* the promise that was broken, and by whom */
} Tally;
extern Tally *tally;

/* the things of a kind that the session has seen: those that live, and those that did */
enum { KNOWN = 96, MOST_KNOWN = 4096 };         /* places of the dead are used again from KNOWN on; what lives always has one */
typedef struct Thing { uint32_t index, generation; int32_t a, b; bool alive; uint32_t owner; } Thing;
typedef struct Things { Thing list[MOST_KNOWN]; int count, alive; } Things;

typedef struct Session {
    wfWorldDef def;
    wfWorld    world;
    bool       made, given;        /* given: the chunks are ours */
    uint8_t   *chunk[2], *transient;
    int        side;               /* in which of the two the world is */
    size_t     size[2];
    uint8_t   *shadow;             /* the permanent chunk as the last call left it */
    Things     bodies, shapes, forces, joints;
    uint64_t   random;
    int        wild;               /* how many numbers of 256 are no sensible ones */
    bool       poisoned;           /* the call got a number that is none */
    bool       badHandle;          /* it got no world */
    bool       inHook, changed;
    int        sinceCheck;
} Session;

uint32_t next(Session *s);
static inline uint32_t below(Session *s, uint32_t n) { return next(s) % n; }
static inline bool chance(Session *s, uint32_t of256) { return (next(s) & 255) < of256; }

enum { READS, CHANGES };
typedef struct Operation {
    const char *name, *group;
    int weight, kind;
    wfResult (*run)(Session *s);
    bool silent;                   /* has no result to return */
} Operation;
extern const Operation operations[];
extern const int operationCount;

void begin_session(Session *s, uint64_t seed);
void do_call(Session *s, Call call);
void end_session(Session *s);
uint32_t choose(uint64_t *random);  /* an operation, by the weights */
extern int tracing;

#define MUST(x) do { if (!(x)) broken(__LINE__, #x); } while (0)
void broken(int line, const char *what);
#endif
