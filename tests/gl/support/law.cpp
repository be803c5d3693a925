#include "tests/gl/support/law.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/gl/support/absent.h"
#include "tests/gl/support/source_picture.h"

namespace gltest
{

std::vector<Target> targets()
{
    using contexts::Kind, contexts::PixelFormat;
    constexpr Target all[] = {
        {Kind::osmesa, PixelFormat::rgba8888, "OsmesaRgba8888"}, {Kind::osmesa, PixelFormat::rgb565, "OsmesaRgb565"},
        {Kind::egl, PixelFormat::rgba8888, "EglRgba8888"},       {Kind::egl, PixelFormat::rgb565, "EglRgb565"},
        {Kind::glx, PixelFormat::rgba8888, "GlxRgba8888"},       {Kind::glx, PixelFormat::rgb565, "GlxRgb565"},
    };
    const Kind named = contexts::kind_of_environment();
    std::vector<Target> chosen;
    for (const Target &target : all)
        if (named == Kind::any ? target.kind != Kind::glx : target.kind == named) chosen.push_back(target);
    return chosen;
}

std::vector<Target> targets_here(size_t most)
{
    std::vector<Target> chosen = targets();
    const auto is_here = [](const Target &target) { return absent_gl(target.kind).empty(); };
    const auto others = std::stable_partition(chosen.begin(), chosen.end(), is_here);
    if (others != chosen.begin()) chosen.erase(others, chosen.end());
    if (chosen.size() > most) chosen.erase(chosen.begin() + std::ptrdiff_t(most), chosen.end());
    return chosen;
}

Law::Law(contexts::Offscreen &context, const PosedModel &posed, const model::Model *source)
    : context_(context), posed_(posed), colours_(zone_colours(posed.tmpl->zone_count()))
{
    struct Place {
        const char *name;
        float distance_radii, turn_rad, tilt_rad;
        double least_share;
    };
    constexpr Place places[] = {{"near", 0.9f, 0.3f, 0.2f, 0.06},
                                {"whole", 2.6f, -0.5f, 0.4f, 0.03},
                                {"far", 30, 0.7f, 0, 0.0003},
                                {"edge-on", 2.6f, 1.53f, 0, 0.004}};
    const float aspect = float(context.width()) / float(context.height());
    std::unique_ptr<SourceLook> look;
    if (source) {
        SourceImages images(*source);
        look = std::make_unique<SourceLook>(context, images, *posed.tmpl, colours_.data(), posed.texture_set);
    }
    for (const Place &place : places) {
        View view;
        view.name = place.name, view.least_share = place.least_share;
        view.camera = camera_on(posed, place.distance_radii, place.turn_rad, place.tilt_rad, aspect);
        view.wanted.plain = look ? draw_source(context, {{look.get(), posed.positions.data(), view.camera.model_view}},
                                               view.camera.projection)
                                 : draw_plain(context, posed, view.camera, colours_.data());
        view.wanted.forwards = draw_ids(context, posed, view.camera, Order::forwards);
        view.wanted.backwards = draw_ids(context, posed, view.camera, Order::backwards);
        views_.push_back(std::move(view));
    }
}

void Law::hold(const passes::RendererOptions &options, Verdict &verdict) const
{
    passes::Renderer renderer(std::pmr::get_default_resource(), options);
    const auto opened = renderer.open(context_.get_proc_address(), context_.user());
    ASSERT_TRUE(opened.ok()) << opened.text;
    const auto prepared = renderer.prepare(*posed_.tmpl);
    ASSERT_TRUE(prepared.ok()) << prepared.text;
    for (const View &view : views_) {
        SCOPED_TRACE(view.name);
        const auto list = list_of(posed_, view.camera, colours_.data());
        verdict.hold(view.wanted, draw(context_, renderer, list, view.least_share), view.least_share);
    }
    renderer.destroy();
}

}  // namespace gltest
