// Positions that `claque dump` writes.
#pragma once

#include <cstring>
#include <utility>

#include "tests/cli/run.h"

namespace cli_test
{

// Positions of all vertices, and standard error. `file`: where the command is to write them.
inline std::pair<std::vector<float>, std::string> dumped(std::vector<std::string> arguments, const std::string &file)
{
    arguments.insert(arguments.begin(), "dump");
    arguments.insert(arguments.end(), {"--out", file});
    const Outcome done = claque(arguments);
    EXPECT_EQ(done.code, 0) << done.err;
    const std::string npy = file_text(file);
    const size_t head = 10 + static_cast<unsigned char>(npy[8]) + 256 * static_cast<unsigned char>(npy[9]);
    std::vector<float> out((npy.size() - head) / 4);
    std::memcpy(out.data(), npy.data() + head, 4 * out.size());
    return {out, done.err};
}

}  // namespace cli_test
