// Helpers of the calls of libclaque-assets.
#pragma once

#include <claque/prepare.h>

#include <cstddef>
#include <cstdint>
#include <string>

#include "lib/api/struct_size.h"
#include "lib/base/error.h"

namespace claque::api
{

// Before `strict`, and before `turn_deg`.
template <>
struct EarlierSizes<clq_asset_options> {
    static constexpr uint32_t sizes[] = {offsetof(clq_asset_options, strict), offsetof(clq_asset_options, turn_deg)};
};

// Before `dofs`.
template <>
struct EarlierSizes<clq_prepare_def> {
    static constexpr uint32_t sizes[] = {offsetof(clq_prepare_def, dofs)};
};

// Fails with the status and the message of another public call.
inline void pass_on(clq_status status)
{
    if (status == CLQ_OK) return;
    const std::string text = clq_last_error();
    base::fail(status, "%s", text.c_str());
}

inline uint64_t limit_of(const clq_asset_options &options)
{
    return options.memory_limit_bytes ? options.memory_limit_bytes : uint64_t(1) << 30;
}

inline std::string folder_of(const std::string &path)
{
    const size_t slash = path.find_last_of('/');
    return slash == std::string::npos ? "." : slash == 0 ? "/" : path.substr(0, slash);
}

}  // namespace claque::api
