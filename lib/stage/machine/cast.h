// What a machine's names mean on one template.
#pragma once

#include "lib/stage/machine/reader.h"

namespace claque::stage
{

// Finds clips, markers and nodes; refuses, where the file names them, those that the template lacks.
Cast find_parts(const CastDef &def, const Machine &machine, const Document &document, const MachineReader &reader);

}  // namespace claque::stage
