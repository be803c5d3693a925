// MPI's side of processes::Ranks: a module that the command loads where mpirun started it.
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <list>
#include <stdexcept>

#include <mpi.h>

#include "samples/processes/ranks.h"

namespace
{

class MpiRanks final : public processes::Ranks
{
public:
    MpiRanks()
    {
        int given = 0;
        MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &given);  // one thread calls MPI, others draw
        MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
        MPI_Comm_size(MPI_COMM_WORLD, &count_);
        MPI_Comm here;
        MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, rank_, MPI_INFO_NULL, &here);
        MPI_Comm_size(here, &count_here_);
        MPI_Comm_free(&here);
    }

    int rank() const override { return rank_; }
    int count() const override { return count_; }
    int count_here() const override { return count_here_; }

    void send(int to, const std::string &message) override
    {
        forget_sent();
        unsent_.push_back({message, MPI_REQUEST_NULL});
        Unsent &one = unsent_.back();
        MPI_Isend(one.message.data(), length(one.message.size()), MPI_BYTE, to, 0, MPI_COMM_WORLD, &one.request);
    }
    bool has_message() override
    {
        int there = 0;
        MPI_Iprobe(MPI_ANY_SOURCE, 0, MPI_COMM_WORLD, &there, MPI_STATUS_IGNORE);
        return there != 0;
    }
    std::string receive(int &from) override
    {
        MPI_Status status;
        MPI_Probe(MPI_ANY_SOURCE, 0, MPI_COMM_WORLD, &status);
        int bytes = 0;
        MPI_Get_count(&status, MPI_BYTE, &bytes);
        from = status.MPI_SOURCE;
        std::string message(static_cast<size_t>(bytes), 0);
        MPI_Recv(message.data(), bytes, MPI_BYTE, from, 0, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
        return message;
    }
    void broadcast(std::string &bytes) override
    {
        int size = length(bytes.size());
        MPI_Bcast(&size, 1, MPI_INT, 0, MPI_COMM_WORLD);
        bytes.resize(static_cast<size_t>(size));
        MPI_Bcast(bytes.data(), size, MPI_BYTE, 0, MPI_COMM_WORLD);
    }

    void finish() override
    {
        for (Unsent &one : unsent_) MPI_Wait(&one.request, MPI_STATUS_IGNORE);
        MPI_Finalize();
    }
    [[noreturn]] void fail(const std::string &sentence) override
    {
        char machine[MPI_MAX_PROCESSOR_NAME + 1] = {0};
        int letters = 0;
        MPI_Get_processor_name(machine, &letters);
        std::fprintf(stderr, "claque: rank %d of %d, on %s: %s\n", rank_, count_, machine, sentence.c_str());
        std::fflush(nullptr);
        MPI_Abort(MPI_COMM_WORLD, 1);
        std::_Exit(1);
    }

private:
    // A rank does not wait until another one has time to receive: that one may be drawing.
    struct Unsent {
        std::string message;
        MPI_Request request;
    };
    void forget_sent()
    {
        unsent_.remove_if([](Unsent &one) {
            int done = 0;
            MPI_Test(&one.request, &done, MPI_STATUS_IGNORE);
            return done != 0;
        });
    }

    static int length(size_t bytes)
    {
        if (bytes > static_cast<size_t>(std::numeric_limits<int>::max()))
            throw std::runtime_error("a message of " + std::to_string(bytes) + " bytes: MPI sends 2 GB at most");
        return static_cast<int>(bytes);
    }

    int rank_ = 0, count_ = 1, count_here_ = 1;
    std::list<Unsent> unsent_;
};

}  // namespace

extern "C" __attribute__((visibility("default"))) processes::Ranks *claque_make_ranks() { return new MpiRanks; }
