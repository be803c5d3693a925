// What preparing a character does besides reading and levels grows with each of its countable elements: building its
// template, saving that, and loading it. Work is counted, never timed.
#include <gtest/gtest.h>

#include "growing_models.h"
#include "lib/model/template_file.h"
#include "meshsplit/build.h"
#include "work_counter.h"

namespace claque::testing
{
namespace
{

constexpr uint64_t most_growth = 16;  // of ten times the count

// Of building, saving and loading.
struct Prepared {
    uint64_t work[3] = {0, 0, 0};
    model::SplitReport report;
};

Prepared prepare(const model::Model &model)
{
    Prepared out;
    model::Template made(std::pmr::get_default_resource()), loaded(std::pmr::get_default_resource());
    std::pmr::vector<uint8_t> bytes;
    out.work[0] = blocks_entered([&] { meshsplit::build(model, {}, made); });
    out.work[1] = blocks_entered([&] { model::save(made, bytes); });
    out.work[2] = blocks_entered([&] { model::load(bytes.data(), bytes.size(), loaded); });
    out.report = loaded.report;
    return out;
}

class BuildWorkOf : public ::testing::TestWithParam<GrowingModel>
{
};

TEST_P(BuildWorkOf, GrowsWithItsNumber)
{
    const GrowingModel &growing = GetParam();
    const Prepared few = prepare(growing.make(growing.most / 10)), many = prepare(growing.make(growing.most));
    const char *const names[] = {"building", "saving", "loading"};
    for (size_t i = 0; i < 3; ++i) {
        EXPECT_GT(few.work[i], 1000u) << names[i] << ": nothing is counted";
        EXPECT_LE(many.work[i], most_growth * few.work[i]) << names[i];
        RecordProperty(names[i], std::to_string(double(many.work[i]) / double(few.work[i])) + " of " +
                                     std::to_string(few.work[i]));
    }
    EXPECT_GT(few.report.dirty, 0u);
    EXPECT_GE(many.report.triangles, few.report.triangles);
}

std::string name_of(const ::testing::TestParamInfo<GrowingModel> &info)
{
    std::string name = info.param.element;
    for (char &c : name) c = c == ' ' ? '_' : c;
    return name;
}

INSTANTIATE_TEST_SUITE_P(Elements, BuildWorkOf, ::testing::ValuesIn(growing_models()), name_of);

}  // namespace
}  // namespace claque::testing
