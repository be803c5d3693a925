#include "samples/hosts/osg/convert.h"

#include <algorithm>
#include <unordered_map>

namespace osg_host
{

osg::ref_ptr<osg::Geometry> geometry_of(const scenes::Geometry &from, size_t first, size_t count)
{
    osg::ref_ptr<osg::Vec3Array> positions = new osg::Vec3Array, normals = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec2Array> places = new osg::Vec2Array;
    osg::ref_ptr<osg::Vec4ubArray> colours = new osg::Vec4ubArray;
    osg::ref_ptr<osg::DrawElementsUInt> triangles = new osg::DrawElementsUInt(GL_TRIANGLES);
    std::unordered_map<uint32_t, uint32_t> renumbered;
    for (size_t i = first; i < first + count; ++i) {
        const uint32_t old = from.indices()[i];
        const auto [found, is_new] = renumbered.emplace(old, static_cast<uint32_t>(positions->size()));
        triangles->push_back(found->second);
        if (!is_new) continue;
        const scenes::SceneryVertex &v = from.vertices()[old];
        positions->push_back({v.position.x, v.position.y, v.position.z});
        normals->push_back({v.normal.x, v.normal.y, v.normal.z});
        places->push_back({v.u, v.v});
        colours->push_back({v.rgba[0], v.rgba[1], v.rgba[2], v.rgba[3]});
    }
    osg::ref_ptr<osg::Geometry> made = new osg::Geometry;
    made->setUseDisplayList(false);
    made->setUseVertexBufferObjects(true);
    made->setVertexArray(positions);
    made->setNormalArray(normals, osg::Array::BIND_PER_VERTEX);
    colours->setNormalize(true);
    made->setColorArray(colours, osg::Array::BIND_PER_VERTEX);
    made->setTexCoordArray(0, places);
    made->addPrimitiveSet(triangles);
    return made;
}

osg::ref_ptr<osg::Geometry> geometry_of(const scenes::Geometry &from)
{
    return geometry_of(from, 0, from.indices().size());
}

osg::ref_ptr<osg::Texture2D> texture_of(const scenes::Image &image, bool repeats)
{
    osg::ref_ptr<osg::Image> copy = new osg::Image;
    copy->allocateImage(image.side_px, image.side_px, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    std::copy(image.rgba.begin(), image.rgba.end(), copy->data());
    osg::ref_ptr<osg::Texture2D> made = new osg::Texture2D(copy);
    const osg::Texture::WrapMode wrap = repeats ? osg::Texture::REPEAT : osg::Texture::CLAMP_TO_EDGE;
    made->setWrap(osg::Texture::WRAP_S, wrap);
    made->setWrap(osg::Texture::WRAP_T, wrap);
    made->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR_MIPMAP_LINEAR);
    made->setResizeNonPowerOfTwoHint(false);
    return made;
}

}  // namespace osg_host
