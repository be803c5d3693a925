// clq_trajectories_...: where people walked, from files.
#include "lib/asset/trajectories/trajectories.h"

#include <claque/trajectories.h>

#include <cmath>
#include <filesystem>
#include <memory>

#include "lib/api/assets/assets_helpers.h"
#include "lib/api/boundary.h"
#include "lib/asset/file.h"

using namespace claque;

struct clq_trajectories {
    explicit clq_trajectories(asset::Trajectories &&read) : all(std::move(read)) {}
    asset::Trajectories all;
};

namespace
{

void require_range(double value, double most, const char *member)
{
    if (!(value >= 0 && value <= most)) base::fail(CLQ_ARGUMENT, "%s is %g: 0 to %g is wanted", member, value, most);
}

asset::TrajectoryOptions trajectory_options(const clq_trajectories_def &def)
{
    asset::TrajectoryOptions out;
    const unsigned format = api::number_of(def.format), up = api::number_of(def.up);
    if (format > CLQ_TRAJECTORY_TABLE)
        base::fail(CLQ_ARGUMENT, "format is %u: 0 to %d are known", format, CLQ_TRAJECTORY_TABLE);
    if (up > CLQ_UP_Y) base::fail(CLQ_ARGUMENT, "up is %u: 0 to %d are known", up, CLQ_UP_Y);
    require_range(def.rate_hz, 1e6, "rate_hz");
    require_range(def.metres_per_unit, 1e6, "metres_per_unit");
    require_range(def.max_gap_s, HUGE_VAL, "max_gap_s");
    if (!(def.max_speed_m_s > 0)) base::fail(CLQ_ARGUMENT, "max_speed_m_s is %g: above 0 is wanted", def.max_speed_m_s);
    if (!(def.start_s <= def.end_s))
        base::fail(CLQ_ARGUMENT, "the time from start_s %g to end_s %g has no length", def.start_s, def.end_s);
    out.format = static_cast<clq_trajectory_format>(format), out.up = static_cast<clq_up_axis>(up);
    out.columns = api::name_of(def.columns);
    out.rate_hz = def.rate_hz, out.metres_per_unit = def.metres_per_unit;
    out.vehicles = def.vehicles;
    out.max_speed_m_s = def.max_speed_m_s, out.max_gap_s = def.max_gap_s;
    out.start_s = def.start_s, out.end_s = def.end_s;
    if (def.memory_limit_bytes) out.memory_limit_bytes = def.memory_limit_bytes;
    if (!def.picture_to_metres) return out;
    out.picture_to_metres.emplace();
    for (size_t i = 0; i < 9; ++i) {
        if (!std::isfinite(def.picture_to_metres[i]))
            base::fail(CLQ_ARGUMENT, "picture_to_metres[%zu] is not finite", i);
        (*out.picture_to_metres)[i] = def.picture_to_metres[i];
    }
    return out;
}

clq_trajectories *read(clq_context *context, const asset::TrajectoryInput &input, const clq_trajectories_def *def)
{
    const clq_trajectories_def wanted = api::read_def(def, clq_trajectories_def_init, "clq_trajectories_def_init");
    try {
        auto made = std::make_unique<clq_trajectories>(asset::read_trajectories(input, trajectory_options(wanted)));
        for (const std::string &warning : made->all.warnings)
            clq_context_log(context, CLQ_LOG_WARNING, warning.c_str());
        return made.release();
    } catch (const base::Error &error) {
        if (input.name.empty()) throw;
        base::fail(error.status(), "%s: %s", input.name.c_str(), error.what());
    }
}

// The matrix that stands beside a .vsp file.
std::optional<std::string> beside(const std::string &path)
{
    constexpr uint64_t most_bytes = 4096;
    const std::string matrix = api::folder_of(path) + "/H.txt";
    std::error_code error;
    if (!std::filesystem::exists(matrix, error)) return {};
    const std::vector<uint8_t> bytes = asset::read_file(matrix, most_bytes);
    return std::string(bytes.begin(), bytes.end());
}

}  // namespace

extern "C" {

clq_status clq_trajectories_load(clq_context *context, const char *path, const clq_trajectories_def *def,
                                 clq_trajectories **out)
{
    return api::boundary("clq_trajectories_load", [&] {
        api::require(context && path && out, "context, path or out is NULL");
        const clq_trajectories_def wanted = api::read_def(def, clq_trajectories_def_init, "clq_trajectories_def_init");
        const asset::TrajectoryOptions options = trajectory_options(wanted);
        const std::vector<uint8_t> bytes = asset::read_file(path, options.memory_limit_bytes);
        asset::TrajectoryInput input;
        input.bytes = bytes.data(), input.size = bytes.size();
        input.name = path;
        input.beside = [path] { return beside(path); };
        *out = read(context, input, def);
    });
}

clq_status clq_trajectories_load_memory(clq_context *context, const void *bytes, size_t size_bytes, const char *name,
                                        const clq_trajectories_def *def, clq_trajectories **out)
{
    return api::boundary("clq_trajectories_load_memory", [&] {
        api::require(context && out && (bytes || size_bytes == 0), "context, bytes or out is NULL");
        asset::TrajectoryInput input;
        input.bytes = static_cast<const uint8_t *>(bytes), input.size = size_bytes;
        input.name = api::name_of(name);
        *out = read(context, input, def);
    });
}

void clq_trajectories_destroy(clq_trajectories *trajectories) { delete trajectories; }

clq_status clq_trajectories_get_info(const clq_trajectories *trajectories, clq_trajectories_info *out)
{
    return api::boundary("clq_trajectories_get_info", [&] {
        api::require(trajectories && out, "trajectories or out is NULL");
        api::require_size(*out, "clq_trajectories_info_init");
        api::write_out(out, trajectories->all.facts);
    });
}

clq_status clq_trajectories_get_person(const clq_trajectories *trajectories, uint32_t person,
                                       clq_trajectory_person *out)
{
    return api::boundary("clq_trajectories_get_person", [&] {
        api::require(trajectories && out, "trajectories or out is NULL");
        api::require_size(*out, "clq_trajectory_person_init");
        const std::vector<asset::Person> &people = trajectories->all.people;
        if (person >= people.size())
            base::fail(CLQ_ARGUMENT, "person %u does not exist: there are %zu", person, people.size());
        clq_trajectory_person found = clq_trajectory_person_init();
        found.id = people[person].id;
        found.first_sample = people[person].first, found.sample_count = people[person].count;
        found.height_m = people[person].height_m;
        api::write_out(out, found);
    });
}

const clq_trajectory_sample *clq_trajectories_get_samples(const clq_trajectories *trajectories)
{
    return trajectories ? trajectories->all.samples.data() : nullptr;
}

const char *clq_trajectories_get_warning(const clq_trajectories *trajectories, uint32_t warning)
{
    return trajectories && warning < trajectories->all.warnings.size() ? trajectories->all.warnings[warning].c_str()
                                                                       : "";
}

}  // extern "C"
