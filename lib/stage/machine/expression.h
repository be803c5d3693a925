// Conditions and values of machines: parsed once to a list of operations for a stack, evaluated with operations that
// IEEE 754 fixes to the last bit.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace claque::stage
{

enum class Type : uint8_t { number, truth };

enum class Code : uint8_t {
    number,
    variable,
    crowd,
    time,
    clock,
    value,
    distance,
    in_view,
    walking,
    own_speed,
    near,
    count,
    random,
    negate,
    negation,
    add,
    subtract,
    multiply,
    divide,
    less,
    less_equal,
    greater,
    greater_equal,
    equal,
    unequal,
    skip_if_false,  // keeps 0 and jumps over `index` operations, or takes the truth away and goes on
    skip_if_true,
    min,
    max,
    abs,
    floor
};

struct Op {
    Code code = Code::number;
    uint32_t index = 0;
    double number = 0;
};

// A range of a machine's operations; empty: no expression.
struct Program {
    uint32_t first = 0, count = 0;
    explicit operator bool() const { return count > 0; }
};

constexpr uint32_t max_operations = 256;  // of one expression
constexpr uint32_t max_stack = 32;        // values and brackets at once
constexpr uint32_t none = 0xffffffffu;

// What names mean; they are looked up when an expression is parsed.
class Names
{
public:
    struct Found {
        uint32_t index = none;
        Type type = Type::number;
    };
    virtual ~Names() = default;
    virtual Found variable(std::string_view name) const = 0;
    virtual Found crowd_variable(std::string_view name) const = 0;
    virtual uint32_t agent_class(std::string_view name) = 0;
    virtual std::string near(std::string_view name) const = 0;  // variables, for messages: near_names.h
};

struct BadExpression {
    size_t offset = 0;  // in the text
    std::string sentence;
};

// Appends the operations of an expression and returns their type. Throws BadExpression, after which `out` has its old
// length.
Type parse_expression(std::string_view text, Names &names, std::vector<Op> &out);

// Answers about other agents, found only when an expression asks for them.
class Nearby
{
public:
    virtual ~Nearby() = default;
    virtual double nearest_m(uint32_t agent_class) = 0;
    virtual double count(uint32_t agent_class, double radius_m) = 0;
};

struct Situation {
    const double *variables = nullptr, *crowd = nullptr;
    double time = 0, clock = 0, value = 0, distance = 0;
    bool in_view = true, walking = false;
    uint64_t seed = 0, agent_seed = 0;
    uint32_t *draws = nullptr;  // random numbers taken by the agent so far
    Nearby *nearby = nullptr;
};

double evaluate(const Op *ops, Program program, Situation &at);

// A random number in [0, 1), the agent's next one.
double draw(Situation &at, uint32_t purpose);

// The walking speed, in m/s, that an agent prefers.
double own_speed_m_s(uint64_t seed, uint64_t agent_seed);

}  // namespace claque::stage
