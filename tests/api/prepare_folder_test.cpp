// The folder of prepared templates: of its user alone, and nothing that another user has planted is read or followed.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "prepare_fixture.h"

namespace prepare_test
{
namespace
{

unsigned mode_of(const fs::path &path)
{
    struct stat facts = {};
    return stat(path.c_str(), &facts) == 0 ? facts.st_mode & 0777u : 0;
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
        EXPECT_NE(std::string(report.text).find("'chmod go-w " + folder_.string() + "' repairs that"),
                  std::string::npos)
            << report.text;
    }
    ASSERT_EQ(chmod(folder_.c_str(), 0755), 0);
    EXPECT_EQ(made(owl(), report), fresh);
    EXPECT_TRUE(report.from_disk);
}

TEST_F(Prepare, SaysHowToRepairAFolderOfALongPathToo)
{
    clq_prepare_report report = clq_prepare_report_init();
    const std::string deep = (folder_ / std::string(190 - folder_.string().size(), 'f')).string();
    fs::create_directories(deep);
    ASSERT_EQ(chmod(deep.c_str(), 0777), 0);
    clq_prepare_def def = owl();
    def.folder = deep.c_str();
    made(def, report);
    EXPECT_NE(std::string(report.text).find("'chmod go-w " + deep + "' repairs that"), std::string::npos)
        << report.text;
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

// A link that another user has made in the place of the folder may lead elsewhere at any time, also where it leads to a
// folder of this user now.
TEST_F(Prepare, UsesNoFolderBehindALinkOfAnotherUserAndSaysHowToRepairIt)
{
    if (geteuid() != 0) GTEST_SKIP() << "only root can make a link of another user";
    clq_prepare_report report = clq_prepare_report_init();
    const Bytes fresh = made(owl(), report);
    ASSERT_EQ(files().size(), 1u);
    const std::string link = folder_.string() + "_link";
    fs::remove(link);
    fs::create_symlink(folder_, link);
    clq_prepare_def def = owl();
    def.folder = link.c_str();
    EXPECT_EQ(made(def, report), fresh);
    EXPECT_TRUE(report.from_disk) << "a link of one's own is followed";
    ASSERT_EQ(lchown(link.c_str(), 12345, 12345), 0);
    for (const std::string &name : {link, link + "/", link + "//"}) {
        def.folder = name.c_str();
        EXPECT_EQ(made(def, report), fresh);
        EXPECT_FALSE(report.from_disk) << name;
        EXPECT_FALSE(report.stored) << name;
        const std::string text = report.text;
        EXPECT_NE(text.find("link that user 12345 made"), std::string::npos) << name << ": " << text;
        EXPECT_NE(text.find("remove it, or name another folder"), std::string::npos) << name << ": " << text;
    }
    fs::remove(link);
}

TEST_F(Prepare, FollowsLinksOfItsUserAndOfRoot)
{
    if (geteuid() != 0) GTEST_SKIP() << "only root can become another user";
    constexpr uid_t user = 12345;
    clq_prepare_report report = clq_prepare_report_init();
    const Bytes fresh = made(owl(), report);
    ASSERT_EQ(files().size(), 1u);
    for (const fs::path &path : {files()[0], folder_}) ASSERT_EQ(chown(path.c_str(), user, user), 0);
    const std::string link = folder_.string() + "_link";
    fs::remove(link);
    fs::create_symlink(folder_, link);
    clq_prepare_def def = owl();
    def.folder = link.c_str();
    for (const uid_t owner : {uid_t(0), user}) {
        ASSERT_EQ(lchown(link.c_str(), owner, owner), 0);
        ASSERT_EQ(seteuid(user), 0);
        const bool is_reachable = faccessat(AT_FDCWD, link.c_str(), R_OK, AT_EACCESS) == 0;
        const Bytes found = made(def, report);
        ASSERT_EQ(seteuid(0), 0);
        if (!is_reachable) GTEST_SKIP() << "other users may not enter " << testing::TempDir();
        EXPECT_EQ(found, fresh);
        EXPECT_TRUE(report.from_disk) << owner << ": " << report.text;
    }
    fs::remove(link);
}

// An entry that is a link to a folder, or a folder, of another user: nothing in it is read, written or removed.
TEST_F(Prepare, EntersNoFolderInThePlaceOfAnEntry)
{
    clq_prepare_report report = clq_prepare_report_init();
    const Bytes fresh = made(owl(), report);
    ASSERT_EQ(files().size(), 1u);
    const fs::path entry = files()[0], foreign = folder_.string() + "_foreign";
    fs::create_directories(foreign);
    write(foreign / "file", {'m', 'i', 'n', 'e'});
    if (geteuid() == 0) {
        ASSERT_EQ(chown(foreign.c_str(), 12345, 12345), 0);
    }
    fs::remove(entry);
    fs::create_directory_symlink(foreign, entry);
    EXPECT_EQ(made(owl(), report), fresh);
    EXPECT_FALSE(report.from_disk);
    EXPECT_TRUE(report.stored) << report.text;
    EXPECT_FALSE(fs::is_symlink(entry));
    EXPECT_EQ(read(entry), fresh);
    fs::remove(entry);
    fs::rename(foreign, entry);
    EXPECT_EQ(made(owl(), report), fresh);
    EXPECT_FALSE(report.stored);
    for (const std::string &word : {entry.string(), std::string("repair that, or name another folder")})
        EXPECT_NE(std::string(report.text).find(word), std::string::npos) << report.text;
    EXPECT_EQ(read(entry / "file"), Bytes({'m', 'i', 'n', 'e'}));
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

}  // namespace
}  // namespace prepare_test
