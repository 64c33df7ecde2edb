/* Weft: testbed/web_files_main.c, tangled from chapters/testbed/05-scenes.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
/* Scenes that are files, in a page: the script brings their worlds. */
#include <stddef.h>
#include <string.h>
#include "testbed/scene_file.h"
#include "weft/save.h"

#define EXPORT(name) __attribute__((export_name(name)))
static wfResult open_brought(const wfScene *scene, const wfMemory *memory, wfWorld *out);
#define FILE_SCENE(file) { .category = "Files", .name = file, .text = "a scene in a file", \
    .chapter = "save-and-replay", .open = open_brought, .viewY = 2, .viewHeight = 10 },
enum { GUESTS = 6 };                    /* files that the reader has brought, at most */
static char guest[GUESTS][40];          /* their names */
static wfScene file_scenes[] = {
#include "gen/files.h"
    FILE_SCENE(guest[0]) FILE_SCENE(guest[1]) FILE_SCENE(guest[2]) FILE_SCENE(guest[3])
    FILE_SCENE(guest[4]) FILE_SCENE(guest[5]) { .name = NULL } };
enum { FILES = sizeof file_scenes / sizeof *file_scenes - 1, GUEST = FILES - GUESTS,
       FILE_ROOM = 1 << 18 };
static struct { size_t size; wfSceneInfo info; uint8_t bytes[FILE_ROOM]; } saves[FILES + 1];
static ptrdiff_t wanted = FILES;        /* the scene whose world should come; FILES: none */

static wfResult open_brought(const wfScene *scene, const wfMemory *memory, wfWorld *out)
{
    ptrdiff_t i = scene - file_scenes;
    if (saves[i].size) return wfLoadFromBytes(saves[i].bytes, saves[i].size, memory, out);
    wanted = i;
    return WF_ERROR_TEXT;
}

/* What the script has the text made of: the record, and behind it the saved world. */
static wfResult write_elsewhere(const wfWorld *world, const wfSceneInfo *info, char *out,
                                size_t capacity, size_t *size)
{
    if (capacity < sizeof *info) return WF_ERROR_MEMORY;
    memcpy(out, info, sizeof *info);
    wfResult result = wfSaveToBytes(world, out + sizeof *info, capacity - sizeof *info,
                                    size);
    *size += sizeof *info;
    return result;
}

static wfSceneGroup files = { file_scenes, GUEST };

/* Puts them behind the table. */
EXPORT("web_bring") void web_bring(void)
{
    wfBroughtScenes = &files;
    wfWriteSceneElsewhere = write_elsewhere;
}

/* The reader's own file is what is wanted now: it gets the next place, or the last. */
EXPORT("web_guest") void web_guest(void)
{
    wanted = (ptrdiff_t)files.count < FILES ? (ptrdiff_t)files.count : FILES - 1;
}

/* One that has the name of an earlier one takes its place. Returns which has it. */
static ptrdiff_t place_guest(ptrdiff_t i)
{
    for (ptrdiff_t k = GUEST; k < i; k++)
        if (strcmp(saves[k].info.name, saves[i].info.name) == 0) {
            memcpy(&saves[k], &saves[i], sizeof saves[i]);
            return k;
        }
    const char *name = saves[i].info.name;
    char *out = guest[i - GUEST];
    size_t n = strlen(name);
    files.count = (size_t)i;
    if (n + 8 > sizeof guest[0]) n = sizeof guest[0] - 8;
    memcpy(out, n ? name : "a file", n ? n + 1 : 7);
    out[n ? n : 6] = 0;
    if (wfFindScene(out) >= 0) memcpy(out + n, " (file)", 8);
    files.count = (size_t)i + 1;
    return i;
}

/* The name of the wanted scene, or NULL; where its save goes, and its record. */
EXPORT("web_wanted") const char *web_wanted(void) { return file_scenes[wanted].name; }
EXPORT("web_came_bytes") uint8_t *web_came_bytes(void) { return saves[wanted].bytes; }
EXPORT("web_came_room") size_t web_came_room(void) { return FILE_ROOM; }
EXPORT("web_came_info") wfSceneInfo *web_came_info(void) { return &saves[wanted].info; }

/* They are there, so many bytes; the script opens the scene of this name anew. 0: it can't
 * be had. */
EXPORT("web_came") const char *web_came(size_t size)
{
    saves[wanted].size = size;
    if (size && wanted >= GUEST) wanted = place_guest(wanted);
    wfScene *row = &file_scenes[wanted];
    const wfSceneInfo *info = &saves[wanted].info;
    wanted = FILES;
    if (!size) return NULL;
    row->text = info->text;
    if (info->viewHeight > 0) {
        row->viewX = info->viewX;
        row->viewY = info->viewY;
        row->viewHeight = info->viewHeight;
    }
    return row->name;
}
