#include "samples/view/script.h"

#include <cstdlib>

#include "samples/io/toml.h"
#include "samples/scenes/odeon/toml_table.h"

namespace view
{
namespace
{

struct Rule {
    const char *verb;
    size_t least, most;  // words after the verb
    const char *form;
};

constexpr Rule rules[] = {
    {"click", 1, 2, "click \"WIDGET\", or click person NUMBER"},
    {"drag", 3, 6, "drag \"WIDGET\" FROM TO, or drag view X0 Y0 X1 Y1 [left|middle|right]"},
    {"type", 2, 2, "type \"WIDGET\" \"TEXT\""},
    {"key", 1, 2, "key NAME [SECONDS]"},
    {"wheel", 1, 1, "wheel NOTCHES"},
    {"wait", 1, 2, "wait SECONDS [FRAMES]"},
    {"size", 1, 1, "size WxH"},
    {"drop", 1, 1, "drop FILE"},
    {"see", 1, 1, "see \"TEXT\""},
    {"shot", 1, 1, "shot FILE.png"},
};

std::vector<std::string> words_of(const std::string &line, bool &closed)
{
    std::vector<std::string> words;
    closed = true;
    for (size_t at = 0; at < line.size();) {
        if (line[at] == ' ') {
            ++at;
            continue;
        }
        const char end = line[at] == '"' ? '"' : ' ';
        const size_t first = end == '"' ? at + 1 : at;
        const size_t last = line.find(end, first);
        if (last == std::string::npos && end == '"') closed = false;
        words.push_back(line.substr(first, last == std::string::npos ? last : last - first));
        at = last == std::string::npos ? line.size() : last + 1;
    }
    return words;
}

void check_step(const Step &step, bool closed)
{
    const auto fail = [&](const std::string &sentence) { throw scenes::Failure(step.at + ": " + sentence); };
    if (step.words.empty()) fail("the step is empty");
    if (!closed) fail("a quotation mark is not closed");
    std::string verbs;
    for (const Rule &rule : rules) {
        verbs += (verbs.empty() ? "" : ", ") + std::string(rule.verb);
        if (step.words[0] != rule.verb) continue;
        if (step.words.size() < rule.least + 1 || step.words.size() > rule.most + 1)
            fail(std::string("the step has the form: ") + rule.form);
        return;
    }
    fail("there is no step '" + step.words[0] + "'; there are: " + verbs);
}

}  // namespace

Script read_script(const std::string &toml, const std::string &where)
{
    Script script;
    const toml::table parsed = scenes::parse_toml(toml, where);
    scenes::TomlTable table(parsed, where, "the script");
    if (table.has("frames_per_s")) script.frames_per_s = table.number("frames_per_s", {0.1, 1000});
    if (table.has("measured")) script.measured = table.flag("measured");
    const std::vector<std::string> lines = table.texts("steps");
    table.done();
    for (const std::string &line : lines) {
        bool closed = true;
        Step step = {words_of(line, closed), {}};
        step.at = where + ": step " + std::to_string(script.steps.size() + 1) + ", '" + line + "'";
        check_step(step, closed);
        script.steps.push_back(std::move(step));
    }
    return script;
}

}  // namespace view
