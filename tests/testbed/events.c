/* Stands before SDL in a program with a window (LD_PRELOAD): pushes what no tool can do on a virtual screen, as events of SDL. New lines of the file that
 * WEFT_EVENTS names are read: `down ID X Y', `move ID X Y', `up ID X Y' (a finger; parts of the window's size), `drop PATH'. For xvfb.sh. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <SDL.h>

static void push_lines(void)
{
    static long at;
    const char *path = getenv("WEFT_EVENTS");
    FILE *file = path ? fopen(path, "r") : NULL;
    char line[1000], what[9];
    long id;
    float x, y;
    if (!file) return;
    fseek(file, at, SEEK_SET);
    while (fgets(line, sizeof line, file) && strchr(line, '\n')) {
        SDL_Event e;
        memset(&e, 0, sizeof e);
        at = ftell(file);
        if (sscanf(line, "%8s %ld %f %f", what, &id, &x, &y) == 4) {
            e.type = *what == 'd' ? SDL_FINGERDOWN : *what == 'u' ? SDL_FINGERUP : SDL_FINGERMOTION;
            e.tfinger.touchId = 1, e.tfinger.fingerId = id, e.tfinger.x = x, e.tfinger.y = y;
        } else {
            line[strcspn(line, "\n")] = 0;
            e.type = SDL_DROPFILE;
            e.drop.file = SDL_strdup(line + strlen("drop "));
        }
        SDL_PushEvent(&e);
    }
    fclose(file);
}

int SDL_PollEvent(SDL_Event *e)
{
    static int (*poll)(SDL_Event *);
    if (!poll) *(void **)&poll = dlsym(RTLD_NEXT, "SDL_PollEvent");
    push_lines();
    return poll(e);
}

int SDL_WaitEventTimeout(SDL_Event *e, int ms)
{
    static int (*wait)(SDL_Event *, int);
    if (!wait) *(void **)&wait = dlsym(RTLD_NEXT, "SDL_WaitEventTimeout");
    push_lines();
    return wait(e, ms);
}
