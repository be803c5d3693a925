// The ranks of an MPI job: processes that mpirun started, on one machine or on many. What calls MPI is a module of its
// own (samples/mpi), loaded when a job is joined, so a command that runs alone needs no MPI.
#pragma once

#include <memory>
#include <string>

namespace processes
{

class Ranks
{
public:
    virtual ~Ranks() = default;
    virtual int rank() const = 0;  // of this process, from 0
    virtual int count() const = 0;
    virtual int count_here() const = 0;  // on this machine

    // At most 2 GB each. send() does not wait until a message is received. Messages of one rank to another keep their
    // order.
    virtual void send(int to, const std::string &message) = 0;
    virtual bool has_message() = 0;
    virtual std::string receive(int &from) = 0;  // waits for the next message of any rank
    // Called by all ranks: each then has the bytes of rank 0.
    virtual void broadcast(std::string &bytes) = 0;

    // Called by all ranks when their work is done.
    virtual void finish() = 0;
    // Prints the rank, its machine and a sentence, and ends all ranks of the job.
    [[noreturn]] virtual void fail(const std::string &sentence) = 0;
};

// How many ranks mpirun started, this process being one of them. 1: none.
int ranks_started();

// Joins the job; null if this process is no rank of several. To be called before other threads are started. Throws
// std::runtime_error if the module is missing: each rank alone would draw everything.
std::unique_ptr<Ranks> join_ranks();

// What the module exports.
using MakeRanks = Ranks *(*)();

}  // namespace processes
