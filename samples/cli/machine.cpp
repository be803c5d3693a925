#include "samples/cli/machine.h"

#include <fstream>
#include <thread>

namespace cli
{

Json machine()
{
    std::string processor, line;
    std::ifstream words("/proc/cpuinfo");
    while (processor.empty() && std::getline(words, line)) {
        const size_t colon = line.find(':');
        if (line.rfind("model name", 0) != 0 || colon == std::string::npos) continue;
        const size_t first = line.find_first_not_of(' ', colon + 1);
        if (first != std::string::npos) processor = line.substr(first);
    }
    return {{"processor", processor.empty() ? "unknown processor" : processor},
            {"cores", std::thread::hardware_concurrency()}};
}

}  // namespace cli
