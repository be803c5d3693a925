// The coarse bound of an actor holds its Refpoint Bsphere at any time, after whatever edits, and is no larger than it
// has to be.
#include <cmath>
#include <random>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "lib/crowd/edits.h"
#include "tests/law/support/figure.h"

namespace claque::crowd
{

using namespace testing_support;

namespace
{

class BoundsTest : public ::testing::Test
{
protected:
    BoundsTest()
    {
        locomotion_.tmpl = figure_.get();
        crowd_.behaviours().add(RootPath(std::pmr::get_default_resource()));
        for (uint32_t i = 0; i < 3; ++i) groups_.push_back(crowd::create_group(crowd_, anywhere(50)));
    }

    double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
    uint32_t below(size_t count) { return static_cast<uint32_t>(random_() % count); }
    Transform anywhere(double size)
    {
        Transform transform;
        transform.position = glm::dvec3(between(-size, size), between(-size, size), between(-size, size));
        transform.scale = static_cast<float>(between(0.5, 2)) * (below(4) == 0 ? -1.0f : 1.0f);
        return transform;
    }
    // Ten seconds of a walk with corners that the curve overshoots, or the piece after another one.
    const track::Track &walk(const track::Track *previous = nullptr)
    {
        auto made = std::make_unique<track::Track>(std::pmr::get_default_resource());
        made->locomotion = &locomotion_;
        made->origin_m = anywhere(1000).position;
        made->start_s = previous ? previous->start_s + previous->length_s : 0;
        made->length_s = 10, made->height_step_m = 0.001;
        made->samples.resize(101);
        int32_t x = 0, z = 0;
        for (track::Sample &sample : made->samples) {
            sample.x = x += int32_t(below(16000)) - 8000, sample.z = z += int32_t(below(16000)) - 8000;
            sample.height = static_cast<uint16_t>(below(3000));
        }
        made->previous_hash = previous ? previous->hash : 0;
        made->hash = ++tracks_made_;
        made->reach = track::reach_of(*made);
        tracks_.push_back(std::move(made));
        return *tracks_.back();
    }

    void follow(Id id)
    {
        const Follow *now = crowd_.follows().of(id.index1 - 1);
        if (now && below(2) == 0) crowd::follow_track(crowd_, id, walk(now->track), now->start_s);
        else if (now) crowd::leave_track(crowd_, id, between(-2, 30));
        else if (crowd_.group_of(id.index1 - 1) == model::none) crowd::follow_track(crowd_, id, walk(), between(-5, 5));
    }
    void change_group(Id id)
    {
        if (crowd_.follows().of(id.index1 - 1)) return;
        const Id none = {};
        crowd::join(crowd_, id, below(2) == 0 ? none : groups_[below(groups_.size())], nullptr);
    }
    void edit(Id id)
    {
        switch (below(7)) {
            case 0: {
                const Transform transform = anywhere(1e5);
                return crowd::set_transforms(crowd_, &id, &transform, 1);
            }
            case 1:
                return change_group(id);
            case 2:
                return follow(id);
            case 3:
                return crowd::follow_ground(crowd_, id, float(below(3)), float(below(3)));
            case 4:
                return void(crowd::attach(crowd_, id, 2, {glm::vec3(0.5f, 0, 0), static_cast<float>(between(0, 3))}));
            case 5:
                return crowd::play_root_path(crowd_, id, RootPathPlay{below(2) == 0 ? 0 : model::none, 1, 0, 0});
            default:
                return crowd::set_group_transform(crowd_, groups_[below(3)], anywhere(1e4));
        }
    }

    void expect_bounds_hold()
    {
        for (uint32_t row = 0; row < crowd_.row_count(); ++row) {
            if (!crowd_.alive(row)) continue;
            const math::RoughSphere &bound = crowd_.bound_of(row);
            const uint32_t group = crowd_.group_of(row);
            const float outer = group == model::none ? 1 : crowd_.group(group).transform.scale;
            const double radius =
                std::fabs(double(crowd_.transform_of(row).scale * outer)) * double(crowd_.extent_of(row).refpoint) +
                double(crowd_.extent_of(row).slack);
            for (uint32_t i = 0; i < 8; ++i) {
                const glm::dvec3 at = crowd::reference_position_of(crowd_, row, between(-10, 60));
                const double apart = glm::length(at - glm::dvec3(bound.x, bound.y, bound.z));
                ASSERT_LE(apart + radius, double(bound.radius)) << "row " << row;
            }
            if (group != model::none || crowd_.follows().of(row)) continue;
            ++standing_;
            EXPECT_LE(double(bound.radius), radius * 1.001 + 1e-5 * glm::length(crowd_.transform_of(row).position));
        }
    }

    std::mt19937 random_{5};
    std::unique_ptr<model::Template> figure_ = make_figure(FigureDef());
    track::Locomotion locomotion_{std::pmr::get_default_resource()};
    std::vector<std::unique_ptr<track::Track>> tracks_;
    uint64_t tracks_made_ = 0;
    Crowd crowd_{std::pmr::get_default_resource(), 7};
    std::vector<Id> groups_;
    uint32_t standing_ = 0;
};

}  // namespace

TEST_F(BoundsTest, HoldAfterAnyEditAndAreTightForActorsThatStandAlone)
{
    std::vector<Id> ids;
    for (uint32_t i = 0; i < 40; ++i) ids.push_back(crowd::create(crowd_, *figure_, anywhere(1000), Play(), i));
    for (uint32_t round = 0; round < 3000 && !HasFatalFailure(); ++round) {
        Id &id = ids[below(ids.size())];
        if (below(30) == 0) {
            crowd::destroy(crowd_, id);
            id = crowd::clone(crowd_,
                              ids[(below(ids.size() - 1) + 1 + static_cast<size_t>(&id - ids.data())) % ids.size()],
                              nullptr, round);
        } else if (below(200) == 0) {
            Id &group = groups_[below(groups_.size())];
            crowd::destroy_group(crowd_, group);
            group = crowd::create_group(crowd_, anywhere(50));
        } else {
            edit(id);
        }
        expect_bounds_hold();
    }
    EXPECT_GT(standing_, 10000u);
}

TEST_F(BoundsTest, OfATrackHoldNoMoreThanItsWay)
{
    for (uint32_t i = 0; i < 50; ++i) {
        const track::Track &track = walk();
        glm::dvec3 low(HUGE_VAL), high(-HUGE_VAL);
        for (double time = -1; time <= 11; time += 0.003) {
            const glm::dvec3 p = track::position_at(track, time);
            low = glm::min(low, p), high = glm::max(high, p);
        }
        for (int k = 0; k < 3; ++k) {
            EXPECT_LE(track.reach.low[k], low[k]);
            EXPECT_GE(track.reach.high[k], high[k]);
            EXPECT_LE(track.reach.high[k] - track.reach.low[k], 1.2 * (high[k] - low[k]) + 1);
        }
    }
}

}  // namespace claque::crowd
