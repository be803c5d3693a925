// XML, read from the front to the back by expat.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "lib/asset/budget.h"

namespace claque::asset
{

// What a reader of a format does with elements. Its members may throw.
class XmlHandler
{
public:
    virtual ~XmlHandler() = default;
    // `attributes`: name, value, name, value, ..., NULL.
    virtual void begin(std::string_view name, const char *const *attributes, uint32_t depth, uint32_t line) = 0;
    virtual void end(std::string_view name, uint32_t depth) = 0;
    virtual void comment(std::string_view) {}
};

// Reads a whole file, which gzip may have packed. Document types are refused, so that no entity can grow. Throws
// base::Error: CLQ_FORMAT (line and what expat says), CLQ_LIMIT (128 elements in each other; an element with more than
// 10 000 attributes; an element, comment or text of more than 4 MB), CLQ_UNSUPPORTED (built without expat); and what
// the handler throws.
void read_xml(const uint8_t *bytes, size_t size, Budget &budget, XmlHandler &handler);

// The value of an attribute; NULL: there is none.
const char *attribute(const char *const *attributes, std::string_view name);

}  // namespace claque::asset
