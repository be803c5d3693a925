// Each operation on a file that a call of libclaque-assets makes fails once: the call says which file, an entry of the
// cache is whole or absent, and nothing else is left in the folder.
#include <claque/claque.h>
#include <claque/colour_files.h>
#include <claque/prepare.h>
#include <claque/zones.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>
#include <unistd.h>

#include <gtest/gtest.h>

#include "tests/faults/failing_files.h"
#include "tests/support/written_characters.h"

namespace
{

namespace fs = std::filesystem;
using failing_files::Fault;
using failing_files::How;
using failing_files::Operation;

struct Kind {
    const char *name;
    Operation operation;
    How how;
    int error;
    bool is_fault;  // false: the call has to go on as if nothing had been
};

constexpr Kind kinds[] = {{"open", Operation::open, How::error, EIO, true},
                          {"open, no descriptors", Operation::open, How::for_good, EMFILE, true},
                          {"read", Operation::read, How::error, EIO, true},
                          {"read, interrupted", Operation::read, How::error, EINTR, false},
                          {"read, short", Operation::read, How::shortened, 0, false},
                          {"write", Operation::write, How::error, EIO, true},
                          {"write, disk full", Operation::write, How::for_good, ENOSPC, true},
                          {"write, interrupted", Operation::write, How::error, EINTR, false},
                          {"write, short", Operation::write, How::shortened, 0, false},
                          {"fsync", Operation::sync, How::error, EIO, true},
                          {"rename", Operation::rename, How::error, EIO, true},
                          {"rename, disk full", Operation::rename, How::for_good, ENOSPC, true},
                          {"close", Operation::close, How::error, EIO, false}};

class FileFaults : public testing::Test
{
protected:
    void SetUp() override
    {
        std::string name = testing::TempDir() + "claque-files-XXXXXX";
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        folder_ = name;
        fs::create_directory(folder_ / "in"), fs::create_directory(folder_ / "cache");
        fs::permissions(folder_ / "cache", fs::perms::owner_all);
        for (const char *file : {"WrittenSparse.gltf", "Written Sparse.png", "WrittenMorph.gltf"})
            fs::copy_file(written::folder() + file, folder_ / "in" / file);
        for (const auto &file : fs::directory_iterator(written::folder()))
            if (file.path().extension() == ".bin") fs::copy_file(file.path(), folder_ / "in" / file.path().filename());
        std::ofstream(folder_ / "in" / "c.toml") << "[[classes]]\nname = \"one\"\n";
        ASSERT_EQ(clq_context_create(nullptr, &context_), CLQ_OK);
    }
    void TearDown() override
    {
        EXPECT_EQ(clq_context_destroy(context_), CLQ_OK) << clq_last_error();
        fs::remove_all(folder_);
    }

    std::string in(const char *name) const { return (folder_ / "in" / name).string(); }

    using Files = std::map<std::string, std::string>;
    Files files() const
    {
        Files all;
        for (const auto &entry : fs::recursive_directory_iterator(folder_)) {
            if (!entry.is_regular_file()) continue;
            std::stringstream text;
            text << std::ifstream(entry.path(), std::ios::binary).rdbuf();
            all[fs::relative(entry.path(), folder_).string()] = text.str();
        }
        return all;
    }

    // Each operation of each kind until there is none of that number. `attempt` makes the call and destroys what it
    // gave; `check` judges what is there then.
    void fail_each(bool without_nameless, const std::function<void()> &before,
                   const std::function<clq_status()> &attempt,
                   const std::function<void(const Kind &, clq_status)> &check)
    {
        for (const Kind &kind : kinds)
            for (uint64_t n = 1;; ++n) {
                before();
                failing_files::arm(folder_.string(), {kind.operation, n, kind.how, kind.error, without_nameless});
                const clq_status status = attempt();
                const bool reached = failing_files::disarm();
                SCOPED_TRACE(std::string(kind.name) + ", number " + std::to_string(n));
                if (!reached) {
                    EXPECT_EQ(status, CLQ_OK) << clq_last_error();
                    break;
                }
                ++tried_;
                check(kind, status);
                if (HasFailure()) return;
                ASSERT_LT(n, 10000u);
            }
    }

    // A call that reads: it fails with the file's name, or goes on.
    void fail_reading(const std::function<clq_status()> &attempt)
    {
        const Files before = files();
        fail_each(
            false, [] {}, attempt,
            [&](const Kind &kind, clq_status status) {
                if (kind.is_fault) {
                    EXPECT_EQ(status, CLQ_IO) << clq_last_error();
                    EXPECT_NE(std::string(clq_last_error()).find((folder_ / "in").string()), std::string::npos)
                        << clq_last_error();
                } else {
                    EXPECT_EQ(status, CLQ_OK) << clq_last_error();
                }
                EXPECT_EQ(files(), before);
            });
        EXPECT_GT(tried_, 4u);
        std::printf("file faults: %llu\n", static_cast<unsigned long long>(tried_));
    }

    clq_status prepare(clq_prepare_report *report) const
    {
        const std::string path = in("WrittenMorph.gltf"), cache = (folder_ / "cache").string();
        clq_prepare_def def = clq_prepare_def_init();
        def.path = path.c_str(), def.folder = cache.c_str();
        clq_template *made = nullptr;
        const clq_status status = clq_template_prepare(context_, &def, &made, report);
        clq_template_destroy(made);
        return status;
    }

    fs::path folder_;
    clq_context *context_ = nullptr;
    uint64_t tried_ = 0;
};

TEST_F(FileFaults, OfAnAssetNameTheFile)
{
    const std::string path = in("WrittenSparse.gltf");
    clq_asset_options options = clq_asset_options_init();
    options.strict = true;
    fail_reading([&] {
        clq_asset *made = nullptr;
        const clq_status status = clq_asset_load_file(context_, path.c_str(), &options, &made);
        clq_asset_destroy(made);
        return status;
    });
}

TEST_F(FileFaults, OfAColourMapNameTheFile)
{
    const std::string path = in("c.toml");
    fail_reading([&] {
        clq_colour_map *made = nullptr;
        const clq_status status = clq_colour_map_load_file(context_, path.c_str(), &made);
        clq_colour_map_destroy(made);
        return status;
    });
}

TEST_F(FileFaults, OfAnImageNameTheFile)
{
    const std::string path = in("Written Sparse.png");
    fail_reading([&] {
        clq_picture picture = clq_picture_init();
        return clq_image_read(context_, path.c_str(), &picture);
    });
}

// Reading the sources fails the call; a folder that cannot be used does not.
TEST_F(FileFaults, OfTheCacheLeaveAWholeEntryOrNone)
{
    clq_prepare_report report = clq_prepare_report_init();
    const Files without = files();
    ASSERT_EQ(prepare(&report), CLQ_OK) << clq_last_error();
    ASSERT_TRUE(report.stored) << report.text;
    const Files with = files();
    ASSERT_EQ(with.size(), without.size() + 1);
    for (const bool stored : {false, true})
        for (const bool nameless : {true, false})
            fail_each(
                !nameless,
                [&] {
                    for (const auto &entry : fs::directory_iterator(folder_ / "cache")) fs::remove(entry.path());
                    report = clq_prepare_report_init();
                    if (stored) {
                        ASSERT_EQ(prepare(nullptr), CLQ_OK) << clq_last_error();
                    }
                },
                [&] { return prepare(&report); },
                [&](const Kind &kind, clq_status status) {
                    const Files now = files();
                    EXPECT_TRUE(now == without || now == with)
                        << now.size() << " files instead of " << without.size() << " or " << with.size();
                    if (status == CLQ_OK) {
                        EXPECT_EQ(now == with, report.stored || report.from_disk) << report.text;
                        EXPECT_EQ(report.stored || report.from_disk, report.text[0] == 0) << report.text;
                    } else {
                        EXPECT_EQ(status, CLQ_IO) << clq_last_error();
                        EXPECT_TRUE(kind.operation == Operation::open || kind.operation == Operation::read);
                        EXPECT_NE(std::string(clq_last_error()).find(folder_.string()), std::string::npos)
                            << clq_last_error();
                    }
                    const bool not_written = kind.operation == Operation::write || kind.operation == Operation::sync;
                    if (kind.is_fault && not_written) {
                        EXPECT_FALSE(report.stored) << "it may not be on the disk";
                    }
                    if (!kind.is_fault) {
                        EXPECT_TRUE(status == CLQ_OK && now == with) << report.text;
                    }
                });
    EXPECT_GT(tried_, 30u);
    std::printf("file faults: %llu\n", static_cast<unsigned long long>(tried_));
}

// Where a file system has no files without a name, parts have one that can be foreseen. Links of every second name are
// planted: of two parts, one meets a link.
TEST_F(FileFaults, OfAFileSystemWithoutNamelessFilesWriteThroughNoLink)
{
    ASSERT_EQ(prepare(nullptr), CLQ_OK) << clq_last_error();
    const fs::path entry = fs::directory_iterator(folder_ / "cache")->path(), foreign = folder_ / "foreign";
    std::ofstream(foreign) << "mine";
    for (int number = 0; number < 20000; number += 2)
        fs::create_symlink(foreign,
                           entry.string() + "." + std::to_string(getpid()) + "-" + std::to_string(number) + ".part");
    for (int i = 0; i < 2; ++i) {
        fs::remove(entry);
        clq_prepare_report report = clq_prepare_report_init();
        failing_files::arm(folder_.string(), {Operation::open, ~uint64_t(0), How::none, 0, true});
        EXPECT_EQ(prepare(&report), CLQ_OK) << clq_last_error();
        failing_files::disarm();
        EXPECT_TRUE(report.stored) << report.text;
        EXPECT_FALSE(fs::is_symlink(entry));
    }
    std::stringstream text;
    text << std::ifstream(foreign).rdbuf();
    EXPECT_EQ(text.str(), "mine");
}

}  // namespace
