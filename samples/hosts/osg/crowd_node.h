// A claque crowd as a node of an OpenSceneGraph: updated in the cull traversal, drawn in the draw traversal, and culled
// together with the scenery in both directions (S0 4.3):
//
//   gate()  actors depend on a node: a group is enabled in the frames in which that node was not culled
//   hold()  a node depends on an actor: it is attached to a joint, the actor's spheres include it, and it is culled
//           with them
//
// It must be traversed after the nodes that gate groups, so make it the last child. One camera draws it. That camera
// must not compute near and far planes of its own, or people and scenery would disagree about depth.
#pragma once

#include <claque/claque.h>

#include <string>
#include <vector>

#include <osg/Group>
#include <osg/MatrixTransform>
#include <osgUtil/CullVisitor>

namespace osg_host
{

class CrowdNode : public osg::Group
{
public:
    // Neither is owned; both must outlive the node. The renderer belongs to the context that draws this node, and its
    // guard is CLQ_GUARD_FULL, so that osg::State's assumptions about GL still hold after a draw.
    CrowdNode(clq_crowd *crowd, clq_renderer *renderer);

    // The node may have several parents; culling or hiding it disables the group.
    void gate(osg::Node &node, clq_group group);

    // Attaches the object upright at the actor's joint. radius_m: of a sphere round the joint that holds the object.
    void hold(clq_actor actor, const char *joint, osg::Node &object, float radius_m);

    void set_height(float height_px);     // of the camera's picture
    void set_cull_scale(float scale);     // see clq_view_set_cull_scale
    const std::string &failure() const;   // the error of the last frame, or ""
    const clq_draw_stats &drawn() const;  // the last frame

    bool is_shown(clq_actor actor) const;
    // True if the object was passed on to be culled and drawn in the last frame.
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
