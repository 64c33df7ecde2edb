/* own_malloc.h: malloc and its like are the test's own: the linker finds these first, for the engine as for the C library. They
 * count, and fail on demand. Under the address sanitizer, which needs its own, OWN_MALLOC is 0 and the tests skip. */
#ifndef WEFT_OWN_MALLOC_H
#define WEFT_OWN_MALLOC_H
#ifdef __has_feature
#if __has_feature(address_sanitizer)
#define OWN_MALLOC 0
#endif
#endif
#if defined __SANITIZE_ADDRESS__ && !defined OWN_MALLOC
#define OWN_MALLOC 0
#endif
#ifndef OWN_MALLOC
#define OWN_MALLOC 1
#endif

static size_t calls, live, fail_at;             /* failAt: the call that fails, from 1; 0: none */
#if OWN_MALLOC
static _Alignas(16) unsigned char store[1000u << 20];
static size_t stored;

static void *take(size_t size)
{
    calls++;
    if (fail_at != 0 && calls == fail_at) return NULL;
    size_t need = (size + 15) / 16 * 16 + 16;
    if (need > sizeof store - stored) return NULL;
    unsigned char *p = store + stored;
    memcpy(p, &size, sizeof size);
    stored += need;
    live++;
    return p + 16;
}

void *malloc(size_t size) { return take(size); }
void free(void *p) { if (p != NULL) live--; }
void *calloc(size_t n, size_t size)
{
    void *p = size != 0 && n > SIZE_MAX / size ? NULL : take(n * size);
    if (p != NULL) memset(p, 0, n * size);
    return p;
}
void *realloc(void *old, size_t size)
{
    void *p = take(size);
    size_t was = 0;
    if (p == NULL || old == NULL) return p;
    memcpy(&was, (unsigned char *)old - 16, sizeof was);
    memcpy(p, old, was < size ? was : size);
    free(old);
    return p;
}
#endif
#endif
