// The law of zones on sheets that meshsplit splits: awkward keys, wrap modes and image sizes.
#include "tests/gl/support/driver.h"
#include "tests/gl/support/fixture.h"
#include "tests/gl/support/law_fixture.h"
#include "tests/gl/support/split.h"

namespace gltest
{
namespace
{

using SplitLaw = LawTest;

// Awkward keys of a file: from 0 on or up to 255 with gaps of 1; or wide apart.
std::vector<uint8_t> awkward_keys(uint32_t count, int first, int step)
{
    std::vector<uint8_t> keys;
    for (uint32_t i = 0; i < count; ++i) keys.push_back(static_cast<uint8_t>(first + int(i) * step));
    return keys;
}

TEST_P(SplitLaw, HoldsForKeysFromNoughtWithGapsOfOne)
{
    const std::vector<uint32_t> all = {2, 8, 10, 16, 48}, few = {10};
    for (const uint32_t zones : on_softpipe() ? few : all)
        for (const std::vector<uint8_t> &keys :
             {awkward_keys(zones, 0, 1), awkward_keys(zones, 256 - int(zones), 1), awkward_keys(zones, 255, -5)}) {
            SCOPED_TRACE(testing::Message() << zones << " zones from key " << int(keys[0]));
            const model::Model source = model_of(sheet(9, 0.2f), torture_map(128, zones, 3), keys, model::Wrap::repeat);
            hold(split_posed(source), source);
        }
}

TEST_P(SplitLaw, HoldsForWrappedAndClampedTextures)
{
    Mesh mesh = sheet(7, 0.2f);
    for (glm::vec2 &uv : mesh.uvs) uv = 2.7f * uv - glm::vec2(0.83f, 0.61f);
    for (const model::Wrap wrap : {model::Wrap::repeat, model::Wrap::clamp, model::Wrap::mirror}) {
        SCOPED_TRACE(testing::Message() << "wrap " << int(wrap));
        const model::Model source = model_of(mesh, torture_map(64, 8, 3), awkward_keys(8, 0, 1), wrap);
        hold(split_posed(source), source);
    }
}

TEST_P(SplitLaw, HoldsForImagesThatHaveToBeResized)
{
    Mesh beyond = sheet(7, 0.2f), within = sheet(7, 0.2f);
    for (glm::vec2 &uv : beyond.uvs) uv = 2.7f * uv - glm::vec2(0.83f, 0.61f);
    for (glm::vec2 &uv : within.uvs) uv = 0.4f * uv + glm::vec2(0.17f, 0.31f);  // most texels are seen by nothing
    for (const Mesh &mesh : {sheet(7, 0.2f), beyond, within})
        for (const model::Wrap wrap : {model::Wrap::repeat, model::Wrap::clamp, model::Wrap::mirror})
            for (const uint32_t side : {100u, 1u}) {
                SCOPED_TRACE(testing::Message() << "side " << side << ", wrap " << int(wrap));
                const uint32_t zones = side > 1 ? 8 : 1;
                const model::Model source =
                    model_of(mesh, torture_map(side, zones, zones > 1 ? 3 : 1), awkward_keys(zones, 1, 9), wrap);
                hold(split_posed(source), source);
            }
}

TEST_P(SplitLaw, GivesTheSamePixelsByEveryStrategyWhereDepthsTie)
{
    Mesh twice = sheet(7, 0.2f);
    const Mesh once = twice;
    const uint32_t count = static_cast<uint32_t>(once.positions.size());
    for (uint32_t v = 0; v < count; ++v) {
        twice.positions.push_back(once.positions[v]), twice.normals.push_back(once.normals[v]);
        twice.uvs.push_back(once.uvs[v] + glm::vec2(0.37f, 0.21f));  // other zones in the same place
    }
    for (const auto &t : once.triangles) twice.triangles.push_back({t[0] + count, t[1] + count, t[2] + count});
    const PosedModel posed =
        split_posed(model_of(twice, torture_map(64, 8, 3), awkward_keys(8, 0, 1), model::Wrap::repeat));
    const std::vector<uint8_t> colours = zone_colours(posed.tmpl->zone_count());
    const Camera camera = camera_on(posed, 2.6f, -0.5f, 0.4f, 4.0f / 3.0f);
    ASSERT_NE(draw_ids(*context_, posed, camera, Order::forwards), draw_ids(*context_, posed, camera, Order::backwards))
        << "no depths tie";
    std::vector<Picture> pictures;
    for (const passes::Strategy strategy : all_strategies) {
        passes::Renderer renderer(std::pmr::get_default_resource(), options_of(strategy));
        ASSERT_TRUE(renderer.open(context_->get_proc_address(), context_->user()).ok());
        ASSERT_TRUE(renderer.prepare(*posed.tmpl).ok());
        pictures.push_back(draw(*context_, renderer, list_of(posed, camera, colours.data())));
        renderer.destroy();
        EXPECT_TRUE(pictures.back() == pictures.front()) << "strategy " << int(strategy);
    }
}

INSTANTIATE_TEST_SUITE_P(On, SplitLaw, testing::ValuesIn(targets()), name_of_target);

}  // namespace
}  // namespace gltest
