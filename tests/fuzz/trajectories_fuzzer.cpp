// Files of trajectories: two bytes choose format and options, the rest is the file. What is read keeps the laws of the
// header, and reading it again gives the same.
#include <claque/trajectories.h>

#include <cmath>

#include "tests/fuzz/fuzzer.h"

namespace
{

using namespace fuzzing;

constexpr double matrix[9] = {-0.026, 0, 7.8, -0.001, 0.022, 5.6, 0, 0, 1};

clq_trajectories_def options_of(unsigned format, unsigned bits)
{
    clq_trajectories_def def = clq_trajectories_def_init();
    def.format = static_cast<clq_trajectory_format>(format % (CLQ_TRAJECTORY_TABLE + 1));
    if (bits & 1) def.rate_hz = 16;
    if (bits & 2) def.metres_per_unit = 0.01;
    if (bits & 4) def.columns = bits & 8 ? "id,time,x,y,z,heading" : "id,frame,x,y";
    if (bits & 16) def.vehicles = true;
    if (bits & 32) def.up = CLQ_UP_Y;
    if (bits & 64) def.max_speed_m_s = def.max_gap_s = HUGE_VAL;
    if (bits & 128) def.picture_to_metres = matrix;
    def.memory_limit_bytes = 64u << 20;
    return def;
}

void expect_people(const clq_trajectories *read, const clq_trajectories_info &info, const clq_trajectories_def &def)
{
    const clq_trajectory_sample *samples = clq_trajectories_get_samples(read);
    uint64_t next = 0;
    for (uint32_t p = 0; p < info.person_count; ++p) {
        clq_trajectory_person person = clq_trajectory_person_init();
        ASSERT_EQ(clq_trajectories_get_person(read, p, &person), CLQ_OK);
        EXPECT_EQ(person.first_sample, next);
        EXPECT_GE(person.sample_count, 1u);
        next += person.sample_count;
        ASSERT_LE(next, info.sample_count);
        for (uint64_t i = person.first_sample; i < next; ++i) {
            const clq_trajectory_sample &sample = samples[i];
            EXPECT_TRUE(std::isfinite(sample.time_s) && std::isfinite(sample.x) && std::isfinite(sample.y) &&
                        std::isfinite(sample.z) && !std::isinf(sample.heading_rad));
            if (i == person.first_sample) continue;
            const clq_trajectory_sample &before = samples[i - 1];
            EXPECT_LT(before.time_s, sample.time_s);
            EXPECT_EQ(before.flags, sample.flags);
            if (sample.flags) continue;
            const double way = std::hypot(sample.x - before.x, sample.y - before.y);
            EXPECT_LE(way, def.max_speed_m_s * (sample.time_s - before.time_s) * (1 + 1e-9));
        }
    }
    EXPECT_EQ(next, info.sample_count);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    if (size < 2) return 0;
    const clq_trajectories_def def = options_of(bytes[0], bytes[1]);
    clq_context *context = new_context();
    clq_trajectories *read = nullptr, *again = nullptr;
    const std::initializer_list<clq_status> refusals{CLQ_FORMAT, CLQ_UNSUPPORTED, CLQ_LIMIT, CLQ_ARGUMENT};
    if (done(clq_trajectories_load_memory(context, bytes + 2, size - 2, nullptr, &def, &read), refusals)) {
        clq_trajectories_info info = clq_trajectories_info_init(), other = clq_trajectories_info_init();
        EXPECT_EQ(clq_trajectories_get_info(read, &info), CLQ_OK);
        expect_people(read, info, def);
        EXPECT_LE(info.most_at_once, info.person_count);
        EXPECT_LE(info.id_count, info.row_count);
        for (uint32_t i = 0; i < info.warning_count; ++i) EXPECT_STRNE(clq_trajectories_get_warning(read, i), "");
        EXPECT_EQ(clq_trajectories_load_memory(context, bytes + 2, size - 2, nullptr, &def, &again), CLQ_OK);
        EXPECT_EQ(clq_trajectories_get_info(again, &other), CLQ_OK);
        EXPECT_EQ(info.sample_count, other.sample_count);
        EXPECT_EQ(std::memcmp(clq_trajectories_get_samples(read), clq_trajectories_get_samples(again),
                              info.sample_count * sizeof(clq_trajectory_sample)),
                  0);
    }
    clq_trajectories_destroy(again);
    clq_trajectories_destroy(read);
    end(context);
    return 0;
}
