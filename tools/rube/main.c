/* weft-rube: translates a scene of R.U.B.E. into one of Weft.
 *     weft-rube SCENE.json > MINE.json
 * 1: it can't be read or translated; standard error says why, and where. MIT licence. */
#include <stdio.h>
#include <stdlib.h>
#include "rube.h"

static char *whole_file(const char *path, size_t *length)
{
    FILE *file = fopen(path, "rb");
    long size = file && fseek(file, 0, SEEK_END) == 0 ? ftell(file) : -1;
    char *text = size >= 0 ? malloc((size_t)size + 1) : NULL;
    *length = (size_t)size;
    bool read = text && fseek(file, 0, SEEK_SET) == 0 && fread(text, 1, *length, file) == *length;
    if (file) fclose(file);
    if (read) return text;
    free(text);
    return NULL;
}

int main(int count, char **word)
{
    if (count != 2) return fprintf(stderr, "weft-rube SCENE.json: translates a scene of R.U.B.E. to standard output\n"), 2;
    size_t length;
    wfTextError e;
    char *text = whole_file(word[1], &length), *out = NULL;
    if (text == NULL) return fprintf(stderr, "weft-rube: %s can't be read\n", word[1]), 1;
    wfResult result = wfTranslateRube(text, length, &out, &e);
    if (result == WF_OK) puts(out);
    else fprintf(stderr, "%s:%d: %s%s%s\n", word[1], (int)e.line, e.where, e.where[0] ? ": " : "", e.what);
    bool written = fflush(stdout) == 0;
    wfFreeText(out);
    free(text);
    return result != WF_OK || !written;
}
