// Poses that a wrong rest makes are told from those that a clip means: by warnings with the key of the map that helps.
#include <gtest/gtest.h>

#include "lib/retarget/retarget.h"
#include "resting_rigs.h"

namespace claque::testing
{
namespace
{

// The person does this about the middle of its body.
Acted tumbling(glm::dvec3 axis, const std::function<double(uint32_t)> &degrees)
{
    Acted out = walker(12);
    const auto walk = out.turn;
    out.turn = [=](const std::string &joint, uint32_t key) { return turned(axis, degrees(key)) * walk(joint, key); };
    out.hips = [=](uint32_t key) { return glm::dvec3(0, 0.5, 0) + turned(axis, degrees(key)) * glm::dvec3(0, 0.2, 0); };
    return out;
}

std::vector<std::string> warnings_of(const model::Rig &source, std::vector<Bone> bones, retarget::Options options)
{
    model::Rig target = rig_of(bones);
    options.mode = retarget::Mode::motion;
    return retarget::add_clips(target, source, options).warnings;
}

std::string one(const std::vector<std::string> &warnings)
{
    std::string out;
    for (const std::string &warning : warnings) out += warning + "\n";
    return out;
}

model::Rig in_t_pose(const Acted &acted)
{
    return acted_rig(
        person(1, 0), acted, 0, [](uint32_t) { return glm::dquat(1, 0, 0, 0); }, true);
}

retarget::Options aligned_arms()
{
    retarget::Options out;
    for (const Bone &bone : person(1, 0)) {
        const std::string name = bone.name;
        const bool arm = name.find("arm") == 0 || name.find("elbow") == 0 || name.find("hand") == 0;
        out.joints.push_back({name, name, arm ? retarget::RestAlignment::align : retarget::RestAlignment::keep});
    }
    return out;
}

}  // namespace

TEST(PoseCheck, SaysNothingOfPosesThatTheClipHasItself)
{
    const std::vector<Acted> all = {walker(12), tumbling({1, 0, 0}, [](uint32_t) { return 90.0; }),  // lies on its face
                                    tumbling({0, 0, 1}, [](uint32_t) { return -90.0; }),             // on its side
                                    tumbling({1, 0, 0}, [](uint32_t) { return 180.0; }),        // stands on its head
                                    tumbling({1, 0, 0}, [](uint32_t k) { return 30.0 * k; })};  // somersaults
    for (const Acted &acted : all)
        for (const float size : {0.5f, 1.0f, 2.0f})
            EXPECT_EQ(one(warnings_of(in_t_pose(acted), person(size, 0), {})), "");
}

TEST(PoseCheck, NamesTheRestWhereABodyLiesThatStandsInTheClip)
{
    retarget::Options options;
    options.rest = retarget::SourceRest::file;
    const model::Rig source = rig_along_x(walker(12), 0);
    const std::string heap = one(warnings_of(source, person(1, 0), options));
    EXPECT_NE(
        heap.find(
            "clip 'walk' at 0 s: 'head' is not above 'hips', unlike in the clips' own skeleton: rest = \"bones\""),
        std::string::npos)
        << heap;
    options.rest = retarget::SourceRest::bones;
    EXPECT_EQ(one(warnings_of(source, person(1, 0), options)), "") << "the remedy";
}

TEST(PoseCheck, NamesTheAlignmentWhereArmsEndInTheTrunk)
{
    const model::Rig source = in_t_pose(walker(12));
    const std::string inside = one(warnings_of(source, person(1, 75), {}));
    EXPECT_NE(inside.find("is inside the trunk, unlike in the clips' own skeleton: `align` in the map"),
              std::string::npos)
        << inside;
    EXPECT_EQ(one(warnings_of(source, person(1, 75), aligned_arms())), "") << "the remedy";
}

TEST(PoseCheck, NamesTheRestWhereNoFootStandsThatStandsInTheClip)
{
    // The legs rest ahead in the file, as on a chair, and hang in the clip: they would turn back from straight down.
    std::vector<Bone> sits = person(1, 80);
    for (Bone &bone : sits)
        if (std::string(bone.name).find("knee") == 0 || std::string(bone.name).find("foot") == 0)
            bone.offset = glm::vec3(0, 0.2f, -bone.offset.y);
    Acted stands = walker(12);
    stands.turn = [](const std::string &joint, uint32_t) {
        return joint.find("leg") == 0 || joint.find("knee") == 0 || joint.find("foot") == 0 ? turned({1, 0, 0}, 110)
                                                                                            : glm::dquat(1, 0, 0, 0);
    };
    const model::Rig source = acted_rig(
        sits, stands, 0, [](uint32_t) { return glm::dquat(1, 0, 0, 0); }, true);
    retarget::Options options;
    options.rest = retarget::SourceRest::file;
    const std::string lifted = one(warnings_of(source, person(1, 80), options));
    EXPECT_NE(lifted.find("above the lowest joint, unlike in the clips' own skeleton: rest = \"bones\""),
              std::string::npos)
        << lifted;
    options.rest = retarget::SourceRest::bones;
    EXPECT_EQ(one(warnings_of(source, person(1, 80), options)), "") << "the remedy";
}

TEST(PoseCheck, CountsTheClipsThatAreAlike)
{
    model::Rig source = in_t_pose(walker(12));
    for (const char *name : {"again", "once more"}) {
        source.clips.push_back(source.clips[0]);
        source.clip_names.emplace_back(name);
    }
    const std::vector<std::string> warnings = warnings_of(source, person(1, 75), {});
    ASSERT_EQ(warnings.size(), 1u) << one(warnings);
    EXPECT_NE(warnings[0].find("clip 'walk' at 0 s: "), std::string::npos) << warnings[0];
    EXPECT_NE(warnings[0].find(", and so in 2 more clips, "), std::string::npos) << warnings[0];
}

}  // namespace claque::testing
