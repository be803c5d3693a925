// The law of memory: loading, building, levels, proposed zones and preparing take at most 64 x (bytes read + 4 x pixels
// decoded + bytes after decompression) and 16 MB. All memory counts, the context's as well.
#include <claque/assets.h>
#include <claque/levels.h>
#include <claque/prepare.h>
#include <claque/zones.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <new>

#include <gtest/gtest.h>

#include "../asset/heap_meter.h"
#include "../asset/png.h"
#include "attacks.h"
#include "lib/asset/decoders.h"
#include "memory_files.h"
#include "packed.h"
#include "tests/support/written_characters.h"

namespace claque::testing
{
namespace
{

namespace fs = std::filesystem;

struct Destroy {
    void operator()(clq_context *p) const { clq_context_destroy(p); }
    void operator()(clq_asset *p) const { clq_asset_destroy(p); }
    void operator()(clq_template *p) const { clq_template_destroy(p); }
};

template <class Thing>
using Own = std::unique_ptr<Thing, Destroy>;

class MemoryLaw : public ::testing::Test
{
protected:
    void SetUp() override
    {
        clq_context_def def = clq_context_def_init();
        def.allocator.allocate = [](void *, size_t size, size_t alignment) {
            return ::operator new(size, std::align_val_t(alignment), std::nothrow);
        };
        def.allocator.release = [](void *, void *memory, size_t, size_t alignment) {
            ::operator delete(memory, std::align_val_t(alignment));
        };
        clq_context *made = nullptr;
        ASSERT_EQ(clq_context_create(&def, &made), CLQ_OK);
        context_.reset(made);
    }

    // What a call takes, against what the file and its images allow.
    template <class Call>
    void hold(const char *call_name, uint64_t allowed, const Call &call)
    {
        clq_status status = CLQ_OK;
        const uint64_t peak = peak_heap_bytes([&] { status = call(); });
        EXPECT_LE(peak, allowed) << name_ << ", " << call_name << ": " << clq_status_name(status);
        const double share = double(peak) / double(allowed);
        if (share > worst_) worst_ = share, RecordProperty("worst", name_ + ", " + call_name);
        ++held_;
    }

    uint64_t pixels_of(const clq_asset *asset) const
    {
        clq_asset_info info = clq_asset_info_init();
        uint64_t pixels = 0;
        if (clq_asset_get_info(asset, &info) != CLQ_OK) return 0;
        for (uint32_t i = 0; i < info.image_count; ++i) {
            clq_asset_image image = clq_asset_image_init();
            if (clq_asset_get_image(asset, i, &image) == CLQ_OK) pixels += uint64_t(image.width_px) * image.height_px;
        }
        return pixels;
    }

    // All calls on a file of these bytes. `more` bytes are in files that it names, or come out of compression.
    void hold_all(const std::string &name, const Bytes &bytes, uint64_t more = 0)
    {
        name_ = name;
        clq_asset *loaded = nullptr;
        const uint64_t before = 64 * (bytes.size() + more) + mega16;
        hold("load", before + 64 * 4 * images_of(bytes),
             [&] { return clq_asset_load(context_.get(), bytes.data(), bytes.size(), nullptr, &loaded); });
        const Own<clq_asset> asset(loaded);
        if (asset) hold_made(asset.get(), before + 64 * 4 * pixels_of(asset.get()));
    }

    void hold_made(clq_asset *asset, uint64_t allowed)
    {
        clq_template *made = nullptr;
        hold("build", allowed, [&] { return clq_asset_build(context_.get(), asset, 0, &made); });
        clq_template_destroy(made);
        hold("propose", allowed, [&] { return propose(asset); });
        clq_levels_def def = clq_levels_def_init();
        def.metres_per_unit = 1;
        hold("levels", allowed, [&] { return clq_asset_make_levels(context_.get(), asset, &def, nullptr); });
    }

    static clq_status propose(const clq_asset *asset)
    {
        clq_asset_image image = clq_asset_image_init();
        const clq_status status = clq_asset_get_image(asset, 0, &image);
        if (status != CLQ_OK) return status;
        std::vector<uint16_t> texels(size_t(image.width_px) * image.height_px);
        std::vector<uint8_t> rgb(3 * 48);
        clq_zone_proposal proposal = clq_zone_proposal_init();
        proposal.max_zones = 48, proposal.texels = texels.data(), proposal.capacity_texels = texels.size();
        proposal.rgb = rgb.data();
        return clq_asset_propose_zones(asset, 0, &proposal);
    }

    // Of a file that is loaded once before, so that its pictures are known.
    uint64_t images_of(const Bytes &bytes)
    {
        clq_asset *loaded = nullptr;
        clq_asset_load(context_.get(), bytes.data(), bytes.size(), nullptr, &loaded);
        const Own<clq_asset> asset(loaded);
        return asset ? pixels_of(asset.get()) : 0;
    }

    static constexpr uint64_t mega16 = 16u << 20;
    Own<clq_context> context_;
    std::string name_;
    double worst_ = 0;
    int held_ = 0;
};

TEST_F(MemoryLaw, HoldsForFilesThatTakeMuch)
{
    bool has_bvh = false;
    for (const Attack &attack : reader_attacks()) {
        has_bvh = has_bvh || attack.bvh;
        for (const size_t count : {300, 3000}) hold_all(attack.name, attack.make(count));
    }
    EXPECT_TRUE(has_bvh);
    hold_all("long clips", long_clips(300, 1, 4000));
    hold_all("many clips", long_clips(3, 500, 4000));
    hold_all("shared keys", shared_keys(3000));
    hold_all("tinted images", tinted_images(500, 256));
    hold_all("root motion", long_root_motion(1e5f));
    EXPECT_GT(held_, 40);
}

TEST_F(MemoryLaw, HoldsForLevelsOfManyTriangles)
{
    for (const size_t count : {100, 1000, 4000}) {
        hold_all("sheet of " + std::to_string(count), sheet(count, false));
        hold_all("folded sheet of " + std::to_string(count), sheet(count, true));
        hold_all("moving sheets of " + std::to_string(count), moving_sheets(count));
    }
    for (const auto &[count, nodes] :
         {std::pair<size_t, size_t>(2000, 1), {2000, 2}, {10000, 2}, {30000, 1}, {1000, 100}})
        hold_all("net of " + std::to_string(count) + " on " + std::to_string(nodes), nets(count, nodes));
    EXPECT_GT(held_, 50);
}

TEST_F(MemoryLaw, HoldsForCompressedFiles)
{
    for (const size_t count : {200, 4000, 20000})
        for (const auto &[name, file] : {std::pair<const char *, PackedFile>("meshopt", meshopt_sheet(count)),
                                         {"Draco, sequential", draco_sheet(count, false)},
                                         {"Draco, edgebreaker", draco_sheet(count, true)}})
            if (!file.bytes.empty()) hold_all(name, file.bytes, file.unpacked);
    for (const uint32_t side : {64, 2048})
        if (const PackedFile file = webp_square(side); !file.bytes.empty()) hold_all("WebP", file.bytes);
    const bool all = asset::has_decoder(asset::Decoder::meshopt) && asset::has_decoder(asset::Decoder::draco) &&
                     asset::has_decoder(asset::Decoder::webp);
    if (all) {
        EXPECT_EQ(held_, 44);
    }
}

TEST_F(MemoryLaw, HoldsForPreparing)
{
    std::string folder = (fs::temp_directory_path() / "claque-memory-XXXXXX").string();
    ASSERT_NE(mkdtemp(folder.data()), nullptr);
    const auto write = [&](const std::string &name, const Bytes &bytes) {
        std::ofstream(folder + "/" + name, std::ios::binary)
            .write(reinterpret_cast<const char *>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
        return folder + "/" + name;
    };
    const clq_levels_def levels = clq_levels_def_init();
    const PackedFile packed = meshopt_sheet(4000);
    const Bytes numbers = numbers_beside(3000), picture = make_png(512, 512, 8, Bytes(513, 3), 512);
    write("numbers.bin", numbers), write("picture.png", picture);
    struct Prepared {
        const char *name;
        Bytes bytes;
        uint64_t more = 0;  // as of hold_all()
        uint64_t pixels = 0;
    };
    const std::vector<Prepared> all = {{"long clips", long_clips(300, 1, 4000)},
                                       {"sheet", sheet(1000, false), 0, 64 * 64},
                                       {"moving sheets", moving_sheets(1000)},
                                       {"channels on the same keys", shared_keys(300)},
                                       {"files beside", named_files(3000), numbers.size() + picture.size(), 512 * 512},
                                       {"meshopt", packed.bytes, packed.unpacked}};
    for (const auto &[name, bytes, more, pixels] : all) {
        if (bytes.empty()) continue;  // this build lacks the decoder
        const std::string path = write(bytes[0] == '{' ? "file.gltf" : "file.glb", bytes);
        const uint64_t allowed = 64 * (bytes.size() + more + 4 * pixels) + mega16;
        name_ = name;
        for (const clq_levels_def *wanted : {static_cast<const clq_levels_def *>(nullptr), &levels}) {
            clq_prepare_def def = clq_prepare_def_init();
            def.path = path.c_str(), def.folder = folder.c_str(), def.levels = wanted;
            for (const char *from : {"prepare", "prepared"}) {  // the second time from the folder
                clq_template *made = nullptr;
                hold(from, allowed, [&] { return clq_template_prepare(context_.get(), &def, &made, nullptr); });
                const bool is_refused = wanted && std::strstr(clq_last_error(), " are left");  // the law itself
                EXPECT_TRUE(made || is_refused) << name << ": " << clq_last_error();
                clq_template_destroy(made);
            }
        }
    }
    fs::remove_all(folder);
    EXPECT_EQ(held_, packed.bytes.empty() ? 20 : 24);
}

TEST_F(MemoryLaw, HoldsForCharacters)
{
    for (const std::string &file : written::characters()) {
        if (fs::path(file).extension() != ".glb") continue;
        std::ifstream in(written::folder() + file, std::ios::binary);
        hold_all(file, Bytes(std::istreambuf_iterator<char>(in), {}));
    }
    EXPECT_GT(held_, 12);
}

}  // namespace
}  // namespace claque::testing
