#include "samples/cli/terminal.h"

#include <iostream>
#include <streambuf>
#include <string>
#include <sys/types.h>
#include <unistd.h>

namespace cli
{
namespace
{

// Of a letter in UTF-8 by its first byte; 0: it begins none.
size_t bytes_of_letter(unsigned char first)
{
    if (first < 0x80) return 1;
    if (first < 0xc2) return 0;
    return first < 0xe0 ? 2 : first < 0xf0 ? 3 : first < 0xf5 ? 4 : 0;
}

bool is_control(const std::string &letter)
{
    const auto byte = [&](size_t i) { return static_cast<unsigned char>(letter[i]); };
    if (letter.size() == 1) return (byte(0) < ' ' && letter != "\n" && letter != "\t") || byte(0) == 0x7f;
    // Of Latin 1; in more bytes than it needs, by which some terminals take it for one of ASCII.
    return (byte(0) == 0xc2 && byte(1) < 0xa0) || (byte(0) == 0xe0 && byte(1) < 0xa0) ||
           (byte(0) == 0xf0 && byte(1) < 0x90);
}

// A stream that passes on to another one.
class Shown
{
public:
    explicit Shown(std::FILE *raw) : raw_(raw) {}

    std::FILE *raw() const { return raw_; }
    // Returns whether all could be written.
    bool write(const char *text, size_t size)
    {
        std::string out;
        for (size_t i = 0; i < size; ++i) take(text[i], out);
        return std::fwrite(out.data(), 1, out.size(), raw_) == out.size() && std::fflush(raw_) == 0;
    }

private:
    void take(char c, std::string &out)
    {
        if (!letter_.empty() && (static_cast<unsigned char>(c) & 0xc0) != 0x80) escape(out);
        letter_ += c;
        const size_t size = bytes_of_letter(static_cast<unsigned char>(letter_[0]));
        if (letter_.size() < size) return;
        if (size == 0 || is_control(letter_)) return escape(out);
        out += letter_;
        letter_.clear();
    }
    void escape(std::string &out)
    {
        static const char digits[] = "0123456789abcdef";
        for (const char c : letter_) {
            const auto byte = static_cast<unsigned char>(c);
            out += {'\\', 'x', digits[byte >> 4], digits[byte & 15]};
        }
        letter_.clear();
    }

    std::FILE *raw_;
    std::string letter_;  // that is not complete yet
};

// To a stream of C that is asked for each time, as it is replaced.
class Through : public std::streambuf
{
public:
    explicit Through(std::FILE *to) : to_(to) {}

protected:
    int overflow(int c) override { return c == EOF || std::fputc(c, to_) != EOF ? 0 : EOF; }
    std::streamsize xsputn(const char *text, std::streamsize size) override
    {
        return static_cast<std::streamsize>(std::fwrite(text, 1, static_cast<size_t>(size), to_));
    }
    int sync() override { return std::fflush(to_) == 0 ? 0 : -1; }

private:
    std::FILE *to_;
};

Shown &output()
{
    static Shown shown(stdout);
    return shown;
}

Shown &errors()
{
    static Shown shown(stderr);
    return shown;
}

#ifdef __GLIBC__
std::FILE *stream_of(Shown &shown, int buffering)
{
    cookie_io_functions_t does = {};
    does.write = [](void *to, const char *text, size_t size) {
        return static_cast<ssize_t>(static_cast<Shown *>(to)->write(text, size) ? size : 0);
    };
    std::FILE *made = fopencookie(&shown, "w", does);
    if (made) std::setvbuf(made, nullptr, buffering, BUFSIZ);
    return made ? made : shown.raw();
}
#endif

}  // namespace

void show_control_characters()
{
#ifdef __GLIBC__
    stdout = stream_of(output(), isatty(STDOUT_FILENO) == 1 ? _IOLBF : _IOFBF);
    stderr = stream_of(errors(), _IONBF);
    // They live as long as std::cout, which is flushed last.
    static auto *const out = new Through(stdout), *const err = new Through(stderr);
    std::cout.rdbuf(out), std::cerr.rdbuf(err);
#endif
}

std::FILE *raw_output() { return output().raw(); }
std::FILE *raw_errors() { return errors().raw(); }

}  // namespace cli
