// Each allocation by the C++ heap and by the host's allocator in ticks of walkers fails once: the call says so, and all
// goes on as if the fault had not been. Recast and Detour allocate by malloc, which never fails here
// (docs/navigation.md). tests/faults tries fewer of these, and the other calls.
#include <claque/assets.h>

#include <cstdlib>
#include <new>

#include "tests/unit/walk/floors.h"

namespace
{

bool is_armed = false;
uint64_t to_go = 0;  // allocations until one fails; 0: it has failed, or none will

void arm(uint64_t n) { is_armed = true, to_go = n; }

bool disarm()  // whether one has failed
{
    is_armed = false;
    return to_go == 0;
}

bool fails()
{
    if (!is_armed || to_go == 0 || --to_go > 0) return false;
    is_armed = false;
    return true;
}

void *allocate(size_t size)
{
    void *made = fails() ? nullptr : std::malloc(size > 0 ? size : 1);
    if (!made) throw std::bad_alloc();
    return made;
}

void *allocate_for_host(void *, size_t size, size_t alignment)
{
    if (fails()) return nullptr;
    return std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
}

void release_for_host(void *, void *memory, size_t, size_t) { std::free(memory); }

}  // namespace

void *operator new(size_t size) { return allocate(size); }
void *operator new[](size_t size) { return allocate(size); }
void operator delete(void *p) noexcept { std::free(p); }
void operator delete[](void *p) noexcept { std::free(p); }
void operator delete(void *p, size_t) noexcept { std::free(p); }
void operator delete[](void *p, size_t) noexcept { std::free(p); }

namespace
{

using floors::Held;

class WalkFaults : public testing::Test
{
protected:
    WalkFaults()
    {
        clq_context_def def = clq_context_def_init();
        def.allocator = {nullptr, allocate_for_host, release_for_host};
        EXPECT_EQ(clq_context_create(&def, &context_), CLQ_OK);
        EXPECT_EQ(clq_template_builtin(context_, "citizen", &citizen_), CLQ_OK) << clq_last_error();
        clq_locomotion_def walk = clq_locomotion_def_init();
        walk.tmpl = citizen_, walk.walk = clq_template_find_clip(citizen_, "walk");
        EXPECT_EQ(clq_locomotion_create(context_, &walk, &locomotion_), CLQ_OK) << clq_last_error();
        floor_ = floors::two_rooms(true);
        floor_.byway(1, 1, 2, 2, 0);
    }
    ~WalkFaults() override
    {
        clq_locomotion_destroy(locomotion_);
        clq_template_destroy(citizen_);
        EXPECT_EQ(clq_context_destroy(context_), CLQ_OK) << clq_last_error();
    }

    // Four people who walk, after some ticks, so that the next one publishes pieces.
    void enter(const Held &held) const
    {
        for (int i = 0; i < 4; ++i) held.go(held.add(1 + 0.7 * i, 0.8 + 0.5 * i, locomotion_), 14, 1 + i);
        held.step(9);
    }
    // What a run has published, with its places at the end.
    struct Run {
        uint64_t hash = 0, pieces = 0;
        std::vector<uint64_t> tracks;  // by walker and time
    };
    static void note(const Held &held, Run &run)
    {
        const clq_walker_piece *first = nullptr;
        uint32_t count = 0;
        EXPECT_EQ(clq_walkers_get_pieces(held.walkers, &first, &count), CLQ_OK);
        std::vector<std::pair<uint32_t, uint64_t>> all;
        for (uint32_t i = 0; i < count; ++i) {
            clq_track_info info = clq_track_info_init();
            EXPECT_EQ(clq_track_get_info(first[i].track, &info), CLQ_OK);
            all.push_back({first[i].walker.index1, info.hash});
        }
        for (const auto &piece : all) run.tracks.push_back(piece.second);
    }
    void finish(const Held &held, uint64_t ticks, Run &run) const
    {
        clq_walkers_info info = clq_walkers_info_init();
        for (;;) {
            EXPECT_EQ(clq_walkers_get_info(held.walkers, &info), CLQ_OK);
            if (info.ticks >= ticks) break;
            held.step();
            note(held, run);
        }
        run.hash = info.hash, run.pieces = info.pieces;
    }

    clq_context *context_ = nullptr;
    clq_template *citizen_ = nullptr;
    clq_locomotion *locomotion_ = nullptr;
    floors::Floor floor_;
};

TEST_F(WalkFaults, OfTicksAreMadeGoodByTheNextOne)
{
    constexpr uint64_t ticks = 40;
    Run wanted;
    {
        const Held held(floor_);
        enter(held);
        finish(held, ticks, wanted);
        ASSERT_GT(wanted.tracks.size(), 8u);
    }
    uint64_t faults = 0;
    for (bool failed = true; failed;) {
        const Held held(floor_);
        enter(held);
        Run run;
        arm(++faults);
        // Up to the tick in which the allocation comes.
        clq_status status = CLQ_OK;
        for (int i = 0; i < 12 && status == CLQ_OK; ++i) {
            status = clq_walkers_step(held.walkers);
            const bool was_armed = is_armed;
            is_armed = false;
            if (status == CLQ_OK) note(held, run);
            is_armed = was_armed;
        }
        failed = disarm();
        EXPECT_EQ(status, failed ? CLQ_OUT_OF_MEMORY : CLQ_OK) << faults << ": " << clq_last_error();
        finish(held, ticks, run);
        EXPECT_EQ(run.hash, wanted.hash) << faults;
        EXPECT_EQ(run.pieces, wanted.pieces) << faults;
        EXPECT_EQ(run.tracks, wanted.tracks) << faults;
        if (HasFailure()) break;
    }
    EXPECT_GT(faults, 20u);
}

}  // namespace
