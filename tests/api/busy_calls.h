// Every call of the C API for a crowd, a view, a scene or a renderer, with arguments that only a guard refuses.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/api/test_world.h"

namespace busy
{

struct Objects {
    TestWorld *world = nullptr;
    clq_crowd *crowd = nullptr;
    clq_actor actor = {0, 0};
    clq_group group = {0, 0};
    clq_attachment attachment = {0, 0};
    clq_view *view = nullptr;
    clq_scene *scene = nullptr;  // in which the actor has a key
    clq_renderer *renderer = nullptr;
    clq_colour_map *map = nullptr;
};

// What a call does with its object.
enum class Use { changes_crowd, reads_crowd, reads_view, renders };

struct Call {
    std::string name;
    Use use;
    std::function<clq_status(const Objects &)> run;  // calls that return a number: 0 is CLQ_BUSY
};

const std::vector<Call> &calls();
void add_view_calls(std::vector<Call> &all);
void add_view_settings(std::vector<Call> &all);
void add_scene_calls(std::vector<Call> &all);
clq_scene *new_scene(clq_crowd *crowd, clq_actor actor);

// A crowd with a group, a view, a renderer and a colour map; its last update showed individuals.
class Busy : public testing::Test
{
protected:
    void SetUp() override;
    void TearDown() override;

    clq_actor add_actor();

    TestWorld world_;
    Objects objects_;
    std::vector<clq_actor> actors_;
};

}  // namespace busy
