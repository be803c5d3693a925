// What capture.json says in both kinds of folders.
#pragma once

#include "samples/parity/write/shown.h"
#include "samples/parity/write/write.h"

namespace parity
{

constexpr int format_version = 1;
constexpr size_t atlas_rows = 1024, atlas_columns = 256;  // S2 2.2

Json described(const char *kind, const scenes::Stage &stage, const Moment &moment, const Shown &shown);

// actors.npy, sizes.npy and model_view.npy.
void write_individuals(const Folder &folder, const Shown &shown, const Skinned &skinned);
void write_json(const Folder &folder, const Json &json);

}  // namespace parity
