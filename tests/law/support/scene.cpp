#include "scene.h"

#include <gtest/gtest.h>

#include "lib/base/hash.h"
#include "lib/crowd/edits.h"
#include "lib/math/slerp.h"

namespace claque::testing_support
{

namespace
{

// Positions are hashes, so that a scene does not depend on earlier calls.
double random_unit(uint32_t actor, uint32_t what)
{
    return base::unit(base::hash(7, actor, base::Purpose::position, what));
}

crowd::Transform transform_of(uint32_t i, const glm::dvec3 &origin)
{
    crowd::Transform place;
    const double away = 2 + 68 * random_unit(i, 0);
    place.position = origin + glm::dvec3((random_unit(i, 1) - 0.5) * away, 0, -away);
    place.orientation = math::unit_quat(1, 0, 4 * random_unit(i, 2) - 2, 0);
    place.scale = float(i % 11 == 3 ? -0.9 : 0.8 + 0.4 * random_unit(i, 3));
    return place;
}

crowd::Play play_of(uint32_t i)
{
    crowd::Play play;
    play.clip = i % 9 == 8 ? model::none : i % 4;
    play.start_s = -random_unit(i, 4);
    play.speed = i % 7 == 5 ? -1.25f : float(0.7 + 0.6 * random_unit(i, 5));
    play.phase_s = float(random_unit(i, 6));
    return play;
}

}  // namespace

Scene::Scene(const SceneDef &def) : crowd(def.memory, 42), frame(def.memory, def.settings), def_(def)
{
    FigureDef figure;
    figure.seed = 11;
    templates[0] = make_figure(figure);
    figure.seed = 12;
    figure.nodes = 13;
    figure.vertices = 25;
    figure.shape = Shape::sheared;
    templates[1] = make_figure(figure);
    const float rgb[9] = {1, 0, 0, 0, 1, 0, 0.2f, 0.4f, 0.6f};
    for (uint32_t i = 0; i < def.actors; ++i) {
        const crowd::Id id = crowd::create(crowd, *templates[i % 3 == 1], transform_of(i, def.origin), play_of(i), i);
        if (i % 3 == 0) crowd::randomise_colours(crowd, id, nullptr, 0);
        if (i % 3 == 1) crowd::set_colours(crowd, id, rgb, 3);
        ids.push_back(id);
    }
    add_view(glm::dvec3(0, 1.7, 0), glm::dvec3(0, 1, -30));
}

frame::View &Scene::add_view(const glm::dvec3 &eye, const glm::dvec3 &target)
{
    views.push_back(std::make_unique<frame::View>(def_.memory));
    views.back()->height_px = 0;  // levels depend on distance alone
    look(uint32_t(views.size() - 1), eye, target);
    return *views.back();
}

void Scene::look(uint32_t view, const glm::dvec3 &eye, const glm::dvec3 &target)
{
    views[view]->camera =
        frame::look_at(def_.origin + eye, def_.origin + target, glm::vec3(0, 1, 0), 0.9f, 1.3f, 0.1f, 500);
}

base::Status Scene::try_update(double time_s, const base::Jobs &jobs)
{
    std::vector<frame::View *> list;
    for (const auto &view : views) list.push_back(view.get());
    return frame::update(crowd, frame, {list.data(), uint32_t(list.size())}, time_s, jobs);
}

uint64_t Scene::update(double time_s, const base::Jobs &jobs)
{
    const base::Status status = try_update(time_s, jobs);
    EXPECT_TRUE(status.ok()) << status.text;
    return hash();
}

uint64_t Scene::hash() const
{
    uint64_t h = base::fnv_start;
    for (const auto &view : views) {
        const uint64_t one = frame::hash(view->list);
        h = base::fnv(h, &one, sizeof one);
    }
    return h;
}

}  // namespace claque::testing_support
