#include "samples/hosts/osg/plugin/troupe.h"

#include <osg/Group>
#include <osg/Transform>
#include <osg/Viewport>

#include "samples/hosts/osg/plugin/up_axis.h"
#include "samples/scenes/random.h"

namespace osg_plugin
{
namespace
{

using scenes::check;

constexpr uint64_t seed = 1;
constexpr float fade_s = 0.25f;

// The places of what hangs below the root: vehicles, say, that drive while all people wait for them.
double places_below(const osg::Node &root)
{
    double sum = 0;
    const osg::Group *group = root.asGroup();
    for (unsigned i = 0; group && i < group->getNumChildren(); ++i) {
        const osg::Transform *moved = group->getChild(i)->asTransform();
        osg::Matrix matrix;
        if (!moved || !moved->computeLocalToWorldMatrix(matrix, nullptr)) continue;
        const osg::Vec3d at = matrix.getTrans();
        sum += (i + 1) * (at.x() + 2 * at.y() + 4 * at.z());
    }
    return sum;
}

}  // namespace

Troupe::Troupe(scenes::Library &library)
{
    clq_crowd_def def = clq_crowd_def_init();
    def.seed = seed;
    clq_crowd *made = nullptr;
    check(clq_crowd_create(library.context(), &def, &made));
    crowd_.reset(made);
    check(clq_view_create(made, &view_));
}

void Troupe::begin(unsigned frame, const osg::Node *root)
{
    for (auto one = people_.begin(); one != people_.end();) {
        if (one->second.frame == frame_) {
            ++one;
            continue;
        }
        if (one->second.actor.index1 != 0) gone_.push_back(one->second.actor);
        one = people_.erase(one);
    }
    frame_ = frame;
    traversals_.clear();
    settled_ = false;
    const double places = root ? places_below(*root) : 0;
    scenery_moved_ = places != scenery_;
    scenery_ = places;
}

bool Troupe::begins(const osgUtil::CullVisitor &visitor, unsigned frame)
{
    if (frame != frame_) return true;
    return traversals_.insert({&visitor, const_cast<osgUtil::CullVisitor &>(visitor).getCurrentCamera()}).second;
}

void Troupe::report(const Path &path, const Member &member, const osg::Matrixd &to_world, unsigned frame)
{
    if (frame != frame_) begin(frame, path.empty() ? nullptr : path.front());
    const auto found = people_.find(path);
    if (found == people_.end()) {
        const uint64_t own = scenes::random_bits(seed, entered_++, scenes::Purpose::act);
        const double phase = scenes::random_unit(own, 0, scenes::Purpose::phase);
        people_.emplace(path, Individual{&member, {0, 0}, own, Steps(phase), to_world, 0, frame});
        return;
    }
    Individual &one = found->second;
    if (one.frame == frame) return;  // another view has reported it
    one.way_m = (to_world.getTrans() - one.to_world.getTrans()).length();
    one.to_world = to_world;
    one.frame = frame;
}

double Troupe::size_of(const Individual &one) const
{
    return one.member->scale() * scenes::random_between(one.seed, 0, scenes::Purpose::size, 0.95, 1.05);
}

void Troupe::enter(Individual &one, double time_s)
{
    clq_actor_def def = clq_actor_def_init();
    def.tmpl = one.member->tmpl();
    def.seed = one.seed;
    def.play = one.member->idle(one.seed);
    def.play.start_s = time_s;
    check(clq_actor_create(crowd_.get(), &def, &one.actor));
    one.member->colour(crowd_.get(), one.actor);
}

// A fade that is given again at its time takes the place of the former, so that it leads to the step of this frame.
void Troupe::play(Individual &one, double time_s)
{
    const bool walks = one.steps.walks(), changes = walks != one.walked;
    if (changes) one.walked = walks, one.changed_s = time_s;
    if (!walks && !changes) return;
    clq_fade_def fade = clq_fade_def_init();
    fade.play = walks ? one.member->gait_at(one.steps.phase()) : one.member->idle(one.seed);
    fade.at_s = fade.play.start_s = one.changed_s;
    fade.length_s = fade_s;
    const bool fading = time_s - one.changed_s <= static_cast<double>(fade_s);
    if (fading && clq_actor_fade_to(crowd_.get(), one.actor, &fade) == CLQ_OK) return;
    check(clq_actor_play(crowd_.get(), one.actor, &fade.play));
}

// Once a frame, when all views have reported.
void Troupe::settle(double time_s)
{
    for (const clq_actor actor : gone_) check(clq_actor_destroy(crowd_.get(), actor));
    gone_.clear();
    bool time_passed = scenery_moved_;
    for (const auto &[path, one] : people_) time_passed = time_passed || one.way_m > 0;
    std::vector<clq_actor> actors;
    std::vector<clq_transform> places;
    for (auto &[path, one] : people_) {
        if (one.actor.index1 == 0) enter(one, time_s);
        clq_transform place = transform_of(one.to_world);
        place.scale *= static_cast<float>(size_of(one));
        one.steps.move(one.way_m, one.member->stride() * static_cast<double>(place.scale), time_passed);
        one.way_m = 0;
        play(one, time_s);
        actors.push_back(one.actor);
        places.push_back(place);
    }
    check(clq_crowd_set_transforms(crowd_.get(), actors.data(), places.data(), static_cast<uint32_t>(actors.size())));
    settled_ = true;
}

void Troupe::draw(osg::State &state, clq_renderer *renderer)
{
    const double time_s = state.getFrameStamp() ? state.getFrameStamp()->getSimulationTime() : 0;
    if (!settled_) settle(time_s);
    const clq_camera camera = camera_of(state.getModelViewMatrix(), state.getProjectionMatrix());
    check(clq_view_set_camera(view_, &camera));
    if (const osg::Viewport *viewport = state.getCurrentViewport())
        check(clq_view_set_height(view_, static_cast<float>(viewport->height())));
    check(clq_crowd_update(crowd_.get(), time_s, &view_, 1));
    check(clq_renderer_draw(renderer, view_, nullptr));
}

}  // namespace osg_plugin
