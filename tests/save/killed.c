/* killed.c: saves a world that changes, again and again, until somebody kills it; reads it; or sees what became of a file.
 *   killed save PATH BODIES [SAVES]   never ends by itself without SAVES; after each save that succeeded, prints the world's steps to stderr
 *   killed read PATH LOADS            loads it so many times; prints how many of them were refused, and the first reason
 *   killed check PATH                 0: a world that keeps its rules; its steps are printed
 *   killed traps DIRECTORY            what stands at the path or beside it: links, pipes, permissions, errno (POSIX only) */
#define _XOPEN_SOURCE 700
#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "weft/weft.h"

static bool make(wfWorld *world, int bodies)
{
    wfWorldDef def = wfDefaultWorldDef();
    def.bodyCapacity = bodies + 1;
    def.shapeCapacity = bodies + 1;
    if (wfCreateWorld(&def, world) != WF_OK) return false;
    wfBodyDef d = wfDefaultBodyDef();
    d.type = WF_STATIC;
    wfMakeBox(50, 1, &d.shape);
    wfAddBodyToWorld(world, &d, NULL);
    d.type = WF_DYNAMIC;
    wfMakeBox(WF_R(0.4), WF_R(0.4), &d.shape);
    for (int i = 0; i < bodies; i++) {
        d.position = wfV2((wfReal)(i % 20), (wfReal)(2 + i / 20));
        if (wfAddBodyToWorld(world, &d, NULL) != WF_OK) return false;
    }
    return true;
}

static int save(const char *path, int bodies, long saves)
{
    wfWorld world;
    if (!make(&world, bodies)) return 1;
    for (long i = 0; saves == 0 || i < saves; i++) {
        if (wfStepWorld(&world) != WF_OK) return 1;
        wfResult result = wfSaveToFile(&world, path);
        if (result != WF_OK) {
            fprintf(stderr, "killed: %s\n", wfResultText(result));
            return 1;
        }
        fprintf(stderr, "%llu\n", (unsigned long long)wfWorldSteps(&world));
    }
    return 0;
}

static int read_often(const char *path, long loads)
{
    long refused = 0;
    for (long i = 0; i < loads; i++) {
        wfWorld world;
        wfResult result = wfLoadFromFile(path, &world);
        if (result == WF_OK) wfDestroyWorld(&world);
        else if (refused++ == 0) printf("load %ld: %s\n", i, wfResultText(result));
    }
    printf("%ld loads, %ld refused\n", loads, refused);
    return refused > 0;
}

static int check(const char *path)
{
    wfWorld world;
    wfResult result = wfLoadFromFile(path, &world);
    if (result != WF_OK) {
        printf("%s: %s\n", path, wfResultText(result));
        return 1;
    }
    result = wfCheckWorld(&world, NULL);
    printf("%llu\n", (unsigned long long)wfWorldSteps(&world));
    wfDestroyWorld(&world);
    return result != WF_OK;
}

#ifdef _WIN32
static int traps(const char *directory) { return (void)directory, 77; }
#else
#include <sys/stat.h>
#include <unistd.h>

static int failures;

static void must(bool good, const char *what)
{
    if (good) return;
    printf("traps: %s\n", what);
    failures++;
}

static void write_text(const char *path, const char *text)
{
    FILE *f = fopen(path, "wb");
    if (f == NULL || fputs(text, f) < 0 || fclose(f) != 0) exit(2);
}

static bool holds(const char *path, const char *text)
{
    char got[100] = "";
    FILE *f = fopen(path, "rb");
    size_t n = f != NULL ? fread(got, 1, sizeof got - 1, f) : 0;
    if (f != NULL) fclose(f);
    return n == strlen(text) && memcmp(got, text, n) == 0;
}

static mode_t mode_of(const char *path)
{
    struct stat s;
    return lstat(path, &s) == 0 ? s.st_mode : 0;
}

/* wfReplaceFile, wfSaveToFile and wfSaveJournalToFile share what they do to files; loading has three doors as well. */
static wfResult save_as(int how, const wfWorld *world, const wfJournal *journal, const char *path)
{
    return how == 0 ? wfSaveToFile(world, path) : how == 1 ? wfSaveJournalToFile(journal, path) : wfReplaceFile(path, "text", 4);
}

static wfResult load_as(int how, const char *path)
{
    static uint8_t room[1000];
    wfJournal journal;
    wfWorld world;
    wfResult result = how == 1 ? wfLoadJournalFromFile(path, room, sizeof room, &journal) : wfLoadFromFile(path, &world);
    if (how != 1 && result == WF_OK) wfDestroyWorld(&world);
    return result;
}

static int traps(const char *directory)
{
    static uint8_t notes[100];
    wfWorld world;
    wfJournal journal;
    if (chdir(directory) != 0 || !make(&world, 5) || wfJournalInit(&journal, notes, sizeof notes, 0) != WF_OK) return 2;
    for (int how = 0; how < 3; how++) {
        umask(022);
        write_text("victim", "precious"), write_text("own.new", "mine");
        must(symlink("victim", "own") == 0 && save_as(how, &world, &journal, "own") == WF_OK, "a link at the path is no obstacle");
        must(holds("victim", "precious") && S_ISREG(mode_of("own")), "a link at the path is replaced, not followed");
        must(holds("own.new", "mine"), "a file beside it is left alone");
        must(mode_of("own") == (S_IFREG | 0644), "a link's target gives its permissions");
        must(save_as(how, &world, &journal, "new") == WF_OK && mode_of("new") == (S_IFREG | 0644), "a new file keeps to the umask");
        must(symlink("nothing", "dangling") == 0 && save_as(how, &world, &journal, "dangling") == WF_OK && S_ISREG(mode_of("dangling")), "a dangling link is replaced");
        umask(077);
        static const mode_t modes[] = { 0600, 0664, 0444, 0755 };
        for (int i = 0; i < 4; i++) {
            must(chmod("new", modes[i]) == 0 && save_as(how, &world, &journal, "new") == WF_OK, "saving over a file of any permissions");
            must(mode_of("new") == (S_IFREG | modes[i]), "permissions are kept");
        }
        must(mkdir("folder", 0755) == 0 && mkfifo("pipe", 0644) == 0 && symlink("/dev/null", "device") == 0, "a folder, a pipe and a link to a device can be made");
        static const struct { const char *path; int why; } bad[] = { { "folder", EISDIR }, { "pipe", EINVAL }, { "device", EINVAL }, { "none/x", ENOENT }, { "new/x", ENOTDIR } };
        for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
            mode_t before = mode_of(bad[i].path);
            errno = 0;
            must(save_as(how, &world, &journal, bad[i].path) == WF_ERROR_FILE && errno == bad[i].why, "what is no regular file is not replaced, and errno says why");
            must(mode_of(bad[i].path) == before, "and it stays what it is");
            errno = 0;
            must(load_as(how, bad[i].path) == WF_ERROR_FILE && errno == bad[i].why, "nor loaded, and nobody waits for a pipe");
        }
        if (geteuid() != 0) {
            must(mkdir("locked", 0555) == 0 && save_as(how, &world, &journal, "locked/x") == WF_ERROR_FILE && errno == EACCES, "errno says what the system refused");
            rmdir("locked");
        }
        char name[300];
        memset(name, 'n', sizeof name), name[255] = 0;
        must(save_as(how, &world, &journal, name) == WF_OK, "a name may be as long as the system allows");
        must(save_as(how, &world, &journal, "./new") == WF_OK && save_as(how, &world, &journal, "folder/../new") == WF_OK, "paths with folders");
        must(load_as(how, "new") == (how == 2 ? WF_ERROR_NOT_A_SAVE : WF_OK), "what was saved loads");
        must(unlink("own") == 0 && unlink("own.new") == 0 && unlink("new") == 0 && unlink("dangling") == 0 && unlink("victim") == 0 && unlink(name) == 0
             && unlink("pipe") == 0 && unlink("device") == 0 && rmdir("folder") == 0, "each is there, once");
    }
    must(chdir("..") == 0 && rmdir(directory) == 0, "and nothing else is left behind");
    wfDestroyWorld(&world);
    return failures != 0;
}
#endif

int main(int argc, char **argv)
{
    if (argc >= 4 && strcmp(argv[1], "save") == 0) return save(argv[2], atoi(argv[3]), argc > 4 ? atol(argv[4]) : 0);
    if (argc == 4 && strcmp(argv[1], "read") == 0) return read_often(argv[2], atol(argv[3]));
    if (argc == 3 && strcmp(argv[1], "check") == 0) return check(argv[2]);
    if (argc == 3 && strcmp(argv[1], "traps") == 0) return traps(argv[2]);
    fprintf(stderr, "killed: save PATH BODIES [SAVES], read PATH LOADS, check PATH, or traps DIRECTORY\n");
    return 2;
}
