#include "samples/hosts/osg/street_life.h"

#include <cmath>

#include <osg/BlendFunc>
#include <osg/Depth>
#include <osg/PolygonOffset>

#include "samples/hosts/osg/convert.h"
#include "samples/hosts/osg/town_graph.h"
#include "samples/scenes/stone.h"

namespace osg_host
{
namespace
{

using namespace scenes;
using town::Omnibus;
using town::VehiclePose;

constexpr Rgb paints[] = {{0.62f, 0.14f, 0.13f}, {0.14f, 0.36f, 0.27f}, {0.15f, 0.27f, 0.50f}, {0.80f, 0.52f, 0.16f}};
constexpr float person_m = 1.75f, shadow_width_m = 0.95f;
constexpr float stick_m = 1.42f, canopy_m = 0.85f, parasol_reach_m = 1.75f;

osg::Matrixd matrix_of(const std::array<float, 16> &m) { return osg::Matrixd(osg::Matrixf(m.data())); }

// In the space of the hand that holds it, upright.
Geometry parasol(Rgb colour)
{
    Geometry g(town::leaves_metres);
    g.turned(0, 0, {{0.018f, -0.3f}, {0.018f, stick_m}}, 6, {0.42f, 0.30f, 0.20f});
    g.turned(0, 0,
             {{canopy_m, stick_m - 0.34f},
              {0.72f * canopy_m, stick_m - 0.12f},
              {0.4f * canopy_m, stick_m + 0.02f},
              {0.001f, stick_m + 0.08f}},
             10, colour);
    g.turned(0, 0,
             {{0.001f, stick_m + 0.06f},
              {0.4f * canopy_m, stick_m},
              {0.72f * canopy_m, stick_m - 0.14f},
              {canopy_m, stick_m - 0.36f}},
             10, colour * 0.6f);  // its inside
    return g;
}

osg::ref_ptr<osg::Geometry> painted(const Geometry &from, osg::StateSet &state)
{
    osg::ref_ptr<osg::Geometry> made = geometry_of(from);
    made->setStateSet(&state);
    return made;
}

}  // namespace

StreetLife::StreetLife(town::Passengers &passengers, CrowdNode &crowd) : passengers_(passengers), root_(new osg::Group)
{
    lay_shadows();
    build_omnibuses(crowd);
    open_parasols(crowd);
    crowd.getOrCreateStateSet()->setRenderBinDetails(people_bin, "RenderBin");
    root_->addChild(&crowd);
    move(0);
}

clq_actor StreetLife::holder(size_t number) const
{
    const std::vector<clq_actor> &everybody = passengers_.cast().actors();
    return everybody[passengers_.seated() + 3 * number];
}

// One body for all omnibuses of one colour; a transform for each.
void StreetLife::build_omnibuses(CrowdNode &crowd)
{
    osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    state->setRenderBinDetails(bin_of(town::SurfaceKind::stone), "RenderBin");
    state->setTextureAttributeAndModes(0, texture_of(plaster(1), true));
    std::vector<osg::ref_ptr<osg::Geometry>> bodies, wheels;
    for (const Rgb &paint : paints) {
        const Omnibus omnibus(paint);
        bodies.push_back(painted(omnibus.body(), *state));
        wheels.push_back(painted(omnibus.wheel(), *state));
    }
    for (size_t i = 0; i < passengers_.groups().size(); ++i) {
        osg::ref_ptr<osg::Group> omnibus = new osg::Group;
        Moving moving;
        moving.body = new osg::MatrixTransform;
        moving.body->addChild(bodies[i % bodies.size()]);
        omnibus->addChild(moving.body);
        for (osg::ref_ptr<osg::MatrixTransform> &wheel : moving.wheels) {
            wheel = new osg::MatrixTransform;
            wheel->addChild(wheels[i % wheels.size()]);
            omnibus->addChild(wheel);
        }
        crowd.gate(*omnibus, passengers_.groups()[i]);
        root_->addChild(omnibus);
        omnibuses_.push_back(omnibus);
        moving_.push_back(moving);
    }
}

void StreetLife::open_parasols(CrowdNode &crowd)
{
    constexpr Rgb colours[] = {
        {0.86f, 0.22f, 0.18f}, {0.96f, 0.84f, 0.42f}, {0.26f, 0.44f, 0.70f}, {0.93f, 0.90f, 0.84f}};
    osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    state->setRenderBinDetails(people_bin + 1, "RenderBin");
    for (size_t i = 0; i < parasol_count; ++i) {
        if (passengers_.seated() + 3 * i >= passengers_.cast().actors().size()) break;
        crowd.hold(holder(i), "hand_r", *painted(parasol(colours[i % 4]), *state), parasol_reach_m);
    }
}

// Not culled: shadows are few, and change in every frame.
void StreetLife::lay_shadows()
{
    shadows_ = new osg::Group;
    shadows_->setCullingActive(false);
    osg::StateSet *state = shadows_->getOrCreateStateSet();
    state->setRenderBinDetails(bin_of(town::SurfaceKind::shade), "RenderBin");
    state->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
    state->setMode(GL_CULL_FACE, osg::StateAttribute::OFF);
    state->setTextureAttributeAndModes(0, texture_of(Shadows::picture(), false));
    state->setAttributeAndModes(new osg::BlendFunc);
    state->setAttribute(new osg::Depth(osg::Depth::LEQUAL, 0, 1, false));
    state->setAttributeAndModes(new osg::PolygonOffset(-2, -4));
    root_->addChild(shadows_);
    cast_.cast(passengers_.standing(), town::Town::light().to_sun, person_m, shadow_width_m);
}

void StreetLife::move(double time_s)
{
    passengers_.drive(time_s);
    Geometry under;
    for (size_t i = 0; i < moving_.size(); ++i) {
        const VehiclePose &pose = passengers_.poses()[i];
        moving_[i].body->setMatrix(matrix_of(pose.matrix()));
        for (int w = 0; w < 4; ++w)
            moving_[i].wheels[w]->setMatrix(
                matrix_of(Omnibus::wheel_matrix(pose, w < 2 ? -1 : 1, w % 2 == 0 ? -1 : 1)));
        Omnibus::shade(under, pose, town::Town::light().to_sun);
    }
    shadows_->removeChildren(0, shadows_->getNumChildren());
    shadows_->addChild(geometry_of(cast_.people()));
    shadows_->addChild(geometry_of(under));
}

}  // namespace osg_host
