#include "animcache/keypose_vertices.h"

#include <cstring>

namespace claque::animcache
{

namespace
{

using math::F4;

void blend_floats(const float *a, const float *b, float blend, float *out, size_t count)
{
    const F4 t = math::splat(blend);
    for (size_t i = 0; i < count; i += 4) {
        const F4 from = math::load4(a + i);
        math::store4(out + i, from + (math::load4(b + i) - from) * t);
    }
}

// Floats of this size have no fraction: adding it rounds half to even, as packing does.
constexpr float rounds_at = 12582912;

// Rounds to integers, four at a time; count is a multiple of four.
template <class Int>
void blend_integers(const Int *a, const Int *b, float blend, Int *out, size_t count)
{
    typedef Int Ints __attribute__((vector_size(4 * sizeof(Int))));
    typedef int32_t Wide __attribute__((vector_size(16)));
    const F4 t = math::splat(blend), shift = math::splat(rounds_at);
    for (size_t i = 0; i < count; i += 4) {
        Ints from, to;
        std::memcpy(&from, a + i, sizeof from);
        std::memcpy(&to, b + i, sizeof to);
        const F4 start = __builtin_convertvector(from, F4);
        const F4 between = start + (__builtin_convertvector(to, F4) - start) * t;
        const Wide whole = __builtin_convertvector(between + shift - shift, Wide);
        const Ints made = __builtin_convertvector(whole, Ints);
        std::memcpy(out + i, &made, sizeof made);
    }
}

// One of the two key-poses, skinned into `vertices` unless it is kept.
const float *key_pose(const Request &request, int which, VertexFormat vertex_format, const Scratch &scratch,
                      float *vertices)
{
    if (request.key_pose.kept[which]) return request.key_pose.kept[which];
    Request alone = request;
    alone.pose.clip_time_s = request.key_pose.time_s[which];
    animate(alone, scratch, scratch.palette);
    skin(alone, scratch.palette, vertex_format, scratch, vertices);
    return vertices;
}

}  // namespace

void blend_vertices(const model::Level &level, VertexFormat vertex_format, const float *a, const float *b, float blend,
                    float *out)
{
    const size_t count = level.vertex_count;
    if (vertex_format == VertexFormat::floats) {
        blend_floats(a, b, blend, out, 6 * count);
        return;
    }
    blend_integers(reinterpret_cast<const int16_t *>(a), reinterpret_cast<const int16_t *>(b), blend,
                   reinterpret_cast<int16_t *>(out), 4 * count);
    blend_integers(reinterpret_cast<const int8_t *>(a + 2 * count), reinterpret_cast<const int8_t *>(b + 2 * count),
                   blend, reinterpret_cast<int8_t *>(out + 2 * count), 4 * count);
}

void interpolate(const Request &request, VertexFormat vertex_format, const Scratch &scratch, float *vertices)
{
    const float *first = key_pose(request, 0, vertex_format, scratch, vertices);
    const float *second = request.key_pose.second == request.key_pose.first
                              ? first
                              : key_pose(request, 1, vertex_format, scratch, scratch.vertices);
    blend_vertices(request.tmpl->levels[request.level], vertex_format, first, second, request.key_pose.blend, vertices);
}

}  // namespace claque::animcache
