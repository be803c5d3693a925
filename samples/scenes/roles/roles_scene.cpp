#include "samples/scenes/roles/roles_scene.h"

#include <algorithm>
#include <cmath>

#include "lib/base/near_names.h"
#include "samples/scenes/roles/performer.h"
#include "samples/scenes/sky.h"
#include "samples/scenes/studio_ground.h"
#include "samples/scenes/template_names.h"

namespace scenes::roles
{
namespace
{

class RolesScene final : public Scene
{
public:
    RolesScene(Library &library, const CrowdOptions &crowd_options, const Scenario &scenario)
        : people_(scenario.people),
          light_(scenario.light.value_or(Daylight())),
          sky_(crowd_options.seed, Sky::Land::studio),
          crowd_(library, crowd_options)
    {
        for (const SocialClass &one : scenario.characters) {
            members_.emplace_back();
            members_.back().described = one;
            asked_at(one.at, [&] { walkers::take_template(library, members_.back(), crowd_options.lod); });
            kits_.push_back(std::make_unique<Kit>(library, crowd_.crowd(), members_.back().tmpl));
        }
        for (const Person &person : people_) asked_at(person.at_file, [&] { enter(person); });
        lay_ground();
    }

    clq_crowd *crowd() const override { return crowd_.crowd(); }
    std::vector<clq_actor> actors() const override { return actors_; }

    std::vector<clq_template *> templates() const override
    {
        std::vector<clq_template *> all;
        for (const walkers::Member &member : members_)
            if (std::find(all.begin(), all.end(), member.tmpl) == all.end()) all.push_back(member.tmpl);
        return all;
    }

    clq_camera camera(Shot shot, double aspect, double) const override
    {
        const double away = shot == Shot::close ? 3 : 3 + 2.2 * reach_;
        return look({middle_[0], middle_[1] + 1.2 + away * 0.15, middle_[2] + away},
                    {middle_[0], middle_[1] + 0.9, middle_[2]}, 40, aspect, 0.05, 40 * away + 200);
    }

    void place(double time_s) override
    {
        for (size_t i = 0; i < people_.size(); ++i)
            asked_at(people_[i].at_file, [&] { performers_[i]->perform(people_[i].role, time_s); });
        time_s_ = time_s;
    }

    void prepare(const Gl &) override {}

    void set_light(const Gl &g, const Eye &eye) const override { set_lights(g, light_, eye); }
    void draw_environment(const Gl &g, const Eye &eye) const override
    {
        g.Disable(gl::texture_2d);
        g.Disable(gl::lighting);  // the ground has its colours as they are
        ground_.draw(g);
        sky_.draw(g, eye);
        g.Disable(gl::lighting);
        for (const auto &one : performers_) one->draw_ground(g, eye, time_s_);
        g.Enable(gl::lighting);
    }

    bool can_cull_by_tile() const override { return false; }  // what people carry follows their poses

    void draw_things(const Gl &g, const Eye &eye) const override
    {
        for (const auto &one : performers_) one->draw_load(g, eye);
    }

private:
    void enter(const Person &person)
    {
        clq_template *tmpl = members_[person.member].tmpl;
        clq_actor_def def = clq_actor_def_init();
        def.tmpl = tmpl, def.seed = person.seed;
        std::copy(person.at.begin(), person.at.end(), def.transform.position);
        std::copy(person.orientation.begin(), person.orientation.end(), def.transform.orientation_xyzw);
        def.transform.scale = person.scale;
        if (!person.textures.empty()) {
            def.texture_set = clq_template_find_texture_set(tmpl, person.textures.c_str());
            if (def.texture_set == CLQ_NONE)
                throw Failure("there are no textures '" + person.textures + "'" +
                              claque::base::names_near(person.textures, names_of_texture_sets(tmpl)));
        }
        clq_actor actor = {};
        check(clq_actor_create(crowd(), &def, &actor));
        actors_.push_back(actor);
        std::vector<float> rgb;
        for (const auto &colour : person.colours)
            for (const uint8_t byte : colour) rgb.push_back(static_cast<float>(byte) / 255);
        if (rgb.empty()) check(clq_actor_randomise_colours(crowd(), actor, nullptr, 0));
        else check(clq_actor_set_colours(crowd(), actor, rgb.data(), static_cast<uint32_t>(rgb.size() / 3)));
        // It begins with nothing, so that all of its role is told.
        performers_.push_back(
            std::make_unique<Performer>(crowd(), actor, *kits_[person.member], present_role(crowd(), actor)));
        for (size_t k = 0; k < 3; ++k) middle_[k] += person.at[k] / static_cast<double>(people_.size());
        for (const Person &other : people_)
            reach_ = std::max(reach_, std::hypot(other.at[0] - person.at[0], other.at[2] - person.at[2]) / 2);
    }

    void lay_ground() { lay_studio_ground(ground_, middle_[0], low(), middle_[2], 60 * (4 + reach_), 16 + 4 * reach_); }

    double low() const
    {
        double lowest = people_[0].at[1];
        for (const Person &person : people_) lowest = std::min(lowest, person.at[1]);
        return lowest;
    }

    std::vector<Person> people_;
    std::vector<walkers::Member> members_;
    std::vector<std::unique_ptr<Kit>> kits_;  // with mechanisms that the crowd calls
    Daylight light_;
    Sky sky_;
    SceneCrowd crowd_;
    std::vector<clq_actor> actors_;
    std::vector<std::unique_ptr<Performer>> performers_;
    Geometry ground_;
    std::array<double, 3> middle_ = {0, 0, 0};
    double reach_ = 0, time_s_ = 0;
};

}  // namespace

std::unique_ptr<Scene> make_scenario(Library &library, const CrowdOptions &crowd_options, const Scenario &scenario)
{
    return std::make_unique<RolesScene>(library, crowd_options, scenario);
}

}  // namespace scenes::roles
