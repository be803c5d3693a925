// claque bench readers: how reading and splitting a file grow with each of the elements that it counts. Processor time
// at a tenth of the limit and at the limit; reader_law.h says what is too much.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <limits>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "samples/cli/bench.h"
#include "samples/cli/progress.h"
#include "samples/cli/reader_files.h"
#include "samples/cli/reader_law.h"
#include "samples/cli/warnings.h"

namespace cli
{
namespace readers
{
namespace
{

constexpr int tries = 3;

}  // namespace
}  // namespace readers

double processor_ms() { return 1000.0 * double(std::clock()) / CLOCKS_PER_SEC; }

namespace readers
{
namespace
{

// Large memory comes as new pages from the kernel each time, which fills them with zeros; small memory is used again.
// With all of it kept, what many elements take and what few take is the time of the reader alone.
void keep_freed_memory()
{
#ifdef __GLIBC__
    mallopt(M_MMAP_MAX, 0);
    mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
#endif
}

void take_better(Reading &best, const Reading &next)
{
    best.load_ms = std::min(best.load_ms, next.load_ms), best.build_ms = std::min(best.build_ms, next.build_ms);
}

// The best of some tries.
Reading read(const ReaderElement &e, scenes::Library &library, const std::string &bytes)
{
    Reading best = e.read(library, bytes);
    for (int i = 1; i < tries && best.load_ms + best.build_ms < 1000; ++i) take_better(best, e.read(library, bytes));
    return best;
}

Json row(scenes::Library &library, const ReaderElement &e, uint32_t most, const Law &law)
{
    const uint32_t count = std::min(e.limit, most);
    const std::string few_bytes = e.make(std::max(count / 10, 1u)), many_bytes = e.make(count);
    Reading few = read(e, library, few_bytes), many = read(e, library, many_bytes);
    const auto holds = [&] { return is_lawful(few, many, law); };
    // Other programs take the caches of the processor: a ratio that is too large has to be so more than once.
    for (int i = 1; i < tries && !holds(); ++i)
        take_better(few, read(e, library, few_bytes)), take_better(many, read(e, library, many_bytes));
    const double load = ratio(few.load_ms, many.load_ms, law), build = ratio(few.build_ms, many.build_ms, law);
    return {{"format", e.format},         {"element", e.element},         {"count", count},
            {"bytes", many_bytes.size()}, {"load_ms", many.load_ms},      {"load_ratio", load},
            {"loaded", many.loaded},      {"build_ms", many.build_ms},    {"build_ratio", build},
            {"built", many.built},        {"most_ratio", law.most_ratio}, {"lawful", holds()}};
}

}  // namespace

static Json rows(uint32_t most, const Law &law)
{
    keep_freed_memory();
    Progress progress("claque bench");
    silence_warnings();  // of files that it makes itself
    scenes::Library library(1);
    Json out = Json::array();
    const std::vector<ReaderElement> all = reader_elements();
    for (const ReaderElement &element : all) {
        out.push_back(row(library, element, most, law));
        progress.step(out.size(), all.size());
    }
    return out;
}

}  // namespace readers

bool is_of_readers(const BenchArguments &a) { return a.subject == "readers"; }

Json bench_readers(const BenchArguments &a)
{
    const readers::Law &law = a.reader_law;
    return {{"claque", version()},
            {"most_ratio", law.most_ratio},
            {"least_ms", law.least_ms},
            {"runs", readers::rows(a.counts[0], law)}};
}

void print_readers(const Json &report)
{
    std::printf("%-9s %-36s %8s %10s  %9s %6s %-14s %9s %6s %s\n", "format", "element", "count", "bytes", "load ms",
                "ratio", "loaded", "build ms", "ratio", "built");
    for (const Json &r : report["runs"]) {
        std::printf("%-9s %-36s %8u %10llu  %9.1f %6.1f %-14s %9.1f %6.1f %s", r["format"].get<std::string>().c_str(),
                    r["element"].get<std::string>().c_str(), r["count"].get<unsigned>(),
                    r["bytes"].get<unsigned long long>(), r["load_ms"].get<double>(), r["load_ratio"].get<double>(),
                    r["loaded"].get<std::string>().c_str(), r["build_ms"].get<double>(), r["build_ratio"].get<double>(),
                    r["built"].get<std::string>().c_str());
        if (!r["lawful"].get<bool>()) std::printf("  <- more than %g", r["most_ratio"].get<double>());
        std::printf("\n");
    }
}

}  // namespace cli
