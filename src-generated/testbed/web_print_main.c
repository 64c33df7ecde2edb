/* Weft: testbed/web_print_main.c, tangled from chapters/testbed/01-platform.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
/* What a library would do for the page's module: snprintf, by stb_sprintf, and memory for
 * the header that compresses pictures. */
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#define STB_SPRINTF_IMPLEMENTATION
#define STB_SPRINTF_STATIC
#include <stb_sprintf.h>

static size_t lent_base, lent_end, lent_count;

int web_vsnprintf(char *text, size_t size, const char *format, va_list list);
int web_snprintf(char *text, size_t size, const char *format, ...);

int web_vsnprintf(char *text, size_t size, const char *format, va_list list)
{
    return stbsp_vsnprintf(text, (int)size, format, list);
}

int web_snprintf(char *text, size_t size, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    int length = stbsp_vsnprintf(text, (int)size, format, list);
    va_end(list);
    return length;
}

void *web_lend(size_t size);
void *web_lend_more(void *old, size_t had, size_t size);
void web_take_back(void *lent);

void *web_lend(size_t size)
{
    enum { PAGE = 65536 };
    size_t end = __builtin_wasm_memory_size(0) * PAGE;
    if (!lent_base) lent_base = lent_end = end;
    size_t at = lent_end, want = at + (size + 15) / 16 * 16;
    if (want < at) return NULL;
    if (want > end && __builtin_wasm_memory_grow(0, (want - end + PAGE - 1) / PAGE) ==
        (size_t)-1) return NULL;
    lent_end = want;
    lent_count++;
    return (void *)(uintptr_t)at;
}

void web_take_back(void *lent)
{
    if (lent && --lent_count == 0) lent_end = lent_base;
}

void *web_lend_more(void *old, size_t had, size_t size)
{
    void *lent = web_lend(size);
    if (lent && old) memcpy(lent, old, had < size ? had : size);
    if (lent) web_take_back(old);
    return lent;
}
