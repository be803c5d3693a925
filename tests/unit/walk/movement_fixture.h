// Walkers of a stage on the ground of two rooms, and all that they publish up to a time.
#pragma once

#include <claque/assets.h>

#include "lib/stage/walk/movement.h"
#include "tests/unit/walk/floors.h"

namespace walk_test
{

using namespace claque;

class Movement : public testing::Test
{
protected:
    Movement() : navigation_(floors::two_rooms(true).make().release())
    {
        EXPECT_EQ(clq_context_create(nullptr, &context_), CLQ_OK);
        EXPECT_EQ(clq_template_builtin(context_, "citizen", &citizen_), CLQ_OK) << clq_last_error();
        clq_locomotion_def walk = clq_locomotion_def_init();
        walk.tmpl = citizen_, walk.walk = clq_template_find_clip(citizen_, "walk");
        EXPECT_EQ(clq_locomotion_create(context_, &walk, &locomotion_), CLQ_OK) << clq_last_error();
    }
    ~Movement() override
    {
        clear(moved_);
        clq_locomotion_destroy(locomotion_);
        clq_template_destroy(citizen_);
        EXPECT_EQ(clq_context_destroy(context_), CLQ_OK) << clq_last_error();
        clq_navigation_destroy(navigation_);
    }
    std::unique_ptr<walk::Walking> make() const
    {
        clq_walkers_def def = clq_walkers_def_init();
        def.max_count = 40;
        return std::make_unique<walk::Walking>(*navigation_, def, std::vector<const clq_locomotion *>{locomotion_});
    }
    std::unique_ptr<walk::Walking> restored_from(const walk::Walking &saved) const
    {
        std::vector<uint8_t> bytes;
        saved.save(bytes);
        auto out = make();
        out->restore(bytes.data(), bytes.size());
        return out;
    }
    stage::Walker walker(double x, double z) const
    {
        stage::Walker out;
        out.locomotion = locomotion_;
        out.position[0] = x, out.position[2] = z;
        return out;
    }
    static stage::Goal goal(double x, double z, uint64_t request)
    {
        stage::Goal out;
        out.position[0] = x, out.position[2] = z, out.request = request, out.heading_rad = NAN;
        return out;
    }
    static void clear(stage::Moved &moved)
    {
        for (const stage::Piece &piece : moved.pieces) clq_track_destroy(piece.track);
        moved.pieces.clear(), moved.arrivals.clear();
    }
    static uint64_t hash_of(const clq_track *track)
    {
        clq_track_info info = clq_track_info_init();
        EXPECT_EQ(clq_track_get_info(track, &info), CLQ_OK);
        return info.hash;
    }
    // Everything that is published up to a time, as text.
    std::vector<std::string> run(walk::Walking &movement, int from, int to)
    {
        std::vector<std::string> out;
        for (int tick = from + 1; tick <= to; ++tick) {
            movement.advance(0.05 * tick, moved_);
            for (const stage::Piece &piece : moved_.pieces)
                out.push_back(std::to_string(piece.agent) + " " + std::to_string(piece.from_s) + " " +
                              (piece.track ? std::to_string(hash_of(piece.track)) : "leaves"));
            for (const stage::Arrival &one : moved_.arrivals)
                out.push_back("arrival " + std::to_string(one.agent) + " " + std::to_string(one.request) + " " +
                              std::to_string(one.time_s) + " " + std::to_string(one.reached));
            clear(moved_);
        }
        return out;
    }
    void crowd(walk::Walking &movement) const
    {
        for (uint32_t i = 0; i < 12; ++i) {
            movement.add(i, walker(1 + 0.8 * (i % 4), 1 + 1.2 * (i / 4)), 0);
            movement.go(i, goal(15 - 0.8 * (i % 4), 1 + 1.2 * (i / 4), i), 0);
        }
    }
    // The same, and as many who go the other way.
    void crowds_that_meet(walk::Walking &movement) const
    {
        crowd(movement);
        for (uint32_t i = 12; i < 24; ++i) {
            movement.add(i, walker(12.5 + 0.8 * (i % 4), 1.3 + 1.2 * ((i - 12) / 4)), 0);
            movement.go(i, goal(3 - 0.8 * (i % 4), 1.3 + 1.2 * ((i - 12) / 4), i), 0);
        }
    }

    clq_navigation *navigation_;
    clq_context *context_ = nullptr;
    clq_template *citizen_ = nullptr;
    clq_locomotion *locomotion_ = nullptr;
    stage::Moved moved_;
};

}  // namespace walk_test
