#include "samples/scenes/roles/kit.h"

#include <algorithm>
#include <cmath>

#include "lib/base/near_names.h"
#include "samples/scenes/roles/gaze.h"
#include "samples/scenes/template_names.h"

namespace scenes::roles
{
namespace
{

clq_dof_pose pose_of(const DofValues &values) { return {static_cast<uint32_t>(values.size()), values.data()}; }

void write_by_hand(void *user, const clq_behaviour_call *call, clq_dof_writer *writer)
{
    const auto &values = *static_cast<const std::map<uint32_t, std::vector<float>> *>(user);
    const auto found = values.find(call->actor.index1);
    if (found == values.end()) return;
    for (size_t k = 0; k < found->second.size(); ++k)
        if (!std::isnan(found->second[k])) clq_dof_write(writer, static_cast<uint32_t>(k), found->second[k], 1);
}

std::string name_of(const clq_template *tmpl)
{
    clq_template_info info = clq_template_info_init();
    check(clq_template_get_info(tmpl, &info));
    return info.name;
}

}  // namespace

Kit::Kit(Library &library, clq_crowd *crowd, clq_template *tmpl)
    : library_(library), crowd_(crowd), tmpl_(tmpl), faces_(faces_of(tmpl))
{
    if (faces_.looks) faces_.gaze = gaze_of(library, tmpl, faces_);
    member_.tmpl = tmpl;
    member_.described.character = name_of(tmpl);
}

uint32_t Kit::clip(const std::string &name) const
{
    if (name.empty()) return CLQ_NONE;
    const uint32_t found = clq_template_find_clip(tmpl_, name.c_str());
    if (found == CLQ_NONE)
        throw Failure(name_of(tmpl_) + " has no clip '" + name + "'" +
                      claque::base::names_near(name, names_of_clips(tmpl_)));
    return found;
}

uint32_t Kit::node(const std::string &name) const
{
    const uint32_t found = clq_template_find_node(tmpl_, name.c_str());
    if (found == CLQ_NONE)
        throw Failure(name_of(tmpl_) + " has no joint '" + name + "'" +
                      claque::base::names_near(name, names_of_nodes(tmpl_)));
    return found;
}

clq_mask Kit::mask(const std::string &joint, bool inverted)
{
    if (joint.empty()) return {};
    node(joint);
    clq_mask &made = masks_[{joint, inverted}];
    if (made.index1 != 0) return made;
    const char *name = joint.c_str();
    clq_mask_def def = clq_mask_def_init();
    def.tmpl = tmpl_, def.node_count = 1, def.nodes = &name, def.inverted = inverted;
    check(clq_crowd_add_mask(crowd_, &def, &made));
    return made;
}

clq_mechanism_def Kit::def_of(clq_mechanism_kind kind) const
{
    clq_mechanism_def def = clq_mechanism_def_init();
    def.kind = kind, def.tmpl = tmpl_;
    return def;
}

clq_mechanism Kit::add(const clq_mechanism_def &def) const
{
    clq_mechanism made = {};
    check(clq_crowd_add_mechanism(crowd_, &def, &made));
    return made;
}

clq_mechanism Kit::gaze()
{
    if (!faces_.looks) throw Failure(name_of(tmpl_) + " has no degrees of freedom to look with");
    clq_mechanism_def def = def_of(CLQ_MECHANISM_GAZE);
    def.gaze = faces_.gaze;
    if (gaze_.index1 == 0) gaze_ = add(def);
    return gaze_;
}

clq_mechanism Kit::blink()
{
    if (faces_.shut.empty()) throw Failure(name_of(tmpl_) + " has no lids to shut");
    clq_mechanism_def def = def_of(CLQ_MECHANISM_BLINK);
    def.blink.closed = pose_of(faces_.shut);
    if (blink_.index1 == 0) blink_ = add(def);
    return blink_;
}

// Pose 0 is the face at rest.
clq_mechanism Kit::expression()
{
    if (faces_.expressions.empty()) throw Failure(name_of(tmpl_) + " has no expressions");
    std::vector<clq_dof_pose> poses(1);
    for (const Expression &one : faces_.expressions) poses.push_back(pose_of(one.values));
    clq_mechanism_def def = def_of(CLQ_MECHANISM_EXPRESSION);
    def.expression.pose_count = static_cast<uint32_t>(poses.size()), def.expression.poses = poses.data();
    if (expression_.index1 == 0) expression_ = add(def);
    return expression_;
}

uint32_t Kit::expression_named(const std::string &name) const
{
    if (name.empty()) return CLQ_NONE;
    std::vector<std::string> names = {"at rest"};
    for (const Expression &one : faces_.expressions) names.push_back(one.name);
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
        throw Failure(name_of(tmpl_) + " has no expression '" + name + "'" + claque::base::names_near(name, names));
    return static_cast<uint32_t>(found - names.begin());
}

clq_mechanism Kit::phrase(const std::string &text)
{
    if (!faces_.speaks()) throw Failure(name_of(tmpl_) + " has no mouth to move");
    clq_mechanism &made = phrases_[text];
    if (made.index1 != 0) return made;
    const clq_dof_pose mouths[] = {pose_of(faces_.wide), pose_of(faces_.round), pose_of(faces_.narrow)};
    clq_mechanism_def def = def_of(CLQ_MECHANISM_PHRASE);
    const std::vector<clq_phrase_key> keys = keys_of(text, def.phrase.length_s);
    if (keys.empty()) throw Failure("a phrase needs letters");
    def.phrase.pose_count = 3, def.phrase.poses = mouths;
    def.phrase.key_count = static_cast<uint32_t>(keys.size()), def.phrase.keys = keys.data();
    def.phrase.pause_s = -1;
    made = add(def);
    return made;
}

clq_mechanism Kit::own(const MechanismFile &file)
{
    const std::string &path = file.path();
    const auto found = owns_.find(path);
    if (found != owns_.end()) return found->second;
    auto loaded = std::make_unique<SharedMechanism>(file, tmpl_);
    clq_mechanism_def def = def_of(CLQ_MECHANISM_HOST);
    def.host = loaded->host();
    const clq_mechanism made = add(def);
    loaded_[path] = std::move(loaded);
    return owns_[path] = made;
}

const char *Kit::own_name(const MechanismFile &file)
{
    own(file);
    return loaded_[file.path()]->name();
}

const clq_locomotion *Kit::walk()
{
    if (!member_.locomotion) member_.locomotion = walkers::locomotion_of(library_, member_);
    return member_.locomotion.get();
}

// It says that it has a memory, so that its people are posed anew in every frame, also while time stands still.
clq_mechanism Kit::hand()
{
    clq_mechanism_def def = def_of(CLQ_MECHANISM_HOST);
    def.host = {write_by_hand, &by_hand, true};
    if (hand_.index1 == 0) hand_ = add(def);
    return hand_;
}

}  // namespace scenes::roles
