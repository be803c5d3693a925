// README.md as something that can be followed: the blocks of a section, each with its language and, where a line before it
// names a file, that file.
#pragma once

#include <string>
#include <vector>

struct Block {
    std::string part;      // title of the ### part it stands in; "" before the first
    std::string language;  // c, cmake, sh
    std::string file;      // of a block that is no commands
    std::string text;
};

std::vector<Block> blocks_of(const std::string &readme, const std::string &section);
