#include "samples/view/designer/dresser.h"

#include <algorithm>
#include <tuple>

namespace view
{
namespace
{

bool same_actor(const clq_actor &a, const clq_actor &b) { return a.index1 == b.index1 && a.generation == b.generation; }

// By the name of its class, else by its template's, as claque's command gives maps to scenes.
SharedClass class_for_person(const Design &design, const std::string &called, const std::string &tmpl)
{
    for (const SharedClass &one : design.classes)
        if (!called.empty() && one->name == called) return one;
    for (const SharedClass &one : design.classes)
        if (one->tmpl == tmpl) return one;
    return nullptr;
}

}  // namespace

void Dresser::forget()
{
    people_.clear();
    maps_.clear();
    dressed_ = false;
}

bool Dresser::idle(const Designer &designer) const
{
    return !dressed_ && designer.design.classes.empty() && designer.sets.empty();
}

bool Dresser::meet(const clq_crowd *crowd, const std::vector<clq_actor> &people,
                   const std::function<std::string(size_t)> &called)
{
    const bool same = people.size() == people_.size() &&
                      std::equal(people.begin(), people.end(), people_.begin(),
                                 [](const clq_actor &a, const Person &b) { return same_actor(a, b.actor); });
    if (same) return false;
    std::map<uint32_t, Person> known;
    for (Person &one : people_) known[one.actor.index1] = std::move(one);
    people_.clear();
    for (size_t k = 0; k < people.size(); ++k) {
        const auto found = known.find(people[k].index1);
        if (found != known.end() && same_actor(found->second.actor, people[k])) {
            people_.push_back(std::move(found->second));
            continue;
        }
        clq_actor_info info = clq_actor_info_init();
        clq_template_info tmpl = clq_template_info_init();
        scenes::check(clq_actor_get_info(crowd, people[k], &info));
        scenes::check(clq_template_get_info(info.tmpl, &tmpl));
        Person one;
        one.actor = people[k];
        one.tmpl = info.tmpl;
        one.tmpl_name = tmpl.name;
        one.called = called(k);
        one.own.resize(3 * static_cast<size_t>(tmpl.zone_count));
        one.own_set = one.set = info.texture_set;
        scenes::check(clq_actor_get_colours(crowd, one.actor, one.own.data(), tmpl.zone_count));
        people_.push_back(std::move(one));
    }
    return true;
}

const clq_colour_map *Dresser::map(clq_context *context, const SharedClass &one)
{
    for (const auto &[made, map] : maps_)
        if (made == one) return map.get();
    Design alone;
    alone.classes.push_back(one);
    maps_.emplace_back(one, map_of(context, alone));
    return maps_.back().second.get();
}

size_t Dresser::colour(clq_context *context, clq_crowd *crowd, const Design &design, std::string &why_not)
{
    std::map<std::pair<const ColourClass *, const clq_template *>, std::pair<SharedClass, std::vector<clq_actor>>>
        groups;
    size_t changed = 0;
    for (Person &one : people_) {
        const SharedClass wanted = class_for_person(design, one.called, one.tmpl_name);
        if (wanted == one.worn) continue;
        one.worn = wanted;
        ++changed;
        if (!wanted) {
            scenes::check(
                clq_actor_set_colours(crowd, one.actor, one.own.data(), static_cast<uint32_t>(one.own.size() / 3)));
            continue;
        }
        auto &[shared, actors] = groups[{wanted.get(), one.tmpl}];
        shared = wanted;
        actors.push_back(one.actor);
    }
    for (const auto &[key, group] : groups) try {
            const auto count = static_cast<uint32_t>(group.second.size());
            scenes::check(clq_crowd_randomise_colours(crowd, map(context, group.first), 0, group.second.data(), count));
        } catch (const scenes::Failure &failure) {
            why_not = failure.what();
        }
    maps_.erase(std::remove_if(maps_.begin(), maps_.end(),
                               [&](const auto &made) {
                                   return std::find(design.classes.begin(), design.classes.end(), made.first) ==
                                          design.classes.end();
                               }),
                maps_.end());
    return changed;
}

void Dresser::put_on_sets(clq_crowd *crowd, const Designer &designer)
{
    for (Person &one : people_) {
        const auto chosen = designer.sets.find(one.tmpl_name);
        const uint32_t set = chosen == designer.sets.end() ? one.own_set : chosen->second;
        if (set == one.set) continue;
        if (clq_actor_set_texture_set(crowd, one.actor, set) == CLQ_OK) one.set = set;
    }
}

size_t Dresser::dress(clq_context *context, clq_crowd *crowd, const std::vector<clq_actor> &people,
                      const std::function<std::string(size_t)> &called, const Designer &designer, std::string &why_not)
{
    if (idle(designer)) return 0;
    const bool others = meet(crowd, people, called);
    put_on_sets(crowd, designer);
    if (dressed_ && !others && designer.design.classes == last_) return 0;
    dressed_ = true;
    last_ = designer.design.classes;
    return colour(context, crowd, designer.design, why_not);
}

}  // namespace view
