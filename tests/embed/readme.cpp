#include "tests/embed/readme.h"

#include <sstream>

#include "tests/support/patterns.h"

std::vector<Block> blocks_of(const std::string &page, const std::string &section)
{
    std::vector<Block> blocks;
    std::istringstream lines(page);
    std::string line, part, file;
    bool inside = false, in_block = false;
    const std::string named = "`([A-Za-z.]+)`[^`]*:$";
    while (std::getline(lines, line)) {
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
        } else if (const patterns::Match match = patterns::first_match(named, line); !match.empty()) {
            file = match[1];
        }
    }
    return blocks;
}
