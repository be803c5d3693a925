// fuzz_seeds FOLDER: writes FOLDER/NAME/seed-... for every fuzzer.
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "tests/fuzz/seeds.h"

int main(int count, char **arguments)
{
    if (count != 2) {
        std::fprintf(stderr, "usage: fuzz_seeds FOLDER\n");
        return 2;
    }
    for (const fuzzing::Seed &seed : fuzzing::seeds()) {
        const std::filesystem::path folder = std::filesystem::path(arguments[1]) / seed.fuzzer;
        std::filesystem::create_directories(folder);
        std::ofstream file(folder / ("seed-" + seed.name), std::ios::binary);
        file.write(reinterpret_cast<const char *>(seed.bytes.data()), static_cast<std::streamsize>(seed.bytes.size()));
        if (!file.flush()) {
            std::fprintf(stderr, "fuzz_seeds: %s cannot be written\n", folder.c_str());
            return 1;
        }
    }
    return testing::UnitTest::GetInstance()->Failed() ? 1 : 0;
}
