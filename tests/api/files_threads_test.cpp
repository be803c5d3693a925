// Files of each kind are read on several threads at once as on one, the broken ones too. To be run under a thread
// sanitizer as well.
#include <claque/colour_files.h>
#include <claque/prepare.h>
#include <claque/trajectories.h>
#include <claque/zones.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <unistd.h>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/written_characters.h"

namespace
{

namespace fs = std::filesystem;

int append_text(void *user, const void *bytes, size_t size)
{
    static_cast<std::string *>(user)->append(static_cast<const char *>(bytes), size);
    return 0;
}

// What calls gave: bytes, numbers, and sentences where they failed.
class Outcomes
{
public:
    explicit Outcomes(clq_context *context, const fs::path &folder) : context_(context), folder_(folder)
    {
        for (const std::string &file : written::characters()) read_character(written::folder() + file);
        for (const char *name : {"whole.png", "half.png", "absent.png"}) read_picture(folder / name);
        for (const char *name : {"people.csv", "half.csv"}) read_people(folder / name);
        for (const char *name : {"place.wkt", "half.wkt"}) read_place(folder / name);
        for (const char *name : {"classes.toml", "half.toml"}) read_colours(folder / name);
        prepare();
    }
    const std::vector<std::string> &all() const { return all_; }

private:
    bool is_good(clq_status status)
    {
        if (status != CLQ_OK) all_.push_back(clq_last_error());
        return status == CLQ_OK;
    }
    void keep(clq_template *tmpl)
    {
        std::string bytes;
        EXPECT_EQ(clq_template_save(tmpl, append_text, &bytes), CLQ_OK) << clq_last_error();
        clq_template_destroy(tmpl);
        all_.push_back(bytes);
    }

    void read_character(const std::string &path)
    {
        clq_asset *asset = nullptr;
        if (!is_good(clq_asset_load_file(context_, path.c_str(), nullptr, &asset))) return;
        clq_asset_info info = clq_asset_info_init();
        EXPECT_EQ(clq_asset_get_info(asset, &info), CLQ_OK);
        std::vector<float> positions(3 * size_t{info.vertex_count});
        EXPECT_EQ(clq_asset_get_positions(asset, CLQ_NONE, 0, positions.data(), positions.size()), CLQ_OK);
        all_.emplace_back(reinterpret_cast<const char *>(positions.data()), positions.size() * sizeof positions[0]);
        for (uint32_t i = 0; i < info.image_count; ++i) {
            std::vector<uint16_t> texels(1 << 16);
            std::vector<uint8_t> rgb(3 * 4);
            clq_zone_proposal proposal = clq_zone_proposal_init();
            proposal.max_zones = 4, proposal.texels = texels.data(), proposal.capacity_texels = texels.size();
            proposal.rgb = rgb.data();
            if (is_good(clq_asset_propose_zones(asset, i, &proposal))) all_.emplace_back(rgb.begin(), rgb.end());
        }
        clq_template *tmpl = nullptr;
        if (is_good(clq_asset_build(context_, asset, 0, &tmpl))) keep(tmpl);
        clq_asset_destroy(asset);
    }
    void read_picture(const fs::path &path)
    {
        std::vector<uint8_t> pixels(1 << 20);
        clq_picture picture = clq_picture_init();
        picture.pixels = pixels.data(), picture.capacity_bytes = pixels.size();
        if (is_good(clq_image_read(context_, path.c_str(), &picture))) all_.emplace_back(pixels.begin(), pixels.end());
    }
    void read_people(const fs::path &path)
    {
        clq_trajectories *read = nullptr;
        if (!is_good(clq_trajectories_load(context_, path.c_str(), nullptr, &read))) return;
        clq_trajectories_info info = clq_trajectories_info_init();
        EXPECT_EQ(clq_trajectories_get_info(read, &info), CLQ_OK);
        double sum = 0;
        for (uint64_t i = 0; i < info.sample_count; ++i) sum += clq_trajectories_get_samples(read)[i].x;
        all_.push_back(std::to_string(sum) + clq_trajectories_get_warning(read, 0));
        clq_trajectories_destroy(read);
    }
    void read_place(const fs::path &path)
    {
        clq_area *read = nullptr;
        if (!is_good(clq_area_load(context_, path.c_str(), &read))) return;
        clq_area_info info = clq_area_info_init();
        EXPECT_EQ(clq_area_get_info(read, &info), CLQ_OK);
        all_.push_back(std::to_string(info.area_m2) + " " + std::to_string(info.triangle_count));
        clq_area_destroy(read);
    }
    void read_colours(const fs::path &path)
    {
        clq_colour_map *map = nullptr;
        if (!is_good(clq_colour_map_load_file(context_, path.c_str(), &map))) return;
        std::string text;
        EXPECT_EQ(clq_colour_map_save(map, append_text, &text), CLQ_OK);
        all_.push_back(text);
        clq_colour_map_destroy(map);
    }
    // All threads store the same character in one folder.
    void prepare()
    {
        clq_prepare_def def = clq_prepare_def_init();
        const std::string folder = (folder_ / "prepared").string();
        def.builtin = "owl", def.folder = folder.c_str();
        clq_template *tmpl = nullptr;
        if (is_good(clq_template_prepare(context_, &def, &tmpl, nullptr))) keep(tmpl);
    }

    clq_context *context_;
    const fs::path folder_;
    std::vector<std::string> all_;
};

std::string bytes_of_file(const fs::path &path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST(Files, OfEachKindAreReadOnThreadsSideBySide)
{
    const fs::path folder = fs::path(testing::TempDir()) / ("claque-files-" + std::to_string(getpid()));
    fs::create_directories(folder);
    const auto write = [&](const char *name, const std::string &whole, const char *half) {
        std::ofstream(folder / name, std::ios::binary) << whole;
        std::ofstream(folder / half, std::ios::binary) << whole.substr(0, whole.size() / 2);
    };
    write("whole.png", bytes_of_file(written::folder() + "Written Sparse.png"), "half.png");
    write("people.csv", "time,pedID,posX,posY\n0.5,a,1,2\n0.5,b,5,5\n1.0,a,1.5,2\n1.0,a,1.5,2\n", "half.csv");
    write("place.wkt", "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 2, 2 2, 2 1, 1 1))", "half.wkt");
    write("classes.toml", "[[classes]]\nname = \"a\"\n[classes.zones]\ncloth = { colour = \"#8a3b12\" }\n",
          "half.toml");
    clq_context *context = nullptr;
    ASSERT_EQ(clq_context_create(nullptr, &context), CLQ_OK);
    const std::vector<std::string> wanted = Outcomes(context, folder).all();
    EXPECT_GT(wanted.size(), 20u);
    fs::remove_all(folder / "prepared");
    std::vector<std::vector<std::string>> found(3);
    std::vector<std::thread> threads;
    for (std::vector<std::string> &one : found) threads.emplace_back([&] { one = Outcomes(context, folder).all(); });
    for (std::thread &thread : threads) thread.join();
    for (const std::vector<std::string> &one : found) EXPECT_TRUE(one == wanted);
    EXPECT_EQ(clq_context_destroy(context), CLQ_OK);
    fs::remove_all(folder);
}
