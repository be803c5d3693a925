#include "lib/asset/clip_extras.h"

#include <algorithm>

#include "lib/base/near_names.h"

namespace claque::asset
{

using base::fail;

namespace
{

constexpr size_t max_markers = 4096;  // per clip

struct Named {
    float time_s;
    std::string name;
};

Named read_marker(const JsonView &view, const model::Clip &clip)
{
    view.object();
    const Named marker = {view["time_s"].real(), view["name"].text()};
    if (marker.name.empty()) fail(CLQ_FORMAT, "%s is empty: a marker has a name", view["name"].path().c_str());
    const float last_s = clip.start_s + clip.duration_s;
    if (!(marker.time_s >= clip.start_s && marker.time_s <= last_s))
        fail(CLQ_FORMAT, "%s is %g s: the animation's keys go from %g to %g s", view["time_s"].path().c_str(),
             static_cast<double>(marker.time_s), static_cast<double>(clip.start_s), static_cast<double>(last_s));
    return marker;
}

void read_markers(const JsonView &list, Budget &budget, model::Rig &rig)
{
    if (list.count() > max_markers)
        fail(CLQ_LIMIT, "%s has %zu markers: %zu are the most", list.path().c_str(), list.count(), max_markers);
    budget.charge(list.count() * (sizeof(model::Marker) + 4 * sizeof(std::string)), list.path().c_str());
    std::vector<Named> markers;
    for (size_t i = 0; i < list.count(); ++i) markers.push_back(read_marker(list.at(i), rig.clips.back()));
    std::stable_sort(markers.begin(), markers.end(),
                     [](const Named &a, const Named &b) { return a.time_s < b.time_s; });
    for (const Named &marker : markers) {
        rig.markers.push_back({static_cast<uint32_t>(rig.clips.size()) - 1, marker.time_s});
        rig.marker_names.emplace_back(marker.name.c_str());
    }
}

uint32_t read_root(const JsonView &view, const model::Rig &rig, File &file)
{
    const std::string &name = view.text();
    // As Rig::find_node: the first of equal names. All nodes are known before the first clip.
    if (file.node_of_name.empty())
        for (uint32_t n = 0; n < rig.node_count(); ++n) file.node_of_name.emplace(rig.node_names[n], n);
    const auto found = file.node_of_name.find(name);
    if (found == file.node_of_name.end())
        fail(CLQ_FORMAT, "%s is '%.60s': no node of the character is called that%s", view.path().c_str(), name.c_str(),
             base::names_near(name, rig.node_names).c_str());
    return found->second;
}

}  // namespace

void read_clip_extras(const JsonView &extras, File &file, model::Rig &rig)
{
    // Extras of other programs may be anything; only the member with claque's name is checked.
    if (!extras.exists() || !extras.is_object()) return;
    const JsonView ours = extras["claque"];
    if (!ours.exists()) return;
    ours.object();
    if (ours["markers"].exists()) read_markers(ours["markers"], file.budget, rig);
    const JsonView root = ours["root_motion"];
    if (root.exists())
        file.root_motions.push_back({static_cast<uint32_t>(rig.clips.size()) - 1, read_root(root, rig, file)});
}

}  // namespace claque::asset
