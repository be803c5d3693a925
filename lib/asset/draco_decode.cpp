#include "lib/asset/draco_decode.h"

#include "lib/asset/decoders.h"

#ifdef CLAQUE_HAS_DRACO

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpedantic"
#include <draco/compression/mesh/mesh_edgebreaker_decoder.h>
#include <draco/compression/mesh/mesh_sequential_decoder.h>
#include <draco/core/varint_decoding.h>
#pragma GCC diagnostic pop

#include <exception>
#include <new>

namespace claque::asset
{

using base::big;
using base::fail;

namespace
{

// The corner table of a triangle and its vertices, and the symbols that they are decoded from.
constexpr uint64_t working_bytes_of_index = 64;
constexpr int32_t max_attributes = 64;
constexpr uint8_t sequential = 0, edgebreaker = 1;

// Stops the decoder of `Base` wherever the stream says more than the file does.
template <class Base>
class Checked : public Base
{
public:
    explicit Checked(const DracoMesh &wanted) : wanted_(wanted) {}
    const std::string &reason() const { return reason_; }

protected:
    bool DecodeConnectivity() override
    {
        draco::DecoderBuffer ahead = *this->buffer();
        uint32_t first = 0, second = 0;
        if (!draco::DecodeVarint(&first, &ahead) || !draco::DecodeVarint(&second, &ahead)) return false;
        const bool faces_first = std::is_same_v<Base, draco::MeshSequentialDecoder>;
        const uint64_t faces = faces_first ? first : second, vertices = faces_first ? second : first;
        if (3 * faces != wanted_.index_count)
            return stop(
                base::text_of("it says %llu triangles, the file %llu", big(faces), big(wanted_.index_count / 3)));
        if (vertices > 3 * faces)
            return stop(base::text_of("it says %llu vertices for %llu triangles", big(vertices), big(faces)));
        return Base::DecodeConnectivity();
    }

    bool DecodeAllAttributes() override
    {
        const draco::PointCloud &cloud = *this->point_cloud();
        if (cloud.num_points() != wanted_.vertex_count)
            return stop(
                base::text_of("it has %u vertices, the file says %llu", cloud.num_points(), big(wanted_.vertex_count)));
        if (cloud.num_attributes() > max_attributes)
            return stop(base::text_of("it has %d attributes", cloud.num_attributes()));
        uint64_t components = 0;
        for (int32_t i = 0; i < cloud.num_attributes(); ++i)
            components += static_cast<uint64_t>(cloud.attribute(i)->num_components());
        // Each number has an integer form and a last form of up to eight bytes.
        if (wanted_.vertex_count * components * 12 > wanted_.working_bytes)
            return stop(base::text_of("its %llu numbers for each of %llu vertices would take more than %llu bytes",
                                      big(components), big(wanted_.vertex_count), big(wanted_.working_bytes)));
        return Base::DecodeAllAttributes();
    }

private:
    bool stop(std::string reason)
    {
        reason_ = std::move(reason);
        return false;
    }

    const DracoMesh &wanted_;
    std::string reason_;
};

template <class Base>
void run(const Bytes &packed, const DracoMesh &wanted, draco::Mesh &out)
{
    Checked<Base> decoder(wanted);
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char *>(packed.data), packed.size);
    draco::DecoderOptions options;
    const draco::Status status = decoder.Decode(options, &buffer, &out);
    if (!status.ok())
        fail(CLQ_FORMAT, "%s: the Draco stream is refused: %s", wanted.path.c_str(),
             decoder.reason().empty() ? status.error_msg() : decoder.reason().c_str());
}

// The method by which the triangles are packed.
uint8_t method_of(const Bytes &packed, const DracoMesh &wanted)
{
    draco::DecoderBuffer buffer;
    draco::DracoHeader header;
    buffer.Init(reinterpret_cast<const char *>(packed.data), packed.size);
    if (!draco::PointCloudDecoder::DecodeHeader(&buffer, &header).ok())
        fail(CLQ_FORMAT, "%s: %llu bytes do not begin as a Draco stream", wanted.path.c_str(), big(packed.size));
    if (header.encoder_type != draco::TRIANGULAR_MESH)
        fail(CLQ_FORMAT, "%s: the Draco stream is no mesh", wanted.path.c_str());
    if (header.version_major != 2 || header.version_minor != 2)
        fail(CLQ_UNSUPPORTED, "%s: the Draco stream has version %u.%u: 2.2 is read", wanted.path.c_str(),
             unsigned(header.version_major), unsigned(header.version_minor));
    if (header.encoder_method != sequential && header.encoder_method != edgebreaker)
        fail(CLQ_FORMAT, "%s: the Draco stream packs triangles by the unknown method %u", wanted.path.c_str(),
             unsigned(header.encoder_method));
    return header.encoder_method;
}

template <class Number>
bool convert(const draco::PointAttribute &from, uint64_t vertex_count, DracoAttribute &out)
{
    out.bytes.resize(vertex_count * out.width * sizeof(Number));
    std::vector<Number> element(out.width);
    for (uint32_t v = 0; v < vertex_count; ++v) {
        const draco::AttributeValueIndex value = from.mapped_index(draco::PointIndex(v));
        if (value.value() >= from.size()) return false;
        if (!from.ConvertValue<Number>(value, static_cast<int8_t>(out.width), element.data())) return false;
        std::memcpy(&out.bytes[v * out.width * sizeof(Number)], element.data(), out.width * sizeof(Number));
    }
    return true;
}

bool convert(const draco::PointAttribute &from, uint64_t vertex_count, DracoAttribute &out)
{
    switch (out.component) {
        case Component::i8:
            return convert<int8_t>(from, vertex_count, out);
        case Component::u8:
            return convert<uint8_t>(from, vertex_count, out);
        case Component::i16:
            return convert<int16_t>(from, vertex_count, out);
        case Component::u16:
            return convert<uint16_t>(from, vertex_count, out);
        case Component::u32:
            return convert<uint32_t>(from, vertex_count, out);
        case Component::f32:
            return convert<float>(from, vertex_count, out);
        case Component::unknown:
            break;
    }
    return false;
}

void take_attributes(const draco::Mesh &from, DracoMesh &mesh)
{
    for (DracoAttribute &wanted : mesh.attributes) {
        const draco::PointAttribute *attribute = from.GetAttributeByUniqueId(wanted.id);
        if (!attribute)
            fail(CLQ_FORMAT, "%s: the Draco stream has no attribute %u for %s", mesh.path.c_str(), wanted.id,
                 wanted.name.c_str());
        if (attribute->num_components() != static_cast<int>(wanted.width))
            fail(CLQ_FORMAT, "%s: %s has %d numbers a vertex in the Draco stream, its accessor %u", mesh.path.c_str(),
                 wanted.name.c_str(), int(attribute->num_components()), wanted.width);
        if (!convert(*attribute, mesh.vertex_count, wanted))
            fail(CLQ_FORMAT, "%s: %s of the Draco stream does not fit its accessor", mesh.path.c_str(),
                 wanted.name.c_str());
    }
}

void take_indices(const draco::Mesh &from, DracoMesh &mesh)
{
    if (uint64_t(3) * from.num_faces() != mesh.index_count || from.num_points() != mesh.vertex_count)
        fail(CLQ_FORMAT, "%s: the Draco stream has %u triangles of %u vertices, the file says %llu of %llu",
             mesh.path.c_str(), from.num_faces(), from.num_points(), big(mesh.index_count / 3), big(mesh.vertex_count));
    mesh.indices.reserve(mesh.index_count);
    for (draco::FaceIndex f(0); f < from.num_faces(); ++f)
        for (const draco::PointIndex &corner : from.face(f)) {
            if (corner.value() >= mesh.vertex_count)
                fail(CLQ_FORMAT, "%s: triangle %u of the Draco stream names vertex %u of %llu", mesh.path.c_str(),
                     f.value(), corner.value(), big(mesh.vertex_count));
            mesh.indices.push_back(corner.value());
        }
}

}  // namespace

void decode_draco(const Bytes &packed, DracoMesh &mesh)
{
    if (mesh.index_count * working_bytes_of_index > mesh.working_bytes)
        fail(CLQ_LIMIT, "%s: %llu triangles need more than the %llu bytes that are left of the limit",
             mesh.path.c_str(), big(mesh.index_count / 3), big(mesh.working_bytes));
    const uint8_t method = method_of(packed, mesh);
    draco::Mesh decoded;
    try {
        if (method == edgebreaker) run<draco::MeshEdgebreakerDecoder>(packed, mesh, decoded);
        else run<draco::MeshSequentialDecoder>(packed, mesh, decoded);
    } catch (const std::bad_alloc &) {
        throw;
    } catch (const base::Error &) {
        throw;
    } catch (const std::exception &error) {
        fail(CLQ_FORMAT, "%s: the Draco stream is refused: %s", mesh.path.c_str(), error.what());
    }
    take_indices(decoded, mesh);
    take_attributes(decoded, mesh);
}

}  // namespace claque::asset

#else

namespace claque::asset
{

void decode_draco(const Bytes &, DracoMesh &mesh) { refuse_without(Decoder::draco, mesh.path); }

}  // namespace claque::asset

#endif
