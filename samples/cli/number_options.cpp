#include "samples/cli/number_options.h"

#include <cmath>

#include <CLI/CLI.hpp>

#include "samples/io/whole_number.h"

namespace cli
{
namespace
{

// Leading zeros are taken away: they would make it octal.
std::string whole(std::string &text, bool may_be_negative)
{
    const bool negative = may_be_negative && text.rfind('-', 0) == 0;
    uint64_t size = 0;
    if (!io::read_whole_number(text.substr(negative ? 1 : 0), size) ||
        (may_be_negative && size > static_cast<uint64_t>(INT64_MAX)))
        return "'" + text + "' is not a whole number of digits that 64 bits hold";
    text = (negative ? "-" : "") + std::to_string(size);
    return "";
}

std::string real(const std::string &text)
{
    double value = 0;
    if (CLI::detail::lexical_cast(text, value) && std::isfinite(value)) return "";
    return "'" + text + "' is not a finite number";
}

}  // namespace

void expect_plain_numbers(CLI::App &app)
{
    for (CLI::Option *option : app.get_options()) {
        const std::string type = option->get_type_name();
        const auto begins = [&type](const char *name) { return type.rfind(name, 0) == 0; };
        if (begins("UINT")) option->transform({[](std::string &text) { return whole(text, false); }, ""});
        if (begins("INT")) option->transform({[](std::string &text) { return whole(text, true); }, ""});
        if (begins("FLOAT")) option->transform({[](std::string &text) { return real(text); }, ""});
    }
    for (CLI::App *one : app.get_subcommands([](CLI::App *) { return true; })) expect_plain_numbers(*one);
}

}  // namespace cli
