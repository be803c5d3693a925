// The folder of prepared people beside libclaque-assets.so: read where root and the owner of the library alone can
// have written, else passed over with a warning. Each test has a copy of the library in a folder of its own.
#include <claque/prepare.h>

#include <cstdlib>
#include <dlfcn.h>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sys/stat.h>
#include <unistd.h>

#include <gtest/gtest.h>

namespace
{

namespace fs = std::filesystem;
using Bytes = std::vector<char>;

void write(const fs::path &path, const Bytes &bytes)
{
    std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

Bytes saved(clq_template *tmpl)
{
    Bytes bytes;
    const auto append = [](void *user, const void *more, size_t size) {
        auto *all = static_cast<Bytes *>(user);
        all->insert(all->end(), static_cast<const char *>(more), static_cast<const char *>(more) + size);
        return 0;
    };
    if (tmpl) EXPECT_EQ(clq_template_save(tmpl, append, &bytes), CLQ_OK);
    clq_template_destroy(tmpl);
    return bytes;
}

class InstalledPeople : public testing::Test
{
protected:
    void SetUp() override
    {
        const auto *test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = fs::path(testing::TempDir()) / (std::string("claque_installed_") + test->name());
        fs::remove_all(folder_);
        fs::create_directories(folder_ / "usr" / "lib" / "here");
        library_ = folder_ / "usr" / "lib" / "here" / "libclaque-assets.so.0";
        people_ = (library_.parent_path() / CLAQUE_PEOPLE_FOLDER).lexically_normal();
        cache_ = folder_ / "cache";
        fs::create_directories(people_.parent_path());
        fs::copy_file(CLAQUE_ASSETS_LIBRARY, library_);
        load(library_);
        setenv("XDG_CACHE_HOME", cache_.c_str(), 1);
        clq_context_def def = clq_context_def_init();
        def.log.user = &log_;
        def.log.write = [](void *user, clq_log_level level, const char *text) {
            if (level == CLQ_LOG_WARNING) *static_cast<std::string *>(user) += text;
        };
        ASSERT_EQ(clq_context_create(&def, &context_), CLQ_OK);
    }
    void TearDown() override
    {
        clq_context_destroy(context_);
        if (handle_) dlclose(handle_);
        fs::remove_all(folder_);
    }

    void load(const fs::path &library)
    {
        if (handle_) dlclose(handle_);
        handle_ = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
        ASSERT_NE(handle_, nullptr) << dlerror();
        prepare_ = reinterpret_cast<decltype(prepare_)>(dlsym(handle_, "clq_template_prepare"));
        builtin_ = reinterpret_cast<decltype(builtin_)>(dlsym(handle_, "clq_template_builtin"));
        ASSERT_TRUE(prepare_ && builtin_);
    }

    // The owl's bytes; `folder` as in clq_prepare_def. What an earlier call has kept for the user is forgotten.
    Bytes made(const char *folder = nullptr)
    {
        fs::remove_all(cache_);
        log_.clear();
        report_ = clq_prepare_report_init();
        clq_prepare_def def = clq_prepare_def_init();
        def.builtin = "owl";
        def.folder = folder;
        clq_template *tmpl = nullptr;
        EXPECT_EQ(prepare_(context_, &def, &tmpl, &report_), CLQ_OK) << clq_last_error();
        return saved(tmpl);
    }
    // Puts a prepared owl beside the library, as every user may read it.
    void install()
    {
        fresh_ = made(people_.c_str());
        ASSERT_TRUE(report_.stored) << report_.text;
        file_ = fs::directory_iterator(people_)->path();
        ASSERT_EQ(chmod(people_.c_str(), 0755), 0);
        ASSERT_EQ(chmod(file_.c_str(), 0644), 0);
    }
    void expect_taken(const std::string &where)
    {
        EXPECT_EQ(made(), fresh_) << where;
        EXPECT_TRUE(report_.from_disk) << where << ": " << log_;
        EXPECT_EQ(log_, "") << where;
        EXPECT_FALSE(fs::exists(cache_)) << where;
    }
    // The warning names `path` and says why.
    void expect_passed_over(const std::string &where, const fs::path &path, const std::string &why)
    {
        EXPECT_EQ(made(), fresh_) << where;
        EXPECT_FALSE(report_.from_disk) << where;
        EXPECT_TRUE(report_.stored) << where << ": " << report_.text;
        EXPECT_EQ(log_.find("prepared people are passed over: "), 0u) << where << ": " << log_;
        EXPECT_NE(log_.find(path.string()), std::string::npos) << where << ": " << log_;
        EXPECT_NE(log_.find(why), std::string::npos) << where << ": " << log_;
    }

    fs::path folder_, library_, people_, cache_, file_;
    Bytes fresh_;
    std::string log_;
    void *handle_ = nullptr;
    decltype(&clq_template_prepare) prepare_ = nullptr;
    decltype(&clq_template_builtin) builtin_ = nullptr;
    clq_context *context_ = nullptr;
    clq_prepare_report report_ = clq_prepare_report_init();
};

}  // namespace

TEST_F(InstalledPeople, AreTakenFromBesideTheLibraryAndNothingIsWritten)
{
    install();
    expect_taken("beside the library");
}

TEST_F(InstalledPeople, ServeTheCallThatTakesANameAlone)
{
    install();
    fs::remove_all(cache_);
    clq_template *tmpl = nullptr;
    ASSERT_EQ(builtin_(context_, "owl", &tmpl), CLQ_OK) << clq_last_error();
    EXPECT_EQ(saved(tmpl), fresh_);
    EXPECT_FALSE(fs::exists(cache_));
}

TEST_F(InstalledPeople, AreLeftAloneWhereAFolderIsNamed)
{
    install();
    EXPECT_EQ(made(""), fresh_);
    EXPECT_FALSE(report_.from_disk);
    EXPECT_EQ(made((folder_ / "mine").c_str()), fresh_);
    EXPECT_TRUE(report_.stored) << report_.text;
}

TEST_F(InstalledPeople, AreMadeWithoutAWordWhereThereIsNoFolder)
{
    made();
    EXPECT_TRUE(report_.stored) << report_.text;
    EXPECT_EQ(log_, "");
    fs::create_directories(people_);
    made();
    EXPECT_TRUE(report_.stored) << report_.text;
    EXPECT_EQ(log_, "");
}

TEST_F(InstalledPeople, ArePassedOverWhereOthersMayWrite)
{
    install();
    for (const mode_t mode : {0664u, 0646u, 0666u}) {
        ASSERT_EQ(chmod(file_.c_str(), mode), 0);
        expect_passed_over("file", file_, "others may write there");
    }
    ASSERT_EQ(chmod(file_.c_str(), 0644), 0);
    for (const mode_t mode : {0775u, 0757u, 0777u}) {
        ASSERT_EQ(chmod(people_.c_str(), mode), 0);
        expect_passed_over("folder", people_, "'chmod go-w " + people_.string() + "' repairs that");
    }
    ASSERT_EQ(chmod(people_.c_str(), 0755), 0);
    expect_taken("repaired");
}

TEST_F(InstalledPeople, BelongToRootOrToTheOwnerOfTheLibrary)
{
    if (geteuid() != 0) GTEST_SKIP() << "only root can give files to other users";
    install();
    const auto give = [](const fs::path &path, uid_t user) { ASSERT_EQ(chown(path.c_str(), user, user), 0); };
    give(file_, 12345);
    expect_passed_over("file", file_, "belongs to user 12345, not to user 0: install claque again");
    give(file_, 0), give(people_, 12345);
    expect_passed_over("folder", people_, "belongs to user 12345, not to user 0: install claque again");
    give(library_, 12345);
    expect_taken("the library's owner's folder, root's file");
    give(file_, 12345);
    expect_taken("all of one owner");
    give(file_, 12346);
    expect_passed_over("file of a third user", file_, "belongs to user 12346, not to user 12345");
}

TEST_F(InstalledPeople, AreReadByEveryUser)
{
    if (geteuid() != 0) GTEST_SKIP() << "only root can become another user";
    install();
    ASSERT_EQ(seteuid(12345), 0);
    const bool is_reachable = faccessat(AT_FDCWD, people_.c_str(), R_OK, AT_EACCESS) == 0;
    if (is_reachable) expect_taken("another user");
    ASSERT_EQ(seteuid(0), 0);
    if (!is_reachable) GTEST_SKIP() << "other users may not enter " << testing::TempDir();
}

TEST_F(InstalledPeople, AreNotReadThroughLinks)
{
    install();
    const fs::path elsewhere = folder_ / "elsewhere";
    fs::rename(file_, elsewhere);
    fs::create_symlink(elsewhere, file_);
    expect_passed_over("file", file_, "is a link");
    fs::remove(file_);
    fs::rename(elsewhere, file_);
    fs::rename(people_, elsewhere);
    fs::create_directory_symlink(elsewhere, people_);
    expect_taken("a link of one's own");
    if (geteuid() != 0) GTEST_SKIP() << "only root can make a link of another user";
    ASSERT_EQ(lchown(people_.c_str(), 12345, 12345), 0);
    expect_passed_over("folder", people_, "is a link that user 12345 made");
    ASSERT_EQ(chown(library_.c_str(), 12345, 12345), 0);
    expect_taken("a link of the library's owner");
}

TEST_F(InstalledPeople, ArePassedOverIfTheyAreDamaged)
{
    install();
    Bytes cut(fresh_.begin(), fresh_.begin() + std::ptrdiff_t(fresh_.size() / 2)), changed = fresh_, version = fresh_;
    changed[fresh_.size() / 2] ^= 1;
    version[8] ^= 1;
    for (const Bytes &bytes : {cut, changed}) {
        write(file_, bytes);
        expect_passed_over("damaged", file_, "cannot be used: ");
    }
    write(file_, version);
    expect_passed_over("other version", file_, "version");
    write(file_, {});
    expect_passed_over("empty", file_, "it is empty");
    fs::remove(file_);
    fs::create_directories(file_);
    expect_passed_over("folder", file_, "it is no file");
}

TEST_F(InstalledPeople, OfAnotherBuildArePassedOver)
{
    install();
    const std::string name = file_.filename().string();
    const fs::path other = people_ / ("0123456789abcdef" + name.substr(16));
    fs::copy_file(file_, people_ / (name.substr(0, 17) + "another.clq"));
    fs::rename(file_, other);
    made();
    EXPECT_TRUE(report_.stored) << report_.text;
    EXPECT_EQ(log_, "") << "people of this build are there, and this one was not prepared";
    fs::remove(people_ / (name.substr(0, 17) + "another.clq"));
    expect_passed_over("another build", other, "the names of this one begin with " + name.substr(0, 16));
}

// A program that holds the library has other files beside it; a relative path leads elsewhere in another folder.
TEST_F(InstalledPeople, AreLookedForBesideALibraryWithAnAbsolutePathAlone)
{
    install();
    const fs::path host = library_.parent_path() / "host.so", before = fs::current_path();
    fs::copy_file(library_, host);
    load(host);
    made();
    EXPECT_FALSE(report_.from_disk) << "of a host that was linked statically";
    fs::current_path(library_.parent_path());
    fs::rename(host, "libclaque-assets.so.9");
    load("./libclaque-assets.so.9");
    made();
    EXPECT_FALSE(report_.from_disk) << "by a relative path";
    fs::current_path(before);
    load(library_.parent_path() / "libclaque-assets.so.9");
    expect_taken("by an absolute path");
}
