// Which shared objects may be loaded: those of one folder, whatever names and links say.
#include "samples/scenes/roles/mechanism_file.h"

#include <filesystem>
#include <fstream>
#include <sys/stat.h>

#include <gtest/gtest.h>

#include "samples/scenes/check.h"

namespace
{

namespace fs = std::filesystem;

using scenes::roles::MechanismFile;

class MechanismFiles : public testing::Test
{
protected:
    MechanismFiles()
    {
        std::string pattern = (fs::temp_directory_path() / "claque-mechanisms-XXXXXX").string();
        root_ = fs::canonical(mkdtemp(pattern.data()));
        fs::create_directories(root_ / "trusted/deep");
        fs::create_directories(root_ / "trusted-not");
        for (const char *name : {"trusted/a.so", "trusted/deep/b.so", "trusted-not/c.so", "d.so"})
            std::ofstream(root_ / name) << "bytes";
    }
    ~MechanismFiles() override { fs::remove_all(root_); }

    std::string at(const std::string &name) const { return (root_ / name).string(); }
    // Why a file is refused; empty: it is not.
    std::string refused(const std::string &file, const std::string &folder = "trusted") const
    {
        try {
            const MechanismFile allowed(folder.empty() ? "" : at(folder), at(file));
            EXPECT_EQ(fs::path(allowed.path()), fs::canonical(at(file)));
        } catch (const scenes::Failure &failure) {
            return failure.what();
        }
        return "";
    }

    fs::path root_;
};

TEST_F(MechanismFiles, AreInTheFolderOrBelow)
{
    for (const char *file : {"trusted/a.so", "trusted/deep/b.so", "trusted/../trusted/./a.so"})
        EXPECT_EQ(refused(file), "") << file;
    const std::string end = ", which is not in " + at("trusted") + ", the folder of --allow-mechanisms";
    for (const char *file : {"d.so", "trusted-not/c.so", "trusted/../d.so"})
        EXPECT_EQ(refused(file),
                  "the mechanism " + at(file) + " is not loaded: it is " + fs::canonical(at(file)).string() + end);
    EXPECT_EQ(refused("d.so", "trusted/.."), "");
}

TEST_F(MechanismFiles, AreWhereTheirLinksLead)
{
    fs::create_symlink(at("d.so"), at("trusted/out.so"));
    fs::create_directory_symlink(root_, at("trusted/up"));
    fs::create_symlink(at("trusted/a.so"), at("in.so"));
    fs::create_directory_symlink(at("trusted"), at("link"));
    for (const char *file : {"trusted/out.so", "trusted/up/d.so"})
        EXPECT_NE(refused(file).find("it is " + at("d.so") + ", which"), std::string::npos) << refused(file);
    EXPECT_EQ(refused("in.so"), "");
    EXPECT_EQ(refused("trusted/a.so", "link"), "");
}

TEST_F(MechanismFiles, AreFilesThatAreThere)
{
    ASSERT_EQ(mkfifo(at("trusted/pipe.so").c_str(), 0600), 0);
    for (const char *file : {"trusted/pipe.so", "trusted/deep"})
        EXPECT_EQ(refused(file), "the mechanism " + at(file) + " is not loaded: it is no regular file");
    EXPECT_EQ(refused("trusted/none.so"),
              "the mechanism " + at("trusted/none.so") + " cannot be loaded: No such file or directory");
    EXPECT_EQ(refused("d.so", "none"), "the mechanism " + at("d.so") + " cannot be loaded: the folder " + at("none") +
                                           " of --allow-mechanisms: No such file or directory");
}

TEST_F(MechanismFiles, AreNoneWithoutTheOption)
{
    EXPECT_TRUE(MechanismFile().empty());
    EXPECT_EQ(refused("trusted/a.so", ""),
              "the mechanism " + at("trusted/a.so") +
                  " is not loaded: it is a program, and only --allow-mechanisms FOLDER lets scenarios of the command "
                  "line load programs, those in FOLDER");
}

}  // namespace
