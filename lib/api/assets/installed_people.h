// The built-in characters that were prepared when the library was installed: a folder that is only read.
#pragma once

#include "lib/api/assets/kept_template.h"

namespace claque::api
{

// The template of this name from the folder beside libclaque-assets.so; NULL: it is not there. The folder and its files
// belong to root or to the owner of the library, and no other user may write them. A folder or file of another kind, a
// damaged file, and a folder without any file of this `build` (the beginning of the names) are passed over, and a
// warning says why. Throws std::bad_alloc.
Template installed_template(clq_context *context, const std::string &build, const std::string &name);

}  // namespace claque::api
