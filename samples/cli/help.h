// The text of --help, which is the same for every version of CLI11: the manual page and the tests read it.
#pragma once

#include <memory>

namespace CLI
{
class FormatterBase;
}

namespace cli
{

std::shared_ptr<CLI::FormatterBase> help_format();

}  // namespace cli
