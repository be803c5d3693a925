// Rules of a saved crowd that no public call checks. Each throws base::Error (CLQ_FORMAT).
#pragma once

#include "lib/crowd/save_archive.h"

namespace claque::crowd
{

constexpr size_t header_bytes = 32;

Reader contents_of(const uint8_t *bytes, size_t size);  // after a correct header

MechanismKind kind_of(uint8_t index, std::pmr::memory_resource *memory);

// Checks that commands are as behave::command_gaze, command_expression and command_phrase write them: of a point, of a
// pose, or none.
void check_command(const Mechanism &mechanism, const Command &command, uint32_t number);

}  // namespace claque::crowd
