// What `make install` puts where: every public header, both libraries by soname and statically, packages that other
// build systems find, the command and its manual; and C99 hosts of all four libraries against it, beside DESTDIR.
#include <cstdlib>
#include <filesystem>

#include <gtest/gtest.h>

#include "include/claque/base.h"
#include "tests/embed/scratch.h"

namespace fs = std::filesystem;

namespace
{

std::string make(const std::string &arguments)
{
    return "unset MAKEFLAGS MAKELEVEL MFLAGS DESTDIR\nmake --no-print-directory -C '" CLAQUE_SOURCE_DIR
           "' -o installed BUILD='" CLAQUE_BUILD_DIR "' " +
           arguments + "\n";
}

std::string python_with_numpy()
{
    for (const std::string python : {"/usr/bin/python3", "python3"})
        if (std::system((python + " -c 'import numpy' 2> /dev/null").c_str()) == 0) return python;
    return "";
}

class Install : public testing::Test
{
protected:
    void SetUp() override
    {
        const auto [code, said] = home_.run(make("install PREFIX=" + prefix()));
        ASSERT_EQ(code, 0) << said;
    }

    std::string prefix() const { return home_.path() + "/prefix"; }
    std::string printed(const std::string &script)
    {
        const auto [code, said] = home_.run(script);
        EXPECT_EQ(code, 0) << script << "\n" << said;
        return said;
    }

    Scratch home_;
};

TEST_F(Install, BringsEveryHeaderAndEachLibrary)
{
    int headers = 0;
    for (const auto &file : fs::directory_iterator(CLAQUE_SOURCE_DIR "/include/claque")) {
        EXPECT_EQ(text_of_file(prefix() + "/include/claque/" + file.path().filename().string()),
                  text_of_file(file.path().string()));
        ++headers;
    }
    EXPECT_GT(headers, 15);
    for (const std::string name : {"claque", "claque-assets", "claque-stage"}) {
        const std::string library = prefix() + "/lib/lib" + name;
        EXPECT_TRUE(fs::is_regular_file(library + ".a"));
        EXPECT_EQ(fs::read_symlink(library + ".so"), "lib" + name + ".so." + CLAQUE_SOVERSION);
        EXPECT_NE(printed("readelf -d '" + library + ".so'")
                      .find("Library soname: [lib" + name + ".so." CLAQUE_SOVERSION "]"),
                  std::string::npos);
    }
    EXPECT_EQ(text_of_file(prefix() + "/share/man/man1/claque.1"), text_of_file(CLAQUE_BUILD_DIR "/samples/claque.1"));
#ifdef CLAQUE_HAS_WINDOW
    const std::string entry = text_of_file(prefix() + "/share/applications/claque.desktop");
    EXPECT_NE(entry.find("\nExec=claque view %f\n"), std::string::npos) << entry;
    EXPECT_NE(entry.find("\nIcon=claque\n"), std::string::npos) << entry;
    EXPECT_EQ(text_of_file(prefix() + "/share/icons/hicolor/256x256/apps/claque.png").substr(1, 3), "PNG");
#endif
    EXPECT_EQ(printed("'" + prefix() + "/bin/claque' --version"), "claque " CLAQUE_VERSION "\n");
}

TEST_F(Install, RunsWhereItIsMovedTo)
{
    printed("mkdir other && mv prefix other/place");
    const std::string alone = "unset LD_LIBRARY_PATH CLAQUE_LIBRARY_DIR CLAQUE_COMMAND\n";
    EXPECT_EQ(printed(alone + "other/place/bin/claque --version"), "claque " CLAQUE_VERSION "\n");
    if (*CLAQUE_CXX_FLAGS) GTEST_SKIP() << "an interpreter without sanitizers cannot load libraries with them";
    const std::string python = python_with_numpy();
    if (python.empty()) GTEST_SKIP() << "no python3 has numpy (Debian: python3-numpy)";
    home_.write("crowd.py",
                "import claque\n"
                "from claque.places import command_path\n"
                "with claque.Context() as context, claque.Crowd(context) as crowd:\n"
                "    crowd.add(claque.Template.builtin(context, 'citizen'), clip='walk')\n"
                "    view = crowd.view()\n"
                "    view.look_at((0, 1, 5), (0, 1, 0))\n"
                "    crowd.update(0.5)\n"
                "    print(len(view), *claque.library_paths(), command_path())\n");
    const std::string place = " " + home_.path() + "/other/place/", of = ".so." CLAQUE_SOVERSION;
    EXPECT_EQ(printed(alone + "PYTHONPATH=other/place/lib/python3/dist-packages " + python + " -B crowd.py"),
              "1" + place + "lib/libclaque" + of + place + "lib/libclaque-assets" + of + place + "lib/libclaque-stage" +
                  of + place + "bin/claque\n");
}

TEST_F(Install, LeavesNoPathOfTheBuildBehind)
{
    // The prefix itself lies in the build folder here.
    EXPECT_EQ(printed("grep -r -e '" CLAQUE_BUILD_DIR "' prefix/lib/pkgconfig prefix/lib/cmake prefix/share | "
                      "grep -v \"$PWD\" || true"),
              "");
    EXPECT_EQ(printed("readelf -d prefix/bin/claque prefix/lib/*.so $(find prefix/lib/claque -type f) | "
                      "sed -nE 's/.*R(UN)?PATH.*\\[(.*)\\]/\\2/p'"),
              "$ORIGIN/../lib\n$ORIGIN\n$ORIGIN\n$ORIGIN\n");
}

TEST_F(Install, GoesBelowDestdirAndIsFoundWhereItWillBe)
{
    const auto [code, said] = home_.run(make("install DESTDIR='" + home_.path() + "/stage' PREFIX=/opt/claque"));
    ASSERT_EQ(code, 0) << said;
    for (const std::string library : {"claque", "claque-assets", "claque-stage"})
        EXPECT_EQ(printed("PKG_CONFIG_PATH=stage/opt/claque/lib/pkgconfig pkg-config --variable=prefix " + library),
                  "/opt/claque\n");
    EXPECT_EQ(printed("cd prefix && find . | sort > ../a; cd ../stage/opt/claque && find . | sort | diff ../../../a -"),
              "");
}

#ifdef CLAQUE_HAS_PEOPLE
// Templates that are made are stored in the user's folder, which stays empty here.
TEST_F(Install, BringsPreparedPeopleSoThatScenesMakeNone)
{
    home_.write("draw", R"(
export XDG_CACHE_HOME="$PWD/cache" LD_LIBRARY_PATH="$PWD/prefix/lib"
prefix/bin/claque render --size 64x48 --out a.png "$@" > said 2>&1 || { echo "$@"; cat said; exit 1; }
[ ! -s said ] || cat said
made=$(ls cache/claque 2> missing | wc -l)
[ "$made" = 0 ] || { echo "$@: $made made"; rm -r cache/claque; }
)");
    const std::string scenes = printed(
        "LD_LIBRARY_PATH=prefix/lib prefix/bin/claque render --help | sed -n 's/.*--scene TEXT:{\\([^}]*\\)}.*/\\1/p' "
        "| tr ',' '\\n'");
    EXPECT_NE(scenes.find("odeon\nmultitude\n"), std::string::npos) << scenes;
    home_.write("scenes", scenes);
    EXPECT_EQ(
        printed("while read -r scene; do case $scene in hundred_actors) count= ;; *) count='--count 200' ;; esac; "
                "sh -e draw --scene $scene $count; done < scenes"),
        "");
    EXPECT_EQ(printed("for scenario in '" CLAQUE_SOURCE_DIR
                      "'/samples/scenarios/*.toml; do sh -e draw --scenario \"$scenario\"; done"),
              "");
    EXPECT_EQ(printed("for name in citizen patrician decurion plebeian herald owl; do sh -e draw $name; done"), "");
    EXPECT_EQ(printed("mv prefix/share/claque/people people; sh -e draw --scene odeon --count 200"),
              "--scene odeon --count 200: 3 made\n");
}

TEST_F(Install, LetsNoOtherUserWritePreparedPeopleWhateverTheUmask)
{
    printed("umask 002\n" + make("install PREFIX=" + home_.path() + "/open"));
    EXPECT_EQ(printed("cd open/share/claque && stat -c %a people people/* | sort | uniq -c | tr -s ' '"),
              " 20 644\n 1 755\n");
}
#endif

TEST_F(Install, LetsHostsInCLinkEachLibrarySharedOrStatic)
{
    const std::string built = printed("export CFLAGS='" CLAQUE_C_FLAGS "' CXXFLAGS='" CLAQUE_CXX_FLAGS
                                      "'\n"
                                      "cmake -G Ninja -S '" CLAQUE_SOURCE_DIR
                                      "/tests/embed/installed' -B hosts "
                                      "-DCLAQUE_WANTED=" +
                                      std::to_string(CLQ_VERSION_MAJOR) + "." + std::to_string(CLQ_VERSION_MINOR) +
                                      " -DCMAKE_PREFIX_PATH='" + prefix() + "' && cmake --build hosts");
    const std::string strip = text_of_file(CLAQUE_SOURCE_DIR "/tests/golden/strip_host.txt");
    EXPECT_EQ(printed("hosts/strip"), strip) << built;
    EXPECT_EQ(printed("hosts/strip_static"), strip);
    const std::string figures = printed("hosts/figures");
    EXPECT_NE(figures.find("citizen"), std::string::npos) << figures;
    EXPECT_EQ(printed("hosts/figures_static"), figures);
    EXPECT_EQ(printed("readelf -d hosts/*_static | grep 'NEEDED.*claque' || true"), "");
}

TEST_F(Install, LetsPkgConfigLinkStatically)
{
    EXPECT_EQ(printed("export PKG_CONFIG_PATH='" + prefix() +
                      "/lib/pkgconfig'\nrm prefix/lib/*.so*\n"
                      "cc " CLAQUE_C_FLAGS " -std=c99 '" CLAQUE_SOURCE_DIR "/tests/embed/strip_host.c' "
                      "$(pkg-config --static --cflags --libs claque) -o strip && ./strip"),
              text_of_file(CLAQUE_SOURCE_DIR "/tests/golden/strip_host.txt"));
}

TEST_F(Install, HasNoLibraryOrCommandThatNamesTheFoldersItWasBuiltIn)
{
    if (CLAQUE_BUILD_TYPE != std::string("Release")) GTEST_SKIP() << "assertions and debug information name sources";
    if (*CLAQUE_CXX_FLAGS) GTEST_SKIP() << "of a build without flags of its own";
    EXPECT_EQ(printed("grep -laE '" CLAQUE_BUILD_DIR "|" CLAQUE_SOURCE_DIR "/(animcache|include|lib|meshsplit|passes|"
                      "samples)/' prefix/bin/* $(find prefix/lib -name '*.a' -o -name '*.so*') || true"),
              "");
}

}  // namespace
