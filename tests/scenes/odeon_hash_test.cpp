// Same time and camera give the same picture, whatever the caches, memory limits, threads and earlier frames.
#include <gtest/gtest.h>

#include "samples/scenes/scene_renderer.h"
#include "tests/gl/support/absent.h"

namespace
{

using namespace scenes;

SceneOptions options(clq_cache_mode cache = CLQ_CACHE_FULL, uint64_t budget_bytes = 0)
{
    SceneOptions o;
    o.scene = "odeon";
    o.crowd_options.count = 0;
    o.crowd_options.cache = cache;
    o.crowd_options.cache_budget_bytes = budget_bytes;
    o.shot = Shot::path;
    o.path.emplace(*recorded_path("odeon"), "the odeon's path");
    o.width = 256, o.height = 192;
    return o;
}

struct Shown {
    uint64_t list, picture;
    bool operator==(const Shown &other) const { return list == other.list && picture == other.picture; }
};
std::ostream &operator<<(std::ostream &out, const Shown &s) { return out << s.list << '/' << s.picture; }

Shown show(SceneRenderer &scene_renderer, double time_s)
{
    const uint64_t picture = hash_of(scene_renderer.picture(time_s));
    return {scene_renderer.view_hash(), picture};
}

constexpr double times_s[] = {3.0, 17.25, 31.5};

// Each in a crowd of its own, without earlier frames.
const std::vector<Shown> &alone()
{
    static const std::vector<Shown> shown = [] {
        std::vector<Shown> made;
        Library library(1);
        for (const double t : times_s) {
            SceneRenderer scene_renderer(library, options());
            made.push_back(show(scene_renderer, t));
        }
        return made;
    }();
    return shown;
}

}  // namespace

TEST(Odeon, AFrameInASequenceIsTheFrameAloneAlsoBackwards)
{
    alone();  // runs first, because it makes contexts of its own current
    Library library(1);
    SceneRenderer scene_renderer(library, options());
    for (double t = 2.0; t < 3.0; t += 0.04) scene_renderer.update(t);
    EXPECT_EQ(show(scene_renderer, times_s[0]), alone()[0]);
    EXPECT_EQ(show(scene_renderer, times_s[2]), alone()[2]);
    EXPECT_EQ(show(scene_renderer, times_s[1]), alone()[1]);
    EXPECT_EQ(show(scene_renderer, times_s[0]), alone()[0]);
}

TEST(Odeon, IsTheSamePictureOnAnyNumberOfThreads)
{
    alone();
    for (const int threads : {2, 4}) {
        Library library(threads);
        SceneRenderer scene_renderer(library, options());
        for (size_t i = 0; i < 3; ++i) EXPECT_EQ(show(scene_renderer, times_s[i]), alone()[i]) << threads << " threads";
    }
}

TEST(Odeon, IsTheSamePictureWithAnyCacheAndMemory)
{
    alone();
    Library library(2);
    for (const auto &[cache, budget] :
         {std::pair(CLQ_CACHE_NONE, 0), {CLQ_CACHE_ANIMATION, 0}, {CLQ_CACHE_FULL, 1}, {CLQ_CACHE_FULL, 3'000'000}}) {
        SceneRenderer scene_renderer(library, options(cache, uint64_t(budget)));
        for (size_t i = 0; i < 3; ++i)
            EXPECT_EQ(show(scene_renderer, times_s[i]), alone()[i]) << cache << ' ' << budget;
    }
}

TEST(Odeon, IsTheSamePictureByAnyStrategyAndFromEglWhereItIs)
{
    alone();
    Library library(2);
    SceneOptions o = options();
    if (gltest::absent_gl(contexts::Kind::egl).empty()) o.context = contexts::Kind::egl;
    SceneRenderer scene_renderer(library, o);
    for (const clq_draw_strategy strategy : {CLQ_STRATEGY_PER_ZONE, CLQ_STRATEGY_BINNED, CLQ_STRATEGY_FUSED}) {
        scene_renderer.use_strategy(strategy);
        EXPECT_EQ(show(scene_renderer, times_s[1]), alone()[1]) << strategy;
    }
}

TEST(Odeon, AnotherSeedIsAnotherPicture)
{
    alone();
    Library library(2);
    SceneOptions o = options();
    o.crowd_options.seed = 2;
    SceneRenderer scene_renderer(library, o);
    EXPECT_FALSE(show(scene_renderer, times_s[1]) == alone()[1]);
}
