// An opened glTF file: the state that all its readers share.
#pragma once

#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "lib/asset/accessor.h"
#include "lib/asset/buffers.h"
#include "lib/asset/json_view.h"

namespace claque::asset
{

using model::none;

struct File {
    File(const JsonView &document, const Container &container, const LoadOptions &wanted, Budget &shared)
        : root(document),
          options(wanted),
          budget(shared),
          buffers(document, container, wanted, shared),
          accessors(document, buffers, shared)
    {
        if (container.left_out)
            warn(base::text_of("%zu bytes follow the end that the GLB's header says: left out", container.left_out));
        for (const std::string &text : buffers.warnings()) warn(text);
    }
    File(const File &) = delete;
    File &operator=(const File &) = delete;

    // Keeps at most 64 warnings; a malicious file could otherwise fill memory with them.
    void warn(std::string text)
    {
        if (warnings.size() < 64) warnings.push_back(std::move(text));
    }

    JsonView root;
    const LoadOptions &options;
    Budget &budget;
    Buffers buffers;
    Accessors accessors;
    std::vector<std::string> warnings;
    std::vector<model::RootMotionRequest> root_motions;
    std::unordered_map<std::string_view, uint32_t> node_of_name;  // of the rig, for the extras of clips
};

}  // namespace claque::asset
