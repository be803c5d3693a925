// A claque crowd as a node of an OpenSceneGraph: updated in the cull traversal, drawn in the draw traversal, and culled
// together with the scenery in both directions (S0 4.3):
//
//   gate()  actors depend on a node: a group is on in the frames in which that node was not culled
//   hold()  a node depends on an actor: it hangs from a joint, the actor's spheres grow round it, and it is culled with them
//
// It has to be traversed after the nodes that gate groups: put it last. One camera draws it; the camera computes no near
// and far planes of its own, or people and scenery would disagree about depth.
#pragma once

#include <claque/claque.h>

#include <osg/Group>
#include <osg/MatrixTransform>
#include <osgUtil/CullVisitor>

#include <string>
#include <vector>

namespace osg_host
{

class CrowdNode : public osg::Group
{
public:
    // Neither is owned; both outlive it. The renderer is of the context that draws this, its guard CLQ_GUARD_FULL: what
    // osg::State believes about GL is then true after a draw.
    CrowdNode(clq_crowd *crowd, clq_renderer *renderer);

    // The node may have parents of its own; culling it switches the group off, and so does hiding it.
    void gate(osg::Node &node, clq_group group);

    // Upright at the actor's joint. radius_m: of a sphere round the joint that holds it.
    void hold(clq_actor actor, const char *joint, osg::Node &object, float radius_m);

    void set_height(float height_px);     // of the camera's picture
    void set_cull_scale(float scale);     // see clq_view_set_cull_scale
    const std::string &failure() const;   // what went wrong in the last frame, or ""
    const clq_draw_stats &drawn() const;  // the last frame

    bool is_shown(clq_actor actor) const;
    // Whether the object was passed on to be culled and drawn in the last frame.
    bool is_held_shown(size_t number) const { return held_[number].shown; }

    void traverse(osg::NodeVisitor &visitor) override;

protected:
    ~CrowdNode() override;

private:
    class People;
    class Gate;
    struct Held {
        clq_actor actor;
        uint32_t joint;
        osg::ref_ptr<osg::MatrixTransform> place;
        bool shown;
    };
    void update(osgUtil::CullVisitor &visitor, double time_s);
    void cull_held(osgUtil::CullVisitor &visitor);
    void note(clq_status status);

    clq_crowd *crowd_;
    clq_view *view_ = nullptr;
    osg::ref_ptr<People> people_;
    std::vector<osg::ref_ptr<Gate>> gates_;
    std::vector<Held> held_;
    std::string failure_;
};

}  // namespace osg_host
