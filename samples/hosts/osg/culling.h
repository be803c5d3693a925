// Makes culling visible (S0 Fig. 10): a frustum that is narrower than the picture's, and marks on the culled objects.
#pragma once

#include <vector>

#include <osg/MatrixTransform>
#include <osg/NodeCallback>

namespace osg_host
{

// For a scene's root: everything below it is culled by a frustum narrower than the camera's by the factor `share`.
class NarrowCulling : public osg::NodeCallback
{
public:
    double share = 1;  // (0, 1]
    void operator()(osg::Node *node, osg::NodeVisitor *visitor) override;
};

// Records which nodes survived the last frame's culling.
class Marks
{
public:
    void watch(osg::Node &node);
    void clear();  // before a frame
    size_t count() const { return nodes_.size(); }
    size_t left_over() const;
    bool is_left(size_t number) const;

    // Paints the objects that are culled at this time in grey, or restores everything.
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

// The edges of a camera's frustum as lines in the world, to the distance reach_m.
osg::ref_ptr<osg::Node> frustum_lines(const osg::Matrixd &view, const osg::Matrixd &projection, double reach_m);

// The margin of a narrow frustum as a rectangle over the picture.
osg::ref_ptr<osg::Node> margin_lines(double share);

}  // namespace osg_host
