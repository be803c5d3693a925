// Colours of a shown crowd change for all actors or for none, and depend on seeds alone.
#include <cstdlib>
#include <thread>

#include "tests/api/calls.h"
#include "tests/api/colour_fixture.h"

namespace colours
{
namespace
{

class ColouredCrowd : public Colours
{
protected:
    void SetUp() override
    {
        Colours::SetUp();
        ASSERT_EQ(clq_crowd_create(context_, nullptr, &crowd_), CLQ_OK);
        ASSERT_EQ(clq_view_create(crowd_, &view_), CLQ_OK);
        clq_camera camera;
        const double eye[3] = {0, 1, 6}, target[3] = {0, 1, 0};
        const float up[3] = {0, 1, 0};
        ASSERT_EQ(api_test::look_at(&camera, eye, target, up, 0.8f, 1.33f, 0.1f, 100), CLQ_OK);
        ASSERT_EQ(clq_view_set_camera(view_, &camera), CLQ_OK);
        for (int i = 0; i < 60; ++i) {
            clq_actor_def def = clq_actor_def_init();
            def.tmpl = tmpl_;
            def.transform.position[0] = (i % 10 - 5) * 0.3;
            def.transform.position[2] = -(i / 10);
            def.seed = uint64_t(i);
            clq_actor actor;
            ASSERT_EQ(clq_actor_create(crowd_, &def, &actor), CLQ_OK);
            actors_.push_back(actor);
        }
        make({zone("zero", wide_, CLQ_COLOUR_SPACE_OKLAB), zone("one", wide_), linked_to("two", "zero", 0.2f)});
    }
    void TearDown() override
    {
        clq_crowd_destroy(crowd_);
        Colours::TearDown();
    }
    clq_status colour(const std::vector<clq_actor> &person)
    {
        return clq_crowd_randomise_colours(crowd_, map_, 0, person.data(), uint32_t(person.size()));
    }
    std::vector<float> colours() const
    {
        std::vector<float> all;
        for (const clq_actor actor : actors_) {
            float rgb[3 * zone_count];
            EXPECT_EQ(clq_actor_get_colours(crowd_, actor, rgb, zone_count), CLQ_OK) << clq_last_error();
            all.insert(all.end(), rgb, rgb + 3 * zone_count);
        }
        return all;
    }
    uint64_t shown()
    {
        EXPECT_EQ(clq_crowd_update(crowd_, 0.5, &view_, 1), CLQ_OK) << clq_last_error();
        return clq_view_get_hash(view_);
    }

    const std::vector<clq_palette_entry> wide_ = {{{200, 100, 0.2f, 0.9f, 0.2f, 1}, 2},
                                                  {{30, 60, 0, 0.1f, 0.5f, 1}, 1}};
    const std::vector<clq_palette_entry> red_ = {{{0, 0, 1, 1, 1, 1}, 1}};
    clq_crowd *crowd_ = nullptr;
    clq_view *view_ = nullptr;
    std::vector<clq_actor> actors_;
};

}  // namespace

TEST_F(ColouredCrowd, ShowsNewColoursWithTheNextUpdate)
{
    const std::vector<float> before = colours();
    EXPECT_EQ(before[0], zones_[0].colour[0]) << "the template's own, until there are others";
    const uint64_t plain = shown();
    ASSERT_EQ(colour(actors_), CLQ_OK) << clq_last_error();
    EXPECT_NE(colours(), before);
    const uint64_t dyed = shown();
    EXPECT_NE(dyed, plain);
    make({zone("one", red_)});
    ASSERT_EQ(colour({actors_[3]}), CLQ_OK);
    EXPECT_NE(shown(), dyed) << "one individual";
}

TEST_F(ColouredCrowd, HasTheSameColoursInAnyOrderAtOnceOrOneByOne)
{
    ASSERT_EQ(colour(actors_), CLQ_OK);
    const std::vector<float> at_once = colours();
    for (size_t i = actors_.size(); i-- > 0;) ASSERT_EQ(colour({actors_[i]}), CLQ_OK);
    EXPECT_EQ(colours(), at_once);
    std::vector<clq_actor> twice(actors_.rbegin(), actors_.rend());
    twice.insert(twice.end(), actors_.begin(), actors_.end());
    ASSERT_EQ(colour(twice), CLQ_OK);
    EXPECT_EQ(colours(), at_once);
}

TEST_F(ColouredCrowd, HasTheSameColoursUnderEveryInstructionSet)
{
    ASSERT_EQ(colour(actors_), CLQ_OK);
    const std::vector<float> usual = colours();
    for (const clq_simd simd : {CLQ_SIMD_SCALAR, CLQ_SIMD_128, CLQ_SIMD_256}) {
        if (clq_simd_set(simd) != CLQ_OK) continue;
        make({zone("zero", wide_, CLQ_COLOUR_SPACE_OKLAB), zone("one", wide_), linked_to("two", "zero", 0.2f)});
        ASSERT_EQ(colour(actors_), CLQ_OK);
        EXPECT_EQ(colours(), usual);
    }
    ASSERT_EQ(clq_simd_set(CLQ_SIMD_WIDEST), CLQ_OK);
}

TEST_F(ColouredCrowd, MayShareAMapWithOthersOnOtherThreads)
{
    std::vector<std::vector<Rgb>> alone;
    for (uint64_t seed = 0; seed < 300; ++seed) alone.push_back(draw(seed));
    std::vector<std::thread> threads;
    int wrong[4] = {};
    for (int t = 0; t < 4; ++t)
        threads.emplace_back([&, t] {
            for (uint64_t k = 0; k < 300; ++k) {
                const uint64_t seed = (k * 7 + uint64_t(t) * 50) % 300;
                const std::vector<Rgb> c = draw(seed);
                for (uint32_t i = 0; i < zone_count; ++i)
                    wrong[t] += c[i].r != alone[seed][i].r || c[i].b != alone[seed][i].b;
            }
        });
    for (std::thread &thread : threads) thread.join();
    for (const int n : wrong) EXPECT_EQ(n, 0);
}

// A sum over all colour bytes of 60 individuals: it is the same on every machine.
TEST_F(ColouredCrowd, HasTheSameColoursOnEveryMachine)
{
    ASSERT_EQ(colour(actors_), CLQ_OK);
    uint64_t hash = 0xcbf29ce484222325u;
    for (const float channel : colours()) hash = (hash ^ uint64_t(channel * 255 + 0.5f)) * 0x100000001b3u;
    EXPECT_EQ(hash, 0xba5788422c1354edu);
}

TEST_F(ColouredCrowd, StaysUnchangedOnAnyError)
{
    ASSERT_EQ(colour({actors_.begin(), actors_.begin() + 30}), CLQ_OK);
    const std::vector<float> before = colours();
    make({zone("one", red_)});
    std::vector<clq_actor> gone = actors_;
    gone[40].generation += 2;
    EXPECT_EQ(colour(gone), CLQ_STALE_ID);
    EXPECT_EQ(clq_crowd_randomise_colours(crowd_, map_, 1, actors_.data(), 60), CLQ_ARGUMENT);
    EXPECT_TRUE(mentions("no class 1"));
    EXPECT_EQ(clq_crowd_randomise_colours(crowd_, map_, 0, nullptr, 1), CLQ_ARGUMENT);
    EXPECT_EQ(clq_crowd_randomise_colours(crowd_, nullptr, 0, actors_.data(), 1), CLQ_ARGUMENT);
    make({zone("wings", red_)});
    EXPECT_EQ(colour(actors_), CLQ_ARGUMENT);
    EXPECT_TRUE(mentions("'wings'") && mentions("zero, one, two, three")) << clq_last_error();
    make({linked_to("one", "wings")});
    EXPECT_EQ(colour(actors_), CLQ_ARGUMENT);
    float rgb[3];
    EXPECT_EQ(clq_actor_get_colours(crowd_, actors_[0], rgb, 1), CLQ_ARGUMENT);
    EXPECT_EQ(api_test::sample_colours(map_, 0, tmpl_, 0, 0, rgb, 1), CLQ_ARGUMENT);
    EXPECT_EQ(colours(), before);
}

namespace
{

// Memory whose n-th allocation from now on fails; 0: none fails.
struct Countdown {
    int left = 0;
    int64_t held = 0;
};
void *allocate(void *user, size_t bytes, size_t alignment)
{
    Countdown &countdown = *static_cast<Countdown *>(user);
    if (countdown.left > 0 && --countdown.left == 0) return nullptr;
    ++countdown.held;
    return std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
}
void release(void *user, void *memory, size_t, size_t)
{
    --static_cast<Countdown *>(user)->held;
    std::free(memory);
}

}  // namespace

TEST(ColourMemory, ThatRunsOutAnywhereLeavesAllColoursUnchanged)
{
    Countdown countdown;
    clq_context_def context_def = clq_context_def_init();
    context_def.allocator = {&countdown, allocate, release};
    clq_context *context = nullptr;
    ASSERT_EQ(clq_context_create(&context_def, &context), CLQ_OK);
    SmallTemplate small;
    clq_template *tmpl = nullptr;
    ASSERT_EQ(clq_template_build(context, &small.def, &tmpl), CLQ_OK);
    clq_crowd *crowd = nullptr;
    ASSERT_EQ(clq_crowd_create(context, nullptr, &crowd), CLQ_OK);
    std::vector<clq_actor> actors(300);
    clq_actor_def def = clq_actor_def_init();
    def.tmpl = tmpl;
    for (clq_actor &actor : actors) ASSERT_EQ(clq_actor_create(crowd, &def, &actor), CLQ_OK);

    const clq_palette_entry entry = {{0, 360, 0, 1, 0, 1}, 1};
    const clq_zone_colours skin = {"skin", 1, &entry, CLQ_COLOUR_SPACE_OKLAB, nullptr, 0};
    const clq_colour_class people = {"people", nullptr, 1, &skin};
    clq_colour_map_def map_def = clq_colour_map_def_init();
    map_def.class_count = 1;
    map_def.classes = &people;
    clq_colour_map *map = nullptr;
    int failed = 0;
    for (int n = 1;; ++n, ++failed) {
        const int64_t before = countdown.held;
        countdown.left = n;
        const clq_status status = clq_colour_map_create(context, &map_def, &map);
        countdown.left = 0;
        if (status == CLQ_OK) break;
        ASSERT_EQ(status, CLQ_OUT_OF_MEMORY);
        ASSERT_EQ(countdown.held, before);
    }
    EXPECT_GT(failed, 5);
    failed = 0;
    for (int n = 1;; ++n, ++failed) {
        countdown.left = n;
        const clq_status status =
            clq_crowd_randomise_colours(crowd, map, 0, actors.data(), static_cast<uint32_t>(actors.size()));
        countdown.left = 0;
        if (status == CLQ_OK) break;
        ASSERT_EQ(status, CLQ_OUT_OF_MEMORY);
        for (const clq_actor actor : actors) {
            float rgb[6];
            ASSERT_EQ(clq_actor_get_colours(crowd, actor, rgb, 2), CLQ_OK);
            ASSERT_EQ(rgb[0], small.zones[0].colour[0]);
        }
    }
    EXPECT_GT(failed, 3);
    clq_crowd_destroy(crowd);
    clq_template_destroy(tmpl);
    EXPECT_EQ(clq_context_destroy(context), CLQ_IN_USE) << "the map is still there";
    clq_colour_map_destroy(map);
    EXPECT_EQ(clq_context_destroy(context), CLQ_OK);
    EXPECT_EQ(countdown.held, 0);
}

}  // namespace colours
