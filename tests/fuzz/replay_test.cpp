// Every fuzzer on its corpus and its seeds, without libFuzzer.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

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
