#include "samples/charts/own_font.h"

#include <filesystem>

#include <fontconfig/fontconfig.h>

namespace charts
{

void prefer_own_font()
{
    namespace fs = std::filesystem;
    std::error_code absent;
    const fs::path program = fs::read_symlink("/proc/self/exe", absent);
    const fs::directory_iterator fonts(program.parent_path().parent_path() / "share/claque/fonts", absent);
    if (absent) return;
    FcConfig *own = FcConfigCreate();
    for (const fs::directory_entry &font : fonts)
        FcConfigAppFontAddFile(own, reinterpret_cast<const FcChar8 *>(font.path().c_str()));
    FcConfigSetCurrent(own);
    FcConfigDestroy(own);  // fontconfig keeps it
}

}  // namespace charts
