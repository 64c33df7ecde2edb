/* What the reader of scenes must keep, whatever the bytes are: it never dies, it refuses with a reason and a result that is an error,
 * or it makes a world that can be stepped; the text of that world is read again, to the same bits, and is its own text then. The
 * translator of R.U.B.E. scenes makes texts that are JSON. Run by tests/json/fuzz.sh. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "weft/json.h"
#include "../../tools/rube/rube.c"

#define MUST(x) ((x) ? (void)0 : (fprintf(stderr, "broken promise: %s, line %d\n", #x, __LINE__), abort()))

static void read_it(const char *text, size_t size)
{
    wfWorld world, again;
    wfTextError e;
    wfSceneInfo info;
    wfResult result = wfReadScene(text, size, NULL, &world, &info, &e);
    MUST(result == e.result);
    if (result != WF_OK) {
        MUST(e.what[0] != 0 && memchr(e.what, 0, sizeof e.what) && memchr(e.where, 0, sizeof e.where));
        return;
    }
    char *one = NULL, *two = NULL;
    result = wfWriteScene(&world, &info, &one);
    if (result == WF_ERROR_MEMORY) {
        wfDestroyWorld(&world);
        return;
    }
    MUST(result == WF_OK);
    result = wfReadScene(one, strlen(one), NULL, &again, &info, &e);
    if (result != WF_OK) fprintf(stderr, "%s, line %d: %s\n%s\n", e.where, (int)e.line, e.what, one);
    MUST(result == WF_OK);
    MUST(wfHashWorld(&world) == wfHashWorld(&again));
    MUST(wfWriteScene(&again, &info, &two) == WF_OK);
    if (strcmp(one, two) != 0) fprintf(stderr, "%s\n----\n%s\n", one, two);
    MUST(strcmp(one, two) == 0);
    for (int i = 0; i < 3; i++) wfStepWorld(&world);      /* may fail by an error value, not by dying */
    wfFreeText(one), wfFreeText(two);
    wfDestroyWorld(&world), wfDestroyWorld(&again);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char *out = NULL;
    read_it((const char *)data, size);
    if (wfTranslateRube((const char *)data, size, &out, NULL) == WF_OK) {
        MUST(out != NULL);
        read_it(out, strlen(out));
        wfFreeText(out);
    }
    return 0;
}
