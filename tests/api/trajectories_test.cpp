// Trajectories and areas through the C API: arguments, defaults, lifetimes, logs.
#include <claque/assets.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>
#include <vector>

#include <gtest/gtest.h>

namespace
{

class TrajectoryCalls : public testing::Test
{
protected:
    TrajectoryCalls()
    {
        clq_context_def def = clq_context_def_init();
        def.log.user = &log_;
        def.log.write = [](void *user, clq_log_level level, const char *text) {
            if (level == CLQ_LOG_WARNING) static_cast<std::vector<std::string> *>(user)->push_back(text);
        };
        EXPECT_EQ(clq_context_create(&def, &context_), CLQ_OK) << clq_last_error();
        std::string name = (std::filesystem::temp_directory_path() / "claque-trajectories-XXXXXX").string();
        folder_ = mkdtemp(name.data());
    }
    ~TrajectoryCalls() override
    {
        clq_trajectories_destroy(read_);
        clq_area_destroy(area_);
        EXPECT_EQ(clq_context_destroy(context_), CLQ_OK);
        std::filesystem::remove_all(folder_);
    }

    std::string file(const std::string &name, const std::string &text) const
    {
        std::ofstream(folder_ + "/" + name, std::ios::binary) << text;
        return folder_ + "/" + name;
    }
    clq_status load(const std::string &text, const clq_trajectories_def *def = nullptr)
    {
        clq_trajectories_destroy(read_);
        read_ = nullptr;
        return clq_trajectories_load_memory(context_, text.data(), text.size(), "people.csv", def, &read_);
    }

    std::vector<std::string> log_;
    clq_context *context_ = nullptr;
    clq_trajectories *read_ = nullptr;
    clq_area *area_ = nullptr;
    std::string folder_;
};

const std::string crowdit = "time,pedID,posX,posY\n0.5,a,1,2\n0.5,b,5,5\n1.0,a,1.5,2\n1.0,a,1.5,2\n9.0,a,1.5,2\n";

TEST_F(TrajectoryCalls, GiveInfoPeopleSamplesAndWarnings)
{
    ASSERT_EQ(load(crowdit), CLQ_OK) << clq_last_error();
    clq_trajectories_info info = clq_trajectories_info_init();
    ASSERT_EQ(clq_trajectories_get_info(read_, &info), CLQ_OK);
    EXPECT_EQ(info.format, CLQ_TRAJECTORY_CROWDIT);
    EXPECT_EQ(info.person_count, 3u);
    EXPECT_EQ(info.id_count, 2u);
    EXPECT_EQ(info.sample_count, 4u);
    EXPECT_EQ(info.row_count, 5u);
    EXPECT_EQ(info.min_s, 0.5);
    EXPECT_EQ(info.max_s, 9);
    EXPECT_EQ(info.box_min_m[0], 1);
    EXPECT_EQ(info.box_max_m[1], 5);
    EXPECT_EQ(info.most_at_once, 2u);
    EXPECT_FALSE(info.has_headings);
    clq_trajectory_person person = clq_trajectory_person_init();
    ASSERT_EQ(clq_trajectories_get_person(read_, 1, &person), CLQ_OK);
    EXPECT_STREQ(person.id, "a#2");
    EXPECT_EQ(person.first_sample, 2u);
    EXPECT_EQ(person.sample_count, 1u);
    EXPECT_TRUE(std::isnan(person.height_m));
    const clq_trajectory_sample *samples = clq_trajectories_get_samples(read_);
    EXPECT_EQ(samples[1].time_s, 1);
    EXPECT_EQ(samples[1].x, 1.5);
    EXPECT_TRUE(std::isnan(samples[1].heading_rad));
    ASSERT_EQ(info.warning_count, 3u);
    EXPECT_EQ(log_.size(), 3u);
    for (uint32_t i = 0; i < 3; ++i) EXPECT_EQ(log_[i], clq_trajectories_get_warning(read_, i));
    EXPECT_STREQ(clq_trajectories_get_warning(read_, 3), "");
    EXPECT_EQ(clq_trajectories_get_person(read_, 3, &person), CLQ_ARGUMENT);
    EXPECT_STREQ(clq_last_error(), "clq_trajectories_get_person: person 3 does not exist: there are 3");
}

TEST_F(TrajectoryCalls, ReadFilesWithTheMatrixBesideThem)
{
    const std::string vsp = "1 - the number of splines\n1 - Num of control points\n10 20 50 0 - (2D point, m_id)\n";
    const std::string path = file("a.vsp", vsp);
    EXPECT_EQ(clq_trajectories_load(context_, path.c_str(), nullptr, &read_), CLQ_ARGUMENT);
    EXPECT_NE(std::string(clq_last_error()).find(path + ": read as vsp: the file has pixels: put H.txt beside it"),
              std::string::npos)
        << clq_last_error();
    file("H.txt", "0.5 0 1\n0 0.25 2\n0 0 1\n");
    ASSERT_EQ(clq_trajectories_load(context_, path.c_str(), nullptr, &read_), CLQ_OK) << clq_last_error();
    // Row 268 from the top, column 370 from the left.
    EXPECT_EQ(clq_trajectories_get_samples(read_)[0].x, 135);
    EXPECT_EQ(clq_trajectories_get_samples(read_)[0].y, 94.5);
    EXPECT_EQ(clq_trajectories_get_samples(read_)[0].time_s, 2);
    // Up in the picture the row falls, and with it x.
    EXPECT_FLOAT_EQ(clq_trajectories_get_samples(read_)[0].heading_rad, 3.14159265f);
    clq_trajectories_def def = clq_trajectories_def_init();
    const double matrix[9] = {1, 0, 0, 0, 1, 0, 0, 0, 2};
    def.picture_to_metres = matrix;
    clq_trajectories_destroy(read_), read_ = nullptr;
    ASSERT_EQ(clq_trajectories_load(context_, path.c_str(), &def, &read_), CLQ_OK) << clq_last_error();
    EXPECT_EQ(clq_trajectories_get_samples(read_)[0].x, 134);
    file("H.txt", "0.5 0 1\n0 0.25 2\n0 0\n");
    clq_trajectories_destroy(read_), read_ = nullptr;
    EXPECT_EQ(clq_trajectories_load(context_, path.c_str(), nullptr, &read_), CLQ_FORMAT);
    EXPECT_NE(std::string(clq_last_error()).find("H.txt has 8 numbers: nine are wanted"), std::string::npos);
}

TEST_F(TrajectoryCalls, RefuseWhatIsOutOfRange)
{
    const auto refused = [&](const char *sentence, void (*change)(clq_trajectories_def &)) {
        clq_trajectories_def def = clq_trajectories_def_init();
        change(def);
        EXPECT_EQ(load(crowdit, &def), CLQ_ARGUMENT) << sentence;
        EXPECT_NE(std::string(clq_last_error()).find(sentence), std::string::npos) << clq_last_error();
        EXPECT_EQ(read_, nullptr);
    };
    using Def = clq_trajectories_def;
    refused("format is 99: 0 to 13 are known", [](Def &d) { d.format = static_cast<clq_trajectory_format>(99); });
    refused("up is 3: 0 to 2 are known", [](Def &d) { d.up = static_cast<clq_up_axis>(3); });
    refused("rate_hz is -1", [](Def &d) { d.rate_hz = -1; });
    refused("rate_hz is nan", [](Def &d) { d.rate_hz = NAN; });
    refused("metres_per_unit is 2e+06", [](Def &d) { d.metres_per_unit = 2e6; });
    refused("max_speed_m_s is 0: above 0 is wanted", [](Def &d) { d.max_speed_m_s = 0; });
    refused("max_gap_s is -3", [](Def &d) { d.max_gap_s = -3; });
    refused("from start_s 3 to end_s 2", [](Def &d) { d.start_s = 3, d.end_s = 2; });
    static const double bad[9] = {1, 0, NAN, 0, 1, 0, 0, 0, 1};
    refused("picture_to_metres[2] is not finite", [](Def &d) { d.picture_to_metres = bad; });
    clq_trajectories_def def = clq_trajectories_def_init();
    def.struct_bytes -= 4;
    EXPECT_EQ(load(crowdit, &def), CLQ_STRUCT_SIZE);
    EXPECT_EQ(clq_trajectories_load_memory(context_, nullptr, 3, nullptr, nullptr, &read_), CLQ_ARGUMENT);
    EXPECT_EQ(clq_trajectories_load_memory(nullptr, "a", 1, nullptr, nullptr, &read_), CLQ_ARGUMENT);
    EXPECT_EQ(clq_trajectories_load(context_, nullptr, nullptr, &read_), CLQ_ARGUMENT);
    EXPECT_EQ(clq_trajectories_load(context_, folder_.c_str(), nullptr, &read_), CLQ_IO);
    EXPECT_EQ(clq_trajectories_load_memory(context_, nullptr, 0, nullptr, nullptr, &read_), CLQ_FORMAT);
    clq_trajectories_info info = clq_trajectories_info_init();
    EXPECT_EQ(clq_trajectories_get_info(nullptr, &info), CLQ_ARGUMENT);
    info.struct_bytes = 1;
    ASSERT_EQ(load(crowdit), CLQ_OK);
    EXPECT_EQ(clq_trajectories_get_info(read_, &info), CLQ_STRUCT_SIZE);
    EXPECT_EQ(clq_trajectories_get_samples(nullptr), nullptr);
    EXPECT_STREQ(clq_trajectories_get_warning(nullptr, 0), "");
    clq_trajectories_destroy(nullptr);
}

TEST_F(TrajectoryCalls, GiveAreasFromFilesAndBytes)
{
    const std::string wkt = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 2, 2 2, 2 1, 1 1), (3 3, 3 3, 3 3))";
    const std::string path = file("a.wkt", wkt);
    ASSERT_EQ(clq_area_load(context_, path.c_str(), &area_), CLQ_OK) << clq_last_error();
    clq_area_info info = clq_area_info_init();
    ASSERT_EQ(clq_area_get_info(area_, &info), CLQ_OK);
    EXPECT_EQ(info.polygon_count, 1u);
    EXPECT_EQ(info.ring_count, 2u);
    EXPECT_EQ(info.point_count, 8u);
    EXPECT_EQ(info.triangle_count, 8u);
    EXPECT_EQ(info.wall_count, 8u);
    EXPECT_EQ(info.area_m2, 15);
    EXPECT_EQ(info.box_max_m[0], 4);
    EXPECT_EQ(info.box_max_m[2], 0);
    EXPECT_EQ(info.rings[1].first_point, 4u);
    EXPECT_EQ(info.points_m[3 * info.triangles[0] + 2], 0);
    ASSERT_EQ(info.warning_count, 1u);
    EXPECT_EQ(log_.at(0), clq_area_get_warning(area_, 0));
    EXPECT_STREQ(clq_area_get_warning(area_, 1), "");
    clq_area *other = nullptr;
    EXPECT_EQ(clq_area_load_memory(context_, "POLYGON ((", 10, "half.wkt", &other), CLQ_FORMAT);
    EXPECT_NE(std::string(clq_last_error()).find("half.wkt: byte 11 of the WKT"), std::string::npos)
        << clq_last_error();
    EXPECT_EQ(clq_area_load(context_, "/nothing", &other), CLQ_IO);
    EXPECT_EQ(clq_area_load_memory(context_, "POLYGON EMPTY", 13, nullptr, &other), CLQ_OK);
    ASSERT_EQ(clq_area_get_info(other, &info), CLQ_OK);
    EXPECT_EQ(info.box_max_m[0], 0);
    EXPECT_EQ(clq_area_get_info(nullptr, &info), CLQ_ARGUMENT);
    clq_area_destroy(other);
    clq_area_destroy(nullptr);
}

}  // namespace
