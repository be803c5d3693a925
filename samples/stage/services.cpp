#include "samples/stage/services.h"

namespace staged
{

std::vector<std::unique_ptr<Service>> make_services(const scenes::Scenario &scenario)
{
    std::vector<std::unique_ptr<Service>> all;
    all.push_back(make_exits());
    if (!scenario.stage->doors.empty()) all.push_back(make_doors(*scenario.stage));
    return all;
}

}  // namespace staged
