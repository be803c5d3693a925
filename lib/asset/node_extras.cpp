#include "lib/asset/node_extras.h"

#include <algorithm>
#include <cmath>

#include "lib/base/error.h"

namespace claque::asset
{

using base::fail;
using model::DofKind;

namespace
{

constexpr size_t max_dofs = 4096;  // per node

DofKind kind_of(const JsonView &view)
{
    const std::string &text = view.text();
    if (text == "rotation") return DofKind::rotation;
    if (text == "translation") return DofKind::translation;
    if (text == "morph") return DofKind::morph;
    fail(CLQ_FORMAT, "%s is '%.60s': rotation, translation and morph are known", view.path().c_str(), text.c_str());
}

glm::vec3 read_axis(const JsonView &view)
{
    float a[3];
    view.numbers(a, 3);
    const double length = std::sqrt(double(a[0]) * a[0] + double(a[1]) * a[1] + double(a[2]) * a[2]);
    if (!(length > 1e-6 && std::isfinite(length)))
        fail(CLQ_FORMAT, "%s has length %g: no direction", view.path().c_str(), length);
    return glm::vec3(float(a[0] / length), float(a[1] / length), float(a[2] / length));
}

model::Dof read_dof(const JsonView &view)
{
    model::Dof dof;
    view.object();
    dof.kind = kind_of(view["kind"]);
    if (dof.kind == DofKind::morph) dof.morph_target = static_cast<uint32_t>(view["morph_target"].integer(0, 0xffff));
    else dof.axis = read_axis(view["axis"]);
    dof.min = view["min"].real();
    dof.max = view["max"].real();
    if (!(dof.min <= dof.max))
        fail(CLQ_FORMAT, "%s has a range from %g to %g, which goes down", view.path().c_str(),
             static_cast<double>(dof.min), static_cast<double>(dof.max));
    dof.rest = view["rest"].real_or(std::clamp(0.0f, dof.min, dof.max));
    if (!(dof.min <= dof.rest && dof.rest <= dof.max))
        fail(CLQ_FORMAT, "%s is %g, outside the range from %g to %g", view["rest"].path().c_str(),
             static_cast<double>(dof.rest), static_cast<double>(dof.min), static_cast<double>(dof.max));
    return dof;
}

void read_dofs(const JsonView &list, Budget &budget, NodeExtras &out)
{
    if (list.count() > max_dofs)
        fail(CLQ_LIMIT, "%s has %zu degrees of freedom: %zu are the most", list.path().c_str(), list.count(), max_dofs);
    budget.charge(list.count() * (sizeof(model::Dof) + 4 * sizeof(std::string)), list.path().c_str());
    for (size_t i = 0; i < list.count(); ++i) {
        const JsonView view = list.at(i);
        out.dofs.push_back(read_dof(view));
        out.dof_names.push_back(view["name"].text_or(""));
        out.dof_paths.push_back(view.path());
    }
}

void read_lod(const JsonView &view, NodeExtras &out)
{
    float range[2] = {0, std::numeric_limits<float>::infinity()};
    view.numbers(range, view.count() == 1 ? 1 : 2);
    if (!(range[0] >= 0 && range[1] > range[0]))
        fail(CLQ_FORMAT, "%s is from %g m to %g m: 0 <= first < last is wanted", view.path().c_str(),
             static_cast<double>(range[0]), static_cast<double>(range[1]));
    out.lod_min_m = range[0], out.lod_max_m = range[1];
    out.has_lod = true;
}

}  // namespace

std::unique_ptr<NodeExtras> read_node_extras(const JsonView &extras, Budget &budget)
{
    // Extras of other programs may be anything; only the member with claque's name is checked.
    if (!extras.exists() || !extras.is_object()) return nullptr;
    const JsonView ours = extras["claque"];
    if (!ours.exists()) return nullptr;
    budget.charge(sizeof(NodeExtras), ours.path().c_str());
    auto out = std::make_unique<NodeExtras>();
    const JsonView stop = ours["deactivation_m"];
    if (stop.exists()) out->deactivation_m = stop.real();
    if (!(out->deactivation_m > 0))
        fail(CLQ_FORMAT, "%s is %g m: more than 0 is wanted", stop.path().c_str(),
             static_cast<double>(out->deactivation_m));
    if (ours["lod_m"].exists()) read_lod(ours["lod_m"], *out);
    if (ours["dofs"].exists()) read_dofs(ours["dofs"], budget, *out);
    return out;
}

}  // namespace claque::asset
