// Chooses the reader of an area by its content.
#include "lib/asset/areas/area_readers.h"
#include "lib/asset/trajectories/database.h"
#include "lib/base/error.h"

namespace claque::asset
{

Area read_area(const uint8_t *bytes, size_t size)
{
    AreaBuilder out;
    std::string_view text(reinterpret_cast<const char *>(bytes), size);
    if (text.substr(0, 3) == "\xef\xbb\xbf") text.remove_prefix(3);
    const size_t begin = text.find_first_not_of(" \t\r\n");
    const char first = begin == std::string_view::npos ? '\0' : text[begin];
    if (is_sqlite(bytes, size)) read_jupedsim_area(bytes, size, out);
    else if (first == '<') read_geo_xml(bytes, size, out);
    else if (first == '{') read_vadere_scenario(bytes, size, out);
    else if (first >= '0' && first <= '9') read_menge_nav(text, out);
    else if ((first >= 'A' && first <= 'Z') || (first >= 'a' && first <= 'z')) read_wkt(text, out);
    else
        base::fail(CLQ_FORMAT,
                   "the file is no area: WKT, JuPedSim's database, geo.xml, Menge's .nav and Vadere's "
                   ".scenario are read");
    return out.take();
}

}  // namespace claque::asset
