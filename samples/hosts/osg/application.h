// The whole program: an osgViewer over an existing offscreen EGL context, the town, and people in it.
#pragma once

#include <osgViewer/Viewer>

#include "samples/contexts/offscreen.h"
#include "samples/hosts/osg/culling.h"
#include "samples/hosts/osg/street_life.h"
#include "samples/hosts/osg/town_graph.h"
#include "samples/scenes/library.h"

namespace osg_host
{

struct Viewpoint {
    osg::Vec3d from, at;
    double fov_y_deg, near_m, far_m;
};

class Application
{
public:
    // Throws scenes::Failure.
    Application(contexts::Offscreen &context, uint32_t people);
    ~Application();

    Viewpoint from_the_roofs() const;  // down on the square
    Viewpoint from_outside() const;    // on that frustum from beside it

    // Three bytes a pixel, top row first, valid until the next call. cull_share: see NarrowCulling.
    const std::vector<uint8_t> &picture(const Viewpoint &viewpoint, double time_s, double cull_share = 1);

    // Another view of the last picture's scene, with culled objects in grey and its frustum.
    const std::vector<uint8_t> &picture_of_culling(const Viewpoint &viewpoint, double time_s);

    CrowdNode &crowd() const { return *crowd_; }
    const StreetLife &street_life() const { return *life_; }
    const scenes::town::Passengers &passengers() const { return passengers_; }
    const Marks &pieces() const { return pieces_; }
    const Marks &omnibuses() const { return omnibuses_; }

private:
    void aim(const Viewpoint &viewpoint);
    void frame(double time_s);
    osg::Vec3d over(double u, double v, double metres) const;

    contexts::Offscreen &context_;
    scenes::Library library_;
    scenes::town::Town town_;
    scenes::town::Passengers passengers_;
    scenes::Own<clq_renderer> renderer_;
    osg::ref_ptr<CrowdNode> crowd_;
    std::unique_ptr<StreetLife> life_;
    osg::ref_ptr<osg::Group> root_, scene_;  // the latter is culled by the narrow frustum
    osg::ref_ptr<NarrowCulling> narrow_ = new NarrowCulling;
    Marks pieces_, omnibuses_;
    osgViewer::Viewer viewer_;
    std::vector<uint8_t> rgb_;
};

}  // namespace osg_host
