// Prepared templates: their bytes on disk and in memory.
#include <claque/prepare.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

#include <gtest/gtest.h>

namespace
{

namespace fs = std::filesystem;
using Bytes = std::vector<char>;

Bytes read(const fs::path &path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

unsigned mode_of(const fs::path &path)
{
    struct stat facts = {};
    return stat(path.c_str(), &facts) == 0 ? facts.st_mode & 0777u : 0;
}

void write(const fs::path &path, const Bytes &bytes)
{
    std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

class Prepare : public testing::Test
{
protected:
    void SetUp() override
    {
        const auto *test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = fs::path(testing::TempDir()) / (std::string("claque_prepare_") + test->name());
        fs::remove_all(folder_);
        const clq_context_def def = clq_context_def_init();
        ASSERT_EQ(clq_context_create(&def, &context_), CLQ_OK);
    }
    void TearDown() override
    {
        clq_context_destroy(context_);
        fs::remove_all(folder_);
    }

    // The template's bytes and the message of the call.
    Bytes made(const clq_prepare_def &def, clq_prepare_report &report)
    {
        clq_template *tmpl = nullptr;
        EXPECT_EQ(clq_template_prepare(context_, &def, &tmpl, &report), CLQ_OK) << clq_last_error();
        Bytes bytes;
        if (!tmpl) return bytes;
        const auto append = [](void *user, const void *more, size_t size) {
            auto *all = static_cast<Bytes *>(user);
            const char *first = static_cast<const char *>(more);
            all->insert(all->end(), first, first + size);
            return 0;
        };
        EXPECT_EQ(clq_template_save(tmpl, append, &bytes), CLQ_OK);
        clq_template_destroy(tmpl);
        return bytes;
    }
    clq_prepare_def owl()
    {
        clq_prepare_def def = clq_prepare_def_init();
        def.builtin = "owl";
        text_ = folder_.string();
        def.folder = text_.c_str();
        return def;
    }
    std::vector<fs::path> files() const
    {
        std::vector<fs::path> found;
        if (fs::exists(folder_))
            for (const auto &entry : fs::directory_iterator(folder_)) found.push_back(entry.path());
        return found;
    }
    // A triangle whose numbers are in a file beside it.
    fs::path triangle() const
    {
        fs::create_directories(folder_ / "in");
        const float numbers[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
        const char *bytes = reinterpret_cast<const char *>(numbers);
        write(folder_ / "in" / "numbers.bin", Bytes(bytes, bytes + sizeof numbers));
        std::ofstream(folder_ / "in" / "triangle.gltf") << R"({"asset":{"version":"2.0"},"scene":0,
            "scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
            "buffers":[{"uri":"numbers.bin","byteLength":36}],"bufferViews":[{"buffer":0,"byteLength":36}],
            "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}]})";
        return folder_ / "in" / "triangle.gltf";
    }

    fs::path folder_;
    std::string text_;
    clq_context *context_ = nullptr;
};

TEST_F(Prepare, MakesOnceAndThenTakesTheSameBytesFromDisk)
{
    clq_prepare_report first = clq_prepare_report_init(), second = first;
    const Bytes fresh = made(owl(), first), kept = made(owl(), second);
    EXPECT_FALSE(first.from_disk);
    EXPECT_TRUE(first.stored) << first.text;
    EXPECT_TRUE(second.from_disk);
    EXPECT_EQ(fresh, kept);
    ASSERT_EQ(files().size(), 1u);
    EXPECT_EQ(read(files()[0]), fresh);
}

TEST_F(Prepare, ReplacesAFileThatWasCutOrChanged)
{
    clq_prepare_report report = clq_prepare_report_init();
    const Bytes fresh = made(owl(), report);
    ASSERT_EQ(files().size(), 1u);
    Bytes cut(fresh.begin(), fresh.begin() + std::ptrdiff_t(fresh.size() / 2)), changed = fresh, other = fresh;
    changed[fresh.size() / 2] ^= 1;
    other[8] ^= 1;  // its version
    for (const Bytes &bytes : {cut, changed, other, Bytes()}) {
        write(files()[0], bytes);
        EXPECT_EQ(made(owl(), report), fresh);
        EXPECT_FALSE(report.from_disk);
        EXPECT_EQ(read(files()[0]), fresh);
    }
}

TEST_F(Prepare, KeepsOtherOptionsInOtherFiles)
{
    clq_prepare_report report = clq_prepare_report_init();
    clq_prepare_def def = owl();
    made(def, report);
    def.max_texture_px = 64;
    made(def, report);
    EXPECT_FALSE(report.from_disk);
    def.builtin = "citizen";
    made(def, report);
    clq_levels_def levels = clq_levels_def_init();
    const uint32_t targets[] = {500, 400};
    levels.targets = targets, levels.target_count = 1;
    def.levels = &levels;
    made(def, report);
    EXPECT_FALSE(report.from_disk);
    levels.target_count = 2;
    made(def, report);
    EXPECT_FALSE(report.from_disk);
    EXPECT_EQ(files().size(), 5u);
}

TEST_F(Prepare, SeesThatAFileBesideTheCharacterChanged)
{
    clq_prepare_def def = owl();
    const std::string path = triangle().string(), kept = (folder_ / "kept").string();
    def.builtin = nullptr, def.path = path.c_str(), def.folder = kept.c_str();
    clq_prepare_report report = clq_prepare_report_init();
    const Bytes before = made(def, report);
    made(def, report);
    EXPECT_TRUE(report.from_disk);
    Bytes numbers = read(folder_ / "in" / "numbers.bin");
    numbers[15] = 0x40;  // x of the second corner: 1 becomes another number
    write(folder_ / "in" / "numbers.bin", numbers);
    EXPECT_NE(made(def, report), before);
    EXPECT_FALSE(report.from_disk);
}

TEST_F(Prepare, WorksWithoutAWritableStoreAndSaysWhy)
{
    fs::create_directories(folder_);
    clq_prepare_def def = owl();
    const std::string file = (folder_ / "file").string();
    write(file, {'x'});
    def.folder = file.c_str();
    clq_prepare_report report = clq_prepare_report_init();
    EXPECT_FALSE(made(def, report).empty());
    EXPECT_FALSE(report.stored);
    EXPECT_NE(std::string(report.text).find(file), std::string::npos) << report.text;
    def.folder = "";
    EXPECT_FALSE(made(def, report).empty());
    EXPECT_FALSE(report.stored);
}

TEST_F(Prepare, MakesItsFolderForItsUserAlone)
{
    const mode_t usual = umask(0);
    clq_prepare_report report = clq_prepare_report_init();
    clq_prepare_def def = owl();
    const std::string deep = (folder_ / "a" / "b").string();
    def.folder = deep.c_str();
    made(def, report);
    umask(usual);
    EXPECT_TRUE(report.stored) << report.text;
    for (const fs::path &path : {folder_, folder_ / "a", folder_ / "a" / "b"}) EXPECT_EQ(mode_of(path), 0700u) << path;
    for (const auto &entry : fs::directory_iterator(deep)) EXPECT_EQ(mode_of(entry.path()), 0600u) << entry.path();
}

TEST_F(Prepare, UsesNoFolderThatOthersMayWriteAndSaysHowToRepairIt)
{
    clq_prepare_report report = clq_prepare_report_init();
    const Bytes fresh = made(owl(), report);
    for (const mode_t mode : {0777u, 0702u, 0770u}) {
        ASSERT_EQ(chmod(folder_.c_str(), mode), 0);
        EXPECT_EQ(made(owl(), report), fresh);
        EXPECT_FALSE(report.from_disk) << "what lies there may be planted";
        EXPECT_FALSE(report.stored);
        EXPECT_NE(std::string(report.text).find("'chmod 700 " + folder_.string() + "' repairs that"), std::string::npos)
            << report.text;
    }
    ASSERT_EQ(chmod(folder_.c_str(), 0755), 0);
    EXPECT_EQ(made(owl(), report), fresh);
    EXPECT_TRUE(report.from_disk);
}

TEST_F(Prepare, UsesNoFolderAndNoFileOfAnotherUser)
{
    if (geteuid() != 0) GTEST_SKIP() << "only root can give a folder to another user";
    clq_prepare_report report = clq_prepare_report_init();
    const Bytes fresh = made(owl(), report);
    ASSERT_EQ(files().size(), 1u);
    ASSERT_EQ(chown(files()[0].c_str(), 12345, 12345), 0);
    EXPECT_EQ(made(owl(), report), fresh);
    EXPECT_FALSE(report.from_disk);
    EXPECT_TRUE(report.stored) << report.text;
    ASSERT_EQ(chown(folder_.c_str(), 12345, 12345), 0);
    EXPECT_EQ(made(owl(), report), fresh);
    EXPECT_FALSE(report.from_disk);
    EXPECT_FALSE(report.stored);
    EXPECT_NE(std::string(report.text).find("belongs to user 12345"), std::string::npos) << report.text;
    EXPECT_NE(std::string(report.text).find("name another folder"), std::string::npos) << report.text;
}

// A link in the place of an entry is neither read nor written through, whatever it leads to.
TEST_F(Prepare, FollowsNoLinkThatWasPlanted)
{
    clq_prepare_report report = clq_prepare_report_init();
    const Bytes fresh = made(owl(), report);
    ASSERT_EQ(files().size(), 1u);
    const fs::path entry = files()[0], foreign = folder_.string() + "_foreign";
    for (const bool is_entry : {true, false}) {
        write(foreign, is_entry ? fresh : Bytes{'m', 'i', 'n', 'e'});
        const Bytes before = read(foreign);
        fs::remove(entry);
        fs::create_symlink(foreign, entry);
        EXPECT_EQ(made(owl(), report), fresh);
        EXPECT_FALSE(report.from_disk);
        EXPECT_TRUE(report.stored) << report.text;
        EXPECT_EQ(read(foreign), before) << "a foreign file was overwritten";
        EXPECT_FALSE(fs::is_symlink(entry));
        EXPECT_EQ(read(entry), fresh);
    }
    ASSERT_EQ(chmod(entry.c_str(), 0666), 0);
    made(owl(), report);
    EXPECT_FALSE(report.from_disk) << "others may have written it";
    fs::remove(foreign);
}

// The names of files that are being written can be foreseen; a link of that name leads nowhere.
TEST_F(Prepare, WritesThroughNoLinkOfAPart)
{
    clq_prepare_report report = clq_prepare_report_init();
    made(owl(), report);
    ASSERT_EQ(files().size(), 1u);
    const fs::path entry = files()[0], foreign = folder_.string() + "_foreign";
    write(foreign, {'m', 'i', 'n', 'e'});
    write(entry, {'x'});  // so that it is made again, beside a file of its name
    for (int number = 0; number < 50; ++number)
        fs::create_symlink(foreign,
                           entry.string() + "." + std::to_string(getpid()) + "-" + std::to_string(number) + ".part");
    made(owl(), report);
    EXPECT_TRUE(report.stored) << report.text;
    EXPECT_EQ(read(foreign), Bytes({'m', 'i', 'n', 'e'}));
    fs::remove(foreign);
}

TEST_F(Prepare, RefusesNamesThatMatchNotExactlyOneCharacter)
{
    clq_prepare_def def = owl();
    clq_template *tmpl = nullptr;
    def.path = "also.glb";
    EXPECT_EQ(clq_template_prepare(context_, &def, &tmpl, nullptr), CLQ_ARGUMENT);
    def.builtin = def.path = nullptr;
    EXPECT_EQ(clq_template_prepare(context_, &def, &tmpl, nullptr), CLQ_ARGUMENT);
    def.path = "there is no such file.glb";
    EXPECT_EQ(clq_template_prepare(context_, &def, &tmpl, nullptr), CLQ_IO);
    def = owl();
    def.builtin = "nobody";
    EXPECT_EQ(clq_template_prepare(context_, &def, &tmpl, nullptr), CLQ_ARGUMENT);
    EXPECT_NE(std::string(clq_last_error()).find("citizen"), std::string::npos) << clq_last_error();
    def.struct_bytes -= 1;
    EXPECT_EQ(clq_template_prepare(context_, &def, &tmpl, nullptr), CLQ_STRUCT_SIZE);
    EXPECT_EQ(tmpl, nullptr);
    EXPECT_TRUE(files().empty());
}

}  // namespace
