// Random definitions and commands: every resulting value is a number within its range.
#include <cmath>

#include <gtest/gtest.h>

#include "lib/base/hash.h"
#include "lib/behave/command.h"
#include "test_actors.h"

namespace claque::behave
{

using namespace testing_support;

namespace
{

class Draw
{
public:
    explicit Draw(uint64_t seed) : seed_(seed) {}
    uint32_t below(uint32_t n) { return static_cast<uint32_t>(base::hash(seed_, ++count_, base::Purpose::pick) % n); }
    float in(float low, float high)
    {
        return low + (high - low) * base::unit(base::hash(seed_, ++count_, base::Purpose::pick));
    }
    // Durations of every magnitude.
    float length() { return std::pow(10.0f, in(-4, 4)); }
    uint32_t dof() { return below(3) == 0 ? model::none : below(10); }

private:
    uint64_t seed_, count_ = 0;
};

crowd::MechanismKind any_kind(Draw &draw, const TestActors &test_actors)
{
    const auto poses = [&](auto &into) {
        const uint32_t count = 1 + draw.below(6);
        for (uint32_t i = 0; i < count; ++i) {
            crowd::DofPose shape{uint32_t(into.values.size()), 0};
            for (uint32_t k = 0; k < dof_count; ++k)
                if (draw.below(3) == 0)
                    into.values.push_back({k, draw.in(test_actors.dof(k).min, test_actors.dof(k).max)});
            shape.count = uint32_t(into.values.size()) - shape.first;
            into.poses.push_back(shape);
        }
        return count;
    };
    switch (draw.below(4)) {
        case 0: {
            crowd::Gaze out;
            for (uint32_t *dof : {&out.eye_yaw[0], &out.eye_yaw[1], &out.eye_pitch[0], &out.eye_pitch[1], &out.neck_yaw,
                                  &out.neck_pitch, &out.spine_yaw, &out.spine_pitch})
                *dof = draw.dof();
            out.spine_yaw = spine_yaw;
            out.neck_share = draw.in(0, 1), out.spine_share = draw.in(0, 1);
            out.turn_s = draw.below(3) ? draw.length() : 0, out.wander_s = draw.below(2) ? draw.length() : 0;
            out.wander_yaw = draw.in(0, 3), out.wander_pitch = draw.in(0, 3);
            return out;
        }
        case 1: {
            crowd::Expression out(std::pmr::get_default_resource());
            poses(out);
            out.hold_s = draw.length();
            out.blend_s = draw.in(0, 0.5f) * out.hold_s;
            return out;
        }
        case 2: {
            crowd::Blink out(std::pmr::get_default_resource());
            out.closed = {{left_lid, 1}, {smile, 0.5f}};
            out.close_s = draw.length();
            out.period_s = out.close_s * draw.in(1.01f, 50);
            return out;
        }
        default: {
            crowd::Phrase out(std::pmr::get_default_resource());
            const uint32_t count = poses(out);
            float time = 0;
            for (uint32_t i = 0; i < 1 + draw.below(9); ++i, time += draw.length())
                out.keys.push_back({time, draw.below(4) ? draw.below(count) : model::none});
            out.length_s = out.keys.back().time_s + (draw.below(3) || out.keys.size() == 1 ? draw.length() : 0);
            out.pause_s = draw.below(4) ? draw.length() : draw.in(-1, 0);
            out.blend_s = draw.below(3) ? draw.length() : 0;
            return out;
        }
    }
}

double any_time(Draw &draw)
{
    switch (draw.below(8)) {
        case 0:
            return 1e300;
        case 1:
            return -1e18;
        case 2:
            return 0;
        default:
            return double(draw.in(-50, 50)) + double(draw.in(0, 1e-3f));
    }
}

void any_command(Draw &draw, TestActors &test_actors, uint32_t mechanism)
{
    const crowd::Mechanism &told = test_actors.crowd.behaviours().mechanism(mechanism);
    const crowd::Id id = test_actors.ids[0];
    if (std::holds_alternative<crowd::Gaze>(told.kind)) {
        const glm::dvec3 point(draw.in(-5, 5), draw.in(-5, 5), draw.in(-5, 5));
        command_gaze(test_actors.crowd, id, mechanism, draw.below(4) ? &point : nullptr, any_time(draw));
    }
    if (const auto *e = std::get_if<crowd::Expression>(&told.kind))
        command_expression(test_actors.crowd, id, mechanism,
                           draw.below(4) ? draw.below(uint32_t(e->poses.size())) : model::none, any_time(draw));
    if (std::holds_alternative<crowd::Phrase>(told.kind))
        command_phrase(test_actors.crowd, id, mechanism, any_time(draw));
}

}  // namespace

TEST(AnyDef, GivesNumbersWithinTheRangesAtAnyTime)
{
    for (uint64_t seed = 0; seed < 400; ++seed) {
        Draw draw(seed);
        TestActors test_actors(1, seed);
        const uint32_t count = 1 + draw.below(16);
        for (uint32_t i = 0; i < count; ++i) {
            crowd::Mechanism mechanism;
            mechanism.kind = any_kind(draw, test_actors);
            mechanism.level_m[0] = 10, mechanism.level_m[1] = 20, mechanism.level_m[2] = 30;
            test_actors.add(std::move(mechanism), float(draw.below(3)));
            test_actors.use(0, i, float(draw.below(3)), draw.in(-9, 9), double(draw.in(-9, 9)));
        }
        for (int i = 0; i < 60; ++i) {
            any_command(draw, test_actors, draw.below(count));
            const std::vector<float> &dofs =
                test_actors.at(any_time(draw), 0, draw.in(0, 40), static_cast<Skeleton>(draw.below(4)));
            for (uint32_t k = 0; k < dof_count; ++k)
                ASSERT_TRUE(dofs[k] >= test_actors.dof(k).min && dofs[k] <= test_actors.dof(k).max)
                    << seed << ": " << dofs[k];
        }
    }
}

}  // namespace claque::behave
