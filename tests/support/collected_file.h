// Files of ../shared/assets, which not every checkout has. Where it has them, none of them may be missing.
#pragma once

#include <filesystem>

#include <gtest/gtest.h>

// Ends a test that needs such a file or folder, or one written here, which is always there.
#define CLAQUE_NEEDS_FILE(path)                                                                                       \
    do {                                                                                                              \
        if (std::filesystem::exists(path)) break;                                                                     \
        if (!std::filesystem::exists(CLAQUE_ASSETS_DIR "/inventory.json")) GTEST_SKIP() << (path) << " is not there"; \
        FAIL() << CLAQUE_ASSETS_DIR " lacks " << (path);                                                              \
    } while (false)
