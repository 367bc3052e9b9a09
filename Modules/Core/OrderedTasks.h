#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <future>
#include <utility>

namespace palpate
{
/// Numbered tasks on threads, at most so many at a time and no further ahead than that; their
/// results come in the order of the numbers. The destructor waits for those that have begun.
template <typename Result>
class OrderedTasks
{
public:
  OrderedTasks(std::size_t count, std::size_t atATime, std::function<Result(std::size_t)> run)
      : Count(count), AtATime(atATime), Run(std::move(run))
  {
  }

  /// The next result; rethrows what its task has thrown.
  Result Next()
  {
    while (this->Begun < this->Count && this->Running.size() < this->AtATime)
    {
      this->Running.push_back(std::async(std::launch::async, this->Run, this->Begun++));
    }
    std::future<Result> next = std::move(this->Running.front());
    this->Running.pop_front();
    return next.get();
  }

private:
  std::size_t Count;
  std::size_t AtATime;
  std::function<Result(std::size_t)> Run;
  std::size_t Begun = 0;
  std::deque<std::future<Result>> Running; // ends first, and waits
};
} // namespace palpate
