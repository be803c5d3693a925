// Loads what Maker makes, and says how that ended.
#pragma once

#include <functional>
#include <string>

#include "lib/asset/gltf.h"
#include "lib/base/error.h"
#include "tests/support/gltf_maker.h"

namespace claque::testing
{

inline model::Model load(const Bytes &bytes, const asset::LoadOptions &options = {})
{
    return asset::load_gltf(bytes.data(), bytes.size(), options);
}

// "OK" or the status and text of the refusal.
struct Outcome {
    int status = 0;
    std::string text;
};
inline Outcome outcome_of(const std::function<void()> &job)
{
    try {
        job();
        return {};
    } catch (const base::Error &error) {
        return {error.status(), error.what()};
    }
}
inline Outcome outcome_of(const Bytes &bytes, const asset::LoadOptions &options = {})
{
    return outcome_of([&] { load(bytes, options); });
}

}  // namespace claque::testing
