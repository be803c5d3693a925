// Which sources this library was built from.
#pragma once

namespace claque::api
{

const char *made_by();  // a hash of them, made by the build

}  // namespace claque::api
