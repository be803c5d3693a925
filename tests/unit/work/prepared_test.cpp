// Prepared files whose parts overlap are refused before they take the product of their numbers.
#include <gtest/gtest.h>

#include "attacks.h"
#include "lib/model/template_file.h"
#include "meshsplit/build.h"
#include "work_counter.h"

namespace claque::testing
{
namespace
{

uint64_t loading(size_t count)
{
    model::Template tmpl(std::pmr::get_default_resource());
    meshsplit::build(load(long_clips(1, 1, 1)), {}, tmpl);
    model::Level &level = tmpl.levels[0];
    const uint32_t index = level.indices[0];
    level.indices.assign(3 * count, index);
    for (size_t i = 0; i < count; ++i) {
        model::Surface &surface = level.surfaces.emplace_back(std::pmr::get_default_resource());
        surface.texture = level.surfaces[0].texture;
        surface.dirty = {0, static_cast<uint32_t>(3 * count)};
    }
    std::pmr::vector<uint8_t> bytes;
    model::save(tmpl, bytes);
    return blocks_entered([&] {
        model::Template loaded(std::pmr::get_default_resource());
        const Outcome outcome = outcome_of([&] { model::load(bytes.data(), bytes.size(), loaded); });
        EXPECT_EQ(outcome.status, CLQ_FORMAT);
        EXPECT_NE(outcome.text.find("ranges overlap"), std::string::npos) << outcome.text;
    });
}

TEST(PreparedWork, OfSurfacesOnTheSameIndicesGrowsWithTheFile)
{
    const uint64_t few = loading(300), many = loading(3000);
    EXPECT_LE(many, 16 * few);
}

}  // namespace
}  // namespace claque::testing
