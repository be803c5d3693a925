// Actors on tracks show the same in any order of times, by any number of threads, and however they are culled.
#include "tests/api/walkers.h"

using walkers::Walkers;

TEST_F(Walkers, ShowTheSameInAnyOrderOfTimes)
{
    const auto hashes = [&](const std::vector<double> &times) {
        clq_crowd *crowd = this->crowd();
        for (int i = 0; i < 6; ++i) walker(crowd, track(0.4 + 0.4 * i, -2.0 * i, 0.3 * i), i);
        clq_view *view = this->view(crowd, 9);
        std::vector<std::pair<double, uint64_t>> out;
        for (const double t : times) {
            EXPECT_EQ(clq_crowd_update(crowd, t, &view, 1), CLQ_OK);
            out.emplace_back(t, clq_view_get_hash(view));
        }
        std::sort(out.begin(), out.end());
        return out;
    };
    std::vector<double> times;
    for (double t = 0; t < 20; t += 0.31) times.push_back(t);
    const auto forwards = hashes(times);
    std::reverse(times.begin(), times.end());
    EXPECT_EQ(hashes(times), forwards);
    EXPECT_EQ(hashes({times[20]})[0].second, forwards[times.size() - 21].second);
}

namespace
{

class ManyThreads : public Walkers
{
protected:
    ManyThreads() : Walkers(4) {}
    std::vector<uint64_t> story(uint32_t threads)
    {
        threads_ = threads;
        clq_crowd *crowd = this->crowd();
        for (int i = 0; i < 300; ++i) walker(crowd, track(0.3 + 0.01 * i, -0.1 * i, 0.5), 0.01 * i);
        clq_view *view = this->view(crowd, 9);
        std::vector<uint64_t> out;
        for (double t = 0.5; t < 12; t += 1.3) {
            EXPECT_EQ(clq_crowd_update(crowd, t, &view, 1), CLQ_OK);
            out.push_back(clq_view_get_hash(view));
        }
        return out;
    }
};

}  // namespace

TEST_F(ManyThreads, ShowWhatOneShows)
{
    const std::vector<uint64_t> one = story(1);
    EXPECT_EQ(story(2), one);
    EXPECT_EQ(story(4), one);
}

TEST_F(Walkers, PassTheCullPhasesAsInTraditionalProcessing)
{
    clq_crowd_def def = clq_crowd_def_init();
    const auto story = [&](clq_cull_mode cull) {
        def.cull = cull;
        clq_crowd *crowd = this->crowd(&def);
        for (int i = 0; i < 40; ++i) walker(crowd, track(0.5 + 0.05 * i, 6.0 - i, 1), 0.1 * i);
        clq_view *view = this->view(crowd, 8);
        std::vector<uint64_t> out;
        for (double t = 0; t < 18; t += 0.41) {
            EXPECT_EQ(clq_crowd_update(crowd, t, &view, 1), CLQ_OK);
            out.push_back(clq_view_get_hash(view));
        }
        return out;
    };
    EXPECT_EQ(story(CLQ_CULL_ACTOR), story(CLQ_CULL_TRADITIONAL));
}
