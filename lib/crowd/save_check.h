// Rules of a saved crowd that no call checks. Each throws base::Error (CLQ_FORMAT).
#pragma once

#include <functional>

#include "lib/crowd/save_archive.h"

namespace claque::crowd
{

constexpr size_t header_bytes = 32;

Reader contents_of(const uint8_t *bytes, size_t size);  // behind a header that is right about them

MechanismKind kind_of(uint8_t index, std::pmr::memory_resource *memory);

// Orders as behave::look, express and say leave them: of a point, of a shape, or of nothing.
void check_command(const Mechanism &mechanism, const Command &command, uint32_t number);

// restore_layers.cpp. What actors blend is checked by Crowd::restore_layering.
void read_layers(Reader &in, const std::function<const model::Template *(uint32_t)> &template_at, Layers &out);
bool read_layer_state(Reader &in, uint32_t row, LayerState &out);  // false: none

}  // namespace claque::crowd
