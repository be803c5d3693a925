// To see culling at work (S0 Fig. 10): a pyramid that is narrower than the picture's, and marks on what was left over.
#pragma once

#include <osg/MatrixTransform>
#include <osg/NodeCallback>

#include <vector>

namespace osg_host
{

// On a scene's root: everything below it is culled by a pyramid so much narrower than the camera's.
class NarrowCulling : public osg::NodeCallback
{
public:
    double share = 1;  // (0, 1]
    void operator()(osg::Node *node, osg::NodeVisitor *visitor) override;
};

// Knows which nodes the last frame's culling left over.
class Marks
{
public:
    void watch(osg::Node &node);
    void clear();  // before a frame
    size_t count() const { return nodes_.size(); }
    size_t left_over() const;
    bool is_left(size_t number) const;

    // Paints grey what was culled when this is called, or everything as it is.
    void show_culled_as_ghosts();
    void show_as_they_are();

private:
    class Mark : public osg::NodeCallback
    {
    public:
        bool left = false;
        void operator()(osg::Node *node, osg::NodeVisitor *visitor) override
        {
            left = true;
            traverse(node, visitor);
        }
    };
    std::vector<osg::ref_ptr<osg::Node>> nodes_;
    std::vector<osg::ref_ptr<Mark>> marks_;
};

// The edges of a camera's pyramid as lines in the world, to reach_m away.
osg::ref_ptr<osg::Node> frustum_lines(const osg::Matrixd &view, const osg::Matrixd &projection, double reach_m);

// The margin of a narrow pyramid as a rectangle over the picture.
osg::ref_ptr<osg::Node> margin_lines(double share);

}  // namespace osg_host
