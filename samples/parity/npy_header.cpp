#include "samples/parity/npy_header.h"

#include <cstring>
#include <set>

#include "samples/parity/npy.h"

namespace parity
{
namespace
{

// Reads the subset of Python that NumPy writes: strings, True and False, whole numbers, tuples.
class Reader
{
public:
    Reader(const std::string &text, const std::string &name) : text_(text), name_(name) {}

    bool take(char c)
    {
        blanks();
        if (at_ >= text_.size() || text_[at_] != c) return false;
        ++at_;
        return true;
    }
    void expect(char c)
    {
        if (!take(c)) fail(std::string("has no '") + c + "'");
    }
    std::string string()
    {
        blanks();
        const char quote = at_ < text_.size() ? text_[at_] : 0;
        const size_t end = quote == '\'' || quote == '"' ? text_.find(quote, at_ + 1) : std::string::npos;
        if (end == std::string::npos) fail("has no quoted string");
        const std::string inside = text_.substr(at_ + 1, end - at_ - 1);
        at_ = end + 1;
        return inside;
    }
    bool truth()
    {
        blanks();
        for (const char *word : {"False", "True"})
            if (text_.compare(at_, std::strlen(word), word) == 0) {
                at_ += std::strlen(word);
                return word[0] == 'T';
            }
        fail("has neither True nor False");
    }
    std::vector<size_t> tuple()
    {
        std::vector<size_t> out;
        expect('(');
        while (!take(')')) {
            out.push_back(number());
            if (!take(',')) {
                expect(')');
                break;
            }
        }
        return out;
    }
    void end()
    {
        blanks();
        if (at_ != text_.size()) fail("goes on after the dictionary");
    }
    [[noreturn]] void fail(const std::string &what) const
    {
        throw Unreadable(name_ + " is not a NumPy array: its header " + what + " at character " + std::to_string(at_));
    }

private:
    void blanks()
    {
        while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n')) ++at_;
    }
    size_t number()
    {
        blanks();
        const size_t first = at_;
        size_t value = 0;
        for (; at_ < text_.size() && text_[at_] >= '0' && text_[at_] <= '9' && at_ - first < 18; ++at_)
            value = 10 * value + static_cast<size_t>(text_[at_] - '0');
        if (at_ == first) fail("has no number");
        return value;
    }

    const std::string &text_, &name_;
    size_t at_ = 0;
};

}  // namespace

NpyHeader npy_header(const std::string &text, const std::string &name)
{
    NpyHeader out;
    std::set<std::string> seen;
    Reader in(text, name);
    in.expect('{');
    while (!in.take('}')) {
        const std::string key = in.string();
        in.expect(':');
        if (key == "descr") out.type = in.string();
        else if (key == "fortran_order") out.fortran_order = in.truth();
        else if (key == "shape") out.shape = in.tuple();
        else in.fail("has the unknown key '" + key.substr(0, 32) + "'");
        seen.insert(key);
        if (!in.take(',')) {
            in.expect('}');
            break;
        }
    }
    in.end();
    if (seen.size() != 3) in.fail("lacks descr, fortran_order or shape");
    return out;
}

}  // namespace parity
