// Identifies the build of a library: two libraries must agree in it before one reads C++ objects of the other.
#pragma once

#include <string>

#include "lib/base/error.h"
#include "lib/model/model.h"

namespace claque::api
{

// Hashes of the sources, made by the build: one in each of the two libraries, under different names, so that a program
// that links both statically still compares two.
const char *runtime_sources();  // libclaque
const char *assets_sources();   // libclaque-assets

#ifdef __GLIBCXX__
constexpr long standard_library = __GLIBCXX__;
#else
constexpr long standard_library = 0;
#endif
#if defined(_GLIBCXX_DEBUG) || (defined(_GLIBCXX_USE_CXX11_ABI) && !_GLIBCXX_USE_CXX11_ABI)
constexpr int other_containers = 1;
#else
constexpr int other_containers = 0;
#endif

// Static: must be compiled into the caller.
static inline std::string build_id_of(const char *sources)
{
    return base::text_of("%.16s, compiler %s, library %ld.%d, sizes %zu %zu %zu", sources, __VERSION__,
                         standard_library, other_containers, sizeof(model::Model), sizeof(model::Rig),
                         sizeof(model::Part));
}

}  // namespace claque::api
