// Prepared files: a file loads as it was saved, and invalid files are refused.
#include <limits>

#include "prepared_files.h"

namespace claque::test
{

namespace
{

// A character with something of everything: zones, dirty triangles, copies, clips, morphs, colours.
model::Model everything()
{
    model::Model m = torture(3, 0, 40);
    m.images[0] = key_image(4, 4, [](uint32_t x, uint32_t y) { return uint8_t((x + y) % 3 * 40); });
    m.parts[0] = sheet_part(1, 1);
    m.parts[0].colours.assign(4, {1, 2, 3, 4});
    m.rig.morph_sets.push_back({0, 0, 1});
    m.rig.rest_weights = {0.5f};
    m.parts[0].morph_set = 0;
    m.parts[0].morphs.resize(1);
    m.parts[0].morphs[0].positions.assign(4, glm::vec3(0, 0, 1));
    m.rig.clips.push_back({0, 1, 0, 1});
    m.rig.clip_names.emplace_back("grow");
    m.rig.times = {0, 1};
    m.rig.values = {0, 0, 0, 1, 2, 3};
    m.rig.channels.push_back({0, model::ChannelTarget::translation, model::Interpolation::linear, 3, 0, 2, 0});
    return m;
}

}  // namespace

TEST(TemplateFile, SavedLoadedAndSavedAgainIsTheSameBytes)
{
    for (const model::Model &m : {everything(), torture(16, 3, 5), puppet_in_levels()}) {
        const Bytes first = saved(*built(m));
        model::Template loaded(std::pmr::get_default_resource());
        model::load(first.data(), first.size(), loaded);
        EXPECT_EQ(saved(loaded), first);
        EXPECT_EQ(loaded.report.triangles, built(m)->report.triangles);
        EXPECT_EQ(loaded.name, std::string_view(m.name));
    }
}

TEST(TemplateFile, IsRefusedWhenCutAtAnyByteOrLonger)
{
    Bytes bytes = saved(*built(everything()));
    for (size_t size = 0; size < bytes.size(); ++size)
        ASSERT_EQ(outcome(Bytes(bytes.begin(), bytes.begin() + ptrdiff_t(size))), CLQ_FORMAT) << size;
    bytes.push_back(0);
    EXPECT_EQ(outcome(bytes), CLQ_FORMAT);
}

TEST(TemplateFile, IsRefusedWhenAnyByteIsChanged)
{
    const Bytes bytes = saved(*built(everything()));
    for (size_t i = 0; i < bytes.size(); ++i) {
        Bytes changed = bytes;
        changed[i] ^= uint8_t(1 + base::mix(i) % 255);
        ASSERT_EQ(outcome(changed), CLQ_FORMAT) << i;
    }
}

TEST(TemplateFile, CutShortWithAForgedHashIsRefused)
{
    const Bytes bytes = saved(*built(everything()));
    for (size_t size = 33; size < bytes.size(); ++size) {
        Bytes cut(bytes.begin(), bytes.begin() + ptrdiff_t(size));
        for (size_t i = 0; i < 8; ++i) cut[16 + i] = uint8_t((size - 32) >> (8 * i));
        forge_hash(cut);
        ASSERT_EQ(outcome(cut), CLQ_FORMAT) << size;
    }
}

TEST(TemplateFile, ChangedWithAForgedHashIsRefusedOrSafe)
{
    const auto try_all = [](const Bytes &bytes, size_t step) {
        size_t refused = 0;
        for (size_t i = 32; i < bytes.size(); i += step)
            for (const uint8_t value : {uint8_t(0xff), uint8_t(0x80), uint8_t(0), uint8_t(bytes[i] + 1)}) {
                Bytes changed = bytes;
                changed[i] = value;
                forge_hash(changed);
                const clq_status status = outcome(changed);
                EXPECT_TRUE(status == CLQ_OK || status == CLQ_FORMAT) << i;
                refused += status == CLQ_FORMAT;
            }
        return refused;
    };
    const Bytes small = saved(*built(everything()));
    EXPECT_GT(try_all(small, 1), small.size() / 2);
    const Bytes large = saved(*built(puppet_in_levels()));
    EXPECT_GT(try_all(large, 17), large.size() / 17 / 2);
}

TEST(TemplateFile, ATemplateThatWouldReadOutOfRangeIsRefused)
{
    const std::vector<void (*)(model::Template &)> breaks = {
        [](model::Template &t) { t.levels[0].joints[1] = 9; },
        [](model::Template &t) { t.levels[0].indices[0] = t.levels[0].source_count; },
        [](model::Template &t) { t.levels[0].indices.back() = t.levels[0].vertex_count; },
        [](model::Template &t) { t.levels[0].copies[0] = t.levels[0].source_count; },
        [](model::Template &t) { t.levels[0].slots[0] = 6; },
        [](model::Template &t) { t.levels[0].runs[0].count += 1; },
        [](model::Template &t) { t.levels[0].morph_deltas[0].vertex = 4; },
        [](model::Template &t) { t.levels[0].morph_ranges[0].weight = 1; },
        [](model::Template &t) { t.levels[0].surfaces[0].texture = 1; },
        [](model::Template &t) { t.levels[0].surfaces[0].fused.count += 3; },
        [](model::Template &t) { t.levels[0].uvs[3] = std::numeric_limits<float>::infinity(); },
        [](model::Template &t) { t.levels[0].colours.pop_back(); },
        [](model::Template &t) { t.textures[0].rgba[3] = 1; },
        [](model::Template &t) { t.textures[0].keys[0].zone = 3; },
        [](model::Template &t) { t.textures[0].rgba.pop_back(); },
        [](model::Template &t) { t.rig.palette[0].node = 1; },
        [](model::Template &t) { t.rig.channels[0].first_value = 1; },
        [](model::Template &t) { t.zone_colours.pop_back(); },
        [](model::Template &t) { t.levels.clear(); },
    };
    for (size_t i = 0; i < breaks.size(); ++i) {
        const auto tmpl = built(everything());
        model::check(*tmpl);
        breaks[i](*tmpl);
        EXPECT_THROW(model::check(*tmpl), base::Error) << i;
        EXPECT_EQ(outcome(saved(*tmpl)), CLQ_FORMAT) << i;
    }
}

TEST(TemplateFile, OfAnotherVersionIsRefusedByNumber)
{
    Bytes bytes = saved(*built(everything()));
    bytes[8] = 99;
    model::Template out(std::pmr::get_default_resource());
    try {
        model::load(bytes.data(), bytes.size(), out);
        FAIL();
    } catch (const base::Error &error) {
        EXPECT_NE(std::string(error.what()).find("version 99"), std::string::npos) << error.what();
    }
}

}  // namespace claque::test
