// A crowd with one of everything, restored into other crowds, and scripted runs to compare them by.
#pragma once

#include <string>

#include "tests/api/saved_bytes.h"
#include "tests/api/test_world.h"

class SaveFixture : public testing::Test
{
protected:
    SaveFixture() : crowd_(test_world_.new_crowd())
    {
        test_world_.set_up(crowd_);
        actors_ = test_world_.fill(crowd_, 40, 1);
    }
    clq_crowd *other()  // set up as a host would, with other actors in it
    {
        clq_crowd *crowd = test_world_.new_crowd();
        test_world_.set_up(crowd);
        test_world_.fill(crowd, 25, 2);
        return crowd;
    }
    clq_status restore(clq_crowd *crowd, const saved::Bytes &bytes)
    {
        return clq_crowd_restore(crowd, bytes.data(), bytes.size(), test_world_.templates, 2);
    }
    // A scripted run of 100 frames; returns the hashes of two views.
    std::vector<uint64_t> story(clq_crowd *crowd, std::vector<clq_actor> actors, uint64_t seed)
    {
        std::vector<uint64_t> out;
        clq_view *views[2] = {test_world_.new_view(crowd, 0), test_world_.new_view(crowd, 12)};
        for (uint32_t frame = 0; frame < 100; ++frame) {
            test_world_.happen(crowd, actors, seed, frame);
            EXPECT_EQ(clq_crowd_update(crowd, 3 + 0.05 * frame, views, 2), CLQ_OK) << clq_last_error();
            out.push_back(clq_view_get_hash(views[0]));
            out.push_back(clq_view_get_hash(views[1]));
        }
        for (clq_view *view : views) clq_view_destroy(view);
        return out;
    }
    void refused(const saved::Bytes &bytes, clq_status status, const char *sentence)
    {
        const uint64_t before = clq_crowd_get_hash(crowd_);
        EXPECT_EQ(restore(crowd_, bytes), status) << sentence;
        EXPECT_NE(std::string(clq_last_error()).find(sentence), std::string::npos) << clq_last_error();
        EXPECT_EQ(clq_crowd_get_hash(crowd_), before) << sentence;
    }

    TestWorld test_world_;
    clq_crowd *crowd_;
    std::vector<clq_actor> actors_;
};
