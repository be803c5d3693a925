// Prepared templates: their bytes on disk and in memory.
#include "prepare_fixture.h"

namespace prepare_test
{
namespace
{

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
    EXPECT_NE(std::string(report.text).find("repair that, or name another folder"), std::string::npos) << report.text;
    def.folder = "";
    EXPECT_FALSE(made(def, report).empty());
    EXPECT_FALSE(report.stored);
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
}  // namespace prepare_test
