// Names of files that a window is given: its own user may name any, viewers of a served one those of one folder.
#include <filesystem>
#include <fstream>
#include <sys/stat.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include "samples/scenes/check.h"
#include "samples/view/designer/files.h"

namespace
{

namespace fs = std::filesystem;

using view::Folder;

class FolderOf : public testing::Test
{
protected:
    FolderOf()
    {
        std::string pattern = (fs::temp_directory_path() / "claque-folder-XXXXXX").string();
        root_ = mkdtemp(pattern.data());
        fs::create_directory(root_ / "shots");
        std::ofstream(root_ / "shots/mine.toml") << "mine";
        std::ofstream(root_ / "outside.toml") << "outside";
    }
    ~FolderOf() override { fs::remove_all(root_); }

    std::string shots() const { return (root_ / "shots").string(); }
    // Why a name is refused in a served window; empty: it is a file of the folder.
    std::string refused(const std::string &name) const
    {
        try {
            EXPECT_EQ(Folder(shots(), true).typed(name), shots() + "/" + name);
        } catch (const scenes::Failure &failure) {
            return failure.what();
        }
        return "";
    }

    fs::path root_;
};

TEST_F(FolderOf, AServedWindowHasItsFilesAlone)
{
    EXPECT_EQ(refused("mine.toml"), "");
    EXPECT_EQ(refused("new.toml"), "");
    for (const char *name : {"../outside.toml", "/etc/x.toml", "sub/x.toml", ".x.toml", "./mine.toml"})
        EXPECT_EQ(refused(name), "'" + std::string(name) +
                                     "' is no name for a file of a served window: it needs letters, no slash, and no "
                                     "dot at its beginning");
    for (const char *name : {"profile", "x.sh", ".toml", "toml"})
        EXPECT_NE(refused(name).find("does not end in .toml"), std::string::npos) << name;
    EXPECT_NE(refused(""), "");
}

TEST_F(FolderOf, AServedWindowFollowsNoLinkAndWaitsForNoPipe)
{
    fs::create_symlink(root_ / "outside.toml", root_ / "shots/link.toml");
    fs::create_symlink(root_ / "none.toml", root_ / "shots/nowhere.toml");
    ASSERT_EQ(mkfifo((root_ / "shots/pipe.toml").c_str(), 0600), 0);
    fs::create_directory(root_ / "shots/folder.toml");
    for (const char *name : {"link.toml", "nowhere.toml", "pipe.toml", "folder.toml"})
        EXPECT_EQ(refused(name), std::string(name) + " is no regular file");
}

TEST_F(FolderOf, AServedWindowLeavesFilesOfOthers)
{
    if (chown((root_ / "shots/mine.toml").c_str(), geteuid() + 1, static_cast<gid_t>(-1)) != 0)
        GTEST_SKIP() << "this user cannot give a file to another one";
    EXPECT_EQ(refused("mine.toml"), "mine.toml belongs to another user");
}

TEST_F(FolderOf, AWindowOfItsOwnUserHasAnyFile)
{
    const Folder folder(shots());
    EXPECT_EQ(folder.typed("mine.toml"), shots() + "/mine.toml");
    EXPECT_EQ(folder.typed("../outside.toml"), "../outside.toml");
    EXPECT_EQ(folder.typed("/etc/x"), "/etc/x");
    EXPECT_THROW(folder.typed(""), scenes::Failure);
}

TEST_F(FolderOf, WhatTheDesignerLoadsIsInIt)
{
    view::Designer designer;
    std::string message;
    designer.file = "../outside.toml", designer.wishes.load = true;
    view::keep_designs(
        designer, nullptr, Folder(shots(), true), [](const std::string &, const std::string &) {}, message);
    EXPECT_NE(message.find("is no name for a file of a served window"), std::string::npos) << message;
}

}  // namespace
