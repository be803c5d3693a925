// Holds every #include of the library and the samples against layers.txt.
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

namespace fs = std::filesystem;

namespace
{

using Table = std::map<std::string, std::set<std::string>>;

Table read_table(const fs::path &path)
{
    Table table;
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        const size_t colon = line.find(':');
        if (line.empty() || line[0] == '#' || colon == std::string::npos) continue;
        std::istringstream rooms(line.substr(colon + 1));
        std::set<std::string> &allowed = table[line.substr(0, colon)];
        for (std::string room; rooms >> room;) allowed.insert(room);
    }
    return table;
}

// The longest room that a path from the root lies in, or "".
std::string room_of(const Table &table, const std::string &path)
{
    std::string found;
    for (const auto &[room, allowed] : table)
        if (path.rfind(room + "/", 0) == 0 && room.size() > found.size()) found = room;
    return found;
}

// What is wrong with one include line of a file of `room`, or "".
std::string verdict(const Table &table, const std::string &room, const std::string &line)
{
    const size_t at = line.find("#include");
    if (at == std::string::npos || line.find_first_not_of(" \t") != at) return "";
    const size_t open = line.find_first_of("\"<", at + 8);
    if (open == std::string::npos) return "an include that is not a name in quotes or brackets";
    const std::string name = line.substr(open + 1, line.find_first_of("\">", open + 1) - open - 1);
    if (line[open] == '<') {
        if (room != "samples" && (name.rfind("GL/", 0) == 0 || name.rfind("EGL/", 0) == 0))
            return "the library uses no GL header: " + name;
        return "";
    }
    const std::string other = room_of(table, name);
    if (other.empty()) return "no room holds '" + name + "': includes start at the project's root";
    const std::set<std::string> &allowed = table.at(room);
    if (other != room && !allowed.count(other) && !allowed.count(name))
        return room + " may not include " + other + " (" + name + ")";
    return "";
}

std::vector<std::string> offences(const Table &table, const fs::path &root)
{
    std::vector<std::string> out;
    for (const char *top : {"lib", "passes", "meshsplit", "animcache", "samples", "include"})
        for (const auto &entry : fs::recursive_directory_iterator(root / top)) {
            const std::string extension = entry.path().extension().string();
            if (extension != ".h" && extension != ".cpp" && extension != ".c") continue;
            const std::string path = fs::relative(entry.path(), root).generic_string();
            const std::string room = room_of(table, path);
            if (room.empty()) {
                if (path.rfind("include/", 0) != 0) out.push_back(path + ": in no room of layers.txt");
                continue;
            }
            std::ifstream file(entry.path());
            int number = 0;
            for (std::string line; std::getline(file, line);) {
                ++number;
                const std::string wrong = verdict(table, room, line);
                if (!wrong.empty()) out.push_back(path + ":" + std::to_string(number) + ": " + wrong);
            }
        }
    return out;
}

const fs::path root = CLAQUE_SOURCE_DIR;

}  // namespace

TEST(Layers, EveryIncludeIsOneThatTheTableAllows)
{
    const Table table = read_table(root / "tests/abi/layers.txt");
    ASSERT_GT(table.size(), 10u);
    for (const std::string &offence : offences(table, root)) ADD_FAILURE() << offence;
}

TEST(Layers, AnIncludeUpwardsOrOfGlIsCaught)
{
    const Table table = read_table(root / "tests/abi/layers.txt");
    EXPECT_NE(verdict(table, "passes", "#include \"lib/crowd/crowd.h\""), "");
    EXPECT_NE(verdict(table, "lib/base", "#include \"lib/math/affine.h\""), "");
    EXPECT_NE(verdict(table, "passes", "#include <GL/gl.h>"), "");
    EXPECT_NE(verdict(table, "samples", "#include \"lib/base/hash.h\""), "");
    EXPECT_NE(verdict(table, "lib/pose", "#include \"pose.h\""), "");
    EXPECT_NE(verdict(table, "lib/lod", "#include \"lib/lod/proxies/reduce.h\""), "");
    EXPECT_EQ(verdict(table, "lib/lod", "#include \"lib/lod/proxies/proxy.h\""), "");
    EXPECT_EQ(verdict(table, "lib/frame", "#include \"animcache/period.h\""), "");
}

TEST(Layers, ArchitectureShowsTheSameTable)
{
    std::ifstream file(root / "ARCHITECTURE.md");
    std::stringstream text;
    text << file.rdbuf();
    for (const auto &[room, allowed] : read_table(root / "tests/abi/layers.txt"))
        if (room != "samples" && fs::exists(root / room)) {
            EXPECT_NE(text.str().find("`" + room + "`"), std::string::npos) << room << " is not in ARCHITECTURE.md";
        }
}

TEST(Layers, FilesAreShort)
{
    for (const char *top : {"lib", "passes", "meshsplit", "animcache", "samples", "include", "tests"})
        for (const auto &entry : fs::recursive_directory_iterator(root / top)) {
            const std::string extension = entry.path().extension().string();
            if (extension != ".h" && extension != ".cpp" && extension != ".c") continue;
            std::ifstream file(entry.path());
            const std::string path = fs::relative(entry.path(), root).string();
            if (path.rfind("tests/abi/v1/", 0) == 0) continue;  // a copy of released headers
            // Two public headers hold one class each with all its documentation.
            const bool long_header = path == "include/claque/crowd.h" || path == "include/claque/template.h";
            const auto lines = std::count(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>(), '\n');
            EXPECT_LE(lines, long_header ? 350 : 300) << path;
        }
}
