// capture.json of a parity folder, checked field by field.
#pragma once

#include "samples/parity/capture.h"

namespace parity
{

struct MeshInfo {
    std::string kind;  // as Actor has it
    size_t vertices = 0;
    ZoneNames zones;
};

struct CaptureInfo {
    std::string renderer, scene;
    int width = 0, height = 0;
    double time_s = 0;
    // Of a folder with actors.npy:
    size_t actors = 0, vertices = 0;
    std::vector<MeshInfo> meshes;
    std::vector<std::string> actor_columns;
};

// path: for error messages; has_table: the folder has an actors.npy, which needs more fields. Throws Unreadable.
CaptureInfo capture_info(const std::string &capture, const std::string &path, bool has_table);

}  // namespace parity
