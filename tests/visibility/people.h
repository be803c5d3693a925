// A few individuals before a camera, drawn as a visibility picture in an offscreen context.
#pragma once

#include <claque/visibility.h>

#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "samples/contexts/offscreen.h"
#include "samples/scenes/check.h"
#include "samples/scenes/library.h"

namespace visibility_test
{

struct Channels {
    std::vector<uint32_t> individuals, actors, parts, zones, triangles;
    std::vector<float> barycentric, depth_m, normals;
    std::vector<double> positions;
};

// Skips the test where this machine has no software GL.
class People : public testing::Test
{
protected:
    static constexpr int width = 64, height = 48;

    void SetUp() override;
    void TearDown() override;

    // Individuals of all built-in characters, placed, posed and seen at random; levels as the distance asks for them.
    void place(uint64_t seed, size_t count);
    void update(double time_s);
    // The numbers, rows from the bottom.
    const std::vector<uint32_t> &draw(const clq_visibility_def &def = clq_visibility_def_init());
    clq_pixels pixels() const;
    Channels channels() const;

    std::unique_ptr<contexts::Offscreen> context_;
    scenes::Library library_{1};
    scenes::Own<clq_crowd> crowd_;
    clq_view *view_ = nullptr;
    scenes::Own<clq_renderer> renderer_;
    clq_camera camera_ = {};
    std::vector<clq_actor> actors_;
    std::vector<uint32_t> numbers_;
    uint32_t first_number_ = 1;
};

}  // namespace visibility_test
