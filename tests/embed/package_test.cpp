// What `make package` makes: which package needs which, and that the packages' files together are a command that runs.
#include <gtest/gtest.h>

#include "tests/embed/scratch.h"

namespace
{

TEST(Package, IsFiveThatUnpackedTogetherRun)
{
    if (!has_command("dpkg-shlibdeps")) GTEST_SKIP() << "needs dpkg-shlibdeps (dpkg-dev)";
    if (*CLAQUE_CXX_FLAGS) GTEST_SKIP() << "of a build without flags of its own";
    const Scratch home;
    const auto [made, log] = home.run("cpack --config '" CLAQUE_BUILD_DIR "/CPackConfig.cmake' -B debs");
    ASSERT_EQ(made, 0) << log;
    const auto [unpacked, trouble] = home.run(
        "for deb in debs/*.deb; do dpkg-deb -x $deb root; dpkg-deb -f $deb Package Architecture Depends Recommends > "
        "${deb%_*_*.deb}.txt; "
        "done");
    ASSERT_EQ(unpacked, 0) << trouble;

    const auto says = [&](const std::string &package, const std::string &text) {
        const std::string control = text_of_file(home.path() + "/debs/" + package + ".txt");
        EXPECT_NE(control.find(text), std::string::npos) << package << ": " << control;
    };
    const std::string runtime = "libclaque" CLAQUE_SOVERSION, assets = "libclaque-assets" CLAQUE_SOVERSION;
    const std::string exactly = " (= " CLAQUE_VERSION ")";
    says(runtime, "libstdc++6");
    says(assets, runtime + exactly);
    says("libclaque-stage" CLAQUE_SOVERSION, runtime + exactly);
    says(assets, "libopenmesh");
#ifdef CLAQUE_HAS_DRACO
    says(assets, "libdraco");
#endif
#ifdef CLAQUE_HAS_MESHOPT
    says(assets, "libmeshoptimizer");
#endif
#ifdef CLAQUE_HAS_WEBP
    says(assets, "libwebp");
#endif
#ifdef CLAQUE_HAS_EXPAT
    says(assets, "libexpat1");
#endif
#ifdef CLAQUE_HAS_SQLITE3
    says(assets, "libsqlite3-0");
#endif
#ifdef CLAQUE_HAS_Z
    says(assets, "zlib1g");
#endif
    says("claque", assets + exactly);
#ifdef CLAQUE_HAS_PEOPLE
    says(assets, "Recommends: claque-people" + exactly);
    says("claque-people", "Architecture: all");
    EXPECT_EQ(home.run("ls root/usr/share/claque/people | wc -l").second, "20\n");
#endif
    says("libclaque-dev", runtime + exactly);
    const std::string control = text_of_file(home.path() + "/debs/" + runtime + ".txt");
    EXPECT_EQ(control.find("libopenmesh"), std::string::npos) << control;

    EXPECT_EQ(home.run("dpkg-deb --ctrl-tarfile debs/" + runtime + "_*.deb | tar -t | sort").second,
              "./\n./control\n./md5sums\n./shlibs\n./triggers\n");
    EXPECT_EQ(home.run("for deb in debs/*.deb; do doc=root/usr/share/doc/$(dpkg-deb -f $deb Package)\n"
                       "head -n \"$(wc -l < '" CLAQUE_SOURCE_DIR "/LICENSE')\" $doc/copyright | "
                       "cmp - '" CLAQUE_SOURCE_DIR "/LICENSE'\n"
                       "grep -q 'Sean Barrett' $doc/copyright || echo no licence of stb\n"
                       "zcat $doc/changelog.gz | dpkg-parsechangelog -l - -S Version; done | sort -u")
                  .second,
              CLAQUE_VERSION "\n");

    const auto [ran, said] = home.run("LD_LIBRARY_PATH=root/usr/lib root/usr/bin/claque inspect citizen");
    EXPECT_EQ(ran, 0) << said;
    EXPECT_NE(said.find("citizen"), std::string::npos) << said;
    EXPECT_EQ(home.run("ls root/usr/share/man/man1/claque.1.gz root/usr/include/claque/claque.h").first, 0);
#ifdef CLAQUE_HAS_WINDOW
    EXPECT_EQ(home.run("ls root/usr/share/applications/claque.desktop").first, 0);
    EXPECT_EQ(home.run("ls root/usr/share/icons/hicolor/256x256/apps/claque.png").first, 0);
#endif
}

}  // namespace
