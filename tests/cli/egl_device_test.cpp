// CLAQUE_EGL_DEVICE: which of a machine's devices draws.
#include <cstdlib>

#include <nlohmann/json.hpp>

#include "tests/cli/run.h"

namespace cli_test
{
namespace
{

class EglDevice : public Command
{
protected:
    void SetUp() override
    {
        const std::string why = why_no_context("egl");
        if (!why.empty()) GTEST_SKIP() << why;
    }
    ~EglDevice() override { unsetenv("CLAQUE_EGL_DEVICE"); }

    Outcome draw(const char *device)
    {
        if (device) setenv("CLAQUE_EGL_DEVICE", device, 1);
        else unsetenv("CLAQUE_EGL_DEVICE");
        return claque({"render", "--context", "egl", "--count", "30", "--size", "96x72", "--out", path("a.png"),
                       "--json", path("a.json")});
    }
    nlohmann::json report() const { return nlohmann::json::parse(file_text(path("a.json"))); }
};

TEST_F(EglDevice, TheFirstDeviceDrawsWhatTheSurfacelessPlatformDrawsWhereBothHaveOneGl)
{
    ASSERT_EQ(draw(nullptr).code, 0);
    const nlohmann::json surfaceless = report();
    const Outcome done = draw("0");
    ASSERT_EQ(done.code, 0) << done.err;
    if (report()["context"] != surfaceless["context"])
        GTEST_SKIP() << "device 0 is " << report()["context"] << ", the surfaceless platform "
                     << surfaceless["context"];
    EXPECT_EQ(report()["frames"][0]["picture_hash"], surfaceless["frames"][0]["picture_hash"]);
}

TEST_F(EglDevice, ADeviceThatIsNotThereIsRefusedWithTheNumberOfDevices)
{
    for (const char *device : {"64", "-1", "one", "0x", " "}) {
        const Outcome done = draw(device);
        EXPECT_NE(done.code, 0) << device;
        EXPECT_NE(done.err.find("CLAQUE_EGL_DEVICE is '" + std::string(device) + "', and this machine has "),
                  std::string::npos)
            << done.err;
        EXPECT_TRUE(left().empty());
    }
}

}  // namespace
}  // namespace cli_test
