// Readers of trajectories and areas whose libraries allocate, too: XML, JSON, SQL, gzip.
#include <claque/trajectories.h>

#include <cstring>

#include "tests/faults/calls.h"
#include "tests/unit/asset/trajectories/writers.h"

namespace faults
{
namespace
{

using W = World &;

const char fcd[] =
    "<fcd-export><timestep time=\"0\"><person id=\"a\" x=\"1\" y=\"2\"/><vehicle id=\"v\" x=\"1\" y=\"3\" "
    "speed=\"1\"/></timestep><timestep time=\"1\"><person id=\"a\" x=\"1\" y=\"3\" "
    "speed=\"1\"/></timestep></fcd-export>";
const char json[] = "{\"1\": {\"0.0\": {\"position\": {\"x\": 1, \"y\": 2, \"z\": 0}}}}";
const char ndjson[] =
    "{\"scene\": {\"fps\": 2.5}}\n{\"track\": {\"f\": 1, \"p\": 1, \"x\": 1, \"y\": 2}}\n"
    "{\"track\": {\"f\": 2, \"p\": 1, \"x\": 1, \"y\": 2}}\n";
const char scenario[] =
    "{\"scenario\": {\"topography\": {\"attributes\": {\"bounds\": {\"x\": 0, \"y\": 0, \"width\": 8, "
    "\"height\": 6}}, \"obstacles\": [{\"shape\": {\"type\": \"RECTANGLE\", \"x\": -2, \"y\": 2, "
    "\"width\": 3, \"height\": 1}}]}}}";

void note_trajectories(W w)
{
    auto *read = static_cast<clq_trajectories *>(w.made);
    clq_trajectories_info info = clq_trajectories_info_init();
    EXPECT_EQ(clq_trajectories_get_info(read, &info), CLQ_OK);
    w.found = hash_of(clq_trajectories_get_samples(read), info.sample_count * sizeof(clq_trajectory_sample));
    for (uint32_t i = 0; i < info.warning_count; ++i) w.found ^= hash_of(clq_trajectories_get_warning(read, i)) + i;
    clq_trajectories_destroy(read);
}

void note_area(W w)
{
    auto *read = static_cast<clq_area *>(w.made);
    clq_area_info info = clq_area_info_init();
    EXPECT_EQ(clq_area_get_info(read, &info), CLQ_OK);
    w.found = hash_of(info.triangles, 3 * info.triangle_count * sizeof(uint32_t)) ^ info.warning_count;
    clq_area_destroy(read);
}

}  // namespace

void add_people_calls(std::vector<Call> &all)
{
    for (const auto &[name, text] : {std::pair("fcd", fcd), std::pair("json", json), std::pair("ndjson", ndjson)})
        all.push_back({"clq_trajectories_load_memory",
                       [text](W w) {
                           return clq_trajectories_load_memory(w.test.context, text, std::strlen(text), "people",
                                                               nullptr, w.out<clq_trajectories>());
                       },
                       0, note_trajectories, name});
    for (const claque::testing::Written &file : claque::testing::written_files()) {
        const bool odd = file.format == CLQ_TRAJECTORY_JUPEDSIM || file.bytes[0] == 0x1f;
        if (!odd || file.options.rate_hz > 0) continue;
        all.push_back({"clq_trajectories_load_memory",
                       [bytes = file.bytes](W w) {
                           return clq_trajectories_load_memory(w.test.context, bytes.data(), bytes.size(), "people",
                                                               nullptr, w.out<clq_trajectories>());
                       },
                       0, note_trajectories, file.name + std::to_string(all.size())});
    }
    all.push_back({"clq_area_load_memory",
                   [](W w) {
                       return clq_area_load_memory(w.test.context, scenario, sizeof scenario - 1, "a",
                                                   w.out<clq_area>());
                   },
                   0, note_area, "scenario"});
    all.push_back({"clq_track_get_plants",
                   [](W w) {
                       clq_track_plant plants[64];
                       size_t count = 0;
                       return clq_track_get_plants(w.test.tracks[0], 0, 0, 9, plants, 64, &count);
                   },
                   quiet});
}

}  // namespace faults
