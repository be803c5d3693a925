// Which pages of a browser may open the window: a browser lets any page connect to this machine, and says whose it is.
#pragma once

#include <string>
#include <vector>

namespace view::serve
{

// `request`: the head of an HTTP request. Whether every origin that it names is of the host that it asks, at any port,
// or one of `origins`, as "https://example.org". A request without one is not a page's.
bool origin_is_allowed(const std::string &request, const std::vector<std::string> &origins);

}  // namespace view::serve
