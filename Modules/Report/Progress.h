#pragma once

#include <functional>
#include <string>

namespace palpate
{
/// Called repeatedly with the progress of a task: fraction in 0..1 and the stage's name. Returns
/// false to cancel the task.
using ProgressFunction = std::function<bool(double fraction, const std::string& stage)>;
} // namespace palpate
