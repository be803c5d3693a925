// Checks a file's version and required extensions before anything else is read.
#pragma once

#include "lib/asset/json_view.h"

namespace claque::asset
{

// Throws base::Error: CLQ_FORMAT, or CLQ_UNSUPPORTED that names the version or the extension.
void check_header(const JsonView &document);

}  // namespace claque::asset
