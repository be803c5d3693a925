// A crowd with everything that a crowd can hold, for tests of its whole state: two templates, mechanisms of all kinds
// with commands, root paths, groups, attached objects, colours, tracks, stale ids and free rows.
#pragma once

#include <claque/claque.h>

#include <vector>

#include <gtest/gtest.h>

#include "tests/api/small_template.h"
#include "tests/api/walker.h"

struct TestWorld {
    enum : uint32_t { nod, turn, shift };
    enum : uint32_t { gaze, expression, blink, phrase, idle, host };

    explicit TestWorld(const clq_context_def *context_def = nullptr);
    ~TestWorld();
    TestWorld(const TestWorld &) = delete;
    TestWorld &operator=(const TestWorld &) = delete;

    // Builds a template. With keeps_templates the second one of a name is loaded from what the first one saved, which
    // takes much less time; one name must then always mean one definition.
    clq_status make(const clq_template_def &def, clq_template **out);
    static bool keeps_templates;

    clq_crowd *new_crowd(const clq_crowd_def *def = nullptr);  // empty; destroyed with this world
    clq_mechanism_def mechanism(uint32_t kind);                // valid as it is
    clq_root_path_def path(bool flight);
    // `seed` changes which actors stand where and what they play.
    void set_up(clq_crowd *crowd);  // mechanisms 1 to 6 in the order above, paths 1 and 2, one actor
    std::vector<clq_actor> fill(clq_crowd *crowd, uint32_t count, uint64_t seed);
    // Makes the tracks known to a crowd for another template of the same structure as the first.
    void add_tracks_for(clq_crowd *crowd, clq_template *tmpl);
    clq_view *new_view(clq_crowd *crowd, double x);

    // Changes something of one actor: number `step` of a scripted run that is the same for equal seeds.
    void happen(clq_crowd *crowd, std::vector<clq_actor> &actors, uint64_t seed, uint32_t step);

    void follow(clq_crowd *crowd, clq_actor person, bool figure, double at_s, uint32_t step);
    void blend(clq_crowd *crowd, clq_actor person, bool figure, const clq_play &play);

    SmallTemplate with_dofs, plain;
    Walker legs{with_dofs};
    clq_dof_def dofs[3];
    clq_context *context = nullptr;
    clq_template *templates[2] = {nullptr, nullptr};
    clq_locomotion *locomotion = nullptr;  // of the first template
    clq_track *tracks[2] = {nullptr, nullptr};
    std::vector<clq_crowd *> crowds;

private:
    clq_dof_value values_[2] = {{turn, 0.5f}, {shift, 0.1f}};
    clq_dof_pose shapes_[2] = {{1, values_}, {1, values_ + 1}};
    clq_phrase_key keys_[2] = {{0, 0}, {0.4f, 1}};
    uint32_t clip_ = 0;
    float positions_[9] = {3, 0, 0, 0, 1, 3, -3, 0, 0};
    float rotations_[12] = {0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, 1};
    float times_[3] = {0, 1, 2};
};

inline uint64_t mixed(uint64_t a, uint64_t b)
{
    uint64_t x = a * 0x9e3779b97f4a7c15u + b + 0x7f4a7c15u;
    x = (x ^ (x >> 33)) * 0xff51afd7ed558ccdu;
    x = (x ^ (x >> 33)) * 0xc4ceb9fe1a85ec53u;
    return x ^ (x >> 33);
}
