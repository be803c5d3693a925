#include "samples/hosts/osg/culling.h"

#include <algorithm>

#include <osg/Camera>
#include <osg/Geometry>
#include <osg/LineWidth>
#include <osg/Material>
#include <osgUtil/CullVisitor>

namespace osg_host
{
namespace
{

// State for drawing lines over everything.
void make_visible(osg::Node &lines)
{
    osg::StateSet *state = lines.getOrCreateStateSet();
    for (const GLenum off : {GL_LIGHTING, GL_FOG, GL_DEPTH_TEST}) state->setMode(off, osg::StateAttribute::OFF);
    state->setTextureMode(0, GL_TEXTURE_2D, osg::StateAttribute::OFF);
    state->setAttribute(new osg::LineWidth(2));
    state->setRenderBinDetails(20, "RenderBin");
    lines.setCullingActive(false);
}

osg::ref_ptr<osg::Geometry> lines_of(const std::vector<osg::Vec3> &ends, const osg::Vec4 &colour)
{
    osg::ref_ptr<osg::Geometry> made = new osg::Geometry;
    osg::ref_ptr<osg::Vec4Array> colours = new osg::Vec4Array(1, &colour);
    made->setVertexArray(new osg::Vec3Array(ends.begin(), ends.end()));
    made->setColorArray(colours, osg::Array::BIND_OVERALL);
    made->addPrimitiveSet(new osg::DrawArrays(GL_LINES, 0, static_cast<int>(ends.size())));
    make_visible(*made);
    return made;
}

const osg::Vec4 yellow(1, 0.9f, 0.1f, 1);

osg::ref_ptr<osg::StateSet> ghost()
{
    constexpr osg::StateAttribute::GLModeValue on = osg::StateAttribute::ON | osg::StateAttribute::OVERRIDE,
                                               off = osg::StateAttribute::OFF | osg::StateAttribute::OVERRIDE;
    osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    osg::ref_ptr<osg::Material> grey = new osg::Material;
    grey->setColorMode(osg::Material::OFF);
    grey->setAmbient(osg::Material::FRONT_AND_BACK, {0.62f, 0.63f, 0.66f, 1});
    grey->setDiffuse(osg::Material::FRONT_AND_BACK, {0.62f, 0.63f, 0.66f, 1});
    state->setAttribute(grey, on);
    state->setTextureMode(0, GL_TEXTURE_2D, off);
    return state;
}

}  // namespace

void NarrowCulling::operator()(osg::Node *node, osg::NodeVisitor *visitor)
{
    osgUtil::CullVisitor *cull = visitor->asCullVisitor();
    if (!cull || share >= 1) {
        traverse(node, visitor);
        return;
    }
    // OSG derives the frustum of each transform from this one.
    osg::Polytope &pyramid = cull->getProjectionCullingStack().back().getFrustum();
    pyramid.setToUnitFrustum(true, true);
    pyramid.transformProvidingInverse(*cull->getProjectionMatrix() * osg::Matrixd::scale(1 / share, 1 / share, 1));
    cull->pushModelViewMatrix(new osg::RefMatrix(*cull->getModelViewMatrix()), osg::Transform::ABSOLUTE_RF);
    traverse(node, visitor);
    cull->popModelViewMatrix();
}

void Marks::watch(osg::Node &node)
{
    nodes_.emplace_back(&node);
    marks_.push_back(new Mark);
    node.addCullCallback(marks_.back());
}

void Marks::clear()
{
    for (const osg::ref_ptr<Mark> &mark : marks_) mark->left = false;
}

size_t Marks::left_over() const
{
    return static_cast<size_t>(
        std::count_if(marks_.begin(), marks_.end(), [](const osg::ref_ptr<Mark> &mark) { return mark->left; }));
}

bool Marks::is_left(size_t number) const { return marks_[number]->left; }

void Marks::show_culled_as_ghosts()
{
    const osg::ref_ptr<osg::StateSet> grey = ghost();
    for (size_t i = 0; i < nodes_.size(); ++i) nodes_[i]->setStateSet(is_left(i) ? nullptr : grey.get());
}

void Marks::show_as_they_are()
{
    for (const osg::ref_ptr<osg::Node> &node : nodes_) node->setStateSet(nullptr);
}

osg::ref_ptr<osg::Node> frustum_lines(const osg::Matrixd &view, const osg::Matrixd &projection, double reach_m)
{
    const osg::Matrixd to_world = osg::Matrixd::inverse(view * projection);
    const osg::Vec3d eye = osg::Matrixd::inverse(view).getTrans();
    const auto at = [&](int corner, double away) {
        const double x = corner == 0 || corner == 3 ? -1 : 1, y = corner < 2 ? -1 : 1;
        const osg::Vec3d along = osg::Vec3d(x, y, 1) * to_world - eye;
        return osg::Vec3(eye + along * (away / along.length()));
    };
    std::vector<osg::Vec3> ends;
    for (int corner = 0; corner < 4; ++corner) {
        ends.emplace_back(eye);
        ends.push_back(at(corner, reach_m));
        for (const double share : {0.06, 1.0}) {
            ends.push_back(at(corner, share * reach_m));
            ends.push_back(at((corner + 1) % 4, share * reach_m));
        }
    }
    return lines_of(ends, yellow);
}

osg::ref_ptr<osg::Node> margin_lines(double share)
{
    const float s = static_cast<float>(share);
    osg::ref_ptr<osg::Camera> over = new osg::Camera;
    over->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
    over->setRenderOrder(osg::Camera::POST_RENDER);
    over->setClearMask(0);
    over->setProjectionMatrix(osg::Matrixd::identity());
    over->setViewMatrix(osg::Matrixd::identity());
    over->setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    over->setCullingActive(false);
    over->addChild(lines_of(
        {{-s, -s, 0}, {s, -s, 0}, {s, -s, 0}, {s, s, 0}, {s, s, 0}, {-s, s, 0}, {-s, s, 0}, {-s, -s, 0}}, yellow));
    return over;
}

}  // namespace osg_host
