// Scenarios with one thing changed, and how they are refused.
#pragma once

#include <string>
#include <vector>

#include "samples/scenes/scenario/scenario.h"

namespace scenes
{

// The sentence by which a scenario is refused, or "read". The files that it names are there if their names do not begin
// with "no"; paths of cameras are the odeon's.
std::string refusal_of(const std::string &toml);

// It is refused by one sentence that begins with file, line and column, and has these words.
void expect_refused(const std::string &toml, const std::vector<std::string> &words);

// The text with the first `was` after `after` replaced.
std::string changed_text(std::string text, const std::string &after, const std::string &was, const std::string &is);

}  // namespace scenes
