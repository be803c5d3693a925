// Errors of packed vertices against floats of the same poses: in millimetres, in degrees, and in pixels of a picture
// 768 lines high over 60 degrees, at the distances of use.
#include <cmath>

#include <gtest/gtest.h>

#include "animcache/evaluate.h"
#include "animcache/scratch.h"
#include "lib/figures/figure.h"
#include "lib/pose/layer.h"
#include "meshsplit/build.h"
#include "tests/law/support/figure.h"

namespace claque::animcache
{

namespace
{

struct PackedError {
    double position = 0, normal_deg = 0;  // the largest
    double mean = 0;                      // of positions
};

class Both
{
public:
    explicit Both(const model::Template &tmpl) : tmpl_(tmpl), pool_(std::pmr::get_default_resource(), 1)
    {
        const Sizes real = sizes_of(tmpl, VertexFormat::floats), packed = sizes_of(tmpl, VertexFormat::packed);
        pool_.reserve(real);
        pool_.reserve(packed);
        palette_.resize(real.palette_floats);
        real_.resize(real.vertex_floats);
        packed_.resize(packed.vertex_floats);
    }

    void add(uint32_t level, uint32_t clip, double time_s, PackedError &error, uint64_t &count)
    {
        Request request;
        request.level = level;
        request.pose.clip = clip;
        request.pose.clip_time_s = time_s;
        add(request, error, count);
    }

    void add(Request request, PackedError &error, uint64_t &count)
    {
        request.tmpl = &tmpl_;
        request.pose.version = 1;
        const uint32_t level = request.level;
        const Scratch scratch = pool_.slice(0);
        animate(request, scratch, palette_.data());
        skin(request, palette_.data(), VertexFormat::floats, scratch, real_.data());
        skin(request, palette_.data(), VertexFormat::packed, scratch, packed_.data());
        const draw::Vertices a = vertices_in(real_.data(), tmpl_, level, VertexFormat::floats);
        const draw::Vertices b = vertices_in(packed_.data(), tmpl_, level, VertexFormat::packed, request.blend_radius);
        for (uint32_t v = 0; v < tmpl_.levels[level].vertex_count; ++v) compare(a, b, v, error, count);
    }

private:
    static void compare(const draw::Vertices &a, const draw::Vertices &b, uint32_t v, PackedError &error,
                        uint64_t &count)
    {
        double square = 0, dot = 0, of_a = 0, of_b = 0;
        for (int k = 0; k < 3; ++k) {
            const double unpacked = double(b.offset[k]) + double(b.step) * b.short_positions[4 * v + k];
            square += (unpacked - double(a.positions[3 * v + k])) * (unpacked - double(a.positions[3 * v + k]));
            const double na = double(a.normals[3 * v + k]), nb = b.byte_normals[4 * v + k];
            dot += na * nb, of_a += na * na, of_b += nb * nb;
        }
        error.position = std::max(error.position, std::sqrt(square));
        error.mean += std::sqrt(square);
        ++count;
        if (of_a > 1e-8)
            error.normal_deg =
                std::max(error.normal_deg, std::acos(std::min(1.0, dot / std::sqrt(of_a * of_b))) * 57.29577951);
    }

    const model::Template &tmpl_;
    ScratchPool pool_;
    std::vector<float> palette_, real_, packed_;
};

PackedError error_of(const model::Template &tmpl)
{
    Both both(tmpl);
    PackedError error;
    uint64_t count = 0;
    for (uint32_t level = 0; level < tmpl.levels.size(); ++level)
        for (uint32_t clip = 0; clip < tmpl.rig.clips.size(); ++clip)
            for (int k = 0; k < 5; ++k)
                both.add(level, clip, tmpl.rig.clips[clip].start_s + tmpl.rig.clips[clip].duration_s * k / 5, error,
                         count);
    error.mean /= double(count);
    return error;
}

double packed_pixels(double metres, double distance_m) { return metres / distance_m * 384 * std::sqrt(3.0); }

}  // namespace

TEST(Packed, EveryPoseOfTheBuiltInCharactersIsWithinHalfAStepAndHalfADegree)
{
    // A person, and a winged character of rigid parts; each takes all clips from one skeleton.
    for (const figures::Builtin &builtin : {figures::builtins().front(), figures::builtins().back()}) {
        const char *name = builtin.name;
        model::Template tmpl(std::pmr::get_default_resource());
        meshsplit::BuildOptions options;
        options.max_texture_px = 64;
        meshsplit::build(builtin.make(), options, tmpl);
        const PackedError error = error_of(tmpl);
        std::printf(
            "%-10s position at most %.4f mm (mean %.4f), normal at most %.2f degrees; at 2, 10 and 30 m %.4f, %.4f and "
            "%.4f pixels\n",
            name, error.position * 1e3, error.mean * 1e3, error.normal_deg, packed_pixels(error.position, 2),
            packed_pixels(error.position, 10), packed_pixels(error.position, 30));
        const double step = double(tmpl.sklsroot.radius) / 32767;
        EXPECT_LE(error.position, 0.5 * std::sqrt(3.0) * step * 1.01) << name;
        EXPECT_GT(error.position, 0.2 * step) << name;
        EXPECT_LT(error.normal_deg, 0.5) << name;
        EXPECT_LT(packed_pixels(error.position, 2), 0.05) << name;
    }
}

// Arms raised by a clip, with a layer that raises them one and a half times more: farther than any clip goes.
TEST(Packed, BlendsThatLeaveTheSphereOfTheClipsAreWithinHalfAStepToo)
{
    model::Template tmpl(std::pmr::get_default_resource());
    meshsplit::BuildOptions options;
    options.max_texture_px = 64;
    meshsplit::build(figures::citizen(), options, tmpl);
    pose::Layer layers[3];
    layers[0].clip = tmpl.rig.find_clip("cheer");
    layers[1].clip = tmpl.rig.find_clip("jog"), layers[1].time_s = 0.1;
    layers[1].kind = pose::LayerKind::add, layers[1].weight = 3, layers[1].reference_clip = layers[0].clip;
    layers[2].clip = tmpl.rig.find_clip("rise"), layers[2].time_s = 2;
    layers[2].kind = pose::LayerKind::add, layers[2].weight = 3, layers[2].reference_clip = layers[2].clip;
    Request request;
    request.layers = {layers, 3};
    request.blend_radius = tmpl.blend_radius.at(6);
    Both both(tmpl);
    PackedError error, clamped;
    uint64_t count = 0;
    for (int k = 0; k < 10; ++k) {
        layers[0].time_s = 0.2 * k;
        both.add(request, error, count);
        Request as_a_clip = request;
        as_a_clip.blend_radius = 0;
        both.add(as_a_clip, clamped, count);
    }
    const double step = double(request.blend_radius) / 32767;
    EXPECT_LE(error.position, 0.5 * std::sqrt(3.0) * step * 1.01);
    EXPECT_GT(clamped.position, 0.05) << "or these blends would not leave the sphere";
}

TEST(Packed, ABlockIsHalfOfThatOfFloats)
{
    const auto tmpl = testing_support::make_figure();
    const size_t real = sizes_of(*tmpl, VertexFormat::floats).vertex_floats;
    const size_t packed = sizes_of(*tmpl, VertexFormat::packed).vertex_floats;
    EXPECT_NEAR(double(packed) / double(real), 0.5, 0.01);
}

TEST(Packed, APoseThatLeavesTheSphereIsHeldAtItsEdge)
{
    const auto tmpl = testing_support::make_figure();
    tmpl->sklsroot.radius *= 0.25f;
    const PackedError error = error_of(*tmpl);
    EXPECT_GT(error.position, 0.1);                                // clamped, not wrapped round
    EXPECT_LT(error.position, 7 * double(tmpl->sklsroot.radius));  // at most as far as the pose exceeds the range
}

}  // namespace claque::animcache
