#pragma once

#include "KernelProgress.h"
#include "Progress.h"

#include <string>
#include <utility>

namespace palpate
{
/// Reports the progress of kernels as that of a stage, and lets their cancellation through as
/// Cancelled. The progress must outlive it.
class KernelWatch
{
public:
  KernelWatch(const ProgressFunction& progress, std::string stage)
      : Progress(progress), Stage(std::move(stage))
  {
  }

  /// For a kernel that is the part [from, to] of the stage.
  KernelProgress Of(double from, double to)
  {
    return [this, from, to](double part)
    {
      this->IsCancelled = this->Progress && !this->Progress(from + (to - from) * part, this->Stage);
      return !this->IsCancelled;
    };
  }
  /// Throws Cancelled if a kernel was.
  void Require() const
  {
    if (this->IsCancelled)
    {
      throw Cancelled();
    }
  }

private:
  const ProgressFunction& Progress;
  std::string Stage;
  bool IsCancelled = false;
};
} // namespace palpate
