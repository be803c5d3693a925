// Assimp's materials as materials of glTF: base colour, picture, both sides.
#include <algorithm>
#include <cmath>

#include <assimp/commonMetaData.h>
#include <assimp/material.h>
#include <assimp/mesh.h>

#include "samples/convert/fbx_bytes.h"
#include "samples/convert/pictures.h"

namespace convert
{
namespace
{

double within_one(double channel) { return std::fmin(std::fmax(std::isfinite(channel) ? channel : 1.0, 0.0), 1.0); }

// Old formats give colours as they are displayed, glTF as light.
double linear(double displayed)
{
    const double x = within_one(displayed);
    return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}

// Written by Blender, or sent through another program since (Mixamo).
bool is_fbx_of_blender(const Scene &scene)
{
    aiString generator;
    return (scene.from.mMetaData && scene.from.mMetaData->Get(AI_METADATA_SOURCE_GENERATOR, generator) &&
            std::string(generator.C_Str()).rfind("Blender (", 0) == 0) ||
           is_last_saved_by(scene.bytes, "Blender (");
}

// Blender's FBX has colours as light, and a diffuse factor that Blender itself does not read. Assimp multiplies by it.
Three base_colour(const Scene &scene, const aiMaterial &from, const std::string &name)
{
    aiColor4D colour(0.8f, 0.8f, 0.8f, 1);  // of a material that gives none
    if (from.Get(AI_MATKEY_COLOR_DIFFUSE, colour) != AI_SUCCESS) (void)from.Get(AI_MATKEY_BASE_COLOR, colour);
    Three out = {double(colour.r), double(colour.g), double(colour.b)};
    const bool is_light = is_fbx_of_blender(scene);
    if (is_light) (void)find_diffuse_colour(scene.bytes, name, out);
    for (double &channel : out) channel = is_light ? within_one(channel) : linear(channel);
    return out;
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
    if (!picture.empty()) texture = pictures.texture_of(picture, name);
    if (!texture && !scene.options.picture.empty()) texture = pictures.texture_of_file(scene.options.picture);
    return texture;
}

Json material_json(Scene &scene, Pictures &pictures, const aiMaterial &from, const std::string &name)
{
    Json look = {{"metallicFactor", 0}};
    const std::optional<size_t> texture = texture_of(scene, pictures, from, name);
    if (texture) {
        look["baseColorTexture"] = {{"index", *texture}};  // in its own colours
    } else {
        const Three light = base_colour(scene, from, name);
        look["baseColorFactor"] = {light[0], light[1], light[2], 1};
    }
    Json out = {{"name", name}, {"pbrMetallicRoughness", look}};
    if (texture && pictures.has_holes(*texture)) out["alphaMode"] = "MASK";
    int both_sides = 0;
    if (from.Get(AI_MATKEY_TWOSIDED, both_sides) == AI_SUCCESS && both_sides) out["doubleSided"] = true;
    return out;
}

bool names_pictures(const aiScene &scene)
{
    return std::any_of(scene.mMaterials, scene.mMaterials + scene.mNumMaterials,
                       [](const aiMaterial *material) { return !picture_name(*material).empty(); });
}

// A surface that a picture was made for, and that is grey without it.
bool lacks_picture(const aiScene &scene, unsigned m, const Json &material)
{
    const Json &look = material["pbrMetallicRoughness"];
    if (look.contains("baseColorTexture")) return false;
    const Json &colour = look["baseColorFactor"];
    if (colour[0] != colour[1] || colour[1] != colour[2] || colour[0].get<double>() < 0.3) return false;
    return std::any_of(scene.mMeshes, scene.mMeshes + scene.mNumMeshes, [&](const aiMesh *mesh) {
        return mesh->mMaterialIndex == m && mesh->HasTextureCoords(0) && mesh->HasBones();
    });
}

}  // namespace

void add_materials(Scene &scene)
{
    Pictures pictures(scene);
    const bool asks = scene.options.picture.empty() && !names_pictures(scene.from);
    std::vector<std::string> without;
    for (unsigned m = 0; m < scene.from.mNumMaterials; ++m) {
        const aiMaterial &from = *scene.from.mMaterials[m];
        aiString name;
        (void)from.Get(AI_MATKEY_NAME, name);
        const std::string known = name.length ? name.C_Str() : "material " + std::to_string(m + 1);
        const Json material = material_json(scene, pictures, from, known);
        if (asks && lacks_picture(scene.from, m, material)) without.push_back(known);
        scene.glb.add("materials", material);
    }
    if (!without.empty())
        scene.warn((without.size() == 1 ? "material " : "materials ") + listed(without) +
                   (without.size() == 1 ? " is" : " are") + " grey and without a picture: --picture FILE gives one");
    if (scene.options.picture.empty()) pictures.warn_of_missing();
}

}  // namespace convert
