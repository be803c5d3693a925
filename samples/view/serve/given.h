// What the places of a served window share.
#pragma once

#include <atomic>
#include <string>

#include "samples/view/input_queue.h"
#include "samples/view/serve/board.h"
#include "samples/view/serve/options.h"

namespace view::serve
{

struct Given {
    Options options;
    std::string title;
    int width = 0, height = 0;
    const Board &board;
    InputQueue &input;
    std::atomic<int> &known;  // viewers that have given the password
};

}  // namespace view::serve
