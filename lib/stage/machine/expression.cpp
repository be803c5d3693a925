#include "lib/stage/machine/expression.h"

#include <charconv>

#include "lib/stage/error.h"
#include "lib/stage/machine/toml_number.h"

namespace claque::stage
{

namespace
{

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Recursive descent. Each function returns the type of what it has read.
class Parser
{
public:
    Parser(std::string_view text, Names &names, std::vector<Op> &out) : text_(text), names_(names), out_(out)
    {
        first_ = out.size();
    }

    Type whole()
    {
        const Type type = alternatives();
        skip_blanks();
        if (at_ < text_.size()) refuse(at_, "'" + std::string(1, text_[at_]) + "' does not continue the expression");
        return type;
    }

private:
    [[noreturn]] static void refuse(size_t offset, std::string sentence)
    {
        throw BadExpression{offset, std::move(sentence)};
    }

    void skip_blanks()
    {
        while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\n')) ++at_;
    }

    bool takes(std::string_view token)
    {
        skip_blanks();
        if (text_.substr(at_, token.size()) != token) return false;
        const size_t end = at_ + token.size();
        if (is_letter(token[0]) && end < text_.size() && (is_letter(text_[end]) || is_digit(text_[end]))) return false;
        at_ = end;
        return true;
    }

    void expect(const char *token)
    {
        if (!takes(token)) refuse(at_, std::string("'") + token + "' is missing");
    }

    void put(Code code, uint32_t index = 0, double number = 0)
    {
        if (out_.size() - first_ >= max_operations)
            refuse(at_, text_of("the expression has more than %u operations", max_operations));
        if (code <= Code::near && ++height_ >= max_stack)
            refuse(at_, text_of("the expression holds more than %u values at once", max_stack));
        out_.push_back({code, index, number});
    }

    void put_pair(Code code)
    {
        put(code);
        --height_;
    }

    // Truths join truths.
    Type joined(Type (Parser::*inner)(), const char *word, Code skip)
    {
        size_t begin = (skip_blanks(), at_);
        const Type type = (this->*inner)();
        while (takes(word)) {
            want(type, Type::truth, begin, word);
            put(skip);
            --height_;
            const size_t from = out_.size();
            begin = (skip_blanks(), at_);
            want((this->*inner)(), Type::truth, begin, word);
            out_[from - 1].index = static_cast<uint32_t>(out_.size() - from);
        }
        return type;
    }

    static void want(Type type, Type wanted, size_t offset, const char *operation)
    {
        if (type == wanted) return;
        refuse(offset, std::string("'") + operation +
                           (wanted == Type::truth ? "' needs a truth, and this is a number"
                                                  : "' needs a number, and this is a truth"));
    }

    Type alternatives() { return joined(&Parser::conditions, "or", Code::skip_if_true); }
    Type conditions() { return joined(&Parser::negation, "and", Code::skip_if_false); }

    Type negation()
    {
        if (!takes("not")) return comparison();
        deeper();
        const size_t begin = (skip_blanks(), at_);
        want(negation(), Type::truth, begin, "not");
        put(Code::negation);
        --depth_;
        return Type::truth;
    }

    Type comparison()
    {
        static constexpr struct {
            const char *token;
            Code code;
        } all[] = {{"<=", Code::less_equal}, {">=", Code::greater_equal}, {"==", Code::equal},
                   {"!=", Code::unequal},    {"<", Code::less},           {">", Code::greater}};
        const size_t begin = (skip_blanks(), at_);
        const Type type = sum();
        for (const auto &one : all) {
            if (!takes(one.token)) continue;
            const bool truths = type == Type::truth && (one.code == Code::equal || one.code == Code::unequal);
            if (!truths) want(type, Type::number, begin, one.token);
            const size_t second = (skip_blanks(), at_);
            want(sum(), truths ? Type::truth : Type::number, second, one.token);
            put_pair(one.code);
            return Type::truth;
        }
        return type;
    }

    Type chain(Type (Parser::*inner)(), const char *first, Code first_code, const char *second, Code second_code)
    {
        size_t begin = (skip_blanks(), at_);
        const Type type = (this->*inner)();
        for (;;) {
            const bool is_first = takes(first);
            if (!is_first && !takes(second)) return type;
            want(type, Type::number, begin, is_first ? first : second);
            begin = (skip_blanks(), at_);
            want((this->*inner)(), Type::number, begin, is_first ? first : second);
            put_pair(is_first ? first_code : second_code);
        }
    }

    Type sum() { return chain(&Parser::product, "+", Code::add, "-", Code::subtract); }
    Type product() { return chain(&Parser::sign, "*", Code::multiply, "/", Code::divide); }

    Type sign()
    {
        if (!takes("-")) return primary();
        deeper();
        const size_t begin = (skip_blanks(), at_);
        want(sign(), Type::number, begin, "-");
        put(Code::negate);
        --depth_;
        return Type::number;
    }

    void deeper()
    {
        if (++depth_ > max_stack) refuse(at_, text_of("more than %u brackets or signs inside each other", max_stack));
    }

    Type primary()
    {
        skip_blanks();
        if (at_ >= text_.size()) refuse(at_, "the expression ends where a value is expected");
        if (takes("(")) {
            deeper();
            const Type type = alternatives();
            expect(")");
            --depth_;
            return type;
        }
        if (is_digit(text_[at_]) || text_[at_] == '.') return number();
        if (is_letter(text_[at_])) return name();
        refuse(at_, "'" + std::string(1, text_[at_]) + "' is no value");
    }

    Type number()
    {
        double value = 0;
        const char *begin = text_.data() + at_, *end = text_.data() + text_.size();
        const auto [stop, error] = std::from_chars(begin, end, value);
        if (error != std::errc()) refuse(at_, "this is no number");
        const std::string_view digits = text_.substr(at_, static_cast<size_t>(stop - begin));
        if (is_rounded(digits, value)) refuse(at_, "this whole number would be rounded to " + text_of("%.0f", value));
        at_ += digits.size();
        put(Code::number, 0, value);
        return Type::number;
    }

    std::string_view word()
    {
        const size_t begin = at_;
        while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]) || text_[at_] == '.')) ++at_;
        return text_.substr(begin, at_ - begin);
    }

    Type name()
    {
        const size_t begin = at_;
        const std::string_view found = word();
        if (takes("(")) return call(found, begin);
        if (found == "true" || found == "false") {
            put(Code::number, 0, found == "true");
            return Type::truth;
        }
        static constexpr struct {
            std::string_view name;
            Code code;
            Type type;
        } built_in[] = {{"time", Code::time, Type::number},          {"clock", Code::clock, Type::number},
                        {"value", Code::value, Type::number},        {"distance", Code::distance, Type::number},
                        {"in_view", Code::in_view, Type::truth},     {"walking", Code::walking, Type::truth},
                        {"own_speed", Code::own_speed, Type::number}};
        for (const auto &one : built_in)
            if (one.name == found) {
                put(one.code);
                return one.type;
            }
        const bool of_crowd = found.substr(0, 6) == "crowd.";
        const Names::Found variable = of_crowd ? names_.crowd_variable(found.substr(6)) : names_.variable(found);
        if (variable.index == none) refuse(begin, "'" + std::string(found) + "' is not known" + names_.near(found));
        put(of_crowd ? Code::crowd : Code::variable, variable.index);
        return variable.type;
    }

    void argument(const char *function)
    {
        const size_t begin = (skip_blanks(), at_);
        want(alternatives(), Type::number, begin, function);
    }

    uint32_t class_name()
    {
        const char *quote = (skip_blanks(), at_ < text_.size() && text_[at_] == '\'') ? "'" : "\"";
        expect(quote);
        const size_t begin = at_;
        while (at_ < text_.size() && text_[at_] != *quote) ++at_;
        const std::string_view found = text_.substr(begin, at_ - begin);
        expect(quote);
        return names_.agent_class(found);
    }

    Type call(std::string_view function, size_t begin)
    {
        static constexpr struct {
            const char *name;
            Code code;
            int arguments;
        } all[] = {{"min", Code::min, 2},    {"max", Code::max, 2},     {"random", Code::random, 2},
                   {"abs", Code::abs, 1},    {"floor", Code::floor, 1}, {"near", Code::near, 0},
                   {"count", Code::count, 0}};
        deeper();
        for (const auto &one : all) {
            if (function != one.name) continue;
            const uint32_t agent_class = one.arguments == 0 ? class_name() : 0;
            if (one.code == Code::count) expect(",");
            if (one.code != Code::near) argument(one.name);
            if (one.arguments == 2) {
                expect(",");
                argument(one.name);
            }
            expect(")");
            // Each place that takes random numbers has a purpose of its own.
            put(one.code, one.code == Code::random ? static_cast<uint32_t>(out_.size()) : agent_class);
            if (one.arguments == 2) --height_;
            --depth_;
            return Type::number;
        }
        refuse(begin,
               "'" + std::string(function) + "' is no function; there are: min, max, abs, floor, random, near, count");
    }

    std::string_view text_;
    Names &names_;
    std::vector<Op> &out_;
    size_t at_ = 0, first_ = 0;
    uint32_t height_ = 0, depth_ = 0;
};

}  // namespace

Type parse_expression(std::string_view text, Names &names, std::vector<Op> &out)
{
    const size_t before = out.size();
    try {
        return Parser(text, names, out).whole();
    } catch (...) {
        out.resize(before);
        throw;
    }
}

}  // namespace claque::stage
