// A crowd that is captured before and after one change of it.
#pragma once

#include <algorithm>
#include <filesystem>
#include <unistd.h>

#include <gtest/gtest.h>

#include "samples/parity/compare.h"
#include "samples/parity/verdict.h"
#include "samples/parity/write/write.h"
#include "tests/api/small_template.h"
#include "tests/gl/support/absent.h"

namespace parity
{

constexpr double mutation_moment_s = 2;

class Mutation : public testing::Test
{
protected:
    void SetUp() override
    {
        std::string why_not;
        if (!contexts::make_offscreen(contexts::Kind::any, 16, 16, contexts::PixelFormat::rgba8888, why_not))
            END_WITHOUT_CONTEXT(contexts::Kind::any, why_not);
        folder_ = std::filesystem::temp_directory_path() / ("claque-mutation-" + std::to_string(getpid()));
        options_.crowd_options.count = 12;
        options_.crowd_options.lod = scenes::Lod::on;
        options_.width = 480;
        options_.height = 360;
    }
    void TearDown() override
    {
        scene_renderer_.reset();
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }

    void make_scene_renderer() { scene_renderer_ = std::make_unique<scenes::SceneRenderer>(library_, options_); }
    Capture capture()
    {
        write_result(*scene_renderer_, {options_.scene, mutation_moment_s, options_.width, options_.height},
                     folder_.string());
        return read_capture(folder_.string());
    }
    // Of a bending strip whose ten rows follow two joints with these weights.
    Capture capture_of_strip(const std::vector<float> &weights)
    {
        SmallTemplate strip;
        strip.parts[0].weights = weights.data();
        clq_template *tmpl = nullptr;
        scenes::check(clq_template_build(library_.context(), &strip.def, &tmpl));
        const scenes::Own<clq_template> held(tmpl);
        options_.character.tmpl = tmpl;
        make_scene_renderer();
        return capture();
    }
    static std::vector<float> weights_of_strip()
    {
        const SmallTemplate strip;
        return {strip.parts[0].weights, strip.parts[0].weights + 20};
    }
    clq_crowd *crowd() const { return scene_renderer_->scene().crowd(); }
    clq_actor_info info_of(clq_actor actor) const
    {
        clq_actor_info info = clq_actor_info_init();
        scenes::check(clq_actor_get_info(crowd(), actor, &info));
        return info;
    }
    // Of the pixels at which the id map shows the actor.
    static size_t pixels_of(const Capture &c, clq_actor actor)
    {
        return static_cast<size_t>(std::count(c.actor->values.begin(), c.actor->values.end(), actor.index1));
    }
    // The actor that fills most of the picture, so that every mutation is visible.
    clq_actor nearest(const Capture &c) const
    {
        const std::vector<clq_actor> all = scene_renderer_->scene().actors();
        return *std::max_element(all.begin(), all.end(),
                                 [&](clq_actor a, clq_actor b) { return pixels_of(c, a) < pixels_of(c, b); });
    }

    // The zone of the actor that most pixels show.
    static size_t widest_zone(const Capture &c, clq_actor actor)
    {
        std::vector<size_t> pixels(UINT16_MAX + 1);
        for (size_t i = 0; i < c.zone->values.size(); ++i)
            if (c.actor->values[i] == actor.index1) ++pixels[c.zone->values[i]];
        return static_cast<size_t>(std::max_element(pixels.begin() + 1, pixels.end()) - pixels.begin()) - 1;
    }

    static Capture vertices_of(Capture c)
    {
        c.colour.reset(), c.depth.reset(), c.actor.reset(), c.zone.reset();
        return c;
    }
    static Capture pictures_of(Capture c)
    {
        c.actors.reset(), c.positions.reset(), c.normals.reset();
        return c;
    }
    static Capture colours_of(Capture c)
    {
        c = pictures_of(std::move(c));
        c.depth.reset(), c.actor.reset(), c.zone.reset();
        return c;
    }
    // Exceeded limits of what both have; empty: these are kept.
    static std::string broken(const Capture &reference, const Capture &result, const char *tolerance = "gpu")
    {
        Verdict verdict = verdict_of(compare(reference, result, 67), tolerance_of(tolerance));
        verdict.lacking.clear();
        return reasons(verdict, 99);
    }
    static void expect_broken(const std::string &said, const char *measure)
    {
        EXPECT_NE(said.find(measure), std::string::npos) << "said: " << said;
    }

    std::filesystem::path folder_;
    scenes::Library library_{1};
    scenes::SceneOptions options_;
    std::unique_ptr<scenes::SceneRenderer> scene_renderer_;
};

}  // namespace parity
