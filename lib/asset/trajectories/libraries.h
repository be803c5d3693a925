// The libraries that readers need and that a build may lack (cmake/decoders.cmake).
#pragma once

#include "lib/base/error.h"

namespace claque::asset
{

#ifdef CLAQUE_HAS_EXPAT
constexpr bool has_expat = true;
#else
constexpr bool has_expat = false;
#endif
#ifdef CLAQUE_HAS_SQLITE3
constexpr bool has_sqlite3 = true;
#else
constexpr bool has_sqlite3 = false;
#endif
#ifdef CLAQUE_HAS_Z
constexpr bool has_zlib = true;
#else
constexpr bool has_zlib = false;
#endif

[[noreturn]] inline void refuse_without_library(const char *what, const char *library)
{
    base::fail(CLQ_UNSUPPORTED, "%s is read by %s, and this libclaque-assets was built without it", what, library);
}

}  // namespace claque::asset
