#include "lib/model/model_size.h"

namespace claque::model
{

namespace
{

template <class Array>
uint64_t array_bytes(const Array &array)
{
    return array.size() * sizeof(typename Array::value_type);
}

template <class Names>
uint64_t name_bytes(const Names &names)
{
    uint64_t sum = array_bytes(names);
    for (const auto &name : names) sum += name.size();
    return sum;
}

uint64_t part_bytes(const Part &part)
{
    uint64_t sum = sizeof part + part.name.size() + array_bytes(part.positions) + array_bytes(part.normals) +
                   array_bytes(part.uvs) + array_bytes(part.colours) + array_bytes(part.indices) +
                   array_bytes(part.joints) + array_bytes(part.weights) + array_bytes(part.morphs);
    for (const MorphTarget &target : part.morphs) sum += array_bytes(target.positions) + array_bytes(target.normals);
    return sum;
}

uint64_t rig_bytes(const Rig &rig)
{
    return array_bytes(rig.parents) + array_bytes(rig.rest) + name_bytes(rig.node_names) + array_bytes(rig.palette) +
           array_bytes(rig.morph_sets) + array_bytes(rig.rest_weights) + array_bytes(rig.clips) +
           name_bytes(rig.clip_names) + array_bytes(rig.channels) + array_bytes(rig.times) + array_bytes(rig.values) +
           array_bytes(rig.deactivation_m) + array_bytes(rig.dofs) + name_bytes(rig.dof_names) +
           array_bytes(rig.markers) + name_bytes(rig.marker_names) + array_bytes(rig.root_curves) +
           array_bytes(rig.root_samples);
}

}  // namespace

uint64_t held_bytes(const Model &model)
{
    uint64_t sum = rig_bytes(model.rig) + array_bytes(model.root_motions);
    for (const Zone &zone : model.zones) sum += sizeof zone + zone.name.size();
    for (const Image &image : model.images) sum += sizeof image + image.name.size() + image.rgba.size();
    for (const Material &material : model.materials) sum += sizeof material + material.name.size();
    for (const TextureSet &set : model.texture_sets) sum += sizeof set + set.name.size() + array_bytes(set.images);
    for (const Part &part : model.parts) sum += part_bytes(part);
    return sum;
}

uint64_t source_bytes(const Model &model) { return model.source_bytes ? model.source_bytes : held_bytes(model); }

}  // namespace claque::model
