#include "samples/processes/crew.h"

#include <gtest/gtest.h>

namespace
{

TEST(Crew, AnswersOfTheLargestSizeArriveAndLongerOnesAreNamed)
{
    processes::Crew crew(1, [](uint32_t) -> processes::Answering {
        return [](const std::string &size) -> processes::Reply { return std::string(std::stoul(size), 'x'); };
    });
    crew.send(0, std::to_string(processes::Channel::max_bytes - 1));
    EXPECT_EQ(crew.wait().text.size(), processes::Channel::max_bytes - 1);
    crew.send(0, std::to_string(processes::Channel::max_bytes));
    try {
        crew.wait();
        FAIL() << "an answer that no message can hold arrived";
    } catch (const std::runtime_error &error) {
        EXPECT_NE(std::string(error.what()).find("an answer of 1073741824 bytes is longer than the 1073741823"),
                  std::string::npos)
            << error.what();
    }
    EXPECT_EQ(crew.replaced(), 0u);
}

}  // namespace
