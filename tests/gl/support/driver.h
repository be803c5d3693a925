// Which of Mesa's drivers draws. The reference rasteriser takes ten times as long as llvmpipe: tests give it fewer
// cameras, as what does not depend on the rasteriser is proved on llvmpipe.
#pragma once

#include <cstdlib>
#include <string>

namespace gltest
{

inline bool on_softpipe()
{
    const char *const driver = std::getenv("GALLIUM_DRIVER");
    return driver && std::string(driver) == "softpipe";
}

}  // namespace gltest
