// Trajectories in each format, and areas.
#include "tests/fuzz/seeds.h"
#include "tests/unit/asset/trajectories/writers.h"

namespace fuzzing
{

namespace
{

Bytes text_bytes(const std::string &text) { return Bytes(text.begin(), text.end()); }

std::vector<std::string> small_pages(std::vector<std::string> statements)
{
    statements.insert(statements.begin(), "PRAGMA page_size = 512");
    return statements;
}

void add_trajectory(std::vector<Seed> &out, const std::string &name, clq_trajectory_format format, unsigned options,
                    const Bytes &file)
{
    Bytes bytes{static_cast<uint8_t>(format), static_cast<uint8_t>(options)};
    bytes.insert(bytes.end(), file.begin(), file.end());
    out.push_back({"trajectories", name, bytes});
}

}  // namespace

void add_people_seeds(std::vector<Seed> &out)
{
    using namespace claque::testing;
    for (const Written &file : written_files()) {
        if (file.format == CLQ_TRAJECTORY_JUPEDSIM) continue;
        const unsigned options = (file.options.rate_hz > 0 ? 1 : 0) | (file.options.metres_per_unit > 0 ? 2 : 0);
        add_trajectory(out, file.name, CLQ_TRAJECTORY_AUTO, options, file.bytes);
        add_trajectory(out, std::string("given-") + file.name, file.format, options, file.bytes);
    }
    add_trajectory(out, "frames", CLQ_TRAJECTORY_AUTO, 1 | 2 | 4, text_bytes("a 1 2 3\na 2 2 4\nb;1;2;3\n"));
    add_trajectory(out, "times", CLQ_TRAJECTORY_AUTO, 2 | 4 | 8 | 32, text_bytes("a 1 2 3 0 90\na 2 2 4 0 -90\n"));
    for (const int version : {1, 3}) {
        const Bytes bytes = database_of(small_pages(jupedsim_statements(version)));
        if (bytes.empty()) continue;
        add_trajectory(out, "jupedsim" + std::to_string(version), CLQ_TRAJECTORY_AUTO, 0, bytes);
        out.push_back({"area", "jupedsim" + std::to_string(version), bytes});
    }
    const char *areas[] = {
        "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 2, 2 2, 2 1, 1 1))",
        "GEOMETRYCOLLECTION (POLYGON ((0 0, 4 0, 4 4)), MULTIPOLYGON (((5 0, 9 0, 9 9)), EMPTY), POLYGON EMPTY)",
        "4\n0 0\n2 0\n2 2\n0 2\n1\n0 2 0 1\n2\n0 1 0 1\n1 2 0 -1\ngroup\n2\n0 0 3 0 1 2 0 0 1 1 0 2 0 1\n0 0 3 0 2 3 "
        "0.5 0 1 1 0 0\n",
        "<geometry unit=\"m\"><subroom><polygon><vertex px=\"0\" py=\"0\"/><vertex px=\"4\" py=\"0\"/><vertex px=\"4\" "
        "py=\"4\"/><vertex px=\"0\" py=\"0\"/></polygon><obstacle><polygon><vertex px=\"3\" py=\"1\"/><vertex "
        "px=\"3\" py=\"2\"/><vertex px=\"2.5\" py=\"1\"/></polygon></obstacle></subroom></geometry>",
        "{\"scenario\": {\"topography\": {\"attributes\": {\"bounds\": {\"x\": 0, \"y\": 0, \"width\": 8, \"height\": "
        "6}, \"boundingBoxWidth\": 0.5}, \"obstacles\": [{\"shape\": {\"type\": \"RECTANGLE\", \"x\": 2, \"y\": 2, "
        "\"width\": 2, \"height\": 1}}]}}}"};
    for (const char *area : areas) out.push_back({"area", std::to_string(out.size()), text_bytes(area)});
}

}  // namespace fuzzing
