#include "lib/api/assets/placement.h"

#include <cmath>
#include <limits>

#include "lib/base/error.h"
#include "lib/math/trig.h"
#include "lib/pose/facing_in_clips.h"

namespace claque::api
{

using base::fail;
using model::none;

namespace
{

constexpr double largest_scale = 1e6;
constexpr double lowest_person = 0.6, highest_person = 4, usual_person = 1.75;  // metres

bool is_scale(double scale) { return scale >= 1 / largest_scale && scale <= largest_scale; }

double scale_of(const model::Model &model, const clq_asset_options &options)
{
    if (options.scale != 0) return options.scale;
    if (options.height_m == 0) return 1;
    const Box box = rest_box(model);
    const double height = double(box.max[1]) - double(box.min[1]);
    if (!(height > 0))
        fail(CLQ_ARGUMENT,
             "height_m (--height) is %g, and the rest pose of '%s' has no height: scale (--scale) multiplies its size",
             options.height_m, model.name.c_str());
    const double scale = options.height_m / height;
    if (!is_scale(scale))
        fail(CLQ_ARGUMENT,
             "height_m (--height) is %g, %g times the height of '%s', which is %g: %g to %g times are possible",
             options.height_m, scale, model.name.c_str(), height, 1 / largest_scale, largest_scale);
    return scale;
}

void put_above(model::Model &model, const math::Trs &placed)
{
    model::Rig &rig = model.rig;
    const auto behind = [](uint32_t &node) {
        if (node != none) ++node;
    };
    for (uint32_t &parent : rig.parents) parent = parent == none ? 0 : parent + 1;
    rig.parents.insert(rig.parents.begin(), none);
    rig.rest.insert(rig.rest.begin(), placed);
    rig.node_names.emplace(rig.node_names.begin());
    if (!rig.deactivation_m.empty())
        rig.deactivation_m.insert(rig.deactivation_m.begin(), std::numeric_limits<float>::infinity());
    for (model::PaletteEntry &entry : rig.palette) behind(entry.node);
    for (model::MorphSet &set : rig.morph_sets) behind(set.node);
    for (model::Channel &channel : rig.channels)
        if (channel.target != model::ChannelTarget::morph_weights) behind(channel.node);
    for (model::Dof &dof : rig.dofs)
        if (dof.kind != model::DofKind::morph) behind(dof.node);
    for (model::Part &part : model.parts) behind(part.node);
    for (model::RootMotionRequest &motion : model.root_motions) behind(motion.node);
    for (auto &[bone, node] : model.human_bones) behind(node);
}

void name_facing(model::Model &model, double turn_deg)
{
    if (model.parts.empty()) return;
    const model::Facing facing = pose::facing_in_clips(model.rig);
    if (!facing.is_elsewhere()) return;
    const double turn = std::fmod(turn_deg + model::turn_to_front_deg(facing.heading_deg), 360);
    const bool toes = std::string_view(facing.seen) == "toes", eyes = std::string_view(facing.seen) == "eyes";
    model.warnings.push_back(base::text_of("the %s of '%s' %s %s, and characters face +z: ", facing.seen,
                                           model.name.c_str(),
                                           toes   ? "point to"
                                           : eyes ? "look to"
                                                  : "stand as if it faced",
                                           model::axis_of(facing.heading_deg)) +
                             (turn == 0 ? std::string("leave turn_deg (--turn) out")
                                        : base::text_of("turn_deg %g (--turn %g) turns it", turn, turn)));
}

// Files in centimetres, and toys.
void name_size(model::Model &model)
{
    if (model.parts.empty() || !model::is_person(model.rig)) return;
    const Box box = rest_box(model);
    const double height = double(box.max[1]) - double(box.min[1]);
    if (!(height > 0) || (height >= lowest_person && height <= highest_person)) return;
    model.warnings.push_back(base::text_of(
        "'%s' is %.3g high, and people are %g to %g: height_m %g (--height %g) or scale %.2g (--scale %.2g) makes it a "
        "person's size; a scale of 1 keeps it",
        model.name.c_str(), height, lowest_person, highest_person, usual_person, usual_person, usual_person / height,
        usual_person / height));
}

}  // namespace

void check_placement(const clq_asset_options &options)
{
    if (!std::isfinite(options.turn_deg))
        fail(CLQ_ARGUMENT, "turn_deg is %g: any finite angle is wanted", options.turn_deg);
    if (options.height_m != 0 && !(options.height_m > 0 && std::isfinite(options.height_m)))
        fail(CLQ_ARGUMENT, "height_m is %g: more than 0 is wanted", options.height_m);
    if (options.scale != 0 && !is_scale(options.scale))
        fail(CLQ_ARGUMENT, "scale is %g: %g to %g is wanted", options.scale, 1 / largest_scale, largest_scale);
    if (options.height_m != 0 && options.scale != 0)
        fail(CLQ_ARGUMENT, "height_m is %g and scale is %g: each gives the size; one of them is wanted",
             options.height_m, options.scale);
}

bool place(model::Model &model, double own_turn_deg, const clq_asset_options &options)
{
    const double given_deg = std::fmod(options.turn_deg, 360), turn_deg = std::fmod(own_turn_deg + given_deg, 360);
    const double scale = scale_of(model, options), half = turn_deg * math::pi / 360;
    const bool is_placed = turn_deg != 0 || scale != 1;
    if (is_placed) {
        math::Trs placed;
        placed.rotation = glm::quat(static_cast<float>(math::cos(half)), 0, static_cast<float>(math::sin(half)), 0);
        placed.scale = glm::vec3(static_cast<float>(scale));
        put_above(model, placed);
    }
    name_facing(model, given_deg);
    if (options.height_m == 0 && options.scale == 0) name_size(model);
    return is_placed;
}

}  // namespace claque::api
