/* fuzz_world.c: libFuzzer chooses the calls. Eight bytes for the world, then three for each call: which, and its seed. */
#include "abuse.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static Tally counts;
    static Session s;
    uint64_t seed = 0;
    tally = &counts;
    if (size < 8) return 0;
    memcpy(&seed, data, 8);
    begin_session(&s, seed);
    for (size_t at = 8; at + 3 <= size && at < 8 + 3 * 400; at += 3) {
        tally->now = (Call){ data[at] % (uint32_t)operationCount, (uint64_t)(data[at + 1] + 256 * data[at + 2]) * 0x9e3779b97f4a7c15u };
        do_call(&s, tally->now);
    }
    end_session(&s);
    return 0;
}
