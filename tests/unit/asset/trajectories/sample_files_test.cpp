// Files that others made, against figures that were computed from them by another program
// (the README of the tracks), within the rounding of its table.
#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "sample_walks.h"

namespace claque::testing
{
namespace
{

struct SampleFile {
    std::string name;
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

// name, format; rate and unit that are told; rows, people, most at once, seconds; extent in x and y; speed: median,
// 99th percentile, largest; slow per cent; time between places of files of events; rows of vehicles, vehicles. -: not
// in the table.
constexpr char printed[] = R"(
pedpy/040_c_56_h-.txt 2 0 0 63110 75 75 66.24 -2.60 2.26 -1.87 5.98 0.13 1.11 1.61 38.3 0 0 0
pedpy/uo-050-180-180.txt 2 16 0.01 9712 61 16 60.88 0.00 2.10 -6.17 7.97 1.37 1.99 2.19 0 0 0 0
pedpy/ref-bottleneck/traj.txt 3 0 0 128783 348 224 59.88 -2.20 3.95 -8.00 6.21 0.33 1.52 2.14 4.9 0 0 0
pedpy/ref-corner/traj.txt 3 0 0 18704 137 35 52.00 -2.80 3.93 -2.79 4.17 1.13 1.73 1.92 0 0 0 0
opentraj/zara01/obsmat.txt 10 0 0 5024 148 20 360.4 -7.35 6.36 4.98 20.73 1.19 1.87 2.58 2.8 0 0 0
opentraj/zara01/annotation.vsp 11 0 0 1520 148 20 360.56 -7.35 6.36 4.98 20.73 1.19 1.87 2.58 2.8 0.4 0 0
opentraj/seq_hotel/obsmat.txt 10 0 0 6544 390 18 722.4 -3.29 4.38 -10.25 4.32 1.28 2.16 2.44 22.0 0 0 0
trajnet/biwi_hotel.ndjson 12 0 0 4621 263 18 698.8 -2.63 4.38 -10.25 4.32 1.21 2.10 2.45 22.8 0 0 0
trajnet/lcas.ndjson 12 0 0 9610 304 18 362.4 -21.28 26.93 -10.62 7.46 0.06 2.07 5.69 58.0 0 0 0
pedpy/jupedsim_v2.sqlite 1 0 0 65482 75 75 68.52 -2.56 2.44 -1.72 5.96 0.11 1.20 1.20 47.3 0 0 0
pedpy/trajectories.sqlite 1 0 0 8083 30 30 19.60 -7.38 7.61 1.79 8.93 0.79 1.20 1.20 0.1 0 0 0
derived/jupedsim_v3.sqlite 1 0 0 8083 30 30 19.60 -7.38 7.61 1.79 8.93 0.79 1.20 1.20 0.1 0 0 0
pedpy/pathfinder.csv 6 0 0 12120 150 150 138.78 -11.10 13.67 -4.77 4.77 0.11 1.19 1.20 48.0 0 0 0
pedpy/vadere_postvis.traj 5 0 0 470 20 20 24.33 1.16 6.79 0.98 8.80 0.55 1.65 1.88 21.4 0.1 0 0
pedpy/crowdit.csv.gz 8 0 0 791 20 20 34.0 29.80 58.06 10.09 40.77 1.02 1.57 1.68 0 0 0 0
pedpy/viswalk_excerpt.pp 9 0 0 42 13 12 217.85 - - - - - - - - 0 0 0
derived/viswalk_from_trajectories_sqlite.pp 9 0 0 8083 30 30 19.60 -7.38 7.61 1.79 8.93 0.79 1.20 1.20 0.1 0 0 0
sumo/crossing_1s.fcd.xml 4 0 0 8224 101 65 199 7.7 112.3 7.7 112.3 1.15 1.57 14.8 15.6 0 599 20
sumo/crossing_0.1s.fcd.xml 4 0 0 6815 52 47 14.9 - - - - 1.22 1.67 2.37 11.5 0 469 4
sumo/beaming.fcd.xml 4 0 0 4 1 1 3 - - - - 397 1386 1406 0 0 0 0
sumo/identical_start_pos_excerpt.fcd.xml 4 0 0 28 4 4 6 - - - - 1.18 1.39 1.39 21.4 0 0 0
trajnet/collision_test.ndjson 12 0 0 18 2 2 3.2 0 0 -6.2 6.2 1.00 1.00 1.00 0 0 0 0
)";

std::vector<SampleFile> read_table()
{
    const auto number = [](std::istream &from) {
        std::string word;
        from >> word;
        return word == "-" ? no : std::stod(word);
    };
    std::vector<SampleFile> out;
    std::istringstream lines(printed);
    for (std::string line; std::getline(lines, line);) {
        if (line.empty()) continue;
        std::istringstream from(line);
        SampleFile file;
        from >> file.name;
        file.format = static_cast<clq_trajectory_format>(int(number(from)));
        file.rate_hz = number(from), file.unit_m = number(from);
        for (uint64_t *count : {&file.rows, &file.people, &file.peak}) *count = uint64_t(number(from));
        file.seconds = number(from);
        for (double &edge : file.box) edge = number(from);
        for (double &speed : file.speed) speed = number(from);
        file.slow_percent = number(from), file.every_s = number(from);
        for (uint64_t *count : {&file.vehicle_rows, &file.vehicles}) *count = uint64_t(number(from));
        out.push_back(file);
    }
    return out;
}

const std::vector<SampleFile> sample_files = read_table();

void PrintTo(const SampleFile &file, std::ostream *out) { *out << file.name; }

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
void expect_printed(double found, double wanted, double step) { EXPECT_NEAR(found, wanted, 0.5 * step + 1e-6); }

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
    CLAQUE_NEEDS_LIBRARY_OF(file.name);
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

INSTANTIATE_TEST_SUITE_P(Tracks, SampleFiles, ::testing::ValuesIn(sample_files), [](const auto &chosen) {
    std::string name = chosen.param.name;
    for (char &c : name)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    return name;
});

// "2.22 without the one in a car", says the table.
TEST(SampleFilesOfSumo, PeopleInAVehicleAreLeftOut)
{
    CLAQUE_NEEDS_TRACKS();
    CLAQUE_NEEDS_LIBRARY_OF("sumo/crossing_1s.fcd.xml");
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

// No sample has duplicates, rows at odds or rows out of order.
TEST(SampleFilesOfAll, WarnOfNothingThatTheyLack)
{
    CLAQUE_NEEDS_TRACKS();
    for (const SampleFile &file : sample_files) {
        if (!missing_library(file.name).empty()) continue;
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
