// Each step of an update names the first array that does not fit, and an update gives every step what it checks for.
#include "lib/frame/steps.h"

#include <gtest/gtest.h>

#include "lib/frame/work.h"
#include "tests/law/support/scene.h"

namespace claque::frame
{

namespace
{

using namespace testing_support;

// All that flows through one update of a scene, with arrays of the full size.
class StepsTest : public ::testing::Test
{
protected:
    StepsTest()
    {
        for (uint32_t row = 0; row < scene_.crowd.row_count(); ++row)
            work_.candidates[row].row = row, work_.candidates[row].slot = row;
    }

    base::Span<Candidate> candidates() { return {work_.candidates.data(), rows_}; }
    base::Span<const Candidate> placed() { return {work_.candidates.data(), rows_}; }
    base::Span<Row> rows(uint32_t missing = 0) { return {work_.rows.data(), rows_ - missing}; }
    base::Span<const Row> found(uint32_t missing = 0) { return {work_.rows.data(), rows_ - missing}; }
    Visibilities visibilities(uint32_t missing = 0)
    {
        return {{work_.visibilities.data(), rows_ - missing}, rows_ - missing};
    }
    template <class T>
    static base::Span<T> cut(std::pmr::vector<T> &array, size_t count)
    {
        return {array.data(), static_cast<uint32_t>(count)};
    }
    // One request per candidate, as MakeRequests leaves them.
    void request_all(uint32_t missing = 0) { work_.caches.begin().assign(rows_ - missing, animcache::Request()); }

    template <class Step>
    static void fits(const Step &step)
    {
        EXPECT_TRUE(step.check().ok()) << step.check().text;
    }
    template <class Step>
    static void is_refused(const Step &step, const char *text)
    {
        EXPECT_EQ(step.check().code, CLQ_ARGUMENT);
        EXPECT_STREQ(step.check().text, text);
    }

    struct ReservedWork : Work {
        explicit ReservedWork(const Scene &scene) : Work(std::pmr::get_default_resource(), Settings())
        {
            View *const view = scene.views[0].get();
            reserve(scene.crowd, base::Span<View *const>(&view, 1));
            const uint32_t count = scene.crowd.row_capacity();
            reserve_candidates(scene.crowd, base::Span<View *const>(&view, 1), count, count);
        }
    };

    Scene scene_;
    ReservedWork work_{scene_};
    base::Jobs jobs_;
    base::HostCalls host_calls_;
    const base::Span<const CameraState> eyes_{work_.eyes.data(), 1};
    const Given given_{scene_.crowd, work_.settings, eyes_, 1, 1, jobs_, host_calls_};
    uint32_t rows_ = scene_.crowd.row_count();
};

}  // namespace

TEST_F(StepsTest, CullGroupsNeedsRoomForBlocksGroupsAndRows)
{
    const size_t blocks = work_.blocks.blocks().count;
    const auto step = [&](size_t seen, size_t tested) {
        return CullGroups{given_, work_.blocks, cut(work_.block_seen, seen), cut(work_.tested, tested)};
    };
    fits(step(blocks, rows_));
    if (blocks > 0) is_refused(step(blocks - 1, rows_), "no room for every block in every view");
    is_refused(step(blocks, rows_ - 1), "no room for every row");
}

TEST_F(StepsTest, CullBoundsNeedsRoomForAllThatAreTested)
{
    const auto step = [&](size_t near) {
        return CullBounds{given_, cut(work_.passed, near), base::Span<uint32_t>(work_.tested.data(), rows_)};
    };
    fits(step(rows_));
    is_refused(step(rows_ - 1), "no room for all that are tested");
}

TEST_F(StepsTest, CullRefpointsNeedsRoomForAllThatAreTested)
{
    const base::Span<const uint32_t> tested(work_.tested.data(), rows_);
    const auto step = [&](size_t passed) { return CullRefpoints{given_, tested, {}, cut(work_.passed, passed)}; };
    fits(step(rows_));
    is_refused(step(rows_ - 1), "no room for all that are tested");
}

TEST_F(StepsTest, StepsThatReadMotionsNeedThatOfEveryActorOnATrack)
{
    for (const uint32_t row : {3u, 5u}) scene_.crowd.tables.follows.make(row);
    std::pmr::vector<track::Motion> all(2);
    const base::Span<const uint32_t> tested(work_.tested.data(), rows_);
    for (const uint32_t count : {2u, 1u}) {
        const base::Span<track::Motion> motions(all.data(), count);
        const base::Span<const track::Motion> moved(all.data(), count);
        const auto judge = [&](const auto &step) {
            if (count == 2) fits(step);
            else is_refused(step, "1 motions for 2 actors on tracks");
        };
        judge(FollowTracks{given_, tested, motions});
        judge(CullRefpoints{given_, tested, moved, cut(work_.passed, rows_)});
        judge(PlaceRoots{given_, moved, candidates(), work_.stats});
        judge(ChooseLevels{given_, visibilities(), moved, 0, candidates(), rows()});
    }
}

TEST_F(StepsTest, ListCandidatesNeedsAllThatAreTestedAndRoomForAllThatPassed)
{
    const base::Span<const uint32_t> tested(work_.tested.data(), rows_);
    for (uint32_t i = 0; i < rows_; ++i) work_.passed[i] = i % 4 == 1;
    const auto step = [&](size_t passed, size_t candidates) {
        const base::Span<const uint8_t> let_through(work_.passed.data(), static_cast<uint32_t>(passed));
        return ListCandidates{given_,     tested, let_through, rows_, work_.seen, cut(work_.candidates, candidates),
                              work_.stats};
    };
    fits(step(rows_, rows_ / 4));
    is_refused(step(rows_ - 1, rows_ / 4), "not all that are tested were culled");
    is_refused(step(rows_, rows_ / 4 - 1), "no room for all that passed");
}

TEST_F(StepsTest, PlaceRootsNeedsRowsThatExist)
{
    fits(PlaceRoots{given_, {}, candidates(), work_.stats});
    work_.candidates[3].row = rows_;
    is_refused(PlaceRoots{given_, {}, candidates(), work_.stats}, "a candidate in row 80 of 80");
}

TEST_F(StepsTest, CullRootsNeedsRoomForEveryCandidateInEveryView)
{
    fits(CullRoots{given_, placed(), visibilities(), work_.stats});
    is_refused(CullRoots{given_, placed(), visibilities(1), work_.stats}, "no room for every candidate in every view");
    const Visibilities narrow{{work_.visibilities.data(), rows_ - 1}, rows_};
    is_refused(CullRoots{given_, placed(), narrow, work_.stats}, "no room for every candidate in every view");
}

TEST_F(StepsTest, ChooseLevelsNeedsVisibilitiesOfEveryCandidateAndRoomForItsResults)
{
    const char *const text = "no visibility of every candidate, or no room for its results";
    fits(ChooseLevels{given_, visibilities(), {}, 0, candidates(), rows()});
    is_refused(ChooseLevels{given_, visibilities(1), {}, 0, candidates(), rows()}, text);
    is_refused(ChooseLevels{given_, visibilities(), {}, 0, candidates(), rows(1)}, text);
}

TEST_F(StepsTest, MakeRequestsNeedsRoomForARequestOfEveryCandidate)
{
    const char *const text = "no room for a request of every candidate, or not a result of it";
    std::pmr::vector<animcache::Request> requests;
    const auto step = [&](uint32_t missing, uint32_t narrow) {
        return MakeRequests{given_,       placed(), found(missing), work_.caches, cut(work_.passed, rows_ - narrow),
                            work_.layers, requests, work_.stats};
    };
    is_refused(step(0, 0), text);
    requests.reserve(rows_);
    fits(step(0, 0));
    is_refused(step(1, 0), text);
    is_refused(step(0, 1), text);
}

TEST_F(StepsTest, KeepToBudgetNeedsRequestsOfAllCandidatesAndTimeThatPasses)
{
    const auto step = [&](double elapsed_s, uint32_t missing) {
        return KeepToBudget{given_, elapsed_s, 0, work_.caches, candidates(), rows(missing)};
    };
    request_all(1);
    is_refused(step(0.1, 0), "no request of every candidate, or no room for its results");
    request_all();
    fits(step(0.1, 0));
    is_refused(step(0.1, 1), "no request of every candidate, or no room for its results");
    is_refused(step(-1, 0), "-1 seconds since the last update");
}

TEST_F(StepsTest, BehaveNeedsRoomForCandidatesAndTheirDegreesOfFreedom)
{
    std::pmr::vector<float> dofs(3 * (size_t(rows_) + 1));
    const auto step = [&](size_t behaving, uint32_t missing, size_t numbers) {
        return Behave{
            given_,       placed(),   found(missing), work_.seen, 3, cut(work_.behaving, behaving), cut(dofs, numbers),
            work_.caches, work_.stats};
    };
    fits(step(rows_, 0, 0));  // without a mechanism nothing is written
    scene_.crowd.behaviours().add(crowd::Mechanism(), {});
    fits(step(rows_, 0, dofs.size()));
    is_refused(step(rows_ - 1, 0, dofs.size()), "no room for every candidate");
    is_refused(step(rows_, 1, dofs.size()), "no room for every candidate");
    is_refused(step(rows_, 0, 0), "no room for the degrees of freedom of every candidate");
    is_refused(step(rows_, 0, dofs.size() - 1), "no room for the degrees of freedom of every candidate");
}

TEST_F(StepsTest, CullPartsNeedsARequestAndASightOfEveryCandidate)
{
    const auto step = [&](uint32_t unseen, uint32_t missing, size_t visible) {
        return CullParts{
            given_,     placed(), work_.caches, visibilities(unseen), rows(missing), cut(work_.visible, visible),
            work_.stats};
    };
    request_all();
    fits(step(0, 0, rows_));
    is_refused(step(1, 0, rows_), "no request or no visibility of every candidate");
    is_refused(step(0, 1, rows_), "no room for every candidate");
    is_refused(step(0, 0, rows_ - 1), "no room for every candidate");
    request_all(1);
    is_refused(step(0, 0, rows_), "no request or no visibility of every candidate");
}

TEST_F(StepsTest, ListViewNeedsAViewThatExistsAndRoomForTheVisible)
{
    const base::Span<const uint32_t> visible(work_.visible.data(), rows_);
    std::pmr::vector<SortEntry> none;
    const auto step = [&](uint32_t view, uint32_t unseen, std::pmr::vector<SortEntry> &listed) {
        return ListView{given_,       view,   placed(),      visible,         visibilities(unseen),
                        work_.caches, listed, work_.ordered, *scene_.views[0]};
    };
    request_all();
    fits(step(0, 0, work_.listed));
    is_refused(step(1, 0, work_.listed), "view 1 of 1");
    is_refused(step(0, 1, work_.listed), "no request or no visibility of every candidate");
    is_refused(step(0, 0, none), "no room for 80 visible individuals");
}

TEST_F(StepsTest, CountBandsNeedsBandsAndResultsOfAllThatAreDrawn)
{
    request_all();
    work_.caches.begin().assign(1, animcache::Request());
    animcache::Request &drawn = work_.caches.pending()[0];
    drawn.drawn = true;
    drawn.slot = rows_ - 1;
    Band bands[1];
    fits(CountBands{given_, work_.caches, found(), 0.1, {bands, 1}});
    is_refused(CountBands{given_, work_.caches, found(), 0.1, {}}, "0 distance bands: 1 to 8 are counted");
    is_refused(CountBands{given_, work_.caches, found(1), 0.1, {bands, 1}}, "slot 79 of 79 is drawn");
}

}  // namespace claque::frame
