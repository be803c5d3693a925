// The walkable area in JuPedSim's databases.
#include "lib/asset/areas/area_readers.h"
#include "lib/asset/trajectories/database.h"
#include "lib/base/error.h"

namespace claque::asset
{

using base::fail;

namespace
{

// The hash of the area in the first frame; false: the file does not say.
bool first_hash(Database &database, int64_t &hash)
{
    if (!database.has_table("frame_data")) return false;
    Query query(database, "SELECT frame, geometry_hash FROM frame_data");
    bool found = false;
    int64_t first = 0;
    while (query.next()) {
        const int64_t frame = query.whole(0);
        if (found && frame >= first) continue;
        first = frame, hash = query.whole(1), found = true;
    }
    return found;
}

}  // namespace

void read_jupedsim_area(const uint8_t *bytes, size_t size, AreaBuilder &out)
{
    Database database(bytes, size);
    if (!database.has_table("geometry")) fail(CLQ_FORMAT, "the database has no table geometry: it is not of JuPedSim");
    int64_t hash = 0;
    const bool hashed = database.has_column("geometry", "hash") && first_hash(database, hash);
    Query query(database, hashed ? "SELECT wkt, hash FROM geometry" : "SELECT wkt, 0 FROM geometry");
    std::string chosen;
    uint64_t areas = 0;
    bool found = false;
    while (query.next()) {
        ++areas;
        if (found || (hashed && query.whole(1) != hash)) continue;
        chosen = query.text(0), found = true;
    }
    if (!found) fail(CLQ_FORMAT, "the database has no area of its first frame, of %llu areas", base::big(areas));
    if (areas > 1)
        out.warn(base::text_of("the area changes: the database has %llu, and that of the first frame is taken",
                               base::big(areas)));
    read_wkt(chosen, out);
}

}  // namespace claque::asset
