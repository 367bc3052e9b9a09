#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace palpate::cli
{
class Console;

/// What a case in a process of its own has to say.
struct CaseOutput
{
  std::string Results;  ///< for the output stream
  std::string Messages; ///< for the error stream
  std::string Record;   ///< for the process that asked
};

/// Runs the cases 0 to `count` - 1 in child processes (fork), at most `jobs` at a time: each has
/// its own memory, and one that dies takes no other along. `run` is called in the child, `take` in
/// this process in the order of the cases, with an empty reason, or the reason why the child ended
/// without returning; `step` after every case that ends, with the number of those. Call it before
/// the first use of other threads, which a child would lack.
///
/// Throws Cancelled, after all children have ended, if Interruption::WasAsked; and
/// std::runtime_error if no process can be started.
void RunInProcesses(
    std::size_t count, unsigned jobs, const std::function<CaseOutput(std::size_t)>& run,
    const std::function<void(std::size_t, const CaseOutput&, const std::string& reason)>& take,
    const std::function<void(std::size_t ended)>& step);

/// Runs the cases, several at a time as above if `jobs` and `count` are above 1, otherwise in this
/// process. `run` writes on the console that it is given and returns a record, which `take` gets;
/// or an empty one and the reason why a process ended without it. Progress of several at a time
/// counts the cases. Throws as above.
void RunCases(std::size_t count, unsigned jobs, Console& console,
              const std::function<std::string(std::size_t, Console&)>& run,
              const std::function<void(std::size_t, const std::string& record,
                                       const std::string& reason)>& take);
} // namespace palpate::cli
