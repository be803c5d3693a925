// Rest poses agree if no joint is off by more than half a hundredth: of the skeleton's size in place, of a unit in
// direction.
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "lib/retarget/retarget.h"
#include "rigs.h"

namespace claque::testing
{
namespace
{

struct Case {
    float size, away;  // of the people, and how far from the origin they stand, in sizes

    // A person whose left elbow is off by this share of the size, and turned by this angle.
    model::Rig person_off_by(float share, float angle) const
    {
        std::vector<Bone> bones = person(size, 0);
        bones[0].offset += glm::vec3(away, 0, -2 * away) * size;
        // From the hips to a foot: the farthest joint.
        const float reach = size * std::sqrt(0.1f * 0.1f + 0.95f * 0.95f);
        for (Bone &bone : bones)
            if (std::string(bone.name) == "elbow.l") bone.offset.z += share * reach;
        model::Rig rig = rig_of(bones);
        rig.rest[rig.find_node("elbow.l")].rotation = axis_turn({0, 0, 1}, angle);
        return rig;
    }
    retarget::Mode mode(float share, float angle) const
    {
        model::Rig source = person_off_by(0, 0), target = person_off_by(share, angle);
        add_motion(source, "dance", 5, size);
        retarget::Options options;
        options.rest = retarget::SourceRest::file;
        return retarget::add_clips(target, source, options).mode;
    }
};

}  // namespace

TEST(Agreement, IsJudgedByTheSizeOfTheSkeletonWhereverItStands)
{
    for (const float size : {0.01f, 1.0f, 40.0f})
        for (const float away : {0.0f, 30.0f}) {
            const Case people{size, away};
            for (const float sign : {-1.0f, 1.0f}) {
                EXPECT_EQ(people.mode(sign * 0.0048f, 0), retarget::Mode::channels) << size << ", " << away;
                EXPECT_EQ(people.mode(sign * 0.0052f, 0), retarget::Mode::motion) << size << ", " << away;
                EXPECT_EQ(people.mode(0, sign * 0.0048f), retarget::Mode::channels) << size << ", " << away;
                EXPECT_EQ(people.mode(0, sign * 0.0052f), retarget::Mode::motion) << size << ", " << away;
            }
        }
}

}  // namespace claque::testing
