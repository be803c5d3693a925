// An actor with degrees of freedom, a view of it, and definitions of mechanisms that are valid as they are.
#pragma once

#include <claque/claque.h>

#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/api/calls.h"
#include "tests/api/small_template.h"

enum : uint32_t { nod, turn, shift };

class BehaveApi : public testing::Test
{
protected:
    void SetUp() override
    {
        dofs_[nod] = {"nod", 1, CLQ_DOF_ROTATION, 0, {1, 0, 0}, -0.5f, 0.5f, 0};
        dofs_[turn] = {"turn", 1, CLQ_DOF_ROTATION, 0, {0, 1, 0}, -1, 1, 0};
        dofs_[shift] = {"shift", 1, CLQ_DOF_TRANSLATION, 0, {0, 1, 0}, 0, 0.2f, 0};
        small_.def.dof_count = 3, small_.def.dofs = dofs_;
        ASSERT_EQ(clq_context_create(nullptr, &context_), CLQ_OK);
        ASSERT_EQ(clq_template_build(context_, &small_.def, &tmpl_), CLQ_OK) << clq_last_error();
        ASSERT_EQ(clq_template_build(context_, &small_.def, &other_), CLQ_OK);
        ASSERT_EQ(clq_crowd_create(context_, nullptr, &crowd_), CLQ_OK);
        clq_actor_def def = clq_actor_def_init();
        def.tmpl = tmpl_;
        def.transform.position[2] = -10;
        ASSERT_EQ(clq_actor_create(crowd_, &def, &actor_), CLQ_OK);
        ASSERT_EQ(clq_view_create(crowd_, &view_), CLQ_OK);
        clq_camera camera;
        const double eye[3] = {0, 1, 0}, target[3] = {0, 1, -10};
        const float up[3] = {0, 1, 0};
        ASSERT_EQ(api_test::look_at(&camera, eye, target, up, 0.9f, 1.3f, 0.1f, 100), CLQ_OK);
        ASSERT_EQ(clq_view_set_camera(view_, &camera), CLQ_OK);
        shape_ = {1, &value_};
    }
    void TearDown() override
    {
        clq_crowd_destroy(crowd_);
        clq_template_destroy(tmpl_);
        clq_template_destroy(other_);
        clq_context_destroy(context_);
    }
    // A valid definition of this kind.
    clq_mechanism_def def(clq_mechanism_kind kind)
    {
        clq_mechanism_def out = clq_mechanism_def_init();
        out.kind = kind;
        out.tmpl = tmpl_;
        out.gaze.neck_yaw = turn, out.gaze.neck_pitch = nod;
        out.expression.pose_count = out.phrase.pose_count = 1;
        out.expression.poses = out.phrase.poses = &shape_;
        out.blink.closed = shape_;
        out.phrase.key_count = 1, out.phrase.keys = &key_, out.phrase.length_s = 1;
        out.idle.clip_count = 1, out.idle.clips = &clip_;
        out.host.run = [](void *user, const clq_behaviour_call *call, clq_dof_writer *writer) {
            static_cast<BehaveApi *>(user)->run(*call, writer);
        };
        out.host.user = this;
        return out;
    }
    clq_mechanism add(const clq_mechanism_def &wanted)
    {
        clq_mechanism out = {0};
        EXPECT_EQ(clq_crowd_add_mechanism(crowd_, &wanted, &out), CLQ_OK) << clq_last_error();
        return out;
    }
    clq_status attach_mechanism(clq_mechanism mechanism, float priority = 0)
    {
        const clq_mechanism_attachment wanted = {mechanism, priority, 0, 0};
        return clq_actor_attach_mechanism(crowd_, actor_, &wanted);
    }
    // Changes one thing of a valid definition and expects this message.
    void refused(clq_mechanism_kind kind, const char *sentence, const std::function<void(clq_mechanism_def &)> &change)
    {
        clq_mechanism_def wrong = def(kind);
        change(wrong);
        clq_mechanism out = {77};
        EXPECT_EQ(clq_crowd_add_mechanism(crowd_, &wrong, &out), CLQ_ARGUMENT) << sentence;
        EXPECT_NE(std::string(clq_last_error()).find(sentence), std::string::npos) << clq_last_error();
        EXPECT_EQ(out.index1, 77u) << "written only on CLQ_OK";
    }
    void refused(const char *sentence, const std::function<void(clq_root_path_def &)> &change)
    {
        clq_root_path_def wrong = clq_root_path_def_init();
        wrong.count = 3, wrong.positions = positions_, wrong.duration_s = 4;
        change(wrong);
        clq_root_path out = {77};
        EXPECT_EQ(clq_crowd_add_root_path(crowd_, &wrong, &out), CLQ_ARGUMENT) << sentence;
        EXPECT_NE(std::string(clq_last_error()).find(sentence), std::string::npos) << clq_last_error();
        EXPECT_EQ(out.index1, 77u);
    }
    uint64_t hash(double time_s)
    {
        EXPECT_EQ(clq_crowd_update(crowd_, time_s, &view_, 1), CLQ_OK) << clq_last_error();
        return clq_view_get_hash(view_);
    }

    virtual void run(const clq_behaviour_call &call, clq_dof_writer *writer)
    {
        calls_.push_back(call);
        clq_dof_write(writer, turn, wanted_, 1);
        clq_dof_write(writer, 99, 1, 1);
        clq_dof_write(nullptr, turn, 1, 1);
    }

    SmallTemplate small_;
    clq_dof_def dofs_[3];
    clq_context *context_ = nullptr;
    clq_template *tmpl_ = nullptr, *other_ = nullptr;
    clq_crowd *crowd_ = nullptr;
    clq_view *view_ = nullptr;
    clq_actor actor_{};
    clq_dof_value value_ = {turn, 0.5f};
    clq_dof_pose shape_{};
    clq_phrase_key key_ = {0, 0};
    uint32_t clip_ = 0;
    float positions_[9] = {3, 0, 0, 0, 1, 3, -3, 0, 0};
    float rotations_[12] = {0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 1};
    float times_[3] = {0, 1, 2};
    float wanted_ = 0.7f;
    std::vector<clq_behaviour_call> calls_;
};
