// A pose job writes within the memory that it is given and asks for, and nowhere beside it.
#include <cstring>

#include <gtest/gtest.h>

#include "lib/pose/pose.h"
#include "meshsplit/motion.h"
#include "random_rig.h"

namespace claque::pose
{

namespace
{

constexpr size_t spare = 64;  // elements behind each span
constexpr unsigned char mark = 0xa5;

// Elements of a span with marked ones behind them.
template <class T>
class Guarded
{
public:
    explicit Guarded(size_t count) : count_(count), all_(count + spare)
    {
        std::memset(static_cast<void *>(all_.data()), mark, all_.size() * sizeof(T));
    }
    base::Span<T> span() { return {all_.data(), static_cast<uint32_t>(count_)}; }
    // `allowed`: bytes behind it that may be written.
    bool kept(size_t allowed = 0) const
    {
        const unsigned char *bytes = reinterpret_cast<const unsigned char *>(all_.data());
        for (size_t i = count_ * sizeof(T) + allowed; i < all_.size() * sizeof(T); ++i)
            if (bytes[i] != mark) return false;
        return true;
    }

private:
    size_t count_;
    std::vector<T> all_;
};

}  // namespace

TEST(PoseMemory, BesideItsSpansStaysAsItWas)
{
    for (uint32_t seed = 1; seed < 6; ++seed) {
        model::Template tmpl(std::pmr::get_default_resource());
        tmpl.rig = test::RigMaker(seed).make();
        tmpl.levels.emplace_back(std::pmr::get_default_resource());
        for (uint32_t i = 0; i < tmpl.rig.node_count(); ++i)
            tmpl.levels[0].part_spheres.push_back({i, {tmpl.rig.rest[i].translation, 0.2f}});
        meshsplit::inflate(meshsplit::make_motion({0.001f, 0.01f}, tmpl), tmpl);
        ASSERT_FALSE(tmpl.motion.empty());
        const model::Rig &rig = tmpl.rig;
        for (const model::Motion *motion : std::initializer_list<const model::Motion *>{nullptr, &tmpl.motion})
            for (uint32_t layer_count = 0; layer_count < 4; ++layer_count) {
                Guarded<math::Trs> locals(rig.node_count());
                Guarded<math::Columns> globals(rig.node_count());
                Guarded<float> scratch(scratch_floats(rig, motion)), weights(rig.rest_weights.size());
                Guarded<math::Affine> palette(rig.palette.size());
                Layer layers[3];
                for (uint32_t k = 0; k < 3; ++k) {
                    layers[k].clip = k, layers[k].time_s = 0.3 * k, layers[k].weight = 0.7f;
                    layers[k].kind = k == 1 ? LayerKind::add : LayerKind::replace;
                    layers[k].reference_clip = test::clip_cubic;
                }
                PoseJob job;
                job.rig = &rig, job.motion = motion, job.clip = test::clip_linear, job.time_s = 0.4;
                job.layers = {layers, layer_count};
                job.locals = locals.span(), job.globals = globals.span(), job.scratch = scratch.span();
                job.weights = weights.span(), job.palette = palette.span();
                ASSERT_TRUE(job.check().ok()) << job.check().text;
                job.run();
                const bool all = locals.kept() && globals.kept() && scratch.kept() && weights.kept();
                EXPECT_TRUE(all && palette.kept(sizeof(float))) << "rig " << seed << ", " << layer_count << " layers";
            }
    }
}

// Each rule of a job by itself, at its limit and beyond it.
TEST(PoseMemory, ThatIsOneShortIsRefusedAndSoIsWhatNamesNoClip)
{
    model::Template tmpl(std::pmr::get_default_resource());
    tmpl.rig = test::RigMaker(2).make();
    const uint32_t clips = static_cast<uint32_t>(tmpl.rig.clips.size());
    tmpl.levels.emplace_back(std::pmr::get_default_resource());
    meshsplit::inflate(meshsplit::make_motion({0.001f, 0.01f}, tmpl), tmpl);
    Workspace workspace(tmpl.rig, &tmpl.motion);
    Layer layer;
    layer.clip = test::clip_linear;
    const auto said = [&](const auto &change) {
        PoseJob job = workspace.job();
        Layer changed = layer;
        job.layers = {&changed, 1};
        change(job, changed);
        return std::string(job.check().text);
    };
    using J = PoseJob;
    using L = Layer;
    EXPECT_TRUE(workspace.job().check().ok());
    EXPECT_EQ(said([](J &, L &) {}), "");
    const auto expect = [&](const char *words, const auto &change) {
        EXPECT_NE(said(change).find(words), std::string::npos) << said(change) << "\nand not: " << words;
    };
    expect("has no rig", [](J &job, L &) { job.rig = nullptr; });
    expect(" nodes", [](J &job, L &) { --job.locals.count; });
    expect(" nodes", [](J &job, L &) { --job.globals.count; });
    expect(" matrices and", [](J &job, L &) { --job.palette.count; });
    expect(" weights", [](J &job, L &) { --job.weights.count; });
    expect("numbers of scratch", [](J &job, L &) { --job.scratch.count; });
    expect("numbers of scratch", [](J &job, L &) { job.layers = {}, --job.scratch.count; });
    EXPECT_EQ(said([](J &job, L &) { job.layers = {}, job.motion = nullptr, job.scratch.count = 0; }), "");
    expect("a pose job asks for clip", [=](J &job, L &) { job.clip = clips; });
    EXPECT_EQ(said([=](J &job, L &) { job.clip = clips - 1; }), "");
    expect("time is not finite", [](J &job, L &) { job.time_s = INFINITY; });
    for (uint32_t L::*clip : {&L::clip, &L::reference_clip}) {
        expect("a layer of a pose job asks for clip", [=](J &, L &one) { one.*clip = clips; });
        EXPECT_EQ(said([=](J &, L &one) { one.*clip = clips - 1; }), "");
        EXPECT_EQ(said([=](J &, L &one) { one.*clip = model::none; }), "");
    }
    const char *const not_finite = "has a time or weight that is not finite";
    expect(not_finite, [](J &, L &one) { one.time_s = INFINITY; });
    expect(not_finite, [](J &, L &one) { one.reference_time_s = NAN; });
    expect(not_finite, [](J &, L &one) { one.weight = -INFINITY; });
    expect("motion of", [&](J &, L &) { tmpl.motion.clips.pop_back(); });
}

}  // namespace claque::pose
