#include "lib/asset/trajectories/xml.h"

#ifdef CLAQUE_HAS_EXPAT
#include <expat.h>
#endif

#include <algorithm>
#include <exception>

#include "lib/asset/decoders.h"
#include "lib/asset/trajectories/gzip.h"
#include "lib/base/error.h"

namespace claque::asset
{

using base::fail;

const char *attribute(const char *const *attributes, std::string_view name)
{
    for (; *attributes; attributes += 2)
        if (name == attributes[0]) return attributes[1];
    return nullptr;
}

#ifdef CLAQUE_HAS_EXPAT

namespace
{

constexpr uint32_t deepest_element = 128;
constexpr int most_attributes = 10000;  // of one element
constexpr int64_t longest_token = 4 << 20;
constexpr size_t xml_piece = 1 << 20;

// Expat 2.9 has new names for both, and calls the old ones deprecated.
#if XML_MAJOR_VERSION > 2 || XML_MINOR_VERSION >= 9
int64_t byte_of(XML_Parser parser) { return XML_GetCurrentByteIndex64(parser); }
uint64_t line_of(XML_Parser parser) { return XML_GetCurrentLineNumber64(parser); }
#else
int64_t byte_of(XML_Parser parser) { return XML_GetCurrentByteIndex(parser); }
uint64_t line_of(XML_Parser parser) { return XML_GetCurrentLineNumber(parser); }
#endif

class XmlParser
{
public:
    explicit XmlParser(XmlHandler &handler) : handler_(handler), parser_(XML_ParserCreate(nullptr))
    {
        if (!parser_) throw std::bad_alloc();
        XML_SetUserData(parser_, this);
        XML_SetElementHandler(parser_, on_begin, on_end);
        XML_SetCommentHandler(parser_, on_comment);
        XML_SetStartDoctypeDeclHandler(parser_, on_doctype);
    }
    ~XmlParser() { XML_ParserFree(parser_); }
    XmlParser(const XmlParser &) = delete;
    XmlParser &operator=(const XmlParser &) = delete;

    void feed(std::string_view piece)
    {
        while (!piece.empty()) {
            const std::string_view part = piece.substr(0, xml_piece);
            parse(part, false);
            fed_ += static_cast<int64_t>(part.size());
            // Reading the beginning of a long token again and again would take quadratic time.
            if (fed_ - std::max<int64_t>(byte_of(parser_), 0) > longest_token)
                fail(CLQ_LIMIT, "line %u: an element, comment or text of more than %lld bytes", line(),
                     static_cast<long long>(longest_token));
            piece.remove_prefix(part.size());
        }
    }
    void finish() { parse({}, true); }

private:
    uint32_t line() const { return static_cast<uint32_t>(line_of(parser_)); }

    void parse(std::string_view text, bool last)
    {
        if (XML_Parse(parser_, text.data(), static_cast<int>(text.size()), last) != XML_STATUS_ERROR) return;
        if (thrown_) std::rethrow_exception(thrown_);
        const XML_Error error = XML_GetErrorCode(parser_);
        if (error == XML_ERROR_NO_MEMORY) throw std::bad_alloc();
        fail(CLQ_FORMAT, "line %u: the XML is broken: %s", line(), XML_ErrorString(error));
    }

    // No exception may pass through expat, which is C.
    template <class Job>
    static void guarded(void *user, const Job &job)
    {
        XmlParser &self = *static_cast<XmlParser *>(user);
        if (self.thrown_) return;
        try {
            job(self);
        } catch (...) {
            self.thrown_ = std::current_exception();
            XML_StopParser(self.parser_, XML_FALSE);
        }
    }

    static void on_begin(void *user, const XML_Char *name, const XML_Char **attributes)
    {
        guarded(user, [&](XmlParser &self) {
            if (++self.depth_ > deepest_element)
                fail(CLQ_LIMIT, "line %u: more than %u elements in each other", self.line(), deepest_element);
            if (const int given = XML_GetSpecifiedAttributeCount(self.parser_) / 2; given > most_attributes)
                fail(CLQ_LIMIT, "line %u: an element with %d attributes; at most %d are read", self.line(), given,
                     most_attributes);
            self.handler_.begin(name, attributes, self.depth_, self.line());
        });
    }
    static void on_end(void *user, const XML_Char *name)
    {
        guarded(user, [&](XmlParser &self) { self.handler_.end(name, self.depth_--); });
    }
    static void on_comment(void *user, const XML_Char *text)
    {
        guarded(user, [&](XmlParser &self) { self.handler_.comment(text); });
    }
    static void on_doctype(void *user, const XML_Char *, const XML_Char *, const XML_Char *, int)
    {
        guarded(user, [](XmlParser &self) {
            fail(CLQ_FORMAT, "line %u: the XML has a DOCTYPE, which no file of these formats has", self.line());
        });
    }

    XmlHandler &handler_;
    XML_Parser parser_;
    std::exception_ptr thrown_;
    uint32_t depth_ = 0;
    int64_t fed_ = 0;
};

}  // namespace

void read_xml(const uint8_t *bytes, size_t size, Budget &budget, XmlHandler &handler)
{
    XmlParser parser(handler);
    if (is_gzip(bytes, size))
        unpack(bytes, size, budget, [&](std::string_view piece) {
            parser.feed(piece);
            return true;
        });
    else parser.feed({reinterpret_cast<const char *>(bytes), size});
    parser.finish();
}

#else

void read_xml(const uint8_t *, size_t, Budget &, XmlHandler &) { refuse_without_library("XML", "libexpat"); }

#endif

}  // namespace claque::asset
