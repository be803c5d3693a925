// What the processes of a team tell each other, as JSON.
#pragma once

#include "samples/io/json.h"
#include "samples/scenes/check.h"

namespace cli
{

// Throws scenes::Failure if `text` is no JSON, or nested deeper than any message.
template <class Json>
Json message_of(const std::string &text)
{
    std::string problem;
    Json message = io::parse_json<Json>(text, problem);
    if (!problem.empty()) throw scenes::Failure("what one process of a team told another " + problem);
    return message;
}

}  // namespace cli
