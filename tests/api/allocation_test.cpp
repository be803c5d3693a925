// An allocation that fails gives a status and leaves everything as it was: every n for small calls, a stride for large
// ones.
#include "tests/api/allocation.h"

#include "tests/support/collected_file.h"
#include "tests/support/written_characters.h"

using namespace allocation;

namespace
{

struct LoadedFile {
    const char *name;
    uint64_t stride;
};

}  // namespace

TEST(ContextAllocation, AContextThatFindsNoMemoryIsNotMade)
{
    clq_context_def def = clq_context_def_init();
    def.allocator = fm::allocator;
    clq_context *out = nullptr;
    fail_each(
        "clq_context_create", fm::Reach::everything, 1,
        [&] {
            out = nullptr;
            const clq_status status = clq_context_create(&def, &out);
            if (status == CLQ_OK) clq_context_destroy(out);
            return status;
        },
        [&] { ASSERT_EQ(out, nullptr) << "out is written only on success"; });
}

TEST_F(Allocation, BuildingATemplateFailsCleanlyAtEveryAllocation)
{
    make_crowd(20);
    ASSERT_EQ(clq_crowd_update(crowd_, 0.5, &view_, 1), CLQ_OK);
    const Seen before = seen();
    clq_template *out = nullptr;
    fail_each(
        "clq_template_build", fm::Reach::everything, 1,
        [&] {
            out = nullptr;
            const clq_status status = clq_template_build(context_, &small_.def, &out);
            if (status == CLQ_OK) clq_template_destroy(out);
            return status;
        },
        [&] {
            ASSERT_EQ(out, nullptr) << "out is written only on success";
            ASSERT_TRUE(seen() == before) << "another template's crowd has changed";
        });
}

TEST_F(Allocation, CreatingActorsFailsCleanlyAtEveryAllocation)
{
    make_crowd(0);
    // Enough actors that every column has to grow at least twice on the way.
    for (int i = 0; i < 100; ++i) {
        const uint64_t before = clq_crowd_get_hash(crowd_);
        const uint32_t count = clq_crowd_get_actor_count(crowd_);
        uint64_t n = 1;
        for (;; ++n) {
            clq_actor_def def = clq_actor_def_init();
            def.tmpl = tmpl_;
            clq_actor actor = {0, 0};
            fm::arm(n, fm::Reach::everything);
            const clq_status status = clq_actor_create(crowd_, &def, &actor);
            if (fm::disarm() < n) {
                ASSERT_EQ(status, CLQ_OK);
                break;
            }
            ASSERT_EQ(status, CLQ_OUT_OF_MEMORY);
            ASSERT_EQ(actor.index1, 0u) << "out is written only on success";
            ASSERT_EQ(clq_crowd_get_hash(crowd_), before);
            ASSERT_EQ(clq_crowd_get_actor_count(crowd_), count);
        }
    }
}

TEST_F(Allocation, AnActorThatIsNotMadeHoldsNoTemplate)
{
    make_crowd(0);
    clq_actor_def def = clq_actor_def_init();
    uint64_t n = 1;
    for (;; ++n) {
        const int64_t without = fm::host_bytes();
        clq_template *other = nullptr;
        ASSERT_EQ(clq_template_build(context_, &small_.def, &other), CLQ_OK);
        const int64_t bytes = fm::host_bytes() - without;
        def.tmpl = other;
        clq_actor actor;
        fm::arm(n, fm::Reach::everything);
        const clq_status status = clq_actor_create(crowd_, &def, &actor);
        const uint64_t seen = fm::disarm();
        clq_template_destroy(other);
        if (seen < n) break;
        ASSERT_EQ(status, CLQ_OUT_OF_MEMORY) << n;
        EXPECT_LT(fm::host_bytes() - without, bytes) << "only what the crowd has reserved may stay, allocation " << n;
    }
    EXPECT_GT(n, 3u);
}

TEST_F(Allocation, AnUpdateFailsCleanlyAtEveryAllocationAndTheNextOneIsTheSame)
{
    make_crowd(60);
    const uint64_t crowd_before = clq_crowd_get_hash(crowd_);
    ASSERT_EQ(clq_crowd_update(crowd_, 0.1, &view_, 1), CLQ_OK) << clq_last_error();
    const uint64_t first = clq_view_get_hash(view_);
    ASSERT_EQ(crowd_before, clq_crowd_get_hash(crowd_)) << "an update changes nothing that the host has set";

    for (int i = 60; i < 200; ++i) ASSERT_EQ(add_actor(i), CLQ_OK);  // so that the update must make room
    ASSERT_EQ(first, clq_view_get_hash(view_));
    fail_each(
        "clq_crowd_update", fm::Reach::everything, 1, [&] { return clq_crowd_update(crowd_, 0.3, &view_, 1); },
        [&] { ASSERT_EQ(clq_view_get_hash(view_), first) << "a failed update leaves the list as it was"; },
        Memory::may_be_kept);
    const uint64_t after = clq_view_get_hash(view_);

    clq_crowd *fresh = nullptr;
    std::swap(crowd_, fresh);
    clq_template *old = tmpl_;
    make_crowd(200);
    ASSERT_EQ(clq_crowd_update(crowd_, 0.3, &view_, 1), CLQ_OK);
    EXPECT_EQ(clq_view_get_hash(view_), after) << "failures on the way changed what is shown";
    clq_crowd_destroy(fresh);
    clq_template_destroy(old);
}

TEST_F(Allocation, FramesThatSetTransformsAndUpdateAllocateNothing)
{
    make_crowd(100);
    const std::vector<clq_actor> actors(1, first_);
    const std::vector<clq_transform> places(1, clq_transform{{0, 0, 0}, {0, 0, 0, 1}, 1});
    const auto frame = [&](int number) {
        return clq_crowd_set_transforms(crowd_, actors.data(), places.data(), 1) == CLQ_OK &&
               clq_crowd_update(crowd_, 0.02 * number, &view_, 1) == CLQ_OK;
    };
    for (int number = 0; number < 3; ++number) ASSERT_TRUE(frame(number)) << clq_last_error();
    fm::arm(0, fm::Reach::everything);
    bool good = true;
    for (int number = 3; number < 30; ++number) good = frame(number) && good;
    EXPECT_EQ(fm::disarm(), 0u);
    EXPECT_TRUE(good);
}

TEST_F(Allocation, LoadingTheSmallestAssetFailsCleanlyAtEveryAllocationAndALargerOneAtAStride)
{
    make_crowd(20);
    ASSERT_EQ(clq_crowd_update(crowd_, 0.5, &view_, 1), CLQ_OK);
    for (const LoadedFile &file : {LoadedFile{"conformance/khronos/SimpleMorph-Embedded/SimpleMorph.gltf", 1},
                                   {"conformance/khronos/SimpleSkin-external/SimpleSkin.gltf", 7},
                                   {"humanoids/khronos/RiggedFigure.glb", 1009},
                                   {"humanoids/quaternius-ultimate/Casual_Male.gltf", 30011}}) {
        const std::string path = written::path_of(file.name, CLAQUE_ASSETS_DIR);
        CLAQUE_NEEDS_FILE(path);
        fail_each_load(path, file.stride);
    }
}

TEST_F(Allocation, LoadingWrittenCharactersFailsCleanlyAtAStride)
{
    make_crowd(20);
    ASSERT_EQ(clq_crowd_update(crowd_, 0.5, &view_, 1), CLQ_OK);
    for (const LoadedFile &file : {LoadedFile{"WrittenMorph.gltf", 61},
                                   {"WrittenOdd.gltf", 67},
                                   {"WrittenSparse.gltf", 401},
                                   {"WrittenQuantised.glb", 397}})
        fail_each_load(written::path_of(file.name, ""), file.stride);
}
