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
        [](model::Template &t) { t.levels[0].surfaces[0].lighting.emission[2] = 1.5f; },
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

// Each rule by itself: what it refuses passes all rules before it, and those after it would not say this.
TEST(TemplateFile, EachRuleOfATemplateIsCheckedAndNamed)
{
    using T = model::Template;
    constexpr float inf = std::numeric_limits<float>::infinity();
    const struct {
        const char *sentence;
        void (*breaks)(T &);
    } all[] = {
        {"have 2 rest transforms", [](T &t) { t.rig.rest.emplace_back(); }},
        {"has a rest transform that is not finite", [](T &t) { t.rig.rest[0].translation.y = inf; }},
        {"has a rotation of length", [](T &t) { t.rig.rest[0].rotation.w = 2; }},
        {"parents come before children", [](T &t) { t.rig.parents[0] = 0; }},
        {"palette entry 0 names node 1", [](T &t) { t.rig.palette[0].node = 1; }},
        {"an inverse bind matrix that is not finite", [](T &t) { t.rig.palette[0].inverse_bind.c[11] = inf; }},
        {"morph set 0 is out of range", [](T &t) { t.rig.morph_sets[0].node = 1; }},
        {"they overlap", [](T &t) { t.rig.morph_sets.push_back(t.rig.morph_sets[0]); }},
        {"1 clips have 2 names", [](T &t) { t.rig.clip_names.emplace_back("again"); }},
        {"a key time or key value is not finite", [](T &t) { t.rig.rest_weights[0] = inf; }},
        {"has channels out of range", [](T &t) { t.rig.clips[0].channel_count = 2; }},
        {"has an invalid length", [](T &t) { t.rig.clips[0].duration_s = -1; }},
        {"moves node or morph set 1", [](T &t) { t.rig.channels[0].node = 1; }},
        {"has 4 components a key", [](T &t) { t.rig.channels[0].component_count = 4; }},
        {"has no keys", [](T &t) { t.rig.channels[0].key_count = 0; }},
        {"needs 3 key times", [](T &t) { t.rig.channels[0].key_count = 3; }},
        {"do not ascend at key 1", [](T &t) { t.rig.times[1] = t.rig.times[0]; }},
        {"deactivation distances", [](T &t) { t.rig.deactivation_m.assign(2, 1); }},
        {"is deactivated from 0 m on", [](T &t) { t.rig.deactivation_m.assign(1, 0); }},
        {"a channel of target 0 and interpolation 9",
         [](T &t) { t.rig.channels[0].interpolation = static_cast<model::Interpolation>(9); }},
        {"zone colours: ", [](T &t) { t.zone_colours.pop_back(); }},
        {"zone ranges: ", [](T &t) { t.zone_ranges.pop_back(); }},
        {"clean counts of zones: ", [](T &t) { t.zone_clean.pop_back(); }},
        {"zone colour: number 2 is not finite", [](T &t) { t.zone_colours[1][2] = inf; }},
        {"zone range: number 0 is not finite", [](T &t) { t.zone_ranges[1].hue_min_deg = inf; }},
        {"neither repeats nor clamps", [](T &t) { t.textures[0].wrap_t = model::Wrap::mirror; }},
        {"texture 0 has no zones", [](T &t) { t.textures[0].keys.clear(); }},
        {"texture 0 has zone 3, which does not exist", [](T &t) { t.textures[0].keys[0].zone = 3; }},
        {"keys that do not ascend", [](T &t) { t.textures[0].keys[1].key = t.textures[0].keys[0].key; }},
        {"texture 0 is 3 x 4", [](T &t) { t.textures[0].width = 3; }},
        {"texture 0 is 4 x 0", [](T &t) { t.textures[0].height = 0; }},
        {"bytes of a texture", [](T &t) { t.textures[0].rgba.pop_back(); }},
        {"which is none of its zones'", [](T &t) { t.textures[0].rgba[3] = 1; }},
        {"images of a texture: 1 instead of 0",
         [](T &t) { t.textures[0].set_images.emplace_back(t.textures.get_allocator().resource()); }},
        {"vertices, of which", [](T &t) { t.levels[0].vertex_count += 1; }},
        {"positions: ", [](T &t) { t.levels[0].positions.pop_back(); }},
        {"normals: ", [](T &t) { t.levels[0].normals.pop_back(); }},
        {"texture coordinates: ", [](T &t) { t.levels[0].uvs.pop_back(); }},
        {"slots: ", [](T &t) { t.levels[0].slots.pop_back(); }},
        {"colours: ", [](T &t) { t.levels[0].colours.pop_back(); }},
        {"positions: number 1 is not finite", [](T &t) { t.levels[0].positions[1] = inf; }},
        {"normals: number 2 is not finite", [](T &t) { t.levels[0].normals[2] = inf; }},
        {"texture coordinates: number 3 is not finite", [](T &t) { t.levels[0].uvs[3] = inf; }},
        {"a vertex is a copy of vertex", [](T &t) { t.levels[0].copies[0] = t.levels[0].source_count; }},
        {"do not follow each other at vertex", [](T &t) { t.levels[0].runs[0].first = 1; }},
        {"the run of influences at vertex", [](T &t) { t.levels[0].runs[0].count += 1; }},
        {"weights: ", [](T &t) { t.levels[0].weights.pop_back(); }},
        {"weights: number 0 is not finite", [](T &t) { t.levels[0].weights[0] = inf; }},
        {"a vertex follows matrix 9", [](T &t) { t.levels[0].joints[1] = 9; }},
        {"a range of morph deltas of weight 1", [](T &t) { t.levels[0].morph_ranges[0].weight = 1; }},
        {"a range of morph deltas of weight 0", [](T &t) { t.levels[0].morph_ranges[0].count += 1; }},
        {"a morph delta is of vertex", [](T &t) { t.levels[0].morph_deltas[0].vertex = 4; }},
        {"morph delta: number 2 is not finite", [](T &t) { t.levels[0].morph_deltas[0].position[2] = inf; }},
        {"morph delta: number 0 is not finite", [](T &t) { t.levels[0].morph_deltas[0].normal[0] = inf; }},
        {"centre of the Sklsroot Bsphere: number 1", [](T &t) { t.sklsroot.centre.y = inf; }},
        {"the Sklsroot Bsphere has a radius of -1", [](T &t) { t.sklsroot.radius = -1; }},
        {"reaches of nodes: 2 instead of 1",
         [](T &t) {
             t.node_reach.assign(2, {1, 1});
         }},
        {"reaches -1 m and 1",
         [](T &t) {
             t.node_reach.assign(1, {-1, 1});
         }},
        {"reaches 1 m and inf",
         [](T &t) {
             t.node_reach.assign(1, {1, inf});
         }},
        {"blended poses have a radius of -1 m", [](T &t) { t.blend_radius.base = -1; }},
        {"and inf m per weight", [](T &t) { t.blend_radius.per_weight = inf; }},
        {"reaches of blended nodes: 2 instead of 1", [](T &t) { t.blend_reach.resize(2); }},
        {"reaches 2 m and -3",
         [](T &t) {
             t.blend_reach.resize(1), t.blend_reach[0].distance = {2, -3};
         }},
        {"reaches -2 m and 3",
         [](T &t) {
             t.blend_reach.resize(1), t.blend_reach[0].scale = {-2, 3};
         }},
    };
    for (const auto &one : all) {
        const auto tmpl = built(everything());
        model::check(*tmpl);
        one.breaks(*tmpl);
        std::string said = "taken";
        try {
            model::check(*tmpl);
        } catch (const base::Error &error) {
            said = error.what();
        }
        EXPECT_NE(said.find(one.sentence), std::string::npos) << said << " where expected: " << one.sentence;
        EXPECT_EQ(outcome(saved(*tmpl)), CLQ_FORMAT) << one.sentence;
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
