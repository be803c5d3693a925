#include "samples/view/serve/origin.h"

#include <algorithm>
#include <cctype>

namespace view::serve
{
namespace
{

std::string in_small_letters(std::string text)
{
    for (char &letter : text) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    return text;
}

// The values of a header, in small letters and without space around them.
std::vector<std::string> values_of(const std::string &request, const std::string &header)
{
    std::vector<std::string> values;
    for (size_t at = 0; at < request.size();) {
        const size_t end = std::min(request.find('\n', at), request.size());
        const std::string line = in_small_letters(request.substr(at, end - at));
        at = end + 1;
        if (line.rfind(header + ":", 0) != 0) continue;
        const size_t first = line.find_first_not_of(" \t", header.size() + 1), last = line.find_last_not_of(" \t\r");
        values.push_back(first == std::string::npos || last < first ? "" : line.substr(first, last + 1 - first));
    }
    return values;
}

// Of "host", "host:port" or "[::1]:port".
std::string without_port(const std::string &host)
{
    if (!host.empty() && host[0] == '[') return host.substr(0, host.find(']') + 1);
    return host.substr(0, host.find(':'));
}

std::string without_slash(std::string origin)
{
    if (!origin.empty() && origin.back() == '/') origin.pop_back();
    return origin;
}

}  // namespace

bool origin_is_allowed(const std::string &request, const std::vector<std::string> &origins)
{
    const std::vector<std::string> hosts = values_of(request, "host");
    std::vector<std::string> named = values_of(request, "origin");
    for (const std::string &old : values_of(request, "sec-websocket-origin")) named.push_back(old);
    return std::all_of(named.begin(), named.end(), [&](const std::string &origin) {
        for (const std::string &one : origins)
            if (without_slash(in_small_letters(one)) == without_slash(origin)) return true;
        const size_t host = origin.find("://");
        if (host == std::string::npos || hosts.size() != 1) return false;
        const std::string page = without_port(without_slash(origin.substr(host + 3)));
        return !page.empty() && page == without_port(hosts[0]);
    });
}

}  // namespace view::serve
