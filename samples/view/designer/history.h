// Undo and redo. A drag or a word that is typed is one step, however many frames it takes.
#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <utility>

namespace view
{

template <class Value>
class History
{
public:
    static constexpr size_t most_steps = 10000;

    // `before` is about to become something else, by a widget of this name. As long as the widget is held, its changes
    // are one step.
    void change(const Value &before, const std::string &by)
    {
        undone_.clear();
        if (!by.empty() && by == held_) return;
        held_ = by;
        done_.push_back(before);
        if (done_.size() > most_steps) done_.pop_front();
    }
    // No widget is held any more.
    void let_go() { held_.clear(); }

    // Return false, with `now` as it is, if there is nothing to give back.
    bool undo(Value &now) { return go(done_, undone_, now); }
    bool redo(Value &now) { return go(undone_, done_, now); }

    size_t done() const { return done_.size(); }
    size_t undone() const { return undone_.size(); }

private:
    bool go(std::deque<Value> &from, std::deque<Value> &to, Value &now)
    {
        held_.clear();
        if (from.empty()) return false;
        to.push_back(std::move(now));
        now = std::move(from.back());
        from.pop_back();
        return true;
    }

    std::deque<Value> done_, undone_;
    std::string held_;
};

}  // namespace view
