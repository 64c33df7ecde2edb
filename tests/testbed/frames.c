/* Stands before SDL in a program with a window (LD_PRELOAD): the window doesn't sleep, and at its end it tells how long its last frames took, from one picture
 * on the screen to the next: their median and the slowest, in milliseconds. For frames.sh. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { LAST = 120, MOST = 1000 };
static double shown[MOST];
static int count;

void SDL_Delay(uint32_t ms);
void SDL_RenderPresent(void *renderer);

void SDL_Delay(uint32_t ms) { (void)ms; }

void SDL_RenderPresent(void *renderer)
{
    static void (*present)(void *);
    if (!present) *(void **)&present = dlsym(RTLD_NEXT, "SDL_RenderPresent");
    present(renderer);
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    if (count < MOST) shown[count++] = 1e3 * (double)t.tv_sec + 1e-6 * (double)t.tv_nsec;
}

static int less(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return x < y ? -1 : x > y;
}

__attribute__((destructor)) static void tell(void)
{
    double ms[LAST];
    if (count <= LAST) return;
    for (int i = 0; i < LAST; i++) ms[i] = shown[count - LAST + i] - shown[count - LAST + i - 1];
    qsort(ms, LAST, sizeof *ms, less);
    printf("%.2f,%.2f\n", ms[LAST / 2], ms[LAST - 1]);
}
