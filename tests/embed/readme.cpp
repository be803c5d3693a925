#include "tests/embed/readme.h"

#include <regex>
#include <sstream>

std::vector<Block> blocks_of(const std::string &page, const std::string &section)
{
    std::vector<Block> blocks;
    std::istringstream lines(page);
    std::string line, part, file;
    bool inside = false, in_block = false;
    const std::regex named("`([A-Za-z.]+)`[^`]*:$");
    while (std::getline(lines, line)) {
        std::smatch match;
        if (in_block) {
            in_block = line != "```";
            if (in_block) blocks.back().text += line + "\n";
        } else if (line.rfind("## ", 0) == 0) {
            inside = line == "## " + section;
        } else if (inside && line.rfind("### ", 0) == 0) {
            part = line.substr(4);
        } else if (inside && line.rfind("```", 0) == 0) {
            blocks.push_back({part, line.substr(3), file, ""});
            in_block = true;
            file.clear();
        } else if (std::regex_search(line, match, named)) {
            file = match[1];
        }
    }
    return blocks;
}
