#include "lib/asset/trajectories/trajectories.h"

#include <algorithm>

#include "lib/asset/trajectories/gzip.h"
#include "lib/asset/trajectories/readers.h"
#include "lib/asset/trajectories/text.h"
#include "lib/base/error.h"

namespace claque::asset
{

using base::fail;

namespace
{

using ReadFormat = void (*)(const TrajectoryInput &, const TrajectoryOptions &, Reading &);

struct KnownFormat {
    const char *name;
    ReadFormat read;
};
// In the order of clq_trajectory_format.
constexpr KnownFormat known_formats[] = {{"a file of trajectories", nullptr},
                                         {"JuPedSim SQLite", read_jupedsim},
                                         {"PeTrack", read_petrack},
                                         {"JPSreport", read_jpsreport},
                                         {"SUMO FCD", read_sumo},
                                         {"Vadere", read_vadere},
                                         {"Pathfinder CSV", read_pathfinder_csv},
                                         {"Pathfinder JSON", read_pathfinder_json},
                                         {"crowd:it", read_crowdit},
                                         {"Viswalk", read_viswalk},
                                         {"obsmat", read_obsmat},
                                         {"vsp", read_vsp},
                                         {"TrajNet++", read_trajnet},
                                         {"table", read_table}};
static_assert(sizeof known_formats / sizeof known_formats[0] == CLQ_TRAJECTORY_TABLE + 1, "one row for each format");

// The beginning of a packed file, to see its format.
std::vector<uint8_t> packed_head(const TrajectoryInput &input)
{
    constexpr size_t head_bytes = 1 << 16;
    std::vector<uint8_t> head;
    Budget budget(input.size + (8u << 20));
    unpack(input.bytes, input.size, budget, [&](std::string_view piece) {
        piece = piece.substr(0, head_bytes - head.size());
        head.insert(head.end(), piece.begin(), piece.end());
        return head.size() < head_bytes;
    });
    return head;
}

clq_trajectory_format format_of(const TrajectoryInput &input, const TrajectoryOptions &options)
{
    if (options.format != CLQ_TRAJECTORY_AUTO) return options.format;
    if (!is_gzip(input.bytes, input.size)) return detect(input, options);
    const std::vector<uint8_t> head = packed_head(input);
    TrajectoryInput unpacked = input;
    unpacked.bytes = head.data(), unpacked.size = head.size();
    if (unpacked.name.size() > 3 && unpacked.name.substr(unpacked.name.size() - 3) == ".gz")
        unpacked.name.resize(unpacked.name.size() - 3);
    return detect(unpacked, options);
}

}  // namespace

const char *format_name(clq_trajectory_format format) { return known_formats[format].name; }

Trajectories read_trajectories(const TrajectoryInput &input, const TrajectoryOptions &options)
{
    Budget budget(options.memory_limit_bytes);
    budget.add_input(input.size);
    Reading reading(budget);
    const clq_trajectory_format format = format_of(input, options);
    try {
        if (is_gzip(input.bytes, input.size) && format != CLQ_TRAJECTORY_SUMO) {
            const std::vector<uint8_t> bytes = unpack_all(input.bytes, input.size, budget);
            TrajectoryInput unpacked = input;
            unpacked.bytes = bytes.data(), unpacked.size = bytes.size();
            known_formats[format].read(unpacked, options, reading);
        } else {
            known_formats[format].read(input, options, reading);
        }
        return assemble(reading, options, format);
    } catch (const base::Error &error) {
        fail(error.status(), "read as %s: %s", known_formats[format].name, error.what());
    }
}

}  // namespace claque::asset
