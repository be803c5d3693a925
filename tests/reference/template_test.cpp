// Every collected and every written character after splitting: what a crowd of one hands to the drawing, against the
// reference. The C API shows no vertices, so this looks behind its handles; all that leads up to them goes through the
// public calls.
#include <claque/assets.h>
#include <claque/view.h>

#include <algorithm>
#include <array>
#include <memory>

#include <gtest/gtest.h>

#include "lib/api/boundary.h"
#include "lib/api/crowd_handle.h"
#include "tests/api/calls.h"
#include "tests/reference/asset_files.h"
#include "tests/reference/comparison.h"
#include "tests/reference/trajectories.h"
#include "tests/reference/triangles.h"
#include "tests/support/written_characters.h"

namespace claque::reference
{
namespace
{

constexpr size_t clips_per_template = 5;

// clq_template_def.motion_error as it is by default: a 2000th of the radius at rest, which is half the size at most.
constexpr double sampling = 1.0 / 4000;

struct DestroyTemplate {
    void operator()(clq_context *context) const { clq_context_destroy(context); }
    void operator()(clq_asset *asset) const { clq_asset_destroy(asset); }
    void operator()(clq_template *tmpl) const { clq_template_destroy(tmpl); }
    void operator()(clq_crowd *crowd) const { clq_crowd_destroy(crowd); }
};

template <class Handle>
using Owned = std::unique_ptr<Handle, DestroyTemplate>;

class SplitFormOfFiles : public testing::TestWithParam<std::string>
{
protected:
    void SetUp() override
    {
        if (GetParam().empty())
            GTEST_SKIP() << "no folder " << CLAQUE_ASSETS_DIR << ": collected characters are not compared";
        const std::string path = written::path_of(GetParam(), assets_folder());
        character_ = load_character(path);
        size_ = size_of(character_);
        triangles_ = triangles_of(character_, size_);
        make_template(path);
        if (is_drawable() && !HasFatalFailure()) make_crowd();
    }

    // Skeletons, points and lines make no template; that is said, and all there is to test.
    bool is_drawable() const { return !triangles_.all.empty(); }

    void make_template(const std::string &path)
    {
        clq_context *context = nullptr;
        ASSERT_EQ(CLQ_OK, clq_context_create(nullptr, &context)) << clq_last_error();
        context_.reset(context);
        clq_asset *asset = nullptr;
        ASSERT_EQ(CLQ_OK, clq_asset_load_file(context, path.c_str(), nullptr, &asset)) << clq_last_error();
        const Owned<clq_asset> owned(asset);
        clq_template *tmpl = nullptr;
        const clq_status expected = is_drawable() ? CLQ_OK : CLQ_ARGUMENT;
        ASSERT_EQ(expected, clq_asset_build(context, asset, 64, &tmpl)) << clq_last_error();
        template_.reset(tmpl);
    }

    // That of a vertex whose clip is sampled: the error that was asked for, whatever the template says of itself.
    double allowed_distance() const { return (tolerance + sampling) * size_; }

    // One actor at the origin, posed anew at every update, and a view from far enough to see all of it.
    void make_crowd()
    {
        clq_crowd_def def = clq_crowd_def_init();
        def.period_near_s = def.period_far_s = 0;
        clq_crowd *crowd = nullptr;
        ASSERT_EQ(CLQ_OK, clq_crowd_create(context_.get(), &def, &crowd)) << clq_last_error();
        crowd_.reset(crowd);
        clq_actor_def actor = clq_actor_def_init();
        actor.tmpl = template_.get();
        ASSERT_EQ(CLQ_OK, clq_actor_create(crowd, &actor, &actor_)) << clq_last_error();
        ASSERT_EQ(CLQ_OK, clq_view_create(crowd, &view_)) << clq_last_error();
        const double reach = 20 * size_;
        const double eye[3] = {0, 0, reach}, target[3] = {0, 0, 0};
        const float up[3] = {0, 1, 0};
        clq_camera camera;
        ASSERT_EQ(CLQ_OK, api_test::look_at(&camera, eye, target, up, 1.5f, 1, static_cast<float>(0.01 * reach),
                                            static_cast<float>(10 * reach)));
        ASSERT_EQ(CLQ_OK, clq_view_set_camera(view_, &camera)) << clq_last_error();
    }

    // The clip stands at its start plus `offset_s`, which is inside it.
    void show(size_t clip, double offset_s, std::vector<Pose> &poses)
    {
        const clq_play play{clip == rest ? CLQ_NONE : static_cast<uint32_t>(clip), 0.0, 1.0f, 0.0f};
        ASSERT_EQ(CLQ_OK, clq_actor_play(crowd_.get(), actor_, &play)) << clq_last_error();
        ASSERT_EQ(CLQ_OK, clq_crowd_update(crowd_.get(), offset_s, &view_, 1)) << clq_last_error();
        const draw::DrawList &list = view_->view.list;
        ASSERT_EQ(1u, list.items.size()) << "the view does not see the actor";
        const draw::Item &item = list.items[0];
        const draw::Vertices &vertices = item.vertices;
        const double start_s = clip == rest ? 0 : character_.clips[clip].first_s;
        Pose pose;
        pose.expected = evaluate(character_, clip, start_s + offset_s);
        const uint32_t count = item.tmpl->levels[item.level].vertex_count;
        for (uint32_t v = 0; v < count; ++v) {
            const float *p = vertices.positions + 3 * v, *n = vertices.normals + 3 * v;
            pose.actual.positions.push_back({p[0], p[1], p[2]});
            pose.actual.normals.push_back({n[0], n[1], n[2]});
        }
        poses.push_back(std::move(pose));
    }

    Character character_;
    double size_ = 0;
    Triangles triangles_;
    Owned<clq_context> context_;
    Owned<clq_template> template_;
    Owned<clq_crowd> crowd_;
    clq_actor actor_{};
    clq_view *view_ = nullptr;
};

TEST_P(SplitFormOfFiles, GoesWhereTheFilesVerticesGo)
{
    if (!is_drawable()) return;
    std::vector<Pose> poses;
    show(rest, 0, poses);
    const size_t shown = std::min(character_.clips.size(), clips_per_template);
    for (size_t i = 0; i < shown && !HasFatalFailure(); ++i) {
        const size_t clip = i * character_.clips.size() / shown;
        const double span = character_.clips[clip].last_s - character_.clips[clip].first_s;
        for (const double part : {0.0, 0.237, 0.618, 0.91})
            if (!HasFatalFailure()) show(clip, part * span, poses);
    }
    if (HasFatalFailure()) return;
    const std::vector<bool> used = vertices_of(triangles_, character_.vertex_count());
    const Matching matching = match(poses, used, allowed_distance());
    EXPECT_TRUE(matching.same) << GetParam() << ": " << matching.text;
}

// The triangles that the binned strategy draws: clean ones and dirty ones, each once.
std::vector<Facet> facets_of(const model::Level &level, const std::vector<Vec3> &positions)
{
    std::vector<model::IndexRange> ranges;
    for (const model::Surface &surface : level.surfaces) {
        for (const model::Bin &bin : surface.clean) ranges.push_back(bin.range);
        ranges.push_back(surface.dirty);
    }
    std::vector<Facet> facets;
    for (const model::IndexRange &range : ranges)
        for (uint32_t i = range.first; i < range.first + range.count; i += 3)
            facets.push_back(facet(positions.at(level.indices.at(i)), positions.at(level.indices.at(i + 1)),
                                   positions.at(level.indices.at(i + 2))));
    return facets;
}

TEST_P(SplitFormOfFiles, HasTheFilesTrianglesAndTheirFronts)
{
    if (!is_drawable()) return;
    std::vector<Pose> poses;
    const bool moves = !character_.clips.empty();
    show(moves ? 0 : rest, moves ? 0.618 * (character_.clips[0].last_s - character_.clips[0].first_s) : 0, poses);
    if (HasFatalFailure()) return;
    const std::vector<Vec3> &at = poses[0].expected.positions;
    std::vector<Facet> expected;
    for (const Triangle &t : triangles_.all) expected.push_back(facet(at[t[0]], at[t[1]], at[t[2]]));
    const std::vector<Facet> actual = facets_of(template_->levels[0], poses[0].actual.positions);
    const SurfaceMatching matching = match(expected, triangles_.has_area, actual, allowed_distance());
    EXPECT_TRUE(matching.same) << GetParam() << ": " << matching.text;
}

INSTANTIATE_TEST_SUITE_P(Written, SplitFormOfFiles, testing::ValuesIn(written::files()),
                         [](const auto &parameter) { return case_name(parameter.param); });

INSTANTIATE_TEST_SUITE_P(Assets, SplitFormOfFiles, testing::ValuesIn(loadable_files()),
                         [](const auto &parameter) { return case_name(parameter.param); });

}  // namespace
}  // namespace claque::reference
