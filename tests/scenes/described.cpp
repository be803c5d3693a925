#include "tests/scenes/described.h"

#include <gtest/gtest.h>

#include "tests/support/patterns.h"

namespace scenes
{

std::string refusal_of(const std::string &toml)
{
    ScenarioFiles files;
    files.find = [](const std::string &path) { return path.rfind("no", 0) == 0 ? path + " is absent" : ""; };
    files.read = [&](const std::string &path, std::string &text) {
        text = *recorded_path("odeon");
        return files.find(path);
    };
    try {
        read_scenario(toml, "mine.toml", files);
    } catch (const Failure &failure) {
        return failure.what();
    }
    return "read";
}

void expect_refused(const std::string &toml, const std::vector<std::string> &words)
{
    static const std::string placed = "[a-z]+\\.toml:[1-9][0-9]*:[1-9][0-9]*: .+";
    const std::string sentence = refusal_of(toml);
    EXPECT_EQ(sentence.rfind("mine.toml:", 0), 0u) << sentence;
    EXPECT_TRUE(patterns::describes(placed, sentence)) << sentence;
    for (const std::string &word : words) EXPECT_NE(sentence.find(word), std::string::npos) << word << ": " << sentence;
}

std::string changed_text(std::string text, const std::string &after, const std::string &was, const std::string &is)
{
    const size_t from = text.find(after), at = text.find(was, from);
    EXPECT_NE(from, std::string::npos) << after;
    EXPECT_NE(at, std::string::npos) << was;
    return at == std::string::npos ? text : text.replace(at, was.size(), is);
}

}  // namespace scenes
