// Same time, same camera, same picture: whatever caches, memory bounds, threads and earlier frames.
#include <gtest/gtest.h>

#include "samples/scenes/stage.h"

namespace
{

using namespace scenes;

StageOptions options(clq_cache_mode cache = CLQ_CACHE_FULL, uint64_t budget_bytes = 0)
{
    StageOptions o;
    o.scene = "odeon";
    o.casting.count = 0;
    o.casting.cache = cache;
    o.casting.cache_budget_bytes = budget_bytes;
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

Shown show(Stage &stage, double time_s)
{
    const uint64_t picture = hash_of(stage.picture(time_s));
    return {stage.view_hash(), picture};
}

constexpr double times_s[] = {3.0, 17.25, 31.5};

// Each in a crowd of its own, so that nothing was before it.
const std::vector<Shown> &alone()
{
    static const std::vector<Shown> shown = [] {
        std::vector<Shown> made;
        Library library(1);
        for (const double t : times_s) {
            Stage stage(library, options());
            made.push_back(show(stage, t));
        }
        return made;
    }();
    return shown;
}

}  // namespace

TEST(odeon, a_frame_in_a_sequence_is_the_frame_alone_also_backwards)
{
    alone();  // whose contexts were current last, before that of this stage
    Library library(1);
    Stage stage(library, options());
    for (double t = 2.0; t < 3.0; t += 0.04) stage.update(t);
    EXPECT_EQ(show(stage, times_s[0]), alone()[0]);
    EXPECT_EQ(show(stage, times_s[2]), alone()[2]);
    EXPECT_EQ(show(stage, times_s[1]), alone()[1]);
    EXPECT_EQ(show(stage, times_s[0]), alone()[0]);
}

TEST(odeon, is_the_same_picture_on_any_number_of_threads)
{
    alone();
    for (const int threads : {2, 4}) {
        Library library(threads);
        Stage stage(library, options());
        for (size_t i = 0; i < 3; ++i) EXPECT_EQ(show(stage, times_s[i]), alone()[i]) << threads << " threads";
    }
}

TEST(odeon, is_the_same_picture_with_any_cache_and_memory)
{
    alone();
    Library library(2);
    for (const auto &[cache, budget] :
         {std::pair(CLQ_CACHE_NONE, 0), {CLQ_CACHE_ANIMATION, 0}, {CLQ_CACHE_FULL, 1}, {CLQ_CACHE_FULL, 3'000'000}}) {
        Stage stage(library, options(cache, uint64_t(budget)));
        for (size_t i = 0; i < 3; ++i) EXPECT_EQ(show(stage, times_s[i]), alone()[i]) << cache << ' ' << budget;
    }
}

TEST(odeon, is_the_same_picture_by_any_strategy_and_from_egl)
{
    alone();
    Library library(2);
    StageOptions o = options();
    o.context = contexts::Kind::egl;
    std::unique_ptr<Stage> stage;
    try {
        stage = std::make_unique<Stage>(library, o);
    } catch (const Failure &failure) {
        GTEST_SKIP() << failure.what();
    }
    for (const clq_variety variety : {CLQ_VARIETY_PER_ZONE, CLQ_VARIETY_BINNED, CLQ_VARIETY_FUSED}) {
        stage->use_variety(variety);
        EXPECT_EQ(show(*stage, times_s[1]), alone()[1]) << variety;
    }
}

TEST(odeon, another_seed_is_another_picture)
{
    alone();
    Library library(2);
    StageOptions o = options();
    o.casting.seed = 2;
    Stage stage(library, o);
    EXPECT_FALSE(show(stage, times_s[1]) == alone()[1]);
}
