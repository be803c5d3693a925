// The people below one root of a scenegraph: a crowd in which every path from the root to a description of people is an
// individual. Each view's cull traversal reports the paths; its draw traversal then draws them all at once.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <vector>

#include <osg/Node>
#include <osg/State>
#include <osgUtil/CullVisitor>

#include "samples/hosts/osg/plugin/member.h"
#include "samples/hosts/osg/plugin/steps.h"

namespace osg_plugin
{

class Troupe
{
public:
    explicit Troupe(scenes::Library &library);

    using Path = std::vector<const osg::Node *>;  // from the root down
    // An individual is at this place in this frame. Those that no view reported in a frame are gone in the next.
    void report(const Path &path, const Member &member, const osg::Matrixd &to_world, unsigned frame);
    // Whether this is the first report of this traversal; the caller then has the troupe drawn.
    bool begins(const osgUtil::CullVisitor &visitor, unsigned frame);

    // Updates the crowd for the camera of this state and draws it. Throws scenes::Failure.
    void draw(osg::State &state, clq_renderer *renderer);

private:
    struct Individual {
        const Member *member;
        clq_actor actor = {0, 0};  // none before the first draw
        uint64_t seed;
        Steps steps;
        osg::Matrixd to_world;
        double way_m = 0;  // since the frame before
        unsigned frame;    // of the last report
        bool walked = false;
        double changed_s = -1e9;  // when it began to walk or to stand
    };
    void begin(unsigned frame, const osg::Node *root);
    void settle(double time_s);
    void enter(Individual &one, double time_s);
    void play(Individual &one, double time_s);
    double size_of(const Individual &one) const;

    scenes::Own<clq_crowd> crowd_;
    clq_view *view_ = nullptr;
    std::map<Path, Individual> people_;
    std::vector<clq_actor> gone_;
    std::set<std::pair<const osgUtil::CullVisitor *, const osg::Camera *>> traversals_;  // of this frame
    uint64_t entered_ = 0;
    std::optional<unsigned> frame_;  // of the last report
    bool settled_ = true, scenery_moved_ = false;
    double scenery_ = 0;  // a number that changes when something below the root moves
};

}  // namespace osg_plugin
