#include "samples/cli/help.h"

#include <set>
#include <sstream>

#include <CLI/CLI.hpp>

namespace cli
{
namespace
{

constexpr size_t column = 30;  // where descriptions begin

// A name that is too long for its column stands on a line of its own.
std::string line_of(const std::string &name, const std::string &description)
{
    std::string line = "  " + name;
    if (line.size() >= column && !description.empty()) line += '\n' + std::string(column, ' ');
    else if (line.size() < column) line.resize(column, ' ');
    return line + description + '\n';
}

// Sorted, since CLI11 sorts them by their addresses.
std::string names_of(const char *relation, const std::set<CLI::Option *> &options)
{
    std::set<std::string> names;
    for (const CLI::Option *option : options) names.insert(option->get_name());
    std::string text = names.empty() ? "" : std::string(" ") + relation + ":";
    for (const std::string &name : names) text += ' ' + name;
    return text;
}

bool takes_any_number(const CLI::Option &option)
{
    return option.get_expected_max() >= CLI::detail::expected_max_vector_size;
}

std::string line_of(const CLI::Option &option)
{
    std::ostringstream name;
    name << (option.get_positional() ? option.get_name(true) : option.get_name(false, true));
    if (option.get_type_size() != 0) {
        if (!option.get_type_name().empty()) name << ' ' << option.get_type_name();
        if (!option.get_default_str().empty()) name << '=' << option.get_default_str();
        if (takes_any_number(option)) name << " ...";
        else if (option.get_expected_min() > 1) name << " x " << option.get_expected();
        if (option.get_required()) name << " REQUIRED";
    }
    name << names_of("Needs", option.get_needs()) << names_of("Excludes", option.get_excludes());
    return line_of(name.str(), option.get_description());
}

std::string usage_of(const CLI::Option &option)
{
    std::string text = option.get_name(true);
    if (takes_any_number(option)) text += "...";
    else if (option.get_expected_max() > 1) text += "(" + std::to_string(option.get_expected()) + "x)";
    return option.get_required() ? text : "[" + text + "]";
}

std::vector<const CLI::Option *> shown(const CLI::App &app, bool positional)
{
    return app.get_options([&](const CLI::Option *one) {
        return !one->get_group().empty() && (positional ? one->get_positional() : one->nonpositional());
    });
}

class Help : public CLI::FormatterBase
{
public:
    std::string make_help(const CLI::App *app, std::string name, CLI::AppFormatMode) const override
    {
        const auto places = shown(*app, true), options = shown(*app, false);
        const auto subcommands = app->get_subcommands([](const CLI::App *one) { return !one->get_name().empty(); });
        std::string text = app->get_description() + "\nUsage: " + name + (options.empty() ? "" : " [OPTIONS]");
        for (const CLI::Option *one : places) text += ' ' + usage_of(*one);
        if (!subcommands.empty()) text += app->get_require_subcommand_min() == 0 ? " [SUBCOMMAND]" : " SUBCOMMAND";
        text += '\n';
        if (!places.empty()) text += "\nPositionals:\n";
        for (const CLI::Option *one : places) text += line_of(*one);
        if (!options.empty()) text += "\nOptions:\n";
        for (const CLI::Option *one : options) text += line_of(*one);
        if (!subcommands.empty()) text += "\nSubcommands:\n";
        for (const CLI::App *one : subcommands) text += line_of(one->get_name(), one->get_description());
        return text + '\n';
    }
};

}  // namespace

std::shared_ptr<CLI::FormatterBase> help_format() { return std::make_shared<Help>(); }

}  // namespace cli
