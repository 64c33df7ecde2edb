/* Weft: testbed/web_files_main.c, tangled from chapters/testbed/05-scenes.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
/* Scenes that are files, in a page: the script brings their worlds. */
#include <stddef.h>
#include "testbed/scene.h"
#include "weft/json.h"
#include "weft/save.h"

#define EXPORT(name) __attribute__((export_name(name)))
static wfResult open_brought(const wfScene *scene, const wfMemory *memory, wfWorld *out);
#define FILE_SCENE(file) { .category = "Files", .name = file, .text = "a scene in a file", \
    .chapter = "save-and-replay", .open = open_brought, .viewY = 2, .viewHeight = 10 },
static wfScene file_scenes[] = {
#include "gen/files.h"
    { .name = NULL } };
enum { FILES = sizeof file_scenes / sizeof *file_scenes - 1, FILE_ROOM = 1 << 18 };
static struct { size_t size; wfSceneInfo info; uint8_t bytes[FILE_ROOM]; } saves[FILES + 1];
static ptrdiff_t wanted = FILES;        /* the scene whose world should come; FILES: none */

static wfResult open_brought(const wfScene *scene, const wfMemory *memory, wfWorld *out)
{
    ptrdiff_t i = scene - file_scenes;
    if (saves[i].size) return wfLoadFromBytes(saves[i].bytes, saves[i].size, memory, out);
    wanted = i;
    return WF_ERROR_TEXT;
}

/* Puts them behind the table. */
EXPORT("web_bring") void web_bring(void)
{
    static const wfSceneGroup files = { file_scenes, FILES };
    wfBroughtScenes = &files;
}

/* The name of the wanted scene, or NULL; where its save goes, and its record. */
EXPORT("web_wanted") const char *web_wanted(void) { return file_scenes[wanted].name; }
EXPORT("web_came_bytes") uint8_t *web_came_bytes(void) { return saves[wanted].bytes; }
EXPORT("web_came_room") size_t web_came_room(void) { return FILE_ROOM; }
EXPORT("web_came_info") wfSceneInfo *web_came_info(void) { return &saves[wanted].info; }

/* They are there, so many bytes; the script opens the scene anew. 0: it can't be had. */
EXPORT("web_came") void web_came(size_t size)
{
    wfScene *row = &file_scenes[wanted];
    const wfSceneInfo *info = &saves[wanted].info;
    saves[wanted].size = size;
    wanted = FILES;
    if (!size) return;
    row->text = info->text;
    if (info->viewHeight > 0) {
        row->viewX = info->viewX;
        row->viewY = info->viewY;
        row->viewHeight = info->viewHeight;
    }
}
