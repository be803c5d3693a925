// Files that others made, against figures that were computed from them by another program
// (shared/assets/tracks/README.md), within the rounding of its table.
#include <algorithm>
#include <cmath>
#include <map>

#include "fixture.h"

namespace claque::testing
{
namespace
{

struct SampleFile {
    const char *name;
    clq_trajectory_format format;
    double rate_hz, unit_m;  // 0: of the file
    uint64_t rows, people, peak;
    double seconds;
    double box[4];    // x from, to, y from, to
    double speed[3];  // median, 99th percentile, largest
    double slow_percent;
    double every_s;  // files of events: places at multiples of this time
    uint64_t vehicle_rows = 0, vehicles = 0;
};

constexpr double no = -1;  // not in the table

const SampleFile sample_files[] = {
    {"pedpy/040_c_56_h-.txt",
     CLQ_TRAJECTORY_PETRACK,
     0,
     0,
     63110,
     75,
     75,
     66.24,
     {-2.60, 2.26, -1.87, 5.98},
     {0.13, 1.11, 1.61},
     38.3,
     0},
    {"pedpy/uo-050-180-180.txt",
     CLQ_TRAJECTORY_PETRACK,
     16,
     0.01,
     9712,
     61,
     16,
     60.88,
     {0.00, 2.10, -6.17, 7.97},
     {1.37, 1.99, 2.19},
     0,
     0},
    {"pedpy/ref-bottleneck/traj.txt",
     CLQ_TRAJECTORY_JPSREPORT,
     0,
     0,
     128783,
     348,
     224,
     59.88,
     {-2.20, 3.95, -8.00, 6.21},
     {0.33, 1.52, 2.14},
     4.9,
     0},
    {"pedpy/ref-corner/traj.txt",
     CLQ_TRAJECTORY_JPSREPORT,
     0,
     0,
     18704,
     137,
     35,
     52.00,
     {-2.80, 3.93, -2.79, 4.17},
     {1.13, 1.73, 1.92},
     0,
     0},
    {"opentraj/zara01/obsmat.txt",
     CLQ_TRAJECTORY_OBSMAT,
     0,
     0,
     5024,
     148,
     20,
     360.4,
     {-7.35, 6.36, 4.98, 20.73},
     {1.19, 1.87, 2.58},
     2.8,
     0},
    {"opentraj/zara01/annotation.vsp",
     CLQ_TRAJECTORY_VSP,
     0,
     0,
     1520,
     148,
     20,
     360.56,
     {-7.35, 6.36, 4.98, 20.73},
     {1.19, 1.87, 2.58},
     2.8,
     0.4},
    {"opentraj/seq_hotel/obsmat.txt",
     CLQ_TRAJECTORY_OBSMAT,
     0,
     0,
     6544,
     390,
     18,
     722.4,
     {-3.29, 4.38, -10.25, 4.32},
     {1.28, 2.16, 2.44},
     22.0,
     0},
    {"trajnet/biwi_hotel.ndjson",
     CLQ_TRAJECTORY_TRAJNET,
     0,
     0,
     4621,
     263,
     18,
     698.8,
     {-2.63, 4.38, -10.25, 4.32},
     {1.21, 2.10, 2.45},
     22.8,
     0},
    {"trajnet/lcas.ndjson",
     CLQ_TRAJECTORY_TRAJNET,
     0,
     0,
     9610,
     304,
     18,
     362.4,
     {-21.28, 26.93, -10.62, 7.46},
     {0.06, 2.07, 5.69},
     58.0,
     0},
    {"pedpy/jupedsim_v2.sqlite",
     CLQ_TRAJECTORY_JUPEDSIM,
     0,
     0,
     65482,
     75,
     75,
     68.52,
     {-2.56, 2.44, -1.72, 5.96},
     {0.11, 1.20, 1.20},
     47.3,
     0},
    {"pedpy/trajectories.sqlite",
     CLQ_TRAJECTORY_JUPEDSIM,
     0,
     0,
     8083,
     30,
     30,
     19.60,
     {-7.38, 7.61, 1.79, 8.93},
     {0.79, 1.20, 1.20},
     0.1,
     0},
    {"derived/jupedsim_v3.sqlite",
     CLQ_TRAJECTORY_JUPEDSIM,
     0,
     0,
     8083,
     30,
     30,
     19.60,
     {-7.38, 7.61, 1.79, 8.93},
     {0.79, 1.20, 1.20},
     0.1,
     0},
    {"pedpy/pathfinder.csv",
     CLQ_TRAJECTORY_PATHFINDER_CSV,
     0,
     0,
     12120,
     150,
     150,
     138.78,
     {-11.10, 13.67, -4.77, 4.77},
     {0.11, 1.19, 1.20},
     48.0,
     0},
    {"pedpy/vadere_postvis.traj",
     CLQ_TRAJECTORY_VADERE,
     0,
     0,
     470,
     20,
     20,
     24.33,
     {1.16, 6.79, 0.98, 8.80},
     {0.55, 1.65, 1.88},
     21.4,
     0.1},
    {"pedpy/crowdit.csv.gz",
     CLQ_TRAJECTORY_CROWDIT,
     0,
     0,
     791,
     20,
     20,
     34.0,
     {29.80, 58.06, 10.09, 40.77},
     {1.02, 1.57, 1.68},
     0,
     0},
    {"pedpy/viswalk_excerpt.pp",
     CLQ_TRAJECTORY_VISWALK,
     0,
     0,
     42,
     13,
     12,
     217.85,
     {no, no, no, no},
     {no, no, no},
     no,
     0},
    {"derived/viswalk_from_trajectories_sqlite.pp",
     CLQ_TRAJECTORY_VISWALK,
     0,
     0,
     8083,
     30,
     30,
     19.60,
     {-7.38, 7.61, 1.79, 8.93},
     {0.79, 1.20, 1.20},
     0.1,
     0},
    {"sumo/crossing_1s.fcd.xml",
     CLQ_TRAJECTORY_SUMO,
     0,
     0,
     8224,
     101,
     65,
     199,
     {7.7, 112.3, 7.7, 112.3},
     {1.15, 1.57, 14.8},
     15.6,
     0,
     599,
     20},
    {"sumo/crossing_0.1s.fcd.xml",
     CLQ_TRAJECTORY_SUMO,
     0,
     0,
     6815,
     52,
     47,
     14.9,
     {no, no, no, no},
     {1.22, 1.67, 2.37},
     11.5,
     0,
     469,
     4},
    {"sumo/beaming.fcd.xml", CLQ_TRAJECTORY_SUMO, 0, 0, 4, 1, 1, 3, {no, no, no, no}, {397, 1386, 1406}, 0, 0},
    {"sumo/identical_start_pos_excerpt.fcd.xml",
     CLQ_TRAJECTORY_SUMO,
     0,
     0,
     28,
     4,
     4,
     6,
     {no, no, no, no},
     {1.18, 1.39, 1.39},
     21.4,
     0},
    {"trajnet/collision_test.ndjson",
     CLQ_TRAJECTORY_TRAJNET,
     0,
     0,
     18,
     2,
     2,
     3.2,
     {0, 0, -6.2, 6.2},
     {1.00, 1.00, 1.00},
     0,
     0},
};

void PrintTo(const SampleFile &file, std::ostream *out) { *out << file.name; }

using Samples = std::vector<clq_trajectory_sample>;

// The samples of each id, without vehicles: the table knows nothing of people who become several.
std::vector<Samples> by_id(const asset::Trajectories &read)
{
    std::vector<Samples> out;
    std::string before;
    for (const asset::Person &person : read.people) {
        const auto begin = read.samples.begin() + static_cast<std::ptrdiff_t>(person.first);
        if (begin->flags & CLQ_TRAJECTORY_VEHICLE) continue;
        const std::string id = std::string(person.id).substr(0, std::string(person.id).find('#'));
        if (id != before) out.emplace_back();
        before = id;
        out.back().insert(out.back().end(), begin, begin + static_cast<std::ptrdiff_t>(person.count));
    }
    return out;
}

// Where a person is at multiples of a time.
Samples sampled(const Samples &all, double every_s)
{
    Samples out;
    size_t i = 0;
    for (double k = std::ceil(all[0].time_s / every_s - 1e-9); k * every_s <= all.back().time_s + 1e-9; ++k) {
        const double t = std::clamp(k * every_s, all[0].time_s, all.back().time_s);
        while (i + 2 < all.size() && all[i + 1].time_s < t) ++i;
        clq_trajectory_sample at = all[i];
        if (all.size() > 1) {
            const double part = (t - all[i].time_s) / (all[i + 1].time_s - all[i].time_s);
            at.x += part * (all[i + 1].x - at.x), at.y += part * (all[i + 1].y - at.y);
        }
        at.time_s = t;
        out.push_back(at);
    }
    return out;
}

// As the table's: between the samples 0.25 s before and after, or the neighbours where these are further apart.
void add_speeds(const Samples &all, std::vector<double> &speeds)
{
    for (size_t i = 0; i < all.size() && all.size() > 1; ++i) {
        size_t a = i, b = i;
        while (a > 0 && all[i].time_s - all[a - 1].time_s <= 0.25 + 1e-9) --a;
        while (b + 1 < all.size() && all[b + 1].time_s - all[i].time_s <= 0.25 + 1e-9) ++b;
        if (a == i && i > 0) a = i - 1;
        if (b == i && i + 1 < all.size()) b = i + 1;
        speeds.push_back(std::hypot(all[b].x - all[a].x, all[b].y - all[a].y) / (all[b].time_s - all[a].time_s));
    }
}

// Rows at one time.
size_t most_rows_at_a_time(const std::vector<Samples> &people)
{
    std::map<long long, size_t> rows;
    for (const Samples &samples : people)
        for (const clq_trajectory_sample &sample : samples) ++rows[std::llround(sample.time_s * 1e4)];
    size_t most = 0;
    for (const auto &row : rows) most = std::max(most, row.second);
    return most;
}

// Between the two nearest, as NumPy's.
double percentile(const std::vector<double> &sorted, double part)
{
    const double at = part * double(sorted.size() - 1);
    const size_t below = size_t(at), above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (at - double(below)) * (sorted[above] - sorted[below]);
}

// A figure with so many decimals as the table prints.
void expect_printed(double found, double printed, double step) { EXPECT_NEAR(found, printed, 0.5 * step + 1e-6); }

void expect_speeds(const SampleFile &file, const std::vector<Samples> &people)
{
    std::vector<double> speeds;
    size_t samples = 0;
    for (const Samples &person : people) add_speeds(person, speeds), samples += person.size();
    std::sort(speeds.begin(), speeds.end());
    const double found[] = {percentile(speeds, 0.5), percentile(speeds, 0.99), speeds.back()};
    for (int k = 0; k < 3; ++k)
        expect_printed(found[k], file.speed[k], file.speed[k] > 100 ? 1 : file.speed[k] > 10 ? 0.1 : 0.01);
    const double slow = double(std::lower_bound(speeds.begin(), speeds.end(), 0.1) - speeds.begin());
    expect_printed(100 * slow / double(samples), file.slow_percent, 0.1);
}

void expect_box(const SampleFile &file, const std::vector<Samples> &people)
{
    double box[4] = {HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL};
    for (const Samples &person : people)
        for (const clq_trajectory_sample &sample : person) {
            box[0] = std::min(box[0], sample.x), box[1] = std::max(box[1], sample.x);
            box[2] = std::min(box[2], sample.y), box[3] = std::max(box[3], sample.y);
        }
    for (int k = 0; k < 4; ++k) expect_printed(box[k], file.box[k], file.format == CLQ_TRAJECTORY_SUMO ? 0.1 : 0.01);
}

class SampleFiles : public ::testing::TestWithParam<SampleFile>
{
};

TEST_P(SampleFiles, HaveTheFiguresOfTheTable)
{
    CLAQUE_NEEDS_TRACKS();
    const SampleFile &file = GetParam();
    asset::TrajectoryOptions options;
    options.rate_hz = file.rate_hz, options.metres_per_unit = file.unit_m;
    options.max_gap_s = options.max_speed_m_s = HUGE_VAL;
    options.vehicles = true;
    const asset::Trajectories read = read_track_file(file.name, options);
    EXPECT_EQ(read.facts.format, file.format);
    EXPECT_EQ(read.facts.row_count, file.rows + file.vehicle_rows);
    EXPECT_EQ(read.facts.id_count, file.people + file.vehicles);
    const double seconds = read.facts.max_s - read.facts.min_s;
    expect_printed(seconds, file.seconds, file.seconds == std::floor(file.seconds) ? 1 : 0.01);
    std::vector<Samples> people = by_id(read);
    EXPECT_EQ(people.size(), file.people);
    // Ends of foot steps are places of the file; the table has the control points after mapping to times.
    if (file.box[1] != no && file.format != CLQ_TRAJECTORY_VSP) expect_box(file, people);
    if (file.every_s > 0)
        for (Samples &person : people) person = sampled(person, file.every_s);
    EXPECT_EQ(most_rows_at_a_time(people), file.peak);
    if (file.format == CLQ_TRAJECTORY_VSP) expect_box(file, people);
    if (file.speed[0] != no) expect_speeds(file, people);
}

INSTANTIATE_TEST_SUITE_P(Tracks, SampleFiles, ::testing::ValuesIn(sample_files), [](const auto &info) {
    std::string name = info.param.name;
    for (char &c : name)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    return name;
});

// "2.22 without the one in a car", says the table.
TEST(SampleFilesOfSumo, PeopleInAVehicleAreLeftOut)
{
    CLAQUE_NEEDS_TRACKS();
    const asset::Trajectories read = read_track_file("sumo/crossing_1s.fcd.xml");
    EXPECT_EQ(read.facts.row_count, 8224u);
    EXPECT_EQ(read.facts.id_count, 101u);
    EXPECT_TRUE(warns(read, {"left out 38 rows of people in a vehicle"})) << all_warnings(read);
    std::vector<double> speeds;
    for (const asset::Person &person : read.people) {
        const auto begin = read.samples.begin() + static_cast<std::ptrdiff_t>(person.first);
        add_speeds(Samples(begin, begin + static_cast<std::ptrdiff_t>(person.count)), speeds);
    }
    expect_printed(*std::max_element(speeds.begin(), speeds.end()), 2.22, 0.01);
}

// 30 people of one run, in three formats.
TEST(SampleFilesOfOneRun, GiveEqualPeople)
{
    CLAQUE_NEEDS_TRACKS();
    const asset::Trajectories second = read_track_file("pedpy/trajectories.sqlite");
    const asset::Trajectories third = read_track_file("derived/jupedsim_v3.sqlite");
    const asset::Trajectories viswalk = read_track_file("derived/viswalk_from_trajectories_sqlite.pp");
    ASSERT_EQ(second.samples.size(), 8083u);
    ASSERT_EQ(third.samples.size(), second.samples.size());
    ASSERT_EQ(viswalk.samples.size(), second.samples.size());
    EXPECT_EQ(viswalk.facts.most_at_once, second.facts.most_at_once);
    for (size_t i = 0; i < second.people.size(); ++i) {
        EXPECT_STREQ(third.people[i].id, second.people[i].id);
        EXPECT_STREQ(viswalk.people[i].id, second.people[i].id);
        EXPECT_EQ(viswalk.people[i].first, second.people[i].first);
        EXPECT_EQ(third.people[i].count, second.people[i].count);
    }
    for (size_t i = 0; i < second.samples.size(); ++i) {
        const clq_trajectory_sample &a = second.samples[i], &b = third.samples[i], &c = viswalk.samples[i];
        EXPECT_EQ(a.time_s, b.time_s);
        EXPECT_EQ(a.x, b.x);
        EXPECT_EQ(a.y, b.y);
        EXPECT_NEAR(a.time_s + 0.04, c.time_s, 1e-9);
        EXPECT_NEAR(a.x, c.x, 5.1e-4);
        EXPECT_NEAR(a.y, c.y, 5.1e-4);
    }
    EXPECT_TRUE(second.facts.has_headings);
    EXPECT_FALSE(third.facts.has_headings);
}

// obsmat is the vsp file, read linearly.
TEST(SampleFilesOfOneRun, ControlPointsMeetTheRowsThatWereMadeFromThem)
{
    CLAQUE_NEEDS_TRACKS();
    const asset::Trajectories rows = read_track_file("opentraj/zara01/obsmat.txt");
    const asset::Trajectories points = read_track_file("opentraj/zara01/annotation.vsp");
    const std::vector<Samples> people = by_id(points), wanted = by_id(rows);
    ASSERT_EQ(people.size(), wanted.size());
    size_t met = 0;
    for (size_t i = 0; i < people.size(); ++i)
        for (const clq_trajectory_sample &sample : sampled(people[i], 0.4))
            for (const clq_trajectory_sample &row : wanted[i]) {
                // Its frame numbers begin at 1.
                if (std::fabs(row.time_s - 0.04 - sample.time_s) > 1e-6) continue;
                EXPECT_NEAR(row.x, sample.x, 5e-6);
                EXPECT_NEAR(row.y, sample.y, 5e-6);
                ++met;
            }
    EXPECT_EQ(met, 5024u);
}

// No sample has duplicates, rows at odds or rows out of order.
TEST(SampleFilesOfAll, WarnOfNothingThatTheyLack)
{
    CLAQUE_NEEDS_TRACKS();
    for (const SampleFile &file : sample_files) {
        asset::TrajectoryOptions options;
        options.rate_hz = file.rate_hz, options.metres_per_unit = file.unit_m;
        const asset::Trajectories read = read_track_file(file.name, options);
        EXPECT_FALSE(warns(read, {"put in order"})) << file.name;
        EXPECT_FALSE(warns(read, {"time and place of another"})) << file.name;
        EXPECT_FALSE(warns(read, {"second place"})) << file.name;
        EXPECT_FALSE(warns(read, {"lack a value"})) << file.name;
    }
}

}  // namespace
}  // namespace claque::testing
