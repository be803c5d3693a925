#include "tests/gl/support/levels.h"

#include <algorithm>
#include <cmath>

#include "lib/base/hash.h"
#include "lib/lod/chain.h"
#include "meshsplit/build.h"
#include "tests/gl/support/absent.h"
#include "tests/gl/support/source_picture.h"
#include "tests/gl/support/split.h"

namespace gltest
{

namespace
{

// Anywhere round the character, from so near that it is cut off to so far that it covers a few pixels.
struct Lot {
    Lot(const PosedModel &posed, uint64_t seed, float aspect)
    {
        const auto random_unit = [seed](uint64_t what) {
            return claque::base::unit(claque::base::mix(8 * seed + what));
        };
        const float radii = 0.7f * std::pow(40.0f, random_unit(0));
        camera = camera_on(posed, radii, 6.2832f * random_unit(1), 2.4f * random_unit(2) - 1.2f, aspect);
        least_share = std::min(0.02, 0.12 / double(radii * radii));
    }
    Camera camera;
    double least_share;  // of the picture that it has to cover: a part of its sphere's disc
};

}  // namespace

void LevelsTest::make_context(const Target &target)
{
    std::string why;
    spy_.reset();  // it watches the context before
    context_ = contexts::make_offscreen(target.kind, 96, 72, target.format, why);
    if (!context_) END_WITHOUT_CONTEXT(target.kind, why);
    spy_ = std::make_unique<Spy>(*context_);
    spy_->watch = [this](const std::string &name, const std::vector<double> &arguments) {
        flat_calls_ += name == "glShadeModel" && arguments[0] == double(claque::passes::gl::flat);
    };
}

uint32_t LevelsTest::hold(const Target &target, model::Model character, uint32_t texture_px, uint32_t cameras_a_level)
{
    verdict_.most_ties_share = 1e-4;
    make_context(target);
    if (!context_) return 0;
    // One clip is enough for posing; spheres of all clips take longer than all the pictures.
    if (character.rig.clips.size() > 1) {
        character.rig.clips.resize(1, character.rig.clips[0]);
        character.rig.clip_names.resize(1, character.rig.clip_names[0]);
    }
    claque::lod::ChainOptions chain_options;
    chain_options.sampling.poses_per_clip = 1;
    claque::lod::make_chain(character, chain_options);
    claque::meshsplit::BuildOptions options;
    options.max_texture_px = texture_px;
    PosedModel posed;
    posed.tmpl = std::make_unique<model::Template>(std::pmr::get_default_resource());
    claque::meshsplit::build(character, options, *posed.tmpl);
    whiten(*posed.tmpl);
    SourceImages images(character, texture_px);
    const bool still = character.rig.clips.empty();
    const uint32_t levels = static_cast<uint32_t>(posed.tmpl->levels.size());
    for (uint32_t level = 0; level < levels; ++level) {
        SCOPED_TRACE(testing::Message() << "level " << level << " of " << levels);
        std::swap(posed.tmpl->levels[0], posed.tmpl->levels[level]);
        skin(*posed.tmpl, still ? model::none : 0, still ? 0 : double(character.rig.clips[0].start_s) + 0.3,
             posed.positions, posed.normals);
        measure(posed);
        hold_level(posed, images, level, cameras_a_level);
        std::swap(posed.tmpl->levels[0], posed.tmpl->levels[level]);
    }
    return levels * cameras_a_level;
}

void LevelsTest::hold_level(PosedModel &posed, SourceImages &images, uint32_t level, uint32_t cameras)
{
    const std::vector<uint8_t> colours = zone_colours(posed.tmpl->zone_count());
    const float aspect = float(context_->width()) / float(context_->height());
    std::vector<std::unique_ptr<passes::Renderer>> renderers;
    for (const passes::Strategy strategy :
         {passes::Strategy::fused, passes::Strategy::binned, passes::Strategy::per_zone}) {
        passes::RendererOptions options;
        options.strategy = strategy;
        renderers.push_back(std::make_unique<passes::Renderer>(std::pmr::get_default_resource(), options));
        ASSERT_TRUE(renderers.back()->open(Spy::get_proc_address, spy_->user()).ok());
        const auto prepared = renderers.back()->prepare(*posed.tmpl);
        ASSERT_TRUE(prepared.ok()) << prepared.text;
    }
    std::vector<std::unique_ptr<SourceLook>> looks;
    for (uint32_t set = 0; set < posed.tmpl->texture_set_count(); ++set)
        looks.push_back(std::make_unique<SourceLook>(*context_, images, *posed.tmpl, colours.data(), set));
    uint64_t covered = 0;
    uint32_t seen = 0;
    bool is_flat = true;
    for (uint32_t i = 0; i < cameras; ++i) {
        posed.texture_set = i % static_cast<uint32_t>(looks.size());
        const Lot lot(posed, 1000 * level + i, aspect);
        const Camera &camera = lot.camera;
        const Wanted wanted = {
            draw_source(*context_, {{looks[posed.texture_set].get(), posed.positions.data(), camera.model_view}},
                        camera.projection),
            draw_ids(*context_, posed, camera, Order::forwards), draw_ids(*context_, posed, camera, Order::backwards)};
        // Thin characters are edge-on or lie between all samples of far pixels. Nothing may be drawn then.
        const bool is_seen = gltest::covered(wanted.plain) > 0;
        seen += is_seen;
        const double least_share = is_seen ? lot.least_share : 0;
        for (size_t k = 0; k < renderers.size(); ++k) {
            flat_calls_ = 0;
            SCOPED_TRACE(testing::Message() << "strategy " << k << ", camera " << i << ", set " << posed.texture_set);
            const auto list = list_of(posed, camera, colours.data());
            covered += verdict_.hold(wanted, draw(*context_, *renderers[k], list, least_share), least_share).covered;
            is_flat = is_flat && flat_calls_ > 0;
        }
    }
    for (const auto &renderer : renderers) renderer->destroy();
    flat_levels_ += is_flat;
    EXPECT_GE(4 * seen, 3 * cameras) << "too many cameras see nothing";
    EXPECT_GT(covered, renderers.size() * 20 * uint64_t(cameras)) << "the cameras see too little of the character";
}

}  // namespace gltest
