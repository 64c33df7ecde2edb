/* Weft: include/weft/json.h, tangled from chapters/methods/33-scenes-as-text.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#ifndef WEFT_JSON_H
#define WEFT_JSON_H
/* json.h: scenes as text, in JSON. The library weft-json has these functions;
 * it needs cJSON and a C library. testbed/scenes/scene.schema.json describes the text. */
#include "weft/save.h"
WF_BEGIN_C

#define WF_SCENE_VERSION 1          /* of the text: its field "weft" */
#define WF_SCENE_DEPTH 32           /* objects and arrays in one another at most */
#define WF_SCENE_BYTES (1 << 28)    /* length of a text at most */

/* What is wrong with a text, and where. */
typedef struct wfTextError {
    wfResult result;                /* WF_OK: nothing */
    int32_t  line;                  /* from 1; 0: of no line in particular */
    char     where[128];            /* "bodies[3].shapes[0].radius"; "": of all of it */
    char     what[192];             /* "must be > 0" */
} wfTextError;
/* What a text says besides its world. Empty strings and zeros: nothing. */
typedef struct wfSceneInfo {
    char   name[40], text[200];
    wfReal viewX, viewY, viewHeight;    /* m: what a camera might look at */
    wfReal energyBound, depthBound; /* J, m: what it may gain, how deep it may sink; < 0:
                                     * it promises nothing */
} wfSceneInfo;
/* Makes the world of a text of so many bytes, in memory handed over (as wfOpenWorld wants
 * it) or, for NULL, in its own. info and error may be NULL. WF_ERROR_TEXT, and whatever the
 * engine's calls find wrong; *error says it in words. After an error nothing has changed,
 * memory included. */
wfResult wfReadScene(const char *text, size_t length, const wfMemory *memory, wfWorld *out,
                     wfSceneInfo *info, wfTextError *error);
/* The same; limits NULL: the usual ones. WF_ERROR_LIMIT: the text's tree and its world
 * would take more memory together, and have taken none beyond it. */
wfResult wfReadSceneWithin(const char *text, size_t length, const wfLoadLimits *limits,
                           const wfMemory *memory, wfWorld *out, wfSceneInfo *info,
                           wfTextError *error);
/* The text of a world as it stands; info may be NULL. Hooks are functions, and contacts
 * and sleep are the solver's memory: they are not in it. Free *out by wfFreeText.
 * WF_ERROR_NULL, _MEMORY; _TEXT: the info's texts are not UTF-8; those of a bad handle. */
wfResult wfWriteScene(const wfWorld *world, const wfSceneInfo *info, char **out);
/* The JSON Schema of such texts, made from the tables by which they are read. NULL: no
 * memory. */
char *wfWriteSceneSchema(void);
void wfFreeText(char *text);
WF_END_C
#endif
