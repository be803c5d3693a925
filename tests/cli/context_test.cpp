// Where OpenGL comes from, as environments name or lack it: a picture, or one sentence. Libraries are hidden by empty
// files of their names, at which the loader gives up.
#include <cstdlib>
#include <fstream>

#include <nlohmann/json.hpp>

#include "run.h"

namespace cli_test
{
namespace
{

const std::vector<std::string> osmesa = {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"};
const std::vector<std::string> egl = {"libEGL.so.1", "libEGL.so"};

class Contexts : public Command
{
protected:
    void hide(const std::vector<std::string> &libraries)
    {
        for (const std::string &library : libraries) std::ofstream(path(library));
        const char *others = std::getenv("LD_LIBRARY_PATH");
        hidden_ = "LD_LIBRARY_PATH=" + path("") + (others ? std::string(":") + others : "");
    }

    // A small picture in an environment with these variables.
    Outcome render(std::vector<std::string> variables, const std::vector<std::string> &arguments = {}) const
    {
        std::vector<std::string> words = {"env", "-u", "CLAQUE_CONTEXT", "-u", "GALLIUM_DRIVER"};
        if (!hidden_.empty()) words.push_back(hidden_);
        words.insert(words.end(), variables.begin(), variables.end());
        for (const char *word : {CLAQUE_COMMAND, "render", "--count", "5", "--size", "64x48", "--out"})
            words.push_back(word);
        words.insert(words.end(), {path("a.png"), "--json", path("a.json")});
        words.insert(words.end(), arguments.begin(), arguments.end());
        return run_program(words);
    }

    void expect_drawn_by(const std::string &kind, const Outcome &done) const
    {
        ASSERT_EQ(done.code, 0) << done.err;
        const std::string says = nlohmann::json::parse(file_text(path("a.json")))["context"];
        EXPECT_EQ(says.substr(0, kind.size() + 1), kind + ",");
    }

    static void expect_sentence(const Outcome &done, const std::vector<std::string> &words)
    {
        EXPECT_EQ(done.code, 1);
        EXPECT_EQ(done.err.find("claque: "), 0u) << done.err;
        EXPECT_EQ(done.err.find('\n'), done.err.size() - 1) << done.err;
        for (const std::string &word : words) EXPECT_NE(done.err.find(word), std::string::npos) << word << done.err;
    }

private:
    std::string hidden_;
};

TEST_F(Contexts, OfAWordThatNamesNoneAreRefusedWithTheFourWords)
{
    const std::vector<std::string> words = {"CLAQUE_CONTEXT is 'bogus'", "osmesa, egl, glx or any"};
    expect_sentence(render({"CLAQUE_CONTEXT=bogus"}), words);
    expect_sentence(render({"CLAQUE_CONTEXT=bogus"}, {"--context", "egl"}), words);
}

TEST_F(Contexts, WithoutAnyLibraryAreRefusedWithThePackages)
{
    hide(osmesa), hide(egl);
    const std::vector<std::string> words = {"libOSMesa.so.8", "libosmesa6", "libEGL.so.1", "libegl1",
                                            "libgl1-mesa-dri"};
    expect_sentence(render({}), words);
    expect_sentence(render({"CLAQUE_CONTEXT=egl"}), {words.begin() + 2, words.end()});
    expect_sentence(render({}, {"--context", "osmesa"}),
                    {"libOSMesa.so.8", "libosmesa6", "libegl1", "libgl1-mesa-dri"});
}

TEST_F(Contexts, OfNoNameAreEglsWhereOsmesaIsMissing)
{
    if (const std::string why = why_no_context("egl"); !why.empty()) GTEST_SKIP() << why;
    hide(osmesa);
    for (const char *word : {"CLAQUE_CONTEXT=", "CLAQUE_CONTEXT=any", "CLAQUE_CONTEXT=egl"})
        expect_drawn_by("EGL", render({word}));
}

TEST_F(Contexts, OfNoNameAreOsmesasWhereItIsThere)
{
    if (const std::string why = why_no_context("osmesa"); !why.empty()) GTEST_SKIP() << why;
    expect_drawn_by("OSMesa", render({}));
    hide(egl);
    for (const char *word : {"CLAQUE_CONTEXT=", "CLAQUE_CONTEXT=any", "CLAQUE_CONTEXT=osmesa"})
        expect_drawn_by("OSMesa", render({word}));
}

TEST_F(Contexts, OfADriverThatMesaLacksAreRefusedByItsName)
{
    if (const std::string why = why_no_context("any"); !why.empty()) GTEST_SKIP() << why;
    for (const char *kind : {"osmesa", "egl", "any"})
        if (why_no_context(kind).empty())
            expect_sentence(render({"GALLIUM_DRIVER=nosuch"}, {"--context", kind}), {"GALLIUM_DRIVER", "'nosuch'"});
}

}  // namespace
}  // namespace cli_test
