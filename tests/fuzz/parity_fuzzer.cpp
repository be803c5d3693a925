// Parity folders: two results in one input, which are read, compared and reported. Files of the second result lie over
// those of the first one.
#include <filesystem>
#include <fstream>
#include <unistd.h>

#include "samples/parity/report.h"
#include "tests/fuzz/files.h"
#include "tests/fuzz/parity_files.h"

namespace
{

namespace fs = std::filesystem;

using namespace fuzzing;

void write(const fs::path &folder, const Files &files, size_t first, size_t last)
{
    fs::create_directories(folder);
    for (size_t i = first; i < last; ++i) {
        const auto &[number, bytes] = files[i];
        std::ofstream(folder / parity_files[number % parity_file_count], std::ios::binary)
            .write(reinterpret_cast<const char *>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    }
}

void compare(const parity::Capture &reference, const parity::Capture &result)
{
    const parity::Comparison comparison = parity::compare(reference, result, 67);
    for (const parity::Tolerance &tolerance : parity::named_tolerances()) {
        const parity::Verdict verdict = parity::verdict_of(comparison, tolerance);
        const parity::Report report = {reference, result, comparison, verdict};
        EXPECT_NE(report_text(report), "");
        EXPECT_NE(report_json(report), "");
        EXPECT_NE(report_html(report, {}), "");
        EXPECT_EQ(verdict.pass, reasons(verdict, 3).empty());
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    const Files files = files_of(bytes, size);
    const fs::path folder = fs::temp_directory_path() / ("claque-fuzz-parity-" + std::to_string(getpid()));
    // Files with a number of 128 and more are those of the second result.
    Files first, second;
    for (const auto &file : files) (file.first < 128 ? first : second).push_back(file);
    write(folder / "reference", first, 0, first.size());
    write(folder / "result", first, 0, first.size());
    for (auto &file : second) file.first = static_cast<uint8_t>(file.first - 128);
    write(folder / "result", second, 0, second.size());
    try {
        const parity::Capture reference = parity::read_capture((folder / "reference").string());
        compare(reference, reference);
        compare(reference, parity::read_capture((folder / "result").string()));
    } catch (const parity::Unreadable &error) {
        EXPECT_STRNE(error.what(), "");
    }
    fs::remove_all(folder);
    return 0;
}
