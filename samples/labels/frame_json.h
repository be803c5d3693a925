// What a picture says of its people, as JSON: the part of a labelled picture that collections are made of.
#pragma once

#include <nlohmann/json.hpp>

#include "samples/labels/sample.h"

namespace labels
{

using Json = nlohmann::ordered_json;

Json frame_json(const Sample &sample);

}  // namespace labels
