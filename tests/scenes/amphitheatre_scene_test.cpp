// The amphitheatre is a function of its options and the time: the same draw lists on any number of threads and in any
// order of times, and the ones of the day when they were accepted.
#include <set>

#include <gtest/gtest.h>

#include "samples/scenes/scene_renderer.h"

namespace
{

using namespace scenes;

SceneOptions options(const char *viewpoint, uint32_t count = 1500)
{
    SceneOptions o;
    o.scene = "amphitheatre";
    o.crowd_options.count = count;
    o.viewpoint = viewpoint;
    o.width = 128, o.height = 96;
    return o;
}

constexpr double times_s[] = {12.5, 3.0, 81.25};
constexpr uint64_t golden[] = {18139062368929785055u, 14131136547579186993u, 5569080262462018816u};

TEST(AmphitheatreScene, HasTheAcceptedDrawListsOnAnyThreadsAndInAnyOrder)
{
    for (const int threads : {1, 3}) {
        Library library(threads);
        SceneRenderer scene_renderer(library, options("top-row"));
        for (const size_t i : {0u, 1u, 2u, 0u}) {
            scene_renderer.update(times_s[i]);
            EXPECT_EQ(scene_renderer.view_hash(), golden[i]) << threads << " threads, " << times_s[i] << " s";
        }
    }
}

TEST(AmphitheatreScene, EverybodyIsInViewFromAboveTheAwning)
{
    Library library(2);
    SceneRenderer scene_renderer(library, options("above"));
    scene_renderer.update(10);
    EXPECT_EQ(scene_renderer.crowd_stats().visible, 1600u);
}

TEST(AmphitheatreScene, EachPlaceAndHourIsAnotherPicture)
{
    Library library(2);
    std::set<uint64_t> pictures;
    for (const char *viewpoint : {"above", "emperor", "top-row", "arena"})
        for (const double hour : {8.0, 12.5, 17.0}) {
            SceneOptions o = options(viewpoint, 200);
            o.crowd_options.hour = hour;
            pictures.insert(hash_of(SceneRenderer(library, o).picture(12)));
        }
    EXPECT_EQ(pictures.size(), 12u);
}

TEST(AmphitheatreScene, AnUnknownPlaceIsRefusedWithTheKnownOnes)
{
    Library library(1);
    try {
        SceneRenderer scene_renderer(library, options("moon", 10));
        FAIL();
    } catch (const Failure &failure) {
        EXPECT_STREQ(failure.what(),
                     "the scene 'amphitheatre' has no camera 'moon'; there are: overview, close, "
                     "above, emperor, top-row, arena");
    }
}

}  // namespace
