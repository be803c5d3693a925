// Skeletons that lie along other axes are turned back, whichever of the 24 orientations their file has.
#include "lib/retarget/alignment.h"

#include <algorithm>
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
    for (size_t i = 0; i < 72; ++i) {
        const glm::dmat3 &turned = all[i % 24];
        const double size = i < 24 ? 1 : i < 48 ? 0.01 : 300;
        retarget::GlobalPose source, target;
        for (const glm::dvec3 &place : places) {
            source.positions.push_back(size * place);
            target.positions.push_back(turned * (size * place) + glm::dvec3(3, -2, 5));
        }
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

// Also between opposite directions, whatever the lengths, which count for nothing.
TEST(Alignment, TurnsOneDirectionIntoAnotherByTheShortestTurn)
{
    std::vector<glm::dvec3> directions;
    for (int x = -1; x <= 1; ++x)
        for (int y = -1; y <= 1; ++y)
            for (int z = -1; z <= 1; ++z)
                if (x || y || z) directions.push_back(glm::normalize(glm::dvec3(x + 0.01 * y, y, z - 0.02 * x)));
    for (const double longer : {1e-7, 1.0, 1e7})
        for (const glm::dvec3 &from : directions)
            for (const glm::dvec3 &to : directions)
                for (const double sign : {1.0, -1.0}) {
                    const glm::dvec3 wanted = &from == &to ? sign * from : to;
                    const glm::dquat turn = retarget::rotation_between(longer * from, 3 * longer * wanted);
                    EXPECT_NEAR(glm::length(turn), 1, 1e-12);
                    EXPECT_LT(glm::length(turn * from - wanted), 1e-6);
                    const double angle = std::acos(std::clamp(glm::dot(from, wanted), -1.0, 1.0));
                    EXPECT_NEAR(2 * std::acos(std::min(1.0, std::fabs(turn.w))), angle, 1e-6);
                }
    for (const glm::dvec3 &other : {glm::dvec3(0), glm::dvec3(1, 2, 3)}) {
        EXPECT_EQ(retarget::rotation_between(glm::dvec3(0), other), glm::dquat(1, 0, 0, 0));
        EXPECT_EQ(retarget::rotation_between(other, glm::dvec3(0)), glm::dquat(1, 0, 0, 0));
    }
}

}  // namespace
