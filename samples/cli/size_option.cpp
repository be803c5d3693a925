// --size WxH.
#include "samples/cli/scene_arguments.h"

namespace cli
{
namespace
{

constexpr int largest_side_px = 16384;

// Parses "1024x768" into two numbers; returns an error message for CLI11 otherwise.
std::string read_size(const std::string &text, int &width, int &height)
{
    const size_t x = text.find('x');
    const auto number = [](const std::string &digits) {
        if (digits.empty() || digits.size() > 5 || digits.find_first_not_of("0123456789") != std::string::npos)
            return 0;
        return std::stoi(digits);
    };
    width = x == std::string::npos ? 0 : number(text.substr(0, x));
    height = x == std::string::npos ? 0 : number(text.substr(x + 1));
    if (width >= 1 && height >= 1 && width <= largest_side_px && height <= largest_side_px) return {};
    return "'" + text + "' is not a size like 1024x768, each side 1 to " + std::to_string(largest_side_px);
}

}  // namespace

void add_size_option(CLI::App &command, int &width, int &height)
{
    command
        .add_option_function<std::string>(
            "--size",
            [&width, &height](const std::string &text) {
                const std::string wrong = read_size(text, width, height);
                if (!wrong.empty()) throw CLI::ValidationError("--size", wrong);
            },
            "Size of the picture in pixels (default " + std::to_string(width) + "x" + std::to_string(height) + ")")
        ->type_name("WxH");
}

}  // namespace cli
