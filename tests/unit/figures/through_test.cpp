// Nothing goes through the body: in every clip of every built-in person hands and forearms stay out of the surface of
// trunk, head and thighs, clothes included. None of the four holds anything.
#include <algorithm>
#include <map>

#include <gtest/gtest.h>

#include "surface.h"

using puppet::dvec3;
using puppet::Model;
using puppet::pose;
using puppet::Posed;
using puppet::Surface;
using puppet::vec3;

namespace
{

// A hand that lies on cloth or on a thigh presses so far into what is a rigid surface here; the seams of a tunic are
// as thick.
constexpr double yields_m = 0.010;
constexpr int moments = 30;

bool is_of(const std::string &bone, std::initializer_list<const char *> names)
{
    return std::any_of(names.begin(), names.end(), [&](const char *name) { return bone.rfind(name, 0) == 0; });
}

struct Person {
    explicit Person(Model made)
        : model(std::move(made)), body(model, [this](size_t v) {
              return !is_of(bone(v), {"upper_arm", "forearm", "hand", "thumb", "finger"});
          })
    {
        for (uint32_t v = 0; v < model.parts[0].positions.size(); ++v)
            if (body.welded()[v] == v && is_of(bone(v), {"forearm", "hand", "thumb", "finger"})) arms.push_back(v);
    }
    const std::string bone(size_t v) const { return std::string(model.rig.node_names[puppet::owner(model, v)]); }

    Model model;
    Surface body;
    std::vector<uint32_t> arms;  // vertices of hands and forearms
};

struct Deepest {
    double depth = 0;
    uint32_t vertex = 0;
};

Deepest deepest(Person &person, const std::vector<vec3> &vertices)
{
    Deepest found;
    person.body.pose(vertices);
    for (const uint32_t v : person.arms) {
        const double depth = person.body.depth(dvec3(vertices[v]));
        if (depth > found.depth) found = {depth, v};
    }
    return found;
}

void expect_nothing_through(const char *name)
{
    for (const auto &builtin : claque::figures::people()) {
        if (builtin.name != std::string(name)) continue;
        Person person(builtin.make());
        ASSERT_GT(person.arms.size(), 100u);
        ASSERT_GT(person.body.triangle_count(), 500u);
        for (uint32_t c = 0; c < person.model.rig.clips.size(); ++c) {
            double most = 0;
            for (int k = 0; k <= moments; ++k) {
                const float time = person.model.rig.clips[c].duration_s * float(k) / moments;
                const Deepest found = deepest(person, pose(person.model, c, time).vertices);
                most = std::max(most, found.depth);
                EXPECT_LE(found.depth, yields_m)
                    << person.bone(found.vertex) << " in " << person.model.rig.clip_names[c] << " at " << time << " s";
            }
            testing::Test::RecordProperty(std::string(person.model.rig.clip_names[c]), std::to_string(most));
        }
        return;
    }
    FAIL() << "no person " << name;
}

}  // namespace

TEST(Through, TheCitizensBodyGoesNoHandOrForearm) { expect_nothing_through("citizen"); }
TEST(Through, ThePatriciansBodyGoesNoHandOrForearm) { expect_nothing_through("patrician"); }
TEST(Through, TheDecurionsBodyGoesNoHandOrForearm) { expect_nothing_through("decurion"); }
TEST(Through, ThePlebeiansBodyGoesNoHandOrForearm) { expect_nothing_through("plebeian"); }

// Hands that hang beside the body, moved towards its middle: found in it at their true depth, and not beyond it.
TEST(Through, TheTestFindsAHandThatIsInside)
{
    for (const auto &builtin : claque::figures::people()) {
        SCOPED_TRACE(builtin.name);
        Person person(builtin.make());
        const Posed posed = pose(person.model, person.model.rig.find_clip("stand"), 0);
        double before = 0;
        for (const float inwards : {0.13f, 0.16f}) {
            std::vector<vec3> moved = posed.vertices;
            for (const uint32_t v : person.arms) moved[v].x -= moved[v].x > 0 ? inwards : -inwards;
            const double depth = deepest(person, moved).depth;
            EXPECT_GT(depth, before + 0.008);
            EXPECT_LT(depth, before + 0.15);
            before = depth;
        }
        std::vector<vec3> away = posed.vertices;
        for (const uint32_t v : person.arms) away[v].x += away[v].x > 0 ? 1.0f : -1.0f;
        EXPECT_EQ(deepest(person, away).depth, 0);
    }
}
