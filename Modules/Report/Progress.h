#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace palpate
{
/// Called repeatedly with the progress of a task: fraction in 0..1 and the stage's name. Returns
/// false to cancel the task.
using ProgressFunction = std::function<bool(double fraction, const std::string& stage)>;

/// The user cancelled.
class Cancelled : public std::runtime_error
{
public:
  Cancelled() : std::runtime_error("cancelled") {}
};

/// Throws Cancelled if `progress`, which may be empty, returns false.
inline void ReportProgress(const ProgressFunction& progress, double fraction,
                           const std::string& stage)
{
  if (progress && !progress(fraction, stage))
  {
    throw Cancelled();
  }
}

/// For a step that is the part [from, to] of a task. `progress`, which may be empty, has to outlive
/// it.
inline ProgressFunction PartOf(const ProgressFunction& progress, double from, double to)
{
  if (!progress)
  {
    return {};
  }
  return [&progress, from, to](double fraction, const std::string& stage)
  { return progress(from + (to - from) * fraction, stage); };
}
} // namespace palpate
