#include "samples/stage/services.h"

namespace staged
{

std::vector<std::unique_ptr<Service>> make_services(const scenes::Scenario &scenario)
{
    std::vector<std::unique_ptr<Service>> all;
    all.push_back(make_exits());
    if (!scenario.stage->doors.empty()) all.push_back(make_doors(*scenario.stage));
    if (!scenario.stage->flyers.empty()) all.push_back(make_flights(*scenario.stage));
    if (scenario.town && scenario.stage->ground) all.push_back(make_market(*scenario.town));
    if (scenario.theatre) all.push_back(make_ushers(scenario));
    return all;
}

}  // namespace staged
