// Each hold of a track that is handed over ends once: with the reader, with what replaces the list, or with the list.
#include "lib/stage/flow/handover.h"

#include <map>
#include <vector>

#include <gtest/gtest.h>

namespace
{

std::map<clq_track *, int> ended;

}  // namespace

// In place of the library's: these tracks are only numbers.
void clq_track_destroy(clq_track *track)
{
    if (track) ++ended[track];
}

namespace
{

using claque::stage::Command;
using claque::stage::Handover;

struct Tracks {
    uintptr_t made = 0;
    Tracks() { ended.clear(); }
    // `count` commands from a time on, each with a hold of a track of its own.
    std::vector<Command> commands(size_t count, double at_s)
    {
        std::vector<Command> out(count);
        for (Command &command : out) command.at_s = at_s, command.track = reinterpret_cast<clq_track *>(64 * ++made);
        return out;
    }
    int ends(uintptr_t number) const
    {
        const auto found = ended.find(reinterpret_cast<clq_track *>(64 * number));
        return found == ended.end() ? 0 : found->second;
    }
};

void read(Handover &list, size_t count)
{
    for (size_t i = 0; i < count; ++i) {
        Command *front = list.front(1e9);
        ASSERT_NE(front, nullptr);
        clq_track_destroy(front->track);  // the reader's, who shows nothing
        list.pop();
    }
}

TEST(Handover, EndsEachHoldOnceWhereverItIsWhenTheListEnds)
{
    for (size_t published = 0; published < 4; ++published)
        for (size_t from_all = 0; from_all <= 3 * published; ++from_all) {
            Tracks tracks;
            {
                Handover list(0);
                for (size_t block = 0; block < published; ++block) {
                    std::vector<Command> commands = tracks.commands(3, double(block));
                    list.publish(commands, double(block));
                }
                read(list, from_all);
            }
            for (uintptr_t i = 1; i <= tracks.made; ++i) EXPECT_EQ(tracks.ends(i), 1) << published << ", " << from_all;
        }
}

TEST(Handover, EndsTheHoldsOfWhatWasReplacedAndKeepsTheNewOnes)
{
    for (size_t published = 0; published < 4; ++published)
        for (size_t from_all = 0; from_all <= 3 * published; ++from_all) {
            Tracks tracks;
            {
                Handover list(0);
                for (size_t block = 0; block < published; ++block) {
                    std::vector<Command> commands = tracks.commands(3, double(block));
                    list.publish(commands, double(block));
                }
                read(list, from_all);
                const uintptr_t old = tracks.made;
                std::vector<Command> commands = tracks.commands(2, 7);
                list.replace(commands, 8);
                for (uintptr_t i = 1; i <= tracks.made; ++i)
                    EXPECT_EQ(tracks.ends(i), i <= old ? 1 : 0) << i << " of " << published << " blocks, " << from_all;
                EXPECT_EQ(list.left().size(), 2u);
                EXPECT_EQ(list.decided_s(), 8);
                commands = tracks.commands(3, 9);
                list.publish(commands, 9);
                read(list, 4);
            }
            for (uintptr_t i = 1; i <= tracks.made; ++i) EXPECT_EQ(tracks.ends(i), 1) << i << " at the end";
        }
}

TEST(Handover, GivesCommandsInTheirOrderAndNoneAheadOfItsTime)
{
    Tracks tracks;
    Handover list(0);
    for (int block = 0; block < 5; ++block) {
        std::vector<Command> commands = tracks.commands(2, block);
        list.publish(commands, block);
        EXPECT_TRUE(commands.empty());
        if (block % 2) {  // blocks that were read come back
            EXPECT_EQ(list.front(block - 1.5), nullptr);
            read(list, 4);
            EXPECT_EQ(list.front(1e9), nullptr);
        }
    }
    ASSERT_NE(list.front(4), nullptr);
    EXPECT_EQ(list.front(4)->track, reinterpret_cast<clq_track *>(64 * 9));
}

}  // namespace
