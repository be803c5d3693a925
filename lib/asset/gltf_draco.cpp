#include "lib/asset/gltf_draco.h"

#include <cstring>

#include "lib/asset/decoders.h"
#include "lib/asset/draco_decode.h"

namespace claque::asset
{

using base::big;
using base::fail;

namespace
{

JsonView packed_of(const JsonView &primitive) { return primitive["extensions"]["KHR_draco_mesh_compression"]; }

// An accessor that the stream fills.
const Accessor &accessor_of(const File &file, const JsonView &view, uint64_t count)
{
    const Accessor &accessor = file.accessors.at(file.accessors.reference(view));
    if (accessor.component == Component::unknown || accessor.width == 0 || accessor.width > 4 || accessor.columns != 1)
        fail(CLQ_FORMAT, "%s has a type that Draco cannot pack", view.path().c_str());
    if (accessor.sparse.count) fail(CLQ_FORMAT, "%s is packed by Draco and sparse", view.path().c_str());
    if (accessor.count != count)
        fail(CLQ_FORMAT, "%s has %u elements, its Draco stream %llu", view.path().c_str(), accessor.count, big(count));
    return accessor;
}

DracoMesh request_of(const File &file, const JsonView &primitive)
{
    const JsonView packed = packed_of(primitive), wanted = packed["attributes"];
    DracoMesh mesh;
    mesh.path = packed.path();
    const uint64_t mode = primitive["mode"].integer_or(4, 0, 6);
    if (mode != 4) fail(CLQ_UNSUPPORTED, "%s has the mode %llu: triangles (4) are read", mesh.path.c_str(), big(mode));
    const JsonView indices = primitive["indices"], attributes = primitive["attributes"];
    mesh.vertex_count = file.accessors.at(file.accessors.reference(attributes["POSITION"])).count;
    mesh.index_count = file.accessors.at(file.accessors.reference(indices)).count;
    for (const auto &member : wanted.object().items()) {
        DracoAttribute out;
        const char *name = member.key().c_str();
        out.name = member.key();
        out.id = static_cast<uint32_t>(wanted[name].integer(0, 0xffffffffu));
        const Accessor &accessor = accessor_of(file, attributes[name], mesh.vertex_count);
        out.component = accessor.component;
        out.width = accessor.width;
        mesh.attributes.push_back(std::move(out));
    }
    if (!wanted["POSITION"].exists()) fail(CLQ_FORMAT, "%s.POSITION is missing", wanted.path().c_str());
    mesh.working_bytes = file.budget.remaining();
    return mesh;
}

std::vector<uint8_t> bytes_of_indices(const std::vector<uint32_t> &indices, const Accessor &accessor)
{
    const uint32_t size = bytes_of(accessor.component);
    const uint64_t limit = 1ull << (8 * size);
    std::vector<uint8_t> bytes(indices.size() * size);
    for (size_t i = 0; i < indices.size(); ++i) {
        if (indices[i] >= limit)
            fail(CLQ_FORMAT, "%s: vertex %u of the Draco stream does not fit %u bytes", accessor.path.c_str(),
                 indices[i], size);
        std::memcpy(&bytes[i * size], &indices[i], size);  // little endian, like the file
    }
    return bytes;
}

void charge(File &file, const DracoMesh &mesh, uint64_t index_bytes)
{
    uint64_t bytes = index_bytes * mesh.index_count;
    for (const DracoAttribute &attribute : mesh.attributes)
        bytes += mesh.vertex_count * attribute.width * bytes_of(attribute.component);
    file.budget.charge(bytes, mesh.path.c_str());
    file.budget.add_input(bytes);  // what is read from them is measured by their size
}

}  // namespace

bool DracoPrimitive::is_packed(const File &file, const JsonView &primitive)
{
    const JsonView positions = primitive["attributes"]["POSITION"];
    return packed_of(primitive).exists() && positions.exists() &&
           file.accessors.at(file.accessors.reference(positions)).view == none;
}

DracoPrimitive::DracoPrimitive(File &file, const JsonView &primitive) : file_(file)
{
    if (!is_packed(file, primitive)) return;
    const JsonView packed = packed_of(primitive);
    if (!has_decoder(Decoder::draco)) refuse_without(Decoder::draco, primitive.path());
    DracoMesh mesh = request_of(file, primitive);
    const uint32_t indices = file.accessors.reference(primitive["indices"]);
    const Accessor &index_accessor = accessor_of(file, primitive["indices"], mesh.index_count);
    const Component type = index_accessor.component;
    if (index_accessor.width != 1 || (type != Component::u8 && type != Component::u16 && type != Component::u32))
        fail(CLQ_FORMAT, "%s are no unsigned integers", primitive["indices"].path().c_str());
    charge(file, mesh, bytes_of(type));
    const uint32_t view = packed["bufferView"].index(file.buffers.view_count(), "buffer view");
    decode_draco(file.buffers.bytes(view, packed.path()), mesh);
    Accessors::Supplied supplied;
    supplied[indices] = bytes_of_indices(mesh.indices, index_accessor);
    for (DracoAttribute &attribute : mesh.attributes)
        supplied[file.accessors.reference(primitive["attributes"][attribute.name.c_str()])] =
            std::move(attribute.bytes);
    file.accessors.supply(std::move(supplied));
}

}  // namespace claque::asset
