// A call that shall be refused with a sentence.
#pragma once

#include <claque/claque.h>

#include <string>

#include <gtest/gtest.h>

// `sentence`: a part of clq_last_error().
inline void expect_refused(clq_status status, const std::string &sentence, clq_status wanted = CLQ_ARGUMENT)
{
    EXPECT_EQ(status, wanted) << sentence;
    EXPECT_NE(std::string(clq_last_error()).find(sentence), std::string::npos)
        << clq_last_error() << "\nand not: " << sentence;
}
