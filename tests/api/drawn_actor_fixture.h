// A crowd of three of the small template before one view, and its vertices skinned here again by the formula of
// docs/parity.md.
#pragma once

#include <claque/claque.h>
#include <claque/drawn_actor.h>
#include <claque/mesh.h>

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/api/calls.h"
#include "tests/api/small_template.h"

namespace api_test
{

class DrawnActor : public testing::Test
{
protected:
    void SetUp() override
    {
        ASSERT_EQ(clq_context_create(nullptr, &context_), CLQ_OK);
        ASSERT_EQ(clq_template_build(context_, &small_.def, &tmpl_), CLQ_OK) << clq_last_error();
    }
    void TearDown() override
    {
        clq_crowd_destroy(crowd_);
        clq_template_destroy(tmpl_);
        EXPECT_EQ(clq_context_destroy(context_), CLQ_OK);
    }

    // Three actors in a row before the eye, each with its own bend.
    void fill(const clq_crowd_def &def)
    {
        clq_crowd_destroy(crowd_);
        ASSERT_EQ(clq_crowd_create(context_, &def, &crowd_), CLQ_OK) << clq_last_error();
        for (int i = 0; i < 3; ++i) {
            clq_actor_def actor = clq_actor_def_init();
            actor.tmpl = tmpl_;
            actor.transform.position[0] = 2 * i - 2, actor.transform.position[2] = -8 - i;
            actor.transform.scale = i == 2 ? -1.0f : 1.0f;
            actor.play.clip = 0, actor.play.phase_s = 0.3f * static_cast<float>(i);
            clq_actor made;
            ASSERT_EQ(clq_actor_create(crowd_, &actor, &made), CLQ_OK) << clq_last_error();
            if (i == 1) {
                ASSERT_EQ(clq_actor_randomise_colours(crowd_, made, nullptr, 0), CLQ_OK);
            }
        }
        ASSERT_EQ(clq_view_create(crowd_, &view_), CLQ_OK);
        clq_camera camera;
        const double eye[3] = {0, 1, 0}, target[3] = {0, 1, -10};
        const float up[3] = {0, 1, 0};
        ASSERT_EQ(api_test::look_at(&camera, eye, target, up, 1.2f, 1.3f, 0.1f, 100), CLQ_OK);
        ASSERT_EQ(clq_view_set_camera(view_, &camera), CLQ_OK);
        ASSERT_EQ(clq_crowd_update(crowd_, 0.2, &view_, 1), CLQ_OK) << clq_last_error();
    }

    // The largest distance between the shown vertices and those computed from palette and mesh.
    double apart(uint32_t index)
    {
        clq_drawn_actor shown = clq_drawn_actor_init();
        clq_mesh mesh = clq_mesh_init();
        EXPECT_EQ(clq_view_get_drawn_actor(view_, index, &shown), CLQ_OK) << clq_last_error();
        EXPECT_EQ(clq_template_get_mesh(shown.tmpl, shown.level, &mesh), CLQ_OK);
        const uint32_t count = mesh.vertex_count, each = mesh.influence_count;
        std::vector<float> palette(12 * shown.joint_count), xyz(3 * count), weights(each * count);
        std::vector<uint16_t> joints(each * count);
        EXPECT_EQ(clq_view_get_palette(view_, index, palette.data(), shown.joint_count), CLQ_OK) << clq_last_error();
        EXPECT_EQ(clq_view_get_vertices(view_, index, xyz.data(), nullptr, count), CLQ_OK) << clq_last_error();
        EXPECT_EQ(api_test::get_influences(shown.tmpl, shown.level, each, joints.data(), weights.data(), joints.size()),
                  CLQ_OK);
        double most = 0;
        for (uint32_t v = 0; v < count; ++v)
            for (uint32_t k = 0; k < 3; ++k) {
                double moved = 0;
                for (uint32_t i = 0; i < each; ++i) {
                    const float *m = palette.data() + 12 * joints[v * each + i];
                    const float *p = mesh.positions + 3 * v;
                    moved +=
                        double(weights[v * each + i]) * (double(m[k]) * double(p[0]) + double(m[3 + k]) * double(p[1]) +
                                                         double(m[6 + k]) * double(p[2]) + double(m[9 + k]));
                }
                most = std::fmax(most, std::fabs(moved - double(xyz[3 * v + k])));
            }
        return most;
    }

    SmallTemplate small_;
    clq_context *context_ = nullptr;
    clq_template *tmpl_ = nullptr;
    clq_crowd *crowd_ = nullptr;
    clq_view *view_ = nullptr;
};

}  // namespace api_test
