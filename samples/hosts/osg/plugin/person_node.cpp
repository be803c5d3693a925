#include "samples/hosts/osg/plugin/person_node.h"

#include <osg/Geode>
#include <osgUtil/CullVisitor>

#include "samples/hosts/osg/plugin/company.h"
#include "samples/hosts/osg/plugin/warning.h"

namespace osg_plugin
{
namespace
{

// SUMO scales a model from these bounds to the size of its vType: they are its usual pedestrian's.
constexpr float width_m = 0.478f, depth_m = 0.215f, height_m = 1.719f;
constexpr float reach_m = 1.2f;  // of limbs, for the near and far planes

// Stands for an individual on each path that leads to it, and is never drawn itself.
class PersonDrawable : public osg::Drawable
{
public:
    explicit PersonDrawable(const PersonFile &file) : company_(Company::shared()), member_(company_.engage(file))
    {
        setSupportsDisplayList(false);
        setCullingActive(false);  // claque culls people, by bounds that hold their steps
        setCullCallback(new Report);
        setInitialBound(osg::BoundingBox(-width_m / 2, -depth_m / 2, 0, width_m / 2, depth_m / 2, height_m));
    }

    void drawImplementation(osg::RenderInfo &) const override {}

    void releaseGLObjects(osg::State *state) const override
    {
        if (state) company_.release(*state);
    }

private:
    struct Report : osg::DrawableCullCallback {
        bool cull(osg::NodeVisitor *visitor, osg::Drawable *drawable, osg::RenderInfo *) const override
        {
            osgUtil::CullVisitor *cull = visitor->asCullVisitor();
            if (!cull) return true;
            const PersonDrawable &person = static_cast<const PersonDrawable &>(*drawable);
            if (cull->getComputeNearFarMode() != osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR)
                cull->updateCalculatedNearFar(
                    *cull->getModelViewMatrix(),
                    osg::BoundingBox(-reach_m, -reach_m, -reach_m, reach_m, reach_m, height_m + reach_m));
            try {
                person.company_.troupe(*root_of(cull->getNodePath())).report(*cull, person.member_);
            } catch (const scenes::Failure &failure) {
                person.warning_.give(failure);
            }
            return true;
        }
    };

    Company &company_;
    const Member &member_;
    mutable Warning warning_;
};

}  // namespace

osg::ref_ptr<osg::Node> person_node(const PersonFile &file)
{
    osg::ref_ptr<osg::Geode> node = new osg::Geode;
    node->addDrawable(new PersonDrawable(file));
    return node;
}

}  // namespace osg_plugin
