// Templates from a host's own arrays: errors are named; valid templates survive saving and loading.
#include <claque/claque.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/api/calls.h"
#include "tests/api/small_template.h"

namespace
{

int append(void *user, const void *bytes, size_t size)
{
    std::vector<char> &out = *static_cast<std::vector<char> *>(user);
    out.insert(out.end(), static_cast<const char *>(bytes), static_cast<const char *>(bytes) + size);
    return 0;
}

class Templates : public testing::Test
{
protected:
    void SetUp() override { ASSERT_EQ(clq_context_create(nullptr, &context_), CLQ_OK); }
    void TearDown() override { EXPECT_EQ(clq_context_destroy(context_), CLQ_OK); }

    // The status of building the small template with one change; the error text names `word`.
    void refused(const std::function<void(SmallTemplate &)> &change, clq_status wanted, const char *word)
    {
        SmallTemplate small;
        change(small);
        clq_template *tmpl = nullptr;
        EXPECT_EQ(clq_template_build(context_, &small.def, &tmpl), wanted) << clq_last_error();
        EXPECT_EQ(tmpl, nullptr);
        EXPECT_NE(std::string(clq_last_error()).find(word), std::string::npos) << clq_last_error();
    }

    clq_context *context_ = nullptr;
};

}  // namespace

// A prepared file gives the warning again.
TEST_F(Templates, PartsThatAreCulledAsOneAndTrianglesOnOthersAreLogged)
{
    std::string log;
    clq_context_def def = clq_context_def_init();
    def.log = {&log, [](void *user, clq_log_level level, const char *text) {
                   *static_cast<std::string *>(user) += std::string(level == CLQ_LOG_WARNING ? "W: " : "I: ") + text;
               }};
    clq_context *context = nullptr;
    ASSERT_EQ(clq_context_create(&def, &context), CLQ_OK);
    for (const uint32_t count : {64u, 65u}) {
        SmallTemplate small;
        const std::vector<clq_part_def> parts(count, small.parts[0]);
        small.def.parts = parts.data(), small.def.part_count = count;
        clq_template *tmpl = nullptr, *again = nullptr;
        log.clear();
        ASSERT_EQ(clq_template_build(context, &small.def, &tmpl), CLQ_OK) << clq_last_error();
        const std::string said = log;
        EXPECT_EQ(
            said.find("I: template 'strip': a level has 65 parts, and 64 can be culled by themselves") != said.npos,
            count > 64)
            << said;
        EXPECT_NE(said.find(" triangles lie on another with the same corners"), said.npos) << said;
        EXPECT_NE(said.find("W: template 'strip': "), said.npos) << said;
        std::vector<char> bytes;
        ASSERT_EQ(clq_template_save(tmpl, append, &bytes), CLQ_OK) << clq_last_error();
        log.clear();
        ASSERT_EQ(clq_template_load(context, bytes.data(), bytes.size(), &again), CLQ_OK) << clq_last_error();
        EXPECT_EQ(log, said.substr(0, said.find("I: ")));
        clq_template_destroy(tmpl), clq_template_destroy(again);
    }
    EXPECT_EQ(clq_context_destroy(context), CLQ_OK);
}

TEST_F(Templates, TheFirstBrokenRuleIsNamed)
{
    refused([](SmallTemplate &s) { s.nodes[0].parent = 1; }, CLQ_ARGUMENT, "root");
    refused([](SmallTemplate &s) { s.joints[1].node = 9; }, CLQ_ARGUMENT, "9");
    refused([](SmallTemplate &s) { s.zones[1].key = 300; }, CLQ_ARGUMENT, "skin");
    refused([](SmallTemplate &s) { s.zones[1].key = 201; }, CLQ_ARGUMENT, "200");
    refused([](SmallTemplate &s) { s.images[0].width_px = 0; }, CLQ_ARGUMENT, "strip");
    refused([](SmallTemplate &s) { s.materials[0].image = 3; }, CLQ_ARGUMENT, "image 3");
    refused([](SmallTemplate &s) { s.parts[0].material = 2; }, CLQ_ARGUMENT, "material 2");
    refused([](SmallTemplate &s) { s.parts[0].index_count = 23; }, CLQ_ARGUMENT, "23");
    refused([](SmallTemplate &s) { const_cast<uint32_t *>(s.parts[0].indices)[3] = 77; }, CLQ_ARGUMENT, "77");
    refused([](SmallTemplate &s) { const_cast<float *>(s.parts[0].weights)[4] = 0.1f; }, CLQ_ARGUMENT, "sum");
    refused([](SmallTemplate &s) { const_cast<uint32_t *>(s.parts[0].joints)[0] = 5; }, CLQ_ARGUMENT, "joint 5");
    refused(
        [](SmallTemplate &s) { const_cast<float *>(s.parts[0].positions)[0] = std::numeric_limits<float>::infinity(); },
        CLQ_ARGUMENT, "finite");
    refused([](SmallTemplate &s) { s.channels[0].node = 4; }, CLQ_ARGUMENT, "channel 0");
    refused([](SmallTemplate &s) { const_cast<float *>(s.channels[0].times_s)[1] = 0; }, CLQ_ARGUMENT, "ascend");
    refused([](SmallTemplate &s) { s.clips[0].channels = nullptr; }, CLQ_ARGUMENT, "channels");
    refused([](SmallTemplate &s) { s.def.struct_bytes = 8; }, CLQ_STRUCT_SIZE, "clq_template_def_init");
}

TEST_F(Templates, FactsOfTheSplitAreThoseOfTheStrip)
{
    SmallTemplate small;
    clq_template *tmpl = nullptr;
    ASSERT_EQ(clq_template_build(context_, &small.def, &tmpl), CLQ_OK) << clq_last_error();
    clq_template_info info = clq_template_info_init();
    ASSERT_EQ(clq_template_get_info(tmpl, &info), CLQ_OK);
    EXPECT_EQ(info.triangle_count, 8u);
    EXPECT_EQ(info.dirty_count, 8u) << "every triangle spans both halves of the texture";
    EXPECT_FLOAT_EQ(info.dirty_zone_mean, 2);
    EXPECT_EQ(info.fused_triangle_count, 16u);
    EXPECT_EQ(info.zone_count, 2u);
    EXPECT_EQ(info.clip_count, 1u);
    EXPECT_EQ(info.vertex_count, 10u);
    EXPECT_EQ(info.fused_vertex_count, 20u) << "each vertex once per zone";
    EXPECT_EQ(info.max_influences, 2u);
    EXPECT_GE(info.sklsroot_radius, 1.0f);
    EXPECT_LE(info.sklsroot_radius, 1.5f);
    clq_clip_info clip = clq_clip_info_init();
    ASSERT_EQ(clq_template_get_clip(tmpl, clq_template_find_clip(tmpl, "bend"), &clip), CLQ_OK);
    EXPECT_FLOAT_EQ(clip.duration_s, 1);
    EXPECT_EQ(clq_template_get_clip(tmpl, 1, &clip), CLQ_ARGUMENT);
    clq_zone_info zone = clq_zone_info_init();
    ASSERT_EQ(clq_template_get_zone(tmpl, clq_template_find_zone(tmpl, "skin"), &zone), CLQ_OK);
    EXPECT_FLOAT_EQ(zone.colour[1], 0.7f);
    EXPECT_EQ(clq_template_find_node(tmpl, "tip"), 1u);
    EXPECT_EQ(clq_template_find_node(tmpl, "nobody"), CLQ_NONE);
    clq_template_destroy(tmpl);
}

TEST_F(Templates, APreparedTemplateComesBackTheSameAndADamagedOneDoesNot)
{
    SmallTemplate small;
    clq_template *tmpl = nullptr, *again = nullptr;
    ASSERT_EQ(clq_template_build(context_, &small.def, &tmpl), CLQ_OK);
    std::vector<char> first, second;
    ASSERT_EQ(clq_template_save(tmpl, append, &first), CLQ_OK);
    ASSERT_EQ(clq_template_load(context_, first.data(), first.size(), &again), CLQ_OK) << clq_last_error();
    ASSERT_EQ(clq_template_save(again, append, &second), CLQ_OK);
    EXPECT_EQ(first, second);
    clq_template_destroy(again);
    clq_template_destroy(tmpl);
    for (size_t size = 0; size < first.size(); ++size)
        ASSERT_EQ(clq_template_load(context_, first.data(), size, &again), CLQ_FORMAT)
            << size << " bytes of " << first.size();
    for (size_t at = 0; at < first.size(); at += 3) {
        std::vector<char> damaged = first;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
        ASSERT_EQ(clq_template_load(context_, damaged.data(), damaged.size(), &again), CLQ_FORMAT) << "byte " << at;
    }
}

TEST_F(Templates, AWriterThatRefusesIsAnIoError)
{
    SmallTemplate small;
    clq_template *tmpl = nullptr;
    ASSERT_EQ(clq_template_build(context_, &small.def, &tmpl), CLQ_OK);
    EXPECT_EQ(clq_template_save(
                  tmpl, [](void *, const void *, size_t) { return 1; }, nullptr),
              CLQ_IO);
    clq_template_destroy(tmpl);
}

TEST_F(Templates, ATextureReturnsItsTexelsAndTheirZones)
{
    SmallTemplate small;
    clq_template *tmpl = nullptr;
    ASSERT_EQ(clq_template_build(context_, &small.def, &tmpl), CLQ_OK);
    uint32_t width = 0, height = 0;
    ASSERT_EQ(api_test::get_texture(tmpl, 0, 0, nullptr, nullptr, 0, &width, &height), CLQ_OK);
    EXPECT_EQ(width, 8u);
    EXPECT_EQ(height, 8u);
    std::vector<uint8_t> rgb(3 * 64, 7);
    std::vector<uint32_t> zones(64, 77);
    EXPECT_EQ(api_test::get_texture(tmpl, 0, 0, rgb.data(), zones.data(), 63, &width, &height), CLQ_ARGUMENT);
    EXPECT_EQ(rgb, std::vector<uint8_t>(3 * 64, 7)) << "nothing is written on failure";
    EXPECT_EQ(api_test::get_texture(tmpl, 0, 1, rgb.data(), zones.data(), 64, &width, &height), CLQ_ARGUMENT);
    EXPECT_EQ(api_test::get_texture(nullptr, 0, 0, rgb.data(), zones.data(), 64, &width, &height), CLQ_ARGUMENT);
    ASSERT_EQ(api_test::get_texture(tmpl, 0, 0, rgb.data(), zones.data(), 64, &width, &height), CLQ_OK);
    EXPECT_EQ(rgb, std::vector<uint8_t>(3 * 64, 255));
    for (size_t i = 0; i < 64; ++i) EXPECT_EQ(zones[i], i % 8 < 4 ? 0u : 1u) << "texel " << i;
    EXPECT_EQ(api_test::get_texture(tmpl, 0, 0, nullptr, zones.data(), 64, &width, &height), CLQ_OK);
    clq_template_destroy(tmpl);
}

TEST_F(Templates, TheSplitPictureIsAsLargeAsSaid)
{
    SmallTemplate small;
    clq_template *tmpl = nullptr;
    ASSERT_EQ(clq_template_build(context_, &small.def, &tmpl), CLQ_OK);
    uint32_t width = 0, height = 0;
    ASSERT_EQ(api_test::get_split_picture(tmpl, 0, 4, nullptr, 0, &width, &height), CLQ_OK);
    EXPECT_EQ(width, 32u);
    EXPECT_EQ(height, 32u);
    std::vector<uint8_t> rgb(3 * 32 * 32);
    EXPECT_EQ(api_test::get_split_picture(tmpl, 0, 4, rgb.data(), rgb.size() - 1, &width, &height), CLQ_ARGUMENT);
    EXPECT_EQ(api_test::get_split_picture(tmpl, 0, 4, rgb.data(), rgb.size(), &width, &height), CLQ_OK);
    EXPECT_NE(std::vector<uint8_t>(3 * 32 * 32), rgb);
    EXPECT_EQ(api_test::get_split_picture(tmpl, 1, 1, nullptr, 0, &width, &height), CLQ_ARGUMENT);
    EXPECT_EQ(api_test::get_split_picture(tmpl, 0, 0, nullptr, 0, &width, &height), CLQ_ARGUMENT);
    clq_template_destroy(tmpl);
}
