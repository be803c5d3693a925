// Structs that may grow: hosts compiled with earlier headers pass shorter ones (claque/base.h).
#pragma once

#include <claque/crowd.h>
#include <claque/mesh.h>
#include <claque/record.h>

#include <cstddef>
#include <cstring>

#include "lib/base/error.h"

namespace claque::api
{

// The sizes of a struct in earlier released headers. A struct that grows gets a specialisation with its earlier sizes.
// 0 is not a size: the first release has no earlier ones.
template <class Struct>
struct EarlierSizes {
    static constexpr uint32_t sizes[] = {0};
};

// From 0.2 on it has motion_tolerance_px.
template <>
struct EarlierSizes<clq_crowd_def> {
    static constexpr uint32_t sizes[] = {offsetof(clq_crowd_def, motion_tolerance_px)};
};

// From 0.3 on it has read_bytes.
template <>
struct EarlierSizes<clq_record_info> {
    static constexpr uint32_t sizes[] = {offsetof(clq_record_info, read_bytes)};
};

// From 0.3 on it has unlit and emission.
template <>
struct EarlierSizes<clq_triangles> {
    static constexpr uint32_t sizes[] = {offsetof(clq_triangles, unlit)};
};

template <class Struct>
void require_size(const Struct &host, const char *init)
{
    if (host.struct_bytes == sizeof(Struct)) return;
    for (const uint32_t size : EarlierSizes<Struct>::sizes)
        if (size != 0 && host.struct_bytes == size) return;
    base::fail(CLQ_STRUCT_SIZE, "struct_bytes is %u, which no header up to %d.%d.%d gives; %s gives %zu",
               host.struct_bytes, CLQ_VERSION_MAJOR, CLQ_VERSION_MINOR, CLQ_VERSION_PATCH, init, sizeof(Struct));
}

// Copies the host's struct to this library's version: members that a shorter struct lacks get defaults. NULL: all
// defaults.
template <class Def>
Def read_def(const Def *host, Def (*init)(), const char *init_name)
{
    Def def = init();
    if (!host) return def;
    require_size(*host, init_name);
    std::memcpy(&def, host, host->struct_bytes);
    def.struct_bytes = static_cast<uint32_t>(sizeof def);
    return def;
}

// Writes as much of `value` as fits in the host's struct, whose size has been checked.
template <class Out>
void write_out(Out *host, Out value)
{
    value.struct_bytes = host->struct_bytes;
    std::memcpy(host, &value, host->struct_bytes);
}

}  // namespace claque::api
