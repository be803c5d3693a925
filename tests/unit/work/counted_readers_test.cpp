// All that `claque bench readers` times, counted: reading, and what is made from it, grow with each element of each
// format. The law is the command's; the work is that of basic blocks, so that it depends on no machine.
#include <gtest/gtest.h>

#include "samples/cli/reader_files.h"
#include "samples/cli/reader_law.h"
#include "work_counter.h"

namespace cli
{

// The clock of the readers, in this program: blocks that were entered.
double processor_ms() { return double(claque::testing::blocks_entered()); }

namespace
{

// The first state within a record comes after some hundreds of calls: a tenth has to have one.
uint32_t most_counted(const ReaderElement &element)
{
    return std::min(element.limit, element.format == std::string("record") ? 10000u : 3000u);
}

// The word of elements whose libraries this program lacks.
bool is_read(const std::string &name)
{
    std::vector<std::string> lacking = {"WebP"};
#ifndef CLAQUE_HAS_EXPAT
    lacking.insert(lacking.end(), {"SUMO", "JuPedSim"});
#endif
    for (const std::string &word : lacking)
        if (name.find(word) != std::string::npos) return false;
    return true;
}

class CountedReaders : public ::testing::TestWithParam<ReaderElement>
{
};

TEST_P(CountedReaders, GrowsWithItsNumber)
{
    const ReaderElement &element = GetParam();
    scenes::Library library(1);
    const uint32_t count = most_counted(element);
    const Reading few = element.read(library, element.make(count / 10));
    const Reading many = element.read(library, element.make(count));
    if (!is_read(std::string(element.format) + " " + element.element)) {
        EXPECT_EQ(many.loaded, "CLQ_UNSUPPORTED");
        return;
    }
    EXPECT_EQ(many.loaded, "ok");
    EXPECT_GE(few.load_ms, count / 10) << "nothing is counted";
    EXPECT_LE(many.load_ms, readers::most_ratio * few.load_ms);
    RecordProperty("load", std::to_string(many.load_ms / few.load_ms) + " of " + std::to_string(few.load_ms));
    if (many.built == "-") return;
    EXPECT_EQ(many.built, "ok");
    EXPECT_GE(few.build_ms, 3000) << "nothing is counted";
    EXPECT_LE(many.build_ms, readers::most_ratio * few.build_ms);
    RecordProperty("build", std::to_string(many.build_ms / few.build_ms) + " of " + std::to_string(few.build_ms));
}

std::string name_of(const ::testing::TestParamInfo<ReaderElement> &info)
{
    std::string out;
    for (const char c : std::string(info.param.format) + "_" + info.param.element)
        if (std::isalnum(static_cast<unsigned char>(c))) out += c;
        else if (c == ' ' || c == '_') out += '_';
    return out;
}

INSTANTIATE_TEST_SUITE_P(Elements, CountedReaders, ::testing::ValuesIn(reader_elements()), name_of);

}  // namespace
}  // namespace cli
