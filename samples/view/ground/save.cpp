#include "samples/view/ground/save.h"

#include <algorithm>
#include <cstdio>

#include "samples/scenes/roles/person.h"
#include "samples/scenes/social_classes.h"
#include "samples/view/panels.h"

namespace view
{
namespace
{

using scenes::roles::Person;

Person person_of(const World &world, const Model &model, clq_actor actor)
{
    clq_actor_info info = clq_actor_info_init();
    if (!world.find(actor, info)) throw scenes::Failure("person " + std::to_string(actor.index1) + " is gone");
    Person person;
    person.character = character_of(world, info.tmpl);
    if (scenes::is_file(person.character)) person.placement = world.placement();
    const auto role = model.ground.roles.find(actor.index1);
    person.role = role != model.ground.roles.end() ? role->second : scenes::roles::present_role(world.crowd(), actor);
    // A treadmill or a path may have it elsewhere than where it stands.
    const bool moved = person.role.motion.treadmill_m_s || person.role.flight.flies();
    const clq_transform place = moved ? world.workbench().place_of(actor, info) : scenes::roles::place_of(info);
    std::copy(place.position, place.position + 3, person.at.begin());
    std::copy(place.orientation_xyzw, place.orientation_xyzw + 4, person.orientation.begin());
    person.scale = info.transform.scale;
    person.seed = info.seed;
    person.textures = clq_template_get_texture_set_name(info.tmpl, info.texture_set);
    const std::vector<uint8_t> rgb = world.colours(actor);
    for (size_t i = 0; i + 2 < rgb.size(); i += 3) person.colours.push_back({rgb[i], rgb[i + 1], rgb[i + 2]});
    return person;
}

std::string numbers(const Point &p)
{
    char text[100];
    std::snprintf(text, sizeof text, "[%.9f, %.9f, %.9f]", p[0], p[1], p[2]);
    return text;
}

std::string camera_text(const Model &model)
{
    const FreeCamera &camera = model.view.free;
    const double fov_deg = std::clamp(camera.fov_rad * 57.29577951308232, 5.0, 120.0);
    std::string out = "[camera]\nfar_m = 2000.0\n";
    for (const double time_s : {0.0, std::max(1.0, model.clock.last_s)})
        out += "\n[[camera.keys]]\ntime_s = " + fixed(time_s, 3) + "\neye = " + numbers(camera.eye()) +
               "\ntarget = " + numbers(camera.target) + "\nfov_deg = " + fixed(fov_deg, 6) +
               "\nnear_m = " + fixed(std::clamp(camera.distance_m * 0.02, 0.02, 2.0), 4) + "\n";
    return out;
}

}  // namespace

std::string character_of(const World &world, const clq_template *tmpl)
{
    if (tmpl == world.character() && !world.character_file().empty()) return world.character_file();
    clq_template_info info = clq_template_info_init();
    scenes::check(clq_template_get_info(tmpl, &info));
    if (scenes::is_builtin(info.name)) return info.name;
    throw scenes::Failure("the character " + std::string(info.name) + " comes from no file that a scenario could name");
}

std::string scenario_text(const World &world, const Model &model)
{
    std::vector<Person> people;
    for (const clq_actor actor : world.everyone())
        if (actor.index1 == model.picked.actor.index1 || model.ground.roles.count(actor.index1) != 0)
            people.push_back(person_of(world, model, actor));
    if (people.empty()) throw scenes::Failure("no individual is picked, and none has been told what to do");
    return "# At " + fixed(model.clock.time_s, 3) + " s of the testing ground: claque render --scenario FILE --time " +
           fixed(model.clock.time_s, 3) + " --camera path\n" +
           scenes::roles::text_of("testing ground", people, camera_text(model));
}

}  // namespace view
