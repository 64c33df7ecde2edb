/* Weft: testbed/challenges.h, tangled from chapters/testbed/18-challenges.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#ifndef TESTBED_CHALLENGES_H
#define TESTBED_CHALLENGES_H
/* Challenges: scenes with a task, whose outcome is judged by the program. */
#include "testbed/scene.h"

enum { WF_NOT_YET, WF_DONE, WF_LOST };

/* What is known of a try; all zero before the first step. */
typedef struct wfTrial {
    int32_t verdict;            /* WF_NOT_YET, WF_DONE or WF_LOST: the judge's */
    int32_t held;               /* 1: the hand holds a body in this step */
    int32_t unfit;              /* 1: something was built that may not be: the judge's */
    double  shown;              /* the number that is told */
    double  kept[4];            /* what the judge remembers */
} wfTrial;

typedef struct wfChallenge {
    const char *name;           /* for the address: #challenge=NAME */
    const char *scene;          /* its scene's name; the scene's text is the task */
    const char *may;            /* a sentence: what the reader may do */
    const char *with;           /* with which tool; NULL: a number of the body `changed' */
    const char *number;         /* a format for `shown' */
    uint64_t before, during;    /* WF_MAY(kind of input): before time runs; while it runs */
    int32_t given;              /* how many bodies the scene has */
    int32_t changed;            /* which of these may be changed; -1: none */
    int32_t most;               /* how many bodies may be added, or how many kicks given */
    bool    hand;               /* bodies may be held while time runs */
    void  (*judge)(const wfWorld *world, wfTrial *trial);
    /* Why what was built does not count, or NULL. May itself be NULL. */
    const char *(*unfit)(const wfWorld *world);
} wfChallenge;
#define WF_MAY(kind) ((uint64_t)1 << (kind))

extern const wfChallenge wfChallengeTable[];
extern const int wfChallengeCount;
/* The row of the challenge with this name, or of this scene; -1: there is none. */
int wfFindChallenge(const char *name);
/* Judges a step of a try that has no verdict yet. */
void wfJudge(const wfChallenge *challenge, const wfWorld *world, wfTrial *trial);
#endif
