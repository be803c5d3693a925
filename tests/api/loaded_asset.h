// Assets from bytes of a test, and what is found in them.
#pragma once

#include <claque/assets.h>
#include <claque/track.h>

#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace loaded
{

struct Destroy {
    void operator()(clq_context *context) const { EXPECT_EQ(clq_context_destroy(context), CLQ_OK) << clq_last_error(); }
    void operator()(clq_asset *asset) const { clq_asset_destroy(asset); }
    void operator()(clq_template *tmpl) const { clq_template_destroy(tmpl); }
    void operator()(clq_locomotion *locomotion) const { clq_locomotion_destroy(locomotion); }
};
template <class Thing>
using Own = std::unique_ptr<Thing, Destroy>;
using Bytes = std::vector<uint8_t>;

class Loading : public testing::Test
{
protected:
    Loading()
    {
        clq_context *made = nullptr;
        EXPECT_EQ(clq_context_create(nullptr, &made), CLQ_OK);
        context_.reset(made);
    }
    // NULL, and the message, where it is refused.
    Own<clq_asset> load(const Bytes &bytes, const clq_asset_options &options = clq_asset_options_init())
    {
        clq_asset *made = nullptr;
        said_ = clq_asset_load(context_.get(), bytes.data(), bytes.size(), &options, &made) == CLQ_OK
                    ? ""
                    : clq_last_error();
        return Own<clq_asset>(made);
    }
    Own<clq_asset> load_file(const std::string &path, const clq_asset_options &options = clq_asset_options_init())
    {
        clq_asset *made = nullptr;
        EXPECT_EQ(clq_asset_load_file(context_.get(), path.c_str(), &options, &made), CLQ_OK) << clq_last_error();
        return Own<clq_asset>(made);
    }
    static clq_asset_info info_of(const clq_asset *asset)
    {
        clq_asset_info info = clq_asset_info_init();
        EXPECT_EQ(clq_asset_get_info(asset, &info), CLQ_OK) << clq_last_error();
        return info;
    }
    static std::vector<float> positions(const clq_asset *asset, uint32_t clip, float time_s)
    {
        std::vector<float> xyz(3 * size_t(info_of(asset).vertex_count));
        EXPECT_EQ(clq_asset_get_positions(asset, clip, time_s, xyz.data(), xyz.size()), CLQ_OK) << clq_last_error();
        return xyz;
    }
    static double height_of(const clq_asset *asset)
    {
        const clq_asset_info info = info_of(asset);
        return double(info.box_max[1]) - double(info.box_min[1]);
    }
    static std::string warnings(const clq_asset *asset)
    {
        std::string all;
        for (uint32_t i = 0; i < info_of(asset).warning_count; ++i)
            all += std::string(clq_asset_get_warning(asset, i)) + "\n";
        return all;
    }
    Own<clq_template> build(const clq_asset *asset)
    {
        clq_template *made = nullptr;
        EXPECT_EQ(clq_asset_build(context_.get(), asset, 0, &made), CLQ_OK) << clq_last_error();
        return Own<clq_template>(made);
    }

    Own<clq_context> context_;
    std::string said_;
};

}  // namespace loaded
