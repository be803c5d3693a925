#include "samples/cli/label_crew.h"

#include <deque>

#include "samples/cli/message.h"
#include "samples/cli/provenance.h"
#include "samples/cli/work_share.h"

namespace cli
{
namespace
{

// A message: a line of JSON that says how large each file is, and the files' bytes one after the other.
std::string packed(const LabelledFiles &made)
{
    Json head = {{"about", made.about}, {"report", made.report}, {"files", Json::array()}};
    for (const labels::FrameFile &file : made.files)
        head["files"].push_back({{"path", file.path}, {"bytes", file.bytes.size()}});
    std::string message = head.dump() + "\n";
    for (const labels::FrameFile &file : made.files) message += file.bytes;
    return message;
}

LabelledFiles unpacked(const std::string &message)
{
    size_t at = message.find('\n');
    const Json head = message_of<Json>(message.substr(0, at));
    LabelledFiles made = {head["about"], head["report"], {}};
    ++at;
    for (const Json &file : head["files"]) {
        const size_t bytes = file["bytes"];
        made.files.push_back({file["path"], message.substr(at, bytes)});
        at += bytes;
    }
    return made;
}

// Tasks: "gl", or the number of a picture.
MakeAnswering answering_by(const LabelArguments &a)
{
    return [&a](int threads) -> processes::Answering {
        const auto maker = std::make_shared<LabelMaker>(a, threads);
        return [maker](const std::string &task) -> processes::Reply {
            if (task == "gl") return provenance(maker->gl()).dump();
            return packed(maker->make(std::stoi(task)));
        };
    };
}

}  // namespace

LabelCrew::LabelCrew(const LabelArguments &a, processes::Ranks *ranks)
    : team_(make_team(a.setup, a.processes, ranks, nullptr, answering_by(a)))
{
}

void LabelCrew::serve(const LabelArguments &a, processes::Ranks &ranks)
{
    serve_team(a.setup, ranks, nullptr, answering_by(a));
}

std::string LabelCrew::gl()
{
    for (uint32_t i = 0; i < team_->size(); ++i) team_->send(i, "gl");
    std::optional<Json> first;
    for (uint32_t i = 0; i < team_->size(); ++i) {
        const processes::Team::Answer answer = team_->wait();
        expect_same_pixels(first, message_of<Json>(answer.text), answer.worker);
    }
    return (*first)["gl"];
}

// Each worker labels the next picture that none has, and gets another before the files of the last one are written.
void LabelCrew::make(const std::vector<int> &numbers, const Done &done)
{
    std::vector<std::deque<size_t>> given(team_->size());
    size_t next = 0;
    const auto give = [&](uint32_t worker) {
        if (next == numbers.size()) return;
        given[worker].push_back(next);
        team_->send(worker, std::to_string(numbers[next++]));
    };
    for (uint32_t slot = 0; slot < team_->depth(); ++slot)
        for (uint32_t i = 0; i < team_->size(); ++i) give(i);
    for (size_t answered = 0; answered < numbers.size(); ++answered) {
        const processes::Team::Answer answer = team_->wait();
        const size_t index = given[answer.worker].front();
        given[answer.worker].pop_front();
        give(answer.worker);
        done(index, unpacked(answer.text));
    }
}

}  // namespace cli
