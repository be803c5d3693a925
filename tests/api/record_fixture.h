// Recorded runs of a crowd with everything that a crowd can hold, and their records played back.
#pragma once

#include <claque/record.h>

#include <memory>
#include <string>
#include <thread>

#include "tests/api/saved_bytes.h"
#include "tests/api/test_world.h"

namespace records
{

using saved::Bytes;

inline uint64_t number_in(const Bytes &bytes, size_t at, size_t size)
{
    uint64_t out = 0;
    for (size_t i = 0; i < size; ++i) out |= uint64_t(bytes[at + i]) << (8 * i);
    return out;
}

struct Threads {
    uint32_t count = 1;
    static void run(void *user, uint32_t count, void (*task)(void *data, uint32_t index), void *data)
    {
        std::vector<std::thread> threads;
        const uint32_t n = static_cast<Threads *>(user)->count;
        for (uint32_t k = 0; k < n; ++k)
            threads.emplace_back([=] {
                for (uint32_t i = k; i < count; i += n) task(data, i);
            });
        for (std::thread &thread : threads) thread.join();
    }
};

inline int keep(void *user, const void *bytes, size_t size)
{
    const uint8_t *first = static_cast<const uint8_t *>(bytes);
    static_cast<Bytes *>(user)->insert(static_cast<Bytes *>(user)->end(), first, first + size);
    return 0;
}

inline clq_recording_def recording_to(Bytes &out, uint64_t key_bytes = 65536)
{
    clq_recording_def def = clq_recording_def_init();
    def.write = keep, def.user = &out, def.key_bytes = key_bytes;
    return def;
}

// What a crowd showed and was at each update.
struct Shown {
    std::vector<double> times;
    std::vector<uint64_t> lists, crowds;
};
inline bool operator==(const Shown &a, const Shown &b)
{
    return a.times == b.times && a.lists == b.lists && a.crowds == b.crowds;
}

struct Recording {
    Bytes bytes;
    Shown shown;
    uint64_t last_hash = 0;  // of the crowd at the end
    clq_recording_info info = clq_recording_info_init();
};

// A run of `steps` updates with changes before each, some of them none; also a state that is saved and restored.
Recording run(TestWorld &world, uint32_t steps, uint64_t seed, uint64_t key_bytes = 3000);

// A record opened in a world and ready to be played, and a crowd for it.
class Player
{
public:
    using Opening = clq_status (*)(clq_context *, const void *bytes, size_t size_bytes, clq_record **out);
    Player(TestWorld &world, const Bytes &bytes, Opening opening = clq_record_load);
    ~Player();
    Player(const Player &) = delete;
    Player &operator=(const Player &) = delete;

    bool opened() const { return record != nullptr; }
    clq_record_info info() const;
    void show(uint64_t step, Shown &out);  // plays to the step and updates

    clq_record *record = nullptr;
    clq_crowd *crowd = nullptr;
    clq_view *view = nullptr;

private:
    TestWorld &world_;
};

}  // namespace records
