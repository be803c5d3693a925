// What a file says about itself before anything is read: its version, and the extensions it cannot be shown without.
#pragma once

#include "lib/asset/json_view.h"

namespace claque::asset
{

// Throws base::Error: CLQ_FORMAT, or CLQ_UNSUPPORTED with the version or the extension named.
void check_header(const JsonView &document);

}  // namespace claque::asset
