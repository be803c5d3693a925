// Rules of a saved crowd that no public call checks. Each throws base::Error (CLQ_FORMAT).
#pragma once

#include "lib/crowd/save.h"

namespace claque::crowd
{

MechanismKind kind_of(uint8_t index, std::pmr::memory_resource *memory);

// Checks that commands are as behave::command_gaze, command_expression and command_phrase write them: of a point, of a
// pose, or none.
void check_command(const Mechanism &mechanism, const Command &command, uint32_t number);

}  // namespace claque::crowd
