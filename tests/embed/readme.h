// Code blocks of a section of README.md or of a page in docs/, for tests that run what the text shows. A block has a
// language, and a file name if the line before it ends with that name in backquotes and a colon.
#pragma once

#include <string>
#include <vector>

struct Block {
    std::string part;      // title of the ### part that contains it; "" before the first
    std::string language;  // c, cmake, sh
    std::string file;      // to write the block to; "" for commands
    std::string text;
};

// The blocks of the ## section of this title, in order. `page` is the text of the page.
std::vector<Block> blocks_of(const std::string &page, const std::string &section);
