// Changes JSON so that it mostly stays legal: other numbers and words in their places, parts left out, repeated,
// exchanged.
#pragma once

#include <random>

#include <nlohmann/json.hpp>

#include "tests/fuzz/fuzzer.h"

namespace fuzzing
{

using Json = nlohmann::json;

class Dice
{
public:
    explicit Dice(unsigned seed) : random_(seed) {}
    size_t below(size_t n) { return random_() % n; }
    bool one_in(size_t n) { return below(n) == 0; }

private:
    std::minstd_rand random_;
};

// Discarded if the text is not JSON or is nested deeply.
Json parsed(const uint8_t *bytes, size_t size);

void mutate(Json &tree, Dice &dice);

}  // namespace fuzzing
