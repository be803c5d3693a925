// Reading databases and packed files of people and areas takes time in proportion to the file. What SQLite and zlib do
// is not counted. The other formats are in counted_readers_test.cpp.
#include <gtest/gtest.h>

#include "../asset/trajectories/writers.h"
#include "lib/asset/areas/area.h"
#include "lib/base/error.h"
#include "work_counter.h"

namespace claque::testing
{
namespace
{

constexpr uint64_t most_track_ratio = 16;  // of ten times the count

uint64_t tracks_work(const Bytes &bytes, size_t people, size_t samples)
{
    asset::TrajectoryInput input;
    input.bytes = bytes.data(), input.size = bytes.size();
    return blocks_entered([&] {
        const asset::Trajectories read = asset::read_trajectories(input, {});
        EXPECT_EQ(read.people.size(), people);
        EXPECT_EQ(read.samples.size(), samples);
    });
}

void expect_growth(const char *name, uint64_t few, uint64_t many)
{
    EXPECT_GT(few, 3000u) << name << ": nothing is counted";
    EXPECT_LE(many, most_track_ratio * few) << name;
    ::testing::Test::RecordProperty(name, std::to_string(double(many) / double(few)));
}

#ifdef CLAQUE_HAS_SQLITE3

// `count` rows of a table, each as `row` says.
template <class Row>
std::string inserted(const char *table, size_t count, const Row &row)
{
    std::string out = std::string("INSERT INTO ") + table + " VALUES ";
    for (size_t i = 0; i < count; ++i) out += (i ? ", (" : "(") + row(i) + ")";
    return out;
}

const std::vector<std::string> database_head = {
    "CREATE TABLE metadata (key TEXT, value TEXT)", "INSERT INTO metadata VALUES ('version', '2'), ('fps', '5')",
    "CREATE TABLE trajectory_data (frame INTEGER, id INTEGER, pos_x REAL, pos_y REAL, ori_x REAL, ori_y REAL)"};

Bytes jupedsim(size_t count, bool of_one)
{
    std::vector<std::string> statements = database_head;
    statements.push_back(inserted("trajectory_data", count, [&](size_t i) {
        return base::text_of("%zu, %zu, %zu.5, 0, 1, 0", of_one ? i : i % 2, of_one ? size_t(1) : i / 2, i % 2);
    }));
    return database_of(statements);
}

TEST(TrackWork, OfDatabasesGrowsWithTheirRows)
{
    expect_growth("rows", tracks_work(jupedsim(300, true), 1, 300), tracks_work(jupedsim(3000, true), 1, 3000));
    expect_growth("people", tracks_work(jupedsim(600, false), 300, 600),
                  tracks_work(jupedsim(6000, false), 3000, 6000));
}

Bytes database_of_areas(size_t count)
{
    std::vector<std::string> statements = database_head;
    statements.emplace_back("CREATE TABLE geometry (hash INTEGER, wkt TEXT)");
    statements.emplace_back("CREATE TABLE frame_data (frame INTEGER, geometry_hash INTEGER)");
    statements.push_back(inserted(
        "geometry", count, [](size_t i) { return base::text_of("%zu, 'POLYGON ((0 0, 1 0, 0 %zu))'", i, i + 1); }));
    statements.push_back(
        inserted("frame_data", count, [&](size_t i) { return base::text_of("%zu, %zu", count - i, i); }));
    return database_of(statements);
}

TEST(TrackWork, OfDatabasesGrowsWithTheirAreas)
{
    const auto work = [](size_t count) {
        const Bytes bytes = database_of_areas(count);
        return blocks_entered([&] {
            const asset::Area area = asset::read_area(bytes.data(), bytes.size());
            EXPECT_EQ(area.rings.size(), 1u);
        });
    };
    expect_growth("areas", work(300), work(3000));
}

#endif

#ifdef CLAQUE_HAS_Z

Bytes packed_rows(size_t count)
{
    std::string text = "# PeTrack project: a\n# framerate: 5 fps\n# id frame x/cm y/cm z/cm\n";
    for (size_t i = 0; i < count; ++i) text += base::text_of("1 %zu %zu 0 175\n", i, i % 100);
    return claque::testing::packed(Bytes(text.begin(), text.end()));
}

TEST(TrackWork, OfPackedFilesGrowsWithWhatTheyHold)
{
    expect_growth("rows", tracks_work(packed_rows(300), 1, 300), tracks_work(packed_rows(3000), 1, 3000));
}

#endif

}  // namespace
}  // namespace claque::testing
