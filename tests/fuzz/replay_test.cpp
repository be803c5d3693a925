// Every fuzzer on its corpus and its seeds, without libFuzzer.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <unistd.h>

#include "samples/parity/capture.h"
#include "tests/fuzz/files.h"
#include "tests/fuzz/parity_files.h"
#include "tests/fuzz/seeds.h"

#define CLAQUE_FUZZER(name) extern "C" int fuzz_##name(const uint8_t *bytes, size_t size);
#include "fuzzers.h"
#undef CLAQUE_FUZZER

namespace
{

namespace fs = std::filesystem;

struct Fuzzer {
    const char *name;
    int (*run)(const uint8_t *bytes, size_t size);
};
#define CLAQUE_FUZZER(name) {#name, fuzz_##name},
const Fuzzer fuzzers[] = {
#include "fuzzers.h"
};
#undef CLAQUE_FUZZER

const fs::path corpora = CLAQUE_SOURCE_DIR "/tests/fuzz/corpus";

void PrintTo(const Fuzzer &fuzzer, std::ostream *out) { *out << fuzzer.name; }

class Corpus : public testing::TestWithParam<Fuzzer>
{
};

TEST_P(Corpus, EveryInputKeepsTheLaws)
{
    const Fuzzer &fuzzer = GetParam();
    size_t inputs = 0;
    for (const auto &entry : fs::directory_iterator(corpora / fuzzer.name)) {
        std::ifstream file(entry.path(), std::ios::binary);
        const fuzzing::Bytes bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
        SCOPED_TRACE(entry.path().filename());
        fuzzer.run(bytes.data(), bytes.size());
        ++inputs;
    }
    EXPECT_GE(inputs, 5u);
}

TEST_P(Corpus, EverySeedKeepsTheLaws)
{
    const Fuzzer &fuzzer = GetParam();
    size_t inputs = 0;
    for (const fuzzing::Seed &seed : fuzzing::seeds()) {
        if (seed.fuzzer != fuzzer.name) continue;
        SCOPED_TRACE(seed.name);
        fuzzer.run(seed.bytes.data(), seed.bytes.size());
        ++inputs;
    }
    EXPECT_GE(inputs, 1u);
}

INSTANTIATE_TEST_SUITE_P(Fuzzers, Corpus, testing::ValuesIn(fuzzers),
                         [](const auto &info) { return std::string(info.param.name); });

// A seed that is refused at once would leave most of the reader untried.
TEST(Seeds, OfAParityFolderAreReadWhole)
{
    const fs::path folder = fs::temp_directory_path() / ("claque-seed-parity-" + std::to_string(getpid()));
    fs::create_directories(folder);
    for (const fuzzing::Seed &seed : fuzzing::seeds()) {
        if (seed.fuzzer != "parity" || seed.name != "whole") continue;
        for (const auto &[number, bytes] : fuzzing::files_of(seed.bytes.data(), seed.bytes.size()))
            std::ofstream(folder / fuzzing::parity_files[number], std::ios::binary)
                .write(reinterpret_cast<const char *>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    }
    const parity::Capture read = parity::read_capture(folder.string());
    EXPECT_EQ(read.actors.value().size(), 2u);
    EXPECT_TRUE(read.positions && read.normals && read.colour && read.depth && read.actor && read.zone);
    fs::remove_all(folder);
}

TEST(Corpora, AreSmallAndEachHasItsFuzzer)
{
    uintmax_t all = 0;
    for (const auto &entry : fs::recursive_directory_iterator(corpora)) {
        if (!entry.is_regular_file()) continue;
        EXPECT_LE(entry.file_size(), 20000u) << entry.path();
        all += entry.file_size();
    }
    EXPECT_LE(all, 300000u);
    for (const auto &folder : fs::directory_iterator(corpora)) {
        const auto named = [&](const Fuzzer &fuzzer) { return folder.path().filename() == fuzzer.name; };
        EXPECT_TRUE(std::any_of(std::begin(fuzzers), std::end(fuzzers), named)) << folder.path();
    }
}

}  // namespace
