#include "samples/hosts/osg/town_graph.h"

#include <array>

#include <osg/BlendFunc>
#include <osg/CullFace>
#include <osg/Depth>
#include <osg/Fog>
#include <osg/LOD>
#include <osg/LightModel>
#include <osg/LightSource>
#include <osg/Material>
#include <osg/PolygonOffset>
#include <osg/Transform>

#include "samples/hosts/osg/convert.h"

namespace osg_host
{
namespace
{

using namespace scenes::town;

constexpr float haze_per_m = 0.00030f, far_away_m = 1e9f;

osg::Vec4 colour(const scenes::Rgb &c) { return {c.r, c.g, c.b, 1}; }

// Keeps its children round the eye.
class AroundTheEye : public osg::Transform
{
public:
    AroundTheEye() { setCullingActive(false); }
    bool computeLocalToWorldMatrix(osg::Matrix &matrix, osg::NodeVisitor *visitor) const override
    {
        if (visitor) matrix.preMult(place(*visitor));
        return true;
    }
    bool computeWorldToLocalMatrix(osg::Matrix &matrix, osg::NodeVisitor *visitor) const override
    {
        if (visitor) matrix.postMult(osg::Matrix::inverse(place(*visitor)));
        return true;
    }

private:
    static osg::Matrix place(osg::NodeVisitor &visitor)
    {
        return osg::Matrix::scale(100, 100, 100) * osg::Matrix::translate(visitor.getEyePoint());
    }
};

osg::ref_ptr<osg::Node> sky_of(const Clouds &sky)
{
    osg::ref_ptr<osg::Group> around = new AroundTheEye;
    osg::ref_ptr<osg::Geometry> dome = geometry_of(sky.dome()), layer = geometry_of(sky.layer());
    osg::StateSet *state = around->getOrCreateStateSet();
    for (const GLenum off : {GL_FOG, GL_LIGHTING, GL_DEPTH_TEST, GL_CULL_FACE})
        state->setMode(off, osg::StateAttribute::OFF);
    state->setAttribute(new osg::Depth(osg::Depth::ALWAYS, 0, 1, false));
    dome->getOrCreateStateSet()->setRenderBinDetails(-2, "RenderBin");
    layer->getOrCreateStateSet()->setRenderBinDetails(-1, "RenderBin");
    layer->getStateSet()->setTextureAttributeAndModes(0, texture_of(sky.picture(), true));
    layer->getStateSet()->setAttributeAndModes(new osg::BlendFunc);
    for (osg::Geometry *part : {dome.get(), layer.get()}) {
        part->setCullingActive(false);
        around->addChild(part);
    }
    return around;
}

osg::ref_ptr<osg::StateSet> state_of(const Town &town, SurfaceKind layer)
{
    osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    state->setRenderBinDetails(bin_of(layer), "RenderBin");
    if (layer != SurfaceKind::shade) {
        state->setTextureAttributeAndModes(0, texture_of(town.picture(layer), layer != SurfaceKind::facades));
        return state;
    }
    state->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
    state->setAttributeAndModes(new osg::BlendFunc);
    state->setAttribute(new osg::Depth(osg::Depth::LEQUAL, 0, 1, false));
    state->setAttributeAndModes(new osg::PolygonOffset(-1, -2));
    return state;
}

using States = std::array<osg::ref_ptr<osg::StateSet>, surface_kind_count>;

osg::ref_ptr<osg::Node> node_of(const Pieces &pieces, const Piece &piece, const States &states)
{
    const float near = near_m + piece.sphere.radius;
    osg::ref_ptr<osg::Group> group = new osg::Group;
    osg::ref_ptr<osg::LOD> lod;
    for (const Span &span : piece.spans) {
        osg::ref_ptr<osg::Geometry> shape = geometry_of(pieces.on(span.layer), span.first, span.count);
        shape->setStateSet(states[static_cast<size_t>(span.layer)]);
        if (span.seen == Visibility::always) {
            group->addChild(shape);
            continue;
        }
        if (!lod) {
            lod = new osg::LOD;
            lod->setCenterMode(osg::LOD::USER_DEFINED_CENTER);
            lod->setCenter({piece.sphere.centre.x, piece.sphere.centre.y, piece.sphere.centre.z});
            lod->setRadius(piece.sphere.radius);
            group->addChild(lod);
        }
        if (span.seen == Visibility::near) lod->addChild(shape, 0, near);
        else lod->addChild(shape, near, far_away_m);
    }
    return group;
}

}  // namespace

int bin_of(SurfaceKind layer) { return layer == SurfaceKind::leaves ? people_bin + 1 : static_cast<int>(layer); }

TownGraph graph_of(const Town &town)
{
    TownGraph graph;
    States states;
    for (size_t i = 0; i < surface_kind_count; ++i) states[i] = state_of(town, static_cast<SurfaceKind>(i));
    graph.root = new osg::Group;
    graph.root->addChild(sky_of(town.sky()));
    for (const Piece &piece : town.pieces().all()) {
        graph.pieces.push_back(node_of(town.pieces(), piece, states));
        graph.root->addChild(graph.pieces.back());
    }
    return graph;
}

void light(osg::Group &root)
{
    const scenes::Daylight day = Town::light();
    const osg::Vec4 none(0, 0, 0, 1);
    const auto lamp = [&](int number, const osg::Vec3 &towards, const scenes::Rgb &of) {
        osg::ref_ptr<osg::LightSource> source = new osg::LightSource;
        osg::Light *made = new osg::Light(static_cast<unsigned>(number));
        made->setPosition(osg::Vec4(towards, 0));
        made->setAmbient(none);
        made->setDiffuse(colour(of));
        made->setSpecular(none);
        source->setLight(made);
        source->setStateSetModes(*root.getOrCreateStateSet(), osg::StateAttribute::ON);
        root.addChild(source);
    };
    lamp(0, {day.to_sun.x, day.to_sun.y, day.to_sun.z}, day.sun);
    lamp(1, {-day.to_sun.x, 0.15f, -day.to_sun.z}, day.bounce);

    osg::StateSet *state = root.getOrCreateStateSet();
    osg::ref_ptr<osg::LightModel> model = new osg::LightModel;
    model->setAmbientIntensity(colour(day.sky));
    osg::ref_ptr<osg::Material> material = new osg::Material;
    material->setColorMode(osg::Material::AMBIENT_AND_DIFFUSE);
    material->setSpecular(osg::Material::FRONT_AND_BACK, none);
    osg::ref_ptr<osg::Fog> haze = new osg::Fog;
    haze->setMode(osg::Fog::EXP);
    haze->setDensity(haze_per_m);
    haze->setColor(colour(Clouds::haze));
    state->setAttribute(model);
    state->setAttribute(material);
    state->setAttributeAndModes(haze);
    state->setAttributeAndModes(new osg::CullFace);
    state->setMode(GL_LIGHTING, osg::StateAttribute::ON);
    state->setAttribute(new osg::Depth(osg::Depth::LEQUAL));
}

}  // namespace osg_host
