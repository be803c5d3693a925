// Texture sets through the C API: which actor shows which set, chosen or at random, and refusals.
#include <claque/claque.h>

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/api/calls.h"
#include "tests/api/saved_bytes.h"
#include "tests/api/small_template.h"

namespace
{

class TextureSet : public testing::Test
{
protected:
    void SetUp() override
    {
        ASSERT_EQ(clq_context_create(nullptr, &context_), CLQ_OK);
        build();
        clq_crowd_def def = clq_crowd_def_init();
        def.seed = 5;
        ASSERT_EQ(clq_crowd_create(context_, &def, &crowd_), CLQ_OK);
    }
    void TearDown() override
    {
        clq_crowd_destroy(crowd_);
        clq_template_destroy(tmpl_);
        clq_context_destroy(context_);
    }

    // The strip with two further sets: one 4 x 4 and all cloth, one that changes nothing.
    void build()
    {
        all_cloth_.assign(4 * 4 * 4, 60);
        for (size_t i = 3; i < all_cloth_.size(); i += 4) all_cloth_[i] = 100;
        images_ = {small_.images[0], {"all cloth", 4, 4, all_cloth_.data(), CLQ_ALPHA_ZONE_KEYS}};
        sets_ = {{"plain", &first_}, {"same", &none_}};
        small_.def.image_count = 2, small_.def.images = images_.data();
        small_.def.texture_set_count = 2, small_.def.texture_sets = sets_.data();
        ASSERT_EQ(clq_template_build(context_, &small_.def, &tmpl_), CLQ_OK) << clq_last_error();
    }

    clq_status create(uint32_t set, uint64_t seed, clq_actor &out)
    {
        clq_actor_def def = clq_actor_def_init();
        def.tmpl = tmpl_, def.seed = seed, def.texture_set = set;
        return clq_actor_create(crowd_, &def, &out);
    }

    uint32_t set_of(clq_actor actor)
    {
        clq_actor_info info = clq_actor_info_init();
        EXPECT_EQ(clq_actor_get_info(crowd_, actor, &info), CLQ_OK);
        return info.texture_set;
    }

    SmallTemplate small_;
    const uint32_t first_ = 1, none_ = CLQ_NONE;
    std::vector<uint8_t> all_cloth_;
    std::vector<clq_image_def> images_;
    std::vector<clq_texture_set_def> sets_;
    clq_context *context_ = nullptr;
    clq_template *tmpl_ = nullptr;
    clq_crowd *crowd_ = nullptr;
};

}  // namespace

TEST_F(TextureSet, ATemplateKnowsItsSetsByNumberAndByName)
{
    clq_template_info info = clq_template_info_init();
    ASSERT_EQ(clq_template_get_info(tmpl_, &info), CLQ_OK);
    EXPECT_EQ(info.texture_set_count, 3u);
    EXPECT_STREQ(clq_template_get_texture_set_name(tmpl_, 0), "");
    EXPECT_STREQ(clq_template_get_texture_set_name(tmpl_, 1), "plain");
    EXPECT_STREQ(clq_template_get_texture_set_name(tmpl_, 9), "");
    EXPECT_EQ(clq_template_find_texture_set(tmpl_, "same"), 2u);
    EXPECT_EQ(clq_template_find_texture_set(tmpl_, "other"), CLQ_NONE);
}

TEST_F(TextureSet, TheTexelsOfEachSetCanBeRead)
{
    uint32_t width = 0, height = 0;
    std::vector<uint32_t> zones(64);
    std::vector<uint8_t> rgb(3 * 64);
    ASSERT_EQ(api_test::get_texture(tmpl_, 1, 0, rgb.data(), zones.data(), 64, &width, &height), CLQ_OK);
    EXPECT_EQ(width, 4u);
    EXPECT_EQ(height, 4u);
    for (uint32_t i = 0; i < 16; ++i) {
        EXPECT_EQ(zones[i], 0u) << i;
        EXPECT_EQ(rgb[3 * i], 60) << i;
    }
    ASSERT_EQ(api_test::get_texture(tmpl_, 2, 0, rgb.data(), zones.data(), 64, &width, &height), CLQ_OK);
    EXPECT_EQ(width, 8u);
    EXPECT_EQ(zones[7], 1u);
    EXPECT_EQ(api_test::get_texture(tmpl_, 3, 0, nullptr, nullptr, 0, &width, &height), CLQ_ARGUMENT);
    EXPECT_NE(std::string(clq_last_error()).find("texture set 3 does not exist: 'strip' has 3"), std::string::npos);
}

TEST_F(TextureSet, AnIndividualShowsItsSetAndKeepsItWhenAnotherIsRefused)
{
    clq_actor actor = {};
    ASSERT_EQ(create(0, 1, actor), CLQ_OK);
    EXPECT_EQ(set_of(actor), 0u);
    ASSERT_EQ(clq_actor_set_texture_set(crowd_, actor, 2), CLQ_OK);
    EXPECT_EQ(set_of(actor), 2u);
    EXPECT_EQ(clq_actor_set_texture_set(crowd_, actor, 3), CLQ_ARGUMENT);
    EXPECT_NE(std::string(clq_last_error()).find("texture set 3 does not exist: template 'strip' has 3"),
              std::string::npos);
    EXPECT_EQ(set_of(actor), 2u);
    clq_actor twin = {};
    ASSERT_EQ(clq_actor_clone(crowd_, actor, nullptr, 9, &twin), CLQ_OK);
    EXPECT_EQ(set_of(twin), 2u);
    EXPECT_EQ(create(3, 1, twin), CLQ_ARGUMENT);
    EXPECT_EQ(clq_crowd_get_actor_count(crowd_), 2u);
    ASSERT_EQ(clq_actor_destroy(crowd_, actor), CLQ_OK);
    EXPECT_EQ(clq_actor_set_texture_set(crowd_, actor, 0), CLQ_STALE_ID);
}

TEST_F(TextureSet, AtRandomTheSeedDecidesAndEverySetGetsItsShare)
{
    uint32_t counts[3] = {0, 0, 0};
    for (uint64_t seed = 0; seed < 3000; ++seed) {
        clq_actor actor = {}, twin = {};
        ASSERT_EQ(create(CLQ_RANDOM, seed, actor), CLQ_OK);
        ASSERT_LT(set_of(actor), 3u);
        ++counts[set_of(actor)];
        if (seed % 100 != 0) continue;
        ASSERT_EQ(create(0, seed, twin), CLQ_OK);
        ASSERT_EQ(clq_actor_set_texture_set(crowd_, twin, CLQ_RANDOM), CLQ_OK);
        EXPECT_EQ(set_of(twin), set_of(actor)) << "seed " << seed;
    }
    // Five standard deviations of a binomial of 3000 samples at 1/3 are 129.
    for (const uint32_t count : counts) EXPECT_NEAR(count, 1000, 129);
}

TEST_F(TextureSet, ASavedCrowdKeepsThem)
{
    std::vector<clq_actor> actors(40);
    for (size_t i = 0; i < actors.size(); ++i) ASSERT_EQ(create(CLQ_RANDOM, i, actors[i]), CLQ_OK);
    std::vector<uint32_t> sets;
    for (const clq_actor actor : actors) sets.push_back(set_of(actor));
    const saved::Bytes bytes = saved::save(crowd_);
    for (const clq_actor actor : actors) ASSERT_EQ(clq_actor_set_texture_set(crowd_, actor, 0), CLQ_OK);
    ASSERT_NE(saved::save(crowd_), bytes);
    clq_template *const templates[] = {tmpl_};
    ASSERT_EQ(clq_crowd_restore(crowd_, bytes.data(), bytes.size(), templates, 1), CLQ_OK) << clq_last_error();
    for (size_t i = 0; i < actors.size(); ++i) EXPECT_EQ(set_of(actors[i]), sets[i]) << i;
    EXPECT_EQ(saved::save(crowd_), bytes);
}

TEST_F(TextureSet, APreparedTemplateKeepsThem)
{
    std::vector<uint8_t> bytes;
    const auto append = [](void *user, const void *more, size_t size) {
        auto *all = static_cast<std::vector<uint8_t> *>(user);
        all->insert(all->end(), static_cast<const uint8_t *>(more), static_cast<const uint8_t *>(more) + size);
        return 0;
    };
    ASSERT_EQ(clq_template_save(tmpl_, append, &bytes), CLQ_OK);
    clq_template *again = nullptr;
    ASSERT_EQ(clq_template_load(context_, bytes.data(), bytes.size(), &again), CLQ_OK) << clq_last_error();
    EXPECT_EQ(clq_template_find_texture_set(again, "plain"), 1u);
    uint32_t width = 0, height = 0;
    EXPECT_EQ(api_test::get_texture(again, 1, 0, nullptr, nullptr, 0, &width, &height), CLQ_OK);
    EXPECT_EQ(width, 4u);
    clq_template_destroy(again);
}

TEST_F(TextureSet, ATemplateWhoseSetsBreakARuleIsRefused)
{
    const auto refused = [&](const char *why) {
        clq_template *made = nullptr;
        EXPECT_EQ(clq_template_build(context_, &small_.def, &made), CLQ_ARGUMENT) << why;
        EXPECT_NE(std::string(clq_last_error()).find(why), std::string::npos) << clq_last_error();
    };
    const uint32_t far = 9;
    sets_[0].images = &far;
    refused("texture set 'plain' has image 9, which does not exist (there are 2), for material 0 'strip'");
    sets_[0].images = nullptr;
    refused("images of a texture set is NULL");
    small_.def.texture_sets = nullptr;
    refused("texture_sets is NULL with a count of 2");
}
