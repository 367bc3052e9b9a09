#pragma once

#include "DisplayServer.h"

#include <memory>

namespace palpate::bench
{
/// An X server for all benchmarks that draw, which share it: when a private one ends, what
/// DISPLAY names ends with it. Null, after a sentence that says why, where there is none.
std::shared_ptr<DisplayServer> OpenDisplay();
} // namespace palpate::bench
