#include "samples/hosts/coin/portico.h"

#include <cmath>
#include <cstdlib>

#include <Inventor/SoDB.h>
#include <Inventor/SoInteraction.h>
#include <Inventor/SoSceneManager.h>
#include <Inventor/nodekits/SoNodeKit.h>
#include <Inventor/nodes/SoCube.h>
#include <Inventor/nodes/SoCylinder.h>
#include <Inventor/nodes/SoDirectionalLight.h>
#include <Inventor/nodes/SoMaterial.h>
#include <Inventor/nodes/SoTranslation.h>
#include <Inventor/system/gl.h>

#include "samples/scenes/random.h"
#include "samples/scenes/scene_crowd.h"

namespace coin_host
{
namespace
{

constexpr uint64_t seed = 1;
constexpr int columns = 6, persons = 60;
constexpr float length_m = 18, depth_m = 7, column_m = 4;

void start_coin()
{
    static const bool started = [] {
        // Coin asks GLX whether its context is direct, and takes one that is not GLX's for a remote display's.
        setenv("COIN_FULL_INDIRECT_RENDERING", "1", 0);
        setenv("COIN_DONT_INFORM_INDIRECT_RENDERING", "1", 0);
        SoDB::init();
        SoNodeKit::init();
        SoInteraction::init();
        return true;
    }();
    static_cast<void>(started);
}

void add(SoSeparator &to, SoNode *shape, const SbVec3f &at, const SbColor &colour)
{
    SoSeparator *one = new SoSeparator;
    SoTranslation *place = new SoTranslation;
    SoMaterial *material = new SoMaterial;
    place->translation = at;
    material->diffuseColor = colour;
    one->addChild(place);
    one->addChild(material);
    one->addChild(shape);
    to.addChild(one);
}

SoNode *box(float x, float y, float z)
{
    SoCube *cube = new SoCube;
    cube->width = x, cube->height = y, cube->depth = z;
    return cube;
}

}  // namespace

Portico::Portico(contexts::Offscreen &context) : context_(context), library_(1)
{
    start_coin();
    root_ = new SoSeparator;
    root_->ref();
    cast();
    build();
    manager_ = std::make_unique<SoSceneManager>();
    manager_->setViewportRegion(
        SbViewportRegion(static_cast<short>(context.width()), static_cast<short>(context.height())));
    manager_->setBackgroundColor(SbColor(0.55f, 0.68f, 0.82f));
    manager_->setSceneGraph(root_);
}

Portico::~Portico()
{
    context_.make_current();
    manager_.reset();
    root_->unref();
}

void Portico::cast()
{
    clq_crowd_def def = clq_crowd_def_init();
    def.seed = seed;
    clq_crowd *crowd = nullptr;
    scenes::check(clq_crowd_create(library_.context(), &def, &crowd));
    crowd_.reset(crowd);
    const SbBox3f bounds(-length_m / 2, 0, -depth_m / 2, length_m / 2, 2, depth_m / 2);
    std::vector<clq_template *> templates;
    for (const char *name : {"citizen", "patrician", "plebeian"}) templates.push_back(library_.builtin(name, {}));
    people_ = std::make_unique<CrowdCallback>(library_.context(), crowd, templates, bounds);
    for (uint64_t i = 0; i < persons; ++i) {
        const auto between = [&](scenes::Purpose what, double a, double b) {
            return scenes::random_between(seed, i, what, a, b);
        };
        clq_actor_def one = clq_actor_def_init();
        one.tmpl = templates[i % templates.size()];
        one.seed = i;
        const double heading = between(scenes::Purpose::heading, -0.9, 0.9);
        one.transform = scenes::stand(between(scenes::Purpose::place_x, -0.45, 0.45) * double(length_m), 0,
                                      between(scenes::Purpose::place_z, -0.45, 0.45) * double(depth_m),
                                      std::sin(heading), std::cos(heading), 1);
        one.play.clip = clq_template_find_clip(one.tmpl, i % 4 == 0 ? "applaud" : "stand");
        one.play.phase_s = static_cast<float>(between(scenes::Purpose::phase, 0, 5));
        clq_actor actor;
        scenes::check(clq_actor_create(crowd, &one, &actor));
        scenes::check(clq_actor_randomise_colours(crowd, actor, nullptr, 0));
    }
}

// The people come between the floor and the columns, so that both show what the callback leaves of Coin's state.
void Portico::build()
{
    camera_ = new SoPerspectiveCamera;
    camera_->position = SbVec3f(4, 3.2f, 11);
    camera_->pointAt(SbVec3f(-0.5f, 1.3f, 0), SbVec3f(0, 1, 0));
    camera_->nearDistance = 0.5f, camera_->farDistance = 80;
    camera_->heightAngle = 0.75f;
    root_->addChild(camera_);
    SoDirectionalLight *sun = new SoDirectionalLight;
    sun->direction = SbVec3f(-0.5f, -0.6f, -0.6f);
    root_->addChild(sun);
    const SbColor stone(0.82f, 0.78f, 0.70f), paving(0.66f, 0.58f, 0.48f);
    add(*root_, box(length_m + 2, 0.2f, depth_m + 2), SbVec3f(0, -0.1f, 0), paving);
    people_here_ = new SoSeparator;
    people_here_->addChild(people_->node());
    root_->addChild(people_here_);
    for (int i = 0; i < columns; ++i) {
        SoCylinder *column = new SoCylinder;
        column->radius = 0.28f, column->height = column_m;
        const float x = length_m * (static_cast<float>(i) / (columns - 1) - 0.5f);
        add(*root_, column, SbVec3f(x, column_m / 2, -depth_m / 2), stone);
    }
    add(*root_, box(length_m + 2, 0.7f, 1.2f), SbVec3f(0, column_m + 0.35f, -depth_m / 2), stone);
}

const std::vector<uint8_t> &Portico::picture(double time_s)
{
    people_->set_time(time_s);
    glEnable(GL_DEPTH_TEST);  // which Coin leaves to its viewers
    manager_->render();
    if (!people_->failure().empty()) throw scenes::Failure(people_->failure());
    context_.read_rgb(rgb_);
    return rgb_;
}

}  // namespace coin_host
