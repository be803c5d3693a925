// Skeletons that lie along other axes are turned back, whichever of the 24 orientations their file has.
#include "lib/retarget/alignment.h"

#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace
{

using namespace claque;

// As joints of a body lie: no two orientations of them are alike.
const std::vector<glm::dvec3> places = {{0, 1, 0},        {0, 1.5, 0.05},    {0.3, 1.4, 0},   {0.7, 1.2, 0.1},
                                        {-0.25, 1.45, 0}, {-0.5, 1.0, 0.25}, {0.1, 0.5, 0.2}, {-0.1, 0.1, -0.1}};

// The signed permutations of the axes that keep their hand: a picture of the 24 orientations of a cube.
std::vector<glm::dmat3> orientations()
{
    std::vector<glm::dmat3> out;
    for (const std::array<int, 3> &axes :
         std::vector<std::array<int, 3>>{{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}})
        for (int signs = 0; signs < 8; ++signs) {
            glm::dmat3 m(0);
            for (int k = 0; k < 3; ++k) m[k][axes[size_t(k)]] = signs >> k & 1 ? -1 : 1;
            if (glm::dot(glm::cross(m[0], m[1]), m[2]) > 0) out.push_back(m);
        }
    return out;
}

TEST(Alignment, TurnsASkeletonOfEachOrientationBack)
{
    const std::vector<glm::dmat3> all = orientations();
    ASSERT_EQ(all.size(), 24u);
    std::vector<retarget::JointMatch> matches(places.size());
    for (uint32_t i = 0; i < matches.size(); ++i) {
        matches[i].source = matches[i].target = i;
        matches[i].above = i == 0 ? model::none : i - 1;
    }
    for (const glm::dmat3 &turned : all) {
        retarget::GlobalPose source, target;
        source.positions = places;
        for (const glm::dvec3 &place : places) target.positions.push_back(turned * place + glm::dvec3(3, -2, 5));
        const retarget::SkeletonAlignment found =
            retarget::align_skeletons(matches, target, source, retarget::common_axes(matches, target, source));
        EXPECT_NEAR(found.scale, 1, 1e-12);
        for (int k = 0; k < 3; ++k) {
            glm::dvec3 axis(0);
            axis[k] = 1;
            EXPECT_LT(glm::length(found.axes * axis - turned[k]), 1e-12) << "axis " << k;
        }
    }
}

}  // namespace
