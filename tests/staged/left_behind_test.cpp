// A run that ends holds no track and nothing else of its context: further runs leave no more behind than the first.
#include <cstdlib>
#include <cstring>

#include "tests/staged/staged_world.h"

using namespace scenes;

namespace
{

// What still exists of a context that has a template: it says so when it refuses to end.
int count_of(clq_context *context)
{
    EXPECT_EQ(clq_context_destroy(context), CLQ_IN_USE);
    const char *number = std::strpbrk(clq_last_error(), "0123456789");
    return number ? std::atoi(number) : 0;
}

}  // namespace

TEST(RunsOfAStage, LeaveNothingBehindWhenTheyEnd)
{
    Library library(1);
    const Scenario scenario = staged_test::evacuation(8, 4);
    std::vector<int> left;
    for (int number = 0; number < 3; ++number) {
        {
            const auto scene = staged::make_staged(library, {}, scenario, {});
            const Own<clq_view> view = staged_test::view_of(scene->crowd(), *scene);
            std::vector<uint8_t> bytes;
            for (int frame = 0; frame < 40; ++frame) {
                scene->place(0.25 * frame);
                staged_test::shown(scene->crowd(), view.get(), 0.25 * frame);
                if (frame == 25) bytes = scene->save();
            }
            EXPECT_GT(scene->run().counts().commands, 20u);
            scene->run().decide(14);  // commands that nothing reads
            // One that goes on from the middle of it.
            const auto other = staged::make_staged(library, {}, scenario, {});
            other->restore(bytes);
        }
        left.push_back(count_of(library.context()));
    }
    EXPECT_GT(left[0], 0);
    EXPECT_EQ(left[1], left[0]);
    EXPECT_EQ(left[2], left[0]);
}
