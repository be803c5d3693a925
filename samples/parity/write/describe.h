// The part of capture.json that both kinds of folders share.
#pragma once

#include "samples/parity/write/drawn_actors.h"
#include "samples/parity/write/write.h"

namespace parity
{

constexpr int format_version = 1;
constexpr size_t atlas_rows = 1024, atlas_columns = 256;  // S2 2.2

Json described(const char *kind, const scenes::SceneRenderer &scene_renderer, const CaptureTime &capture_time,
               const DrawnActors &drawn_actors);

// actors.npy, sizes.npy and model_view.npy.
void write_individuals(Folder &folder, const DrawnActors &drawn_actors, const Skinned &skinned);
void write_json(Folder &folder, const Json &json);

}  // namespace parity
