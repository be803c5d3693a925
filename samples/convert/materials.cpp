// Assimp's materials as materials of glTF: base colour, picture, both sides.
#include <cmath>

#include <assimp/material.h>

#include "samples/convert/pictures.h"

namespace convert
{
namespace
{

// Old formats give colours as they are displayed, glTF as light.
double linear(float displayed)
{
    const double x = std::fmin(std::fmax(std::isfinite(displayed) ? double(displayed) : 1.0, 0.0), 1.0);
    return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}

std::string picture_name(const aiMaterial &from)
{
    aiString name;
    for (const aiTextureType kind : {aiTextureType_DIFFUSE, aiTextureType_BASE_COLOR})
        if (from.GetTexture(kind, 0, &name) == AI_SUCCESS && name.length > 0) return name.C_Str();
    return {};
}

std::optional<size_t> texture_of(Scene &scene, Pictures &pictures, const aiMaterial &from, const std::string &name)
{
    const std::string picture = picture_name(from);
    std::optional<size_t> texture;
    if (!picture.empty()) {
        const size_t warned = scene.warnings.size();
        texture = pictures.texture_of(picture, name);
        if (!texture && !scene.options.picture.empty()) scene.warnings.resize(warned);
    }
    if (!texture && !scene.options.picture.empty()) texture = pictures.texture_of_file(scene.options.picture);
    return texture;
}

Json material_json(Scene &scene, Pictures &pictures, const aiMaterial &from, const std::string &name)
{
    Json look = {{"metallicFactor", 0}};
    aiColor4D colour(0.8f, 0.8f, 0.8f, 1);  // of a material that gives none
    if (from.Get(AI_MATKEY_COLOR_DIFFUSE, colour) != AI_SUCCESS) (void)from.Get(AI_MATKEY_BASE_COLOR, colour);
    if (const std::optional<size_t> texture = texture_of(scene, pictures, from, name))
        look["baseColorTexture"] = {{"index", *texture}};  // in its own colours
    else look["baseColorFactor"] = {linear(colour.r), linear(colour.g), linear(colour.b), 1};
    Json out = {{"name", name}, {"pbrMetallicRoughness", look}};
    int both_sides = 0;
    if (from.Get(AI_MATKEY_TWOSIDED, both_sides) == AI_SUCCESS && both_sides) out["doubleSided"] = true;
    return out;
}

}  // namespace

void add_materials(Scene &scene)
{
    Pictures pictures(scene);
    for (unsigned m = 0; m < scene.from.mNumMaterials; ++m) {
        const aiMaterial &from = *scene.from.mMaterials[m];
        aiString name;
        (void)from.Get(AI_MATKEY_NAME, name);
        const std::string known = name.length ? name.C_Str() : "material " + std::to_string(m + 1);
        scene.glb.add("materials", material_json(scene, pictures, from, known));
    }
}

}  // namespace convert
