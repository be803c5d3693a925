#include "tests/faults/left_files.h"

#include "tests/cli/run.h"

namespace command_faults
{

namespace fs = std::filesystem;

Files files_below(const fs::path &folder)
{
    Files all;
    for (const auto &entry : fs::recursive_directory_iterator(folder))
        all[fs::relative(entry.path(), folder).string()] =
            entry.is_regular_file() ? cli_test::file_text(entry.path()) : "/";
    return all;
}

std::string without_times(const std::string &name, const std::string &text)
{
    return fs::path(name).extension() == ".json" && text.size() > 2 ? text.substr(text.size() - 2) : text;
}

std::string last_line(const std::string &text)
{
    if (text.empty() || text.back() != '\n') return "";
    const size_t before = text.rfind('\n', text.size() - 2);
    return text.substr(before == std::string::npos ? 0 : before + 1);
}

}  // namespace command_faults
