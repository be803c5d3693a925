#include "lib/asset/meshopt.h"

#ifdef CLAQUE_HAS_MESHOPT
#include <meshoptimizer.h>
#endif

#include "lib/asset/decoders.h"

namespace claque::asset
{

using base::big;
using base::fail;

namespace
{

constexpr uint64_t max_packed_bytes = 1ull << 48;
constexpr uint64_t max_stride = 256;

template <class Enum, size_t count>
Enum choice_of(const JsonView &view, const char *const (&names)[count], const char *otherwise)
{
    const std::string name = otherwise ? view.text_or(otherwise) : view.text();
    for (size_t i = 0; i < count; ++i)
        if (name == names[i]) return static_cast<Enum>(i);
    fail(CLQ_FORMAT, "%s is '%.40s', which is no %s", view.path().c_str(), name.c_str(), names[0]);
}

constexpr const char *modes[] = {"ATTRIBUTES", "TRIANGLES", "INDICES"};
constexpr const char *filters[] = {"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL"};

bool fits_filter(const MeshoptView &view)
{
    switch (view.filter) {
        case MeshoptFilter::octahedral:
            return view.stride == 4 || view.stride == 8;
        case MeshoptFilter::quaternion:
            return view.stride == 8;
        default:
            return true;
    }
}

// What the decoder takes for granted.
void check_layout(const MeshoptView &view, uint64_t view_bytes)
{
    const char *path = view.path.c_str(), *mode = modes[static_cast<size_t>(view.mode)];
    const bool attributes = view.mode == MeshoptMode::attributes;
    if (attributes ? view.stride % 4 != 0 : view.stride != 2 && view.stride != 4)
        fail(CLQ_FORMAT, "%s.byteStride is %llu, which %s cannot have", path, big(view.stride), mode);
    if (view.mode == MeshoptMode::triangles && view.count % 3 != 0)
        fail(CLQ_FORMAT, "%s.count is %llu: not a multiple of 3", path, big(view.count));
    if (view.filter != MeshoptFilter::none && (!attributes || !fits_filter(view)))
        fail(CLQ_FORMAT, "%s.filter %s cannot follow %s of %llu bytes", path, filters[static_cast<size_t>(view.filter)],
             mode, big(view.stride));
    if (view.count * view.stride != view_bytes)  // no overflow: below 2^32 and at most 256
        fail(CLQ_FORMAT, "%s unpacks to %llu bytes, its buffer view has %llu", path, big(view.count * view.stride),
             big(view_bytes));
}

#ifdef CLAQUE_HAS_MESHOPT

int unpack(const MeshoptView &view, const uint8_t *packed, uint8_t *out)
{
    const size_t count = view.count, stride = view.stride, length = view.length;
    switch (view.mode) {
        case MeshoptMode::attributes:
            return meshopt_decodeVertexBuffer(out, count, stride, packed, length);
        case MeshoptMode::triangles:
            return meshopt_decodeIndexBuffer(out, count, stride, packed, length);
        case MeshoptMode::indices:
            break;
    }
    return meshopt_decodeIndexSequence(out, count, stride, packed, length);
}

void apply_filter(const MeshoptView &view, uint8_t *out)
{
    switch (view.filter) {
        case MeshoptFilter::octahedral:
            return meshopt_decodeFilterOct(out, view.count, view.stride);
        case MeshoptFilter::quaternion:
            return meshopt_decodeFilterQuat(out, view.count, view.stride);
        case MeshoptFilter::exponential:
            return meshopt_decodeFilterExp(out, view.count, view.stride);
        case MeshoptFilter::none:
            break;
    }
}

#endif

}  // namespace

MeshoptView read_meshopt_view(const JsonView &extension, size_t buffer_count, uint64_t view_bytes)
{
    MeshoptView view;
    extension.object();
    view.path = extension.path();
    view.buffer = extension["buffer"].index(buffer_count, "buffer");
    view.offset = extension["byteOffset"].integer_or(0, 0, max_packed_bytes);
    view.length = extension["byteLength"].integer(1, max_packed_bytes);
    view.stride = extension["byteStride"].integer(1, max_stride);
    view.count = extension["count"].integer(1, 0xffffffffu);
    view.mode = choice_of<MeshoptMode>(extension["mode"], modes, nullptr);
    view.filter = choice_of<MeshoptFilter>(extension["filter"], filters, "NONE");
    check_layout(view, view_bytes);
    return view;
}

std::vector<uint8_t> decode_meshopt(const MeshoptView &view, const uint8_t *packed)
{
#ifdef CLAQUE_HAS_MESHOPT
    std::vector<uint8_t> out(view.count * view.stride);
    if (const int error = unpack(view, packed, out.data()); error != 0)
        fail(CLQ_FORMAT, "%s: the %llu packed bytes are no %llu elements of %llu bytes (decoder's error %d)",
             view.path.c_str(), big(view.length), big(view.count), big(view.stride), error);
    apply_filter(view, out.data());
    return out;
#else
    (void)packed;
    refuse_without(Decoder::meshopt, view.path);
#endif
}

}  // namespace claque::asset
