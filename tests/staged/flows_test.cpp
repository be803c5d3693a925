// A run is the same for any number of threads, with its flows together or apart, and its record shows it again.
#include <claque/record.h>

#include "samples/scenes/walkers/replay.h"
#include "tests/staged/staged_world.h"

namespace staged_test
{
namespace
{

using namespace scenes;

constexpr double fps = 5, seconds = 24;

struct Recorded {
    std::string record;
    std::vector<uint64_t> lists;
    uint64_t hash = 0;
    clq_stage_info info = clq_stage_info_init();
};

int append(void *user, const void *bytes, size_t size)
{
    static_cast<std::string *>(user)->append(static_cast<const char *>(bytes), size);
    return 0;
}

Recorded record(int threads, bool apart)
{
    World world(evacuation(24, 16), threads, apart);
    Recorded out;
    clq_recording_def def = clq_recording_def_init();
    def.write = append, def.user = &out.record;
    check(clq_crowd_begin_recording(world.scene->crowd(), &def));
    for (int frame = 0; frame <= int(seconds * fps); ++frame) out.lists.push_back(world.show(frame / fps));
    check(clq_crowd_end_recording(world.scene->crowd(), nullptr));
    world.scene->rest();
    out.info = world.run().info();
    return out;
}

TEST(FlowsOfARun, TogetherAndApartOnAnyNumberOfThreadsGiveTheSameRecord)
{
    const Recorded first = record(1, false);
    EXPECT_GT(first.info.transitions, 60u);
    EXPECT_GT(first.record.size(), 100000u);
    for (const auto &[threads, apart] : {std::pair(1, false), {1, true}, {2, true}, {4, true}, {4, false}}) {
        const Recorded other = record(threads, apart);
        EXPECT_EQ(other.info.hash, first.info.hash) << threads << apart;
        EXPECT_TRUE(other.record == first.record) << threads << apart;
        EXPECT_EQ(other.lists, first.lists) << threads << apart;
        EXPECT_EQ(other.info.ticks, first.info.ticks) << threads << apart;
    }
}

TEST(FlowsOfARun, ARecordPlaysBackToTheSameDrawLists)
{
    const Recorded run = record(2, true);
    World camera(evacuation(1, 1), 1, false);
    Library library(1);
    clq_record *made = nullptr;
    check(clq_record_load(library.context(), run.record.data(), run.record.size(), &made));
    const walkers::OwnRecord owned(made);
    clq_template *templates[] = {library.looking("citizen", false), library.looking("plebeian", false)};
    check(clq_record_set_templates(made, templates, 2));
    clq_crowd_def def = clq_crowd_def_init();
    check(clq_record_get_crowd_def(made, &def));
    clq_crowd *crowd = nullptr;
    check(clq_crowd_create(library.context(), &def, &crowd));
    const Own<clq_crowd> held(crowd);
    const Own<clq_view> view = view_of(crowd, *camera.scene);
    for (const int frame : {119, 3, 60, 61, 0, 90}) {
        check(clq_record_play_step(made, crowd, static_cast<uint64_t>(frame)));
        EXPECT_EQ(shown(crowd, view.get(), frame / fps), run.lists[size_t(frame)]) << frame;
    }
    EXPECT_NE(run.lists[3], run.lists[90]);
}

TEST(FlowsOfARun, AnotherSeedGivesAnotherRun)
{
    World first(evacuation(5, 5), 1, false, 1), second(evacuation(5, 5), 1, false, 2);
    first.show(14), second.show(14);
    EXPECT_NE(first.run().info().hash, second.run().info().hash);
}

// What a decision throws comes out of the flow that draws, and a run whose decisions failed can still be destroyed.
TEST(FlowsOfARun, AFailedDecisionReachesTheFlowThatDraws)
{
    for (const bool apart : {false, true}) {
        Scenario scenario = evacuation(3, 1);
        scenario.stage->agents[1].exits.clear();
        World world(scenario, 1, apart);
        world.show(0);
        try {
            for (double time_s = 1; time_s < 40; ++time_s) world.show(time_s);
            FAIL() << "nothing was thrown";
        } catch (const Failure &failure) {
            EXPECT_NE(std::string(failure.what()).find("calls 'exit', and it has no 'exits'"), std::string::npos)
                << failure.what();
        }
    }
}

}  // namespace
}  // namespace staged_test
