#include "samples/view/ground/ground_panels.h"

namespace view
{

scenes::roles::Role *picked_role(Model &model, const World &world)
{
    clq_actor_info info = clq_actor_info_init();
    if (!world.find(model.picked.actor, info)) return nullptr;
    return &world.workbench().role_of(model, model.picked.actor);
}

void ground_panels(Ui &ui, Model &model, const World &world)
{
    GroundSections &open = model.ground.open;
    clq_actor_info info = clq_actor_info_init();
    const bool picked = world.find(model.picked.actor, info);
    const auto section = [&](const char *name, bool &is_open, auto &&panel) {
        if (!ui.section(name, is_open)) return;
        if (!picked) return ui.faint("Click a person in the picture.");
        // A role that no widget changed is not kept.
        const bool had = model.ground.roles.count(model.picked.actor.index1) != 0;
        scenes::roles::Role &role = *picked_role(model, world);
        const scenes::roles::Role before = role;
        panel(role);
        if (!had && role == before) model.ground.roles.erase(model.picked.actor.index1);
    };
    section("Motion", open.motion, [&](scenes::roles::Role &role) { motion_panel(ui, model, role, info.tmpl); });
    section("Face", open.face, [&](scenes::roles::Role &role) { face_panel(ui, model, role); });
    section("Flight", open.flight, [&](scenes::roles::Role &role) { flight_panel(ui, model, role, info.tmpl); });
    section("State", open.state, [&](scenes::roles::Role &) { state_panel(ui, model); });
    section("Check", open.check, [&](scenes::roles::Role &) { check_panel(ui, model, world, info.tmpl); });
}

void mouse_choice(Ui &ui, Model &model, const std::string &list, Tool tool, const char *name)
{
    int chosen = model.ground.tool == tool ? 1 : 0;
    if (ui.choice(list.c_str(), chosen, {"camera", name})) model.ground.tool = chosen == 1 ? tool : Tool::camera;
}

std::vector<std::string> joints_of(const clq_template *tmpl)
{
    static const char *const usual[] = {"spine",
                                        "chest",
                                        "neck",
                                        "head",
                                        "upper_arm_l",
                                        "upper_arm_r",
                                        "hand_l",
                                        "hand_r",
                                        "Spine",
                                        "Spine1",
                                        "Chest",
                                        "Neck",
                                        "Head",
                                        "LeftArm",
                                        "RightArm",
                                        "LeftHand",
                                        "RightHand",
                                        "upperarm.l",
                                        "upperarm.r",
                                        "handslot.l",
                                        "handslot.r",
                                        "UpperArm.L",
                                        "UpperArm.R",
                                        "Torso",
                                        "Abdomen",
                                        "arm_left",
                                        "arm_right",
                                        "wing_left",
                                        "wing_right",
                                        "legs",
                                        "mixamorig:Spine",
                                        "mixamorig:Head",
                                        "mixamorig:LeftArm",
                                        "mixamorig:RightArm"};
    std::vector<std::string> found;
    for (const char *name : usual)
        if (clq_template_find_node(tmpl, name) != CLQ_NONE) found.emplace_back(name);
    return found;
}

}  // namespace view
