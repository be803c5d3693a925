// What a file is by its name.
#pragma once

#include <cctype>
#include <filesystem>
#include <string>

namespace io
{

// In lower case, with its dot: ".png" of "A.PNG". "": the name has none.
inline std::string ending_of(const std::string &path)
{
    std::string ending = std::filesystem::path(path).extension().string();
    for (char &c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return ending;
}

}  // namespace io
